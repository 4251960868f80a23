// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>
#include <array>
#include <charconv>
#include <fstream>
#include <iterator>
#include <optional>
#include <string_view>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "command/learn/content_table.hpp"
#include "command/learn/exercise.hpp"
#include "command/learn/pass_program.hpp"
#include "equality/form.hpp"
#include "magicmass/errors.hpp"
#include "magicmass/scenes/shown_text.hpp"

namespace magicmass::command {
namespace {

constexpr std::array<std::pair<const char*, ExerciseKind>, 3> kinds{
    {{"symbolic", ExerciseKind::symbolic},
     {"code", ExerciseKind::code},
     {"predict", ExerciseKind::predict}}};

constexpr std::array<std::pair<const char*, Shape>, 4> shapes{{{"expression", Shape::expression},
                                                               {"matrix", Shape::matrix},
                                                               {"derivation", Shape::derivation},
                                                               {"equations", Shape::equations}}};

template <class Value, std::size_t count>
Value chosen(ContentTable& table, const std::string& key, const std::string& text,
             const std::array<std::pair<const char*, Value>, count>& names) {
  std::string allowed;
  for (const auto& [name, value] : names) {
    if (text == name) return value;
    allowed += (allowed.empty() ? "" : ", ") + std::string(name);
  }
  table.refuse(key, "got \"" + shown_text(text) + "\"", allowed);
}

/// The whole numbers of "1..9", within a thousand million: how many there are fits a long.
std::optional<std::pair<long, long>> range_of(const std::string& text) {
  constexpr long furthest = 1'000'000'000;
  const char* const end = text.data() + text.size();
  long low = 0;
  long high = 0;
  const auto first = std::from_chars(text.data(), end, low);
  if (first.ec != std::errc() || !std::string_view(first.ptr, end).starts_with("..")) return {};
  const auto second = std::from_chars(first.ptr + 2, end, high);
  if (second.ec != std::errc() || second.ptr != end) return {};
  if (low < -furthest || high > furthest || low > high) return {};
  return std::pair(low, high);
}

void read_variants(ContentTable& table, Exercise& exercise) {
  exercise.variants = table.records("variants");
  for (const auto& [name, text] : table.pairs("ranges")) {
    const auto range = range_of(text);
    if (!range)
      table.refuse("ranges", name + " = \"" + shown_text(text) + "\"",
                   "{ k = \"1..9\" }, whole numbers from -1000000000 to 1000000000");
    exercise.ranges[name] = *range;
  }
  if (exercise.variants.empty()) exercise.variants.emplace_back();
  for (const Values& variant : exercise.variants)
    for (const auto& [name, value] : exercise.variants.front())
      if (variant.size() != exercise.variants.front().size() || !variant.contains(name))
        table.refuse("variants", "they have different names", "the same names in each");
}

void read_theorem(ContentTable& table, Exercise& exercise) {
  exercise.theorem = table.text("theorem", "");
  exercise.where = table.pairs("where");
  exercise.notation = table.pairs("notation");
}

void read_form(ContentTable& table, Exercise& exercise) {
  exercise.form = table.text("form", "");
  const auto& names = equality::form_names();
  if (exercise.form.empty() || std::find(names.begin(), names.end(), exercise.form) != names.end())
    return;
  table.refuse("form", "got \"" + shown_text(exercise.form) + "\"",
               fmt::format("{}", fmt::join(names, ", ")));
}

void read_symbolic(ContentTable& table, Exercise& exercise) {
  exercise.shape = chosen(table, "shape", table.text("shape", "expression"), shapes);
  read_form(table, exercise);
  exercise.symbols = table.texts("symbols");
  exercise.domain = table.texts("domain");
  exercise.start = table.text("start", "");
  exercise.truth = table.pairs("truth");
  exercise.truth_theorems = table.pairs("truth_theorems");
  if (exercise.shape == Shape::derivation && exercise.start.empty())
    table.refuse("start", "missing", "the expression that a derivation starts from");
  if (exercise.shape == Shape::derivation && exercise.form.empty())
    table.refuse("form", "missing", "the form that ends a derivation");
  if (exercise.shape == Shape::equations && exercise.truth.empty())
    table.refuse("truth", "missing", "a section that says what the unknowns are");
  if (exercise.theorem.empty() && exercise.run.empty())
    table.refuse("theorem", "missing",
                 "the id of the theorem that proves the solution, or run = [...], so that the "
                 "program's own answer is taken");
}

void read_predict(ContentTable& table, Exercise& exercise) {
  exercise.within = table.text("within", "");
  exercise.law = table.text("law", "");
  for (ContentTable& choice : table.tables("choices")) {
    exercise.choices.push_back({choice.text("text"), choice.text("when")});
    choice.finish();
  }
  if (exercise.run.empty())
    table.refuse("run", "missing",
                 "arguments of magicmass that answer the question, as [\"count\", "
                 "\"--alpha\", \"{alpha}\"]");
}

GeneratorPass read_pass(ContentTable& outer) {
  GeneratorPass pass;
  if (!outer.has("program")) return pass;
  ContentTable table = outer.table("program");
  pass.name = table.text("pass");
  const auto& names = pass_names();
  if (std::find(names.begin(), names.end(), pass.name) == names.end())
    table.refuse("pass", "got \"" + shown_text(pass.name) + "\"",
                 fmt::format("{}", fmt::join(names, ", ")));
  pass.outputs = table.pairs("outputs");
  if (pass.outputs.empty())
    table.refuse("outputs", "missing", "names and theorems, as { a = \"power.a_product\" }");
  pass.bindings = table.texts("bindings");
  pass.wanted = table.texts("wanted");
  table.finish();
  return pass;
}

CodeCheck read_code(ContentTable& outer, const Exercise& exercise) {
  ContentTable table = outer.table("code");
  CodeCheck code;
  code.inputs = table.texts("inputs");
  code.cases = table.rows("cases");
  code.place = table.text("place", "");
  code.ulp = table.number("ulp", 4);
  code.absolute = table.number("absolute", 0);
  code.contestants = table.texts("contestants");
  code.pass = read_pass(table);
  for (ContentTable& output : table.tables("outputs")) {
    code.outputs.push_back({output.text("name"), output.text("exact", ""), output.text("field", ""),
                            output.text("words", ""), output.text("theorem", "")});
    const ComparedOutput& read = code.outputs.back();
    if (read.exact.empty() == read.field.empty())
      output.refuse("exact", "one of exact and field is needed",
                    "exact = \"an expression in the inputs\", or field = \"/N_A\"");
    if (!read.field.empty() && exercise.run.empty() && code.pass.name.empty())
      output.refuse("field", "there is no run",
                    "run = [...] at the top of the file, or a section [code.program]");
    output.finish();
  }
  if (code.cases.empty()) table.refuse("cases", "missing", "a list like [[\"1/7\", 2], [1, 3]]");
  if (code.outputs.empty()) table.refuse("outputs", "missing", "sections [[code.outputs]]");
  for (const auto& row : code.cases)
    if (row.size() != code.inputs.size())
      table.refuse("cases", fmt::format("a case with {} values", row.size()),
                   fmt::format("{} values, one an input", code.inputs.size()));
  table.finish();
  return code;
}

std::vector<Misconception> read_misconceptions(const std::filesystem::path& file) {
  ContentTable table(file);
  std::vector<Misconception> all;
  for (ContentTable& entry : table.tables("misconception")) {
    Misconception one;
    one.name = entry.text("name");
    one.feedback = entry.text("feedback");
    one.answers = entry.texts("answers");
    one.replace = entry.pairs("replace");
    one.program = entry.text("program", "");
    if (one.answers.empty() && one.replace.empty() && one.program.empty())
      entry.refuse("answers", "missing",
                   "answers = [...], replace = { theta = \"-theta\" } or program = \"FILE\"");
    entry.finish();
    all.push_back(std::move(one));
  }
  table.finish();
  return all;
}

}  // namespace

std::string name_of(ExerciseKind kind) {
  return std::find_if(kinds.begin(), kinds.end(),
                      [&](const auto& entry) { return entry.second == kind; })
      ->first;
}

std::string text_of(const std::filesystem::path& file) {
  constexpr std::size_t longest = 1'000'000;
  std::ifstream stream;
  if (std::filesystem::is_regular_file(file)) stream.open(file, std::ios::binary);  // a pipe waits
  if (!stream.is_open())
    throw InvalidInput(shown_text(file.string(), 300) +
                       ": cannot be read; a text file is expected");
  std::string text(longest + 1, '\0');
  stream.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<std::size_t>(stream.gcount()));
  if (text.size() > longest)
    throw InvalidInput(shown_text(file.string(), 300) + ": larger than a megabyte");
  return text;
}

