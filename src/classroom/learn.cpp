#include <fstream>

#include "classroom/classroom.hpp"
#include "host/embedded.hpp"
#include "magicmass/scenes/files.hpp"

namespace classroom {

using magicmass::scenes::text_of;

namespace {

std::vector<Exercise> asked_for(const Request& request) {
  const std::int64_t seed = request.whole("seed", 0, 1'000'000'000).value_or(0);
  std::vector<Exercise> all = exercises(request.text("folder"), static_cast<std::size_t>(seed));
  for (Exercise& e : all) {
    if (!e.variants.empty() && request.has("seed")) e.options += " --seed " + request.text("seed");
    if (request.has("folder")) e.options += " --folder " + request.text("folder");
  }
  return all;
}

Exercise exercise(const Request& request) {
  if (request.words.size() < 2) throw InvalidInput("learn " + request.words[0] + ": give an ID");
  return named(asked_for(request), request.words[1]);
}

Answer document(const Request& request, const Exercise& e, const std::string& text) {
  if (request.format == "text") return {{}, text + "\n"};
  return {answers::one_row({{"id", text_cell(e.id)}, {"text", text_cell(text)}})};
}

Answer list(const Request& request) {
  answers::Table table{{"id", "done", "title", "kind", "chapter"}, {}};
  std::map<std::string, Attempts> before = attempts();
  for (const Exercise& e : asked_for(request)) {
    const std::string& done = before[e.id].done;
    table.rows.push_back({text_cell(e.id), done.empty() ? answers::missing_cell() : text_cell(done),
                          text_cell(e.title), text_cell(e.kind), text_cell(e.chapter)});
  }
  const bool is_text = request.format == "text";  // that fits on a screen
  return {is_text ? selected(table, {"id", "done", "title"}) : table};
}

Answer show(const Request& request) {
  const Exercise e = exercise(request);
  std::string text = e.title + "\n\n" + e.prompt + "\n";
  if (const learn::Texts lines = rules(e); !lines.empty())
    text += "\n" + answers::joined(lines, "\n") + "\n";
  const bool is_code = e.kind == "code";
  if (is_code)
    text += "\nBegin with this in a file, answer.cpp, for c++ -std=c++20:\n\n" + e.starter + "\n";
  text += "\nTry: magicmass learn check " + e.id + (is_code ? " --file answer.cpp" : " \"...\"") +
          e.options;
  return document(request, e, text);
}

Answer check(const Request& request) {
  const Exercise e = exercise(request);
  const bool is_file = request.has("file");
  if (request.words.size() != (is_file ? 2 : 3))
    throw InvalidInput("learn check: give an ID and one answer, in quotes, or --file FILE");
  const std::string text = is_file ? text_of(request.text("file")) : request.words[2];
  Judgement said = judge(e, text, run_code);
  remember(e, said);
  answers::Fields fields = told(e, said);
  if (request.has("reveal")) fields.emplace_back("answer", text_cell(own_answer(e)));
  Answer answer{answers::one_row(fields)};
  answer.is_undecided = said.mark == learn::Mark::undecided;
  answer.check_failed = said.mark != learn::Mark::right && !answer.is_undecided;
  return answer;
}

Answer hint(const Request& request) {
  const Exercise e = exercise(request);
  const std::string which = request.words.size() > 2 ? request.words[2] : "1";
  for (std::size_t i = 0; i < e.hints.size(); ++i)
    if (which == std::to_string(i + 1)) {
      remember_hint(e, i + 1);
      return document(request, e, e.hints[i]);
    }
  throw InvalidInput(
      "learn hint: " + e.id +
      (e.hints.empty() ? " has no hints" : " has hints 1 to " + std::to_string(e.hints.size())));
}

Answer solution(const Request& request) {
  const Exercise e = exercise(request);
  return document(request, e, own_answer(e) + "\n\n" + e.solution);
}

Answer watch_folder(const Request& request) {
  if (request.format != "text") throw InvalidInput("learn watch: --format: allowed: text");
  const std::string folder = request.words.size() > 1 ? request.words[1] : ".";
  return {.table = {}, .stream = [folder, all = asked_for(request)](const auto& say) {
            watch(all, folder, run_code, say);
          }};
}

Answer grade_class(const Request& request) { return grade(request, asked_for(request), run_code); }

Answer make(const Request& request) {
  if (request.words.size() != 2) throw InvalidInput("learn new: give the name of one new file");
  const std::string& path = request.words[1];
  if (std::filesystem::exists(path))
    throw InvalidInput("learn new: " + answers::shown_text(path) + " is there already");
  auto text = host::embedded().at(request.has("kind") ? "new_code.toml" : "new_exercise.toml");
  const std::string name = std::filesystem::path(path).stem();
  learn::replace_all(text, "my_exercise", learn::replaced(name, "\\W", [](auto&) { return "_"; }));
  if (!(std::ofstream(path) << text << std::flush))
    throw InvalidInput("learn new: cannot write " + answers::shown_text(path));
  return {{}, path + ": edit it, then run: magicmass learn test " + path + "\n"};
}

Answer test(const Request& request) {
  Answer answer;
  answer.table.columns = {"id", "fault"};
  const std::string place = request.words.size() > 1 ? request.words[1] : request.text("folder");
  const std::size_t count = exercises(place, 0).size();
  std::size_t most_variants = 1;
  for (std::size_t variant = 0; variant < most_variants; ++variant)
    for (const Exercise& e : exercises(place, variant)) {
      most_variants = std::max(most_variants, e.variants.size());
      if (variant > 0 && variant >= e.variants.size()) continue;
      for (const std::string& fault : faults(e, run_code))
        answer.table.rows.push_back({text_cell(e.id), text_cell(fault)});
    }
  answer.check_failed = !answer.table.rows.empty();
  if (!answer.check_failed && request.format == "text")
    return {{}, "sound: " + std::to_string(count) + (count == 1 ? " exercise\n" : " exercises\n")};
  return answer;
}

}  // namespace

std::vector<Exercise> exercises(const std::string& place, std::size_t variant) {
  std::map<std::string, std::string> texts;
  if (place.empty()) {
    for (const auto& [name, text] : host::embedded())
      if (name.find("/exercises/") != name.npos && name.ends_with(".toml")) texts[name] = text;
  } else if (std::filesystem::is_directory(place)) {
    for (const auto& entry : std::filesystem::recursive_directory_iterator(place))
      if (entry.path().extension() == ".toml")
        if (const std::string text = "\n" + text_of(entry.path());
            text.find("\nid") != text.npos || text.find("\nprompt") != text.npos)  // not scenes
          texts.emplace(entry.path(), text.substr(1));
  } else {
    texts.emplace(place, text_of(place));
  }
  std::vector<Exercise> all;
  for (const auto& [source, text] : texts) {
    const Exercise e = learn::read_exercise(text, source, variant);
    for (const Exercise& other : all)
      if (other.id == e.id) throw InvalidInput(source + ": the id of " + other.source + ", too");
    all.push_back(e);
  }
  if (all.empty()) throw InvalidInput("learn: no exercises in " + answers::shown_text(place));
  return all;
}

Answer learn_by_exercises(const Request& request) {
  static const std::map<std::string, Answer (*)(const Request&)> actions{
      {"list", list}, {"show", show},          {"check", check},
      {"hint", hint}, {"watch", watch_folder}, {"grade", grade_class},
      {"new", make},  {"solution", solution},  {"test", test}};
  static const std::map<std::string, std::string> of_some{
      {"list, show, check, hint, solution, watch, grade, test", "folder"},
      {"show, check, hint, solution, watch, grade", "seed"},
      {"check", "file reveal"},
      {"new", "kind"},
      {"grade", "only why summary"}};
  const std::string name = request.words.empty() ? "" : request.words[0];
  const auto found = actions.find(name);
  if (found == actions.end())
    throw InvalidInput("learn: " + answers::shown_text(name) +
                       "; allowed: list, show, check, hint, solution, watch, grade, new, test");
  for (const auto& [names, options] : of_some)
    for (const std::string& option : learn::split(options, ' '))
      if (request.has(option) && names.find(name) == names.npos)
        throw InvalidInput("learn " + name + ": no --" + option + " here; allowed with: " + names);
  const std::size_t most = name == "list" ? 1 : name == "hint" ? 3 : 2;
  if (name != "check" && request.words.size() > most)
    throw InvalidInput("learn " + name + ": " + answers::shown_text(request.words[most]) +
                       " is one word too many");
  return found->second(request);
}

}  // namespace classroom