Exercise read_exercise(const std::filesystem::path& folder) {
  ContentTable table(folder / "exercise.toml");
  Exercise exercise;
  exercise.folder = folder;
  exercise.id = table.text("id");
  if (exercise.id != folder.filename().string())
    table.refuse("id", "got \"" + shown_text(exercise.id) + "\"",
                 "the folder's name, " + folder.filename().string());
  exercise.title = table.text("title");
  exercise.kind = chosen(table, "kind", table.text("kind"), kinds);
  exercise.chapter = table.text("chapter");
  const std::string chapter_folder = folder.parent_path().parent_path().filename().string();
  if (exercise.chapter != chapter_folder)
    table.refuse("chapter", "got \"" + shown_text(exercise.chapter) + "\"",
                 "the folder's chapter, " + chapter_folder);
  exercise.difficulty = static_cast<int>(table.whole("difficulty", 1, 5));
  exercise.hints = table.texts("hints");
  if (exercise.hints.size() != 3)
    table.refuse("hints", fmt::format("{} hints", exercise.hints.size()), "three hints, graded");
  read_variants(table, exercise);
  exercise.run = table.texts("run");
  exercise.fields = table.pairs("fields");
  read_theorem(table, exercise);
  if (exercise.kind == ExerciseKind::symbolic) read_symbolic(table, exercise);
  if (exercise.kind == ExerciseKind::predict) read_predict(table, exercise);
  if (exercise.kind == ExerciseKind::code) exercise.code = read_code(table, exercise);
  exercise.right = table.texts("right");
  exercise.wrong = table.texts("wrong");
  exercise.other_form = table.texts("other_form");
  table.finish();
  exercise.misconceptions = read_misconceptions(folder / "misconceptions.toml");
  return exercise;
}

}  // namespace magicmass::command
