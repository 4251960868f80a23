// SPDX-License-Identifier: GPL-2.0-or-later
// What is said to answers, to exercises that are not sound, and to files that are no exercises.
#include <algorithm>
#include <array>
#include <cmath>

#include "answers/errors.hpp"
#include "answers/shown_text.hpp"
#include "catch.hpp"
#include "host/embedded.hpp"
#include "learn/judge.hpp"
#include "magicmass/scenes/keys.hpp"
#include "refusal.hpp"

using learn::Exercise;

namespace {

/// All variants of the tutorials' exercises, by id.
const std::map<std::string, std::vector<Exercise>>& exercises() {
  static const auto all = [] {
    std::map<std::string, std::vector<Exercise>> found;
    for (const auto& [file, text] : host::all_embedded()) {
      if (file.find("/exercises/") == file.npos || !file.ends_with(".toml")) continue;
      const Exercise first = learn::read_exercise(text, file);
      for (std::size_t i = 0; i < std::max(std::size_t{1}, first.variants.size()); ++i)
        found[first.id].push_back(learn::read_exercise(text, file, i));
    }
    return found;
  }();
  return all;
}

const std::string sound = R"toml(id = "x"
title = "x"
chapter = "x"
kind = "symbolic"
prompt = "x"
symbols = ["alpha"]
answer = "1/(1 + alpha)"
hints = ["x"]
)toml";
const std::string misconception = R"toml(
[[misconceptions]]
answers = ["1 + alpha"]
feedback = "Upside down."
)toml";

std::string changed(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  REQUIRE(at != text.npos);
  return text.replace(at, from.size(), to);
}
std::string all_faults(const std::string& text) {
  return answers::joined(learn::faults(learn::read_exercise(text, "x.toml")), "\n");
}
std::string refused(const std::string& text) {
  return refusal<answers::InvalidInput>([&] { learn::read_exercise(text, "x.toml"); });
}

/// What becomes of a sound text with a change: what changes, to what, and a part of what is said.
using Changes = std::vector<std::array<std::string, 3>>;
void check(std::string (*said)(const std::string&), const std::string& text, const Changes& rows) {
  for (const auto& [from, to, part] : rows) {
    INFO(from << " becomes " << to);
    CHECK_THAT(said(changed(text, from, to)), ContainsSubstring(part));
  }
}

}  // namespace

TEST_CASE("Answers are judged as in answers.tsv") {
  const std::string text =
      magicmass::scenes::text_of(MAGICMASS_SOURCE "/tests/src/learn/answers.tsv", "lines");
  int judged = 0;
  for (const std::string& row : learn::fields(text, '\n')) {
    if (row.starts_with('#')) continue;
    learn::Texts fields = learn::fields(row, '\t');
    fields.resize(4);
    const learn::Judgement said = learn::judge(exercises().at(fields[0])[0], fields[1]);
    INFO(row << "\n" << said.feedback);
    CHECK(word(said.mark) == fields[2]);
    CHECK_THAT(said.feedback, ContainsSubstring(fields[3]));
    CHECK(said.feedback.find("typed_") == std::string::npos);
    ++judged;
  }
  CHECK(judged >= 500);
}

TEST_CASE("Each exercise is sound, in each variant") {
  CHECK(exercises().size() == 50);
  std::size_t more = 0;
  for (const auto& [id, variants] : exercises()) {
    if (variants[0].kind == "code") continue;  // in the sandbox's test
    more += variants.size() - 1;
    for (std::size_t i = 0; i < variants.size(); ++i) {
      INFO(id << ", variant " << i);
      CHECK(learn::faults(variants[i]) == learn::Texts{});
      CHECK((i == 0 || variants[i].prompt != variants[0].prompt));
    }
  }
  CHECK(more >= 15);
}

TEST_CASE("What is spoilt in an exercise is a fault of it") {
  const std::string text = sound + misconception;
  REQUIRE(all_faults(text) == "");
  // A condition counts only where all of its symbols are.
  CHECK(all_faults(changed(text, "[\"alpha\"]\nanswer = \"1",
                           "[\"alpha\", \"n\"]\ndomain = \"n*alpha < 3\"\nanswer = \"n")) == "");
  check(
      all_faults, text,
      {{"1 + alpha\"]", "1/(alpha + 1)\"]", "is judged right"},
       {"1 + alpha\"]", "1 + alpha\", \"1 - (\"]", "1 - ( is judged unread"},
       {"answer =", "answer_from = \"rotation.psi\"\nanswer =", "its own answer is judged wrong"},
       {"answer =", "form = \"no difference\"\nanswer_from = \"nowhere.x\"\nanswer =", "nowhere.x"},
       {"1/(1 + alpha)\"", "1/(1 + alpha\"", "1/(1 + alpha: column"},
       {"answer = \"1/", "form = \"factored\"\nanswer = \"0 + 1/", "judged other form"},
       {"hints = [\"x\"]", "hints = []", "hints are missing"},
       {"symbolic\"", "predict\"\nrun = \"walk --alpha 1\"", "run: allowed"},
       {"symbolic\"", "predict\"\nchoices = [\"x\", \"y\"]\nwhen = [\"1 = 1\", \"0 < 1\"]",
        "2 choices are right"}});
}

TEST_CASE("A file that is no exercise is refused by line") {
  REQUIRE(refused(sound) == "not refused");
  check(refused, sound + misconception,
        {{"title = \"x\"\n", "", "title is missing"},
         {"hints", "hint", "x.toml:8: no such key: hint; is hints meant?"},
         {"symbolic", "code", "starter is missing"},
         {"symbolic", "riddle", "kind: allowed: symbolic"},
         {"answer =", "form = \"nice\"\nanswer =", "form: allowed: no trig"},
         {"[\"alpha\"]", "\"alpha\"", "x.toml:6: symbols: texts"},
         {"[\"alpha\"]", "[1]", "symbols: a text is expected"},
         {"answer = \"1/(1 + alpha)\"\n", "", "answer is missing"},
         {"feedback", "says", "no such key in a misconception"},
         {"feedback = \"Upside down.\"\n", "", "and feedback"},
         {"symbolic", "derivation", "laws are missing"},
         {"kind = ", "kind ", "allowed: an exercise in TOML"},
         {"id = \"x\"", "id = \"../x\"", "id: allowed: letters"},
         {"answer =", "choices = [\"x\"]\nwhen = []\nvalues = 3\nanswer =",
          "values: names and texts"}});
}

namespace {

const std::string varied = R"toml(id = "x"
title = "x"
chapter = "x"
kind = "predict"
prompt = "The mass ratio is {alpha}."
run = "count --alpha {alpha}"
answer = "N_A"
hints = ["Not {beta}."]
variants = [{ alpha = "1/7" }, { alpha = "2" }]
[[misconceptions]]
name = "alpha"
answers = ["{alpha}"]
feedback = "This is {alpha}."
)toml";

}  // namespace

TEST_CASE("A variant fills all texts of an exercise") {
  for (const auto& [number, alpha, answer] :
       {std::tuple{0, "1/7", "3"}, {1, "2", "1"}, {2, "1/7", "3"}, {1000000001, "2", "1"}}) {
    const Exercise e = learn::read_exercise(varied, "x.toml", static_cast<std::size_t>(number));
    CHECK(e.prompt == std::string("The mass ratio is ") + alpha + ".");
    CHECK(learn::judge(e, answer).mark == learn::Mark::right);
    const learn::Judgement said = learn::judge(e, alpha);
    CHECK(said.feedback == std::string("This is ") + alpha + ".");
    CHECK(said.misconception == "alpha");
    CHECK(e.hints == learn::Texts{"Not {beta}."});
  }
  CHECK(learn::judge(learn::read_exercise(varied, "x.toml"), "5").misconception.empty());
}

TEST_CASE("Variants that do not fit are refused by line") {
  REQUIRE(refused(varied) == "not refused");
  const std::string first = "{ alpha = \"1/7\" }", second = "{ alpha = \"2\" }";
  const std::string both = "[" + first + ", " + second + "]";
  check(refused, varied,
        {{both, "[]", "x.toml:9: variants: at least one"},
         {both, second, "variants: at least one"},
         {second, "\"2\"", "names and texts"},
         {second, "{ alpha = 2 }", "quotation marks"},
         {second, "{ beta = \"2\" }", "{beta} is not in each variant and in a text"},
         {first, "{ alpha = \"1/7\", gamma = \"1\" }",
          "{gamma} is not in each variant and in a text"},
         {first, "{ alpha = \"1/7\", beta = \"1\" }", "a name is missing"},
         {"predict", "code", "variants: not of code"}});
}

namespace {

const std::string sound_code = R"toml(id = "x"
title = "x"
chapter = "x"
kind = "code"
prompt = "x"
starter = "zero"
driver = "x"
solution_code = "f(x) = 2 x"
inputs = ["x", "n"]
cases = [["1/8", "0"], ["above 1", "1"], ["1/3", "2"]]
values = { y = "3" }
outputs = ["2*x", "n + y"]
words = ["double", "sum"]
within = "2 ulp or 1e-300"
hints = ["x"]
[[misconceptions]]
name = "half"
replace = [["2 x", "x/2"]]
feedback = "Half, not double."
)toml";
Exercise code_exercise(const std::string& from = "sound", const std::string& to = "sound") {
  return learn::read_exercise(changed("# sound\n" + sound_code, from, to), "x.toml");
}
/// Of each program what it gives for a case; "late" stops at the second one.
learn::Ran fake(const Exercise&, const std::string& code, const learn::Rows& inputs) {
  if (code == "junk") return {.unread = "line 1"};
  learn::Ran ran;
  for (const learn::Numbers& in : inputs) {
    const double x = in[0], n = in[1];
    const double off = std::nextafter(2 * x, 100) - 2 * x;
    ran.rows.push_back({code == "f(x) = x/2"  ? x / 2
                        : code == "zero"      ? 0
                        : code == "nan"       ? std::nan("")
                        : code == "two ulp"   ? 2 * x + 2 * off
                        : code == "three ulp" ? 2 * x + 3 * off
                                              : 2 * x,
                        code == "sum" ? n : n + 3});
    if (code == "late" && n == 1) {
      ran.rows.pop_back();
      ran.stopped = "it stopped: why?";
      break;
    }
  }
  if (code == "one row") ran.rows.resize(1);
  return ran;
}

}  // namespace

TEST_CASE("A program is held against exact results at its doubles") {
  const Exercise e = code_exercise();
  const auto said = [&](const std::string& code) {
    const learn::Judgement judgement = learn::judge(e, code, fake);
    return word(judgement.mark) + (": " + judgement.feedback);
  };
  CHECK(said("f(x) = 2 x") == "right: Right, in all cases.");
  CHECK(said("two ulp") == "right: Right, in all cases.");
  CHECK(said("three ulp") ==
        "wrong: At x = 1/8, n = 0: your double is 0.25000000000000017; it should be 0.25, which is "
        "3 ulp off.");
  CHECK(said("zero") == "wrong: At x = 1/8, n = 0: your double is 0; it should be 0.25.");
  CHECK(said("nan") == "wrong: At x = 1/8, n = 0: your double is nan; it should be 0.25.");
  CHECK(said("sum") == "wrong: At x = 1/8, n = 0: your sum is 0; it should be 3.");
  CHECK(said("f(x) = x/2") == "wrong: Half, not double.");
  CHECK(said("late") == "wrong: At x = the double above 1, n = 1: it stopped: why?");
  CHECK(said("one row") ==
        "wrong: At x = the double above 1, n = 1: it gave another number of results than is asked "
        "for.");
  CHECK(said("junk") == "unread: Not compiled: line 1");
  CHECK(said("") == "unread: The answer is empty.");
  CHECK(learn::judge(e, "f(x) = 2 x").mark == learn::Mark::undecided);
  learn::Rows seen;
  learn::judge(e, "x", [&](const Exercise& of, const std::string& code, const learn::Rows& inputs) {
    seen = inputs;
    return fake(of, code, inputs);
  });
  CHECK(seen == learn::Rows{{0.125, 0}, {1 + 0x1p-52, 1}, {1.0 / 3, 2}});
}

TEST_CASE("Right results come from a command, a step or the solution") {
  const auto mark = [](const std::string& outputs, const std::string& more,
                       const learn::Numbers& results) {
    Exercise e = code_exercise("outputs = [\"2*x\", \"n + y\"]", outputs);
    e.inputs = {"alpha", "n"};
    e.run = more;
    e.cases = {{"1/8", "2"}};
    return learn::judge(e, "x",
                        [&](const Exercise&, const std::string&, const learn::Rows&) {
                          return learn::Ran{.rows = {results}};
                        })
        .mark;
  };
  const std::string run = "eval --alpha {alpha} --n {n} --tier exact";
  const std::string columns = "outputs = [\"a\", \"c\"]";
  CHECK(mark(columns, run, {217. / 729, 1792. / 729}) == learn::Mark::right);
  CHECK(mark(columns, run, {217. / 729, 1.}) == learn::Mark::wrong);
  const std::string psi = "outputs = [\"rotation.psi\", \"psi\"]";
  const double right = 2 * std::atan(std::sqrt(0.125 * 2.125));
  CHECK(mark(psi, "", {right, right}) == learn::Mark::right);
  CHECK(mark(psi, "", {1, right}) == learn::Mark::wrong);
  const std::string own = "outputs = [\"n\", \"solution_code\"]";
  CHECK(mark(own, "", {2, 6}) == learn::Mark::right);
  CHECK(mark(own, "", {3, 6}) == learn::Mark::wrong);
}

TEST_CASE("What is spoilt in an exercise in code is a fault of it, or refused by line") {
  REQUIRE(learn::faults(code_exercise(), fake).empty());
  const auto first_fault = [](const std::string& text) {
    const learn::Texts all = learn::faults(learn::read_exercise(text, "x.toml"), fake);
    return all.empty() ? "" : all[0];
  };
  Changes changes{{"\"zero\"", "\"x\"", "the starter is judged right"},
                  {"\"zero\"", "\"junk\"", "the starter is judged unread"},
                  {"\"x/2\"", "\"3 x\"", "the misconception half is judged"},
                  {"\"2*x\"", "\"3*x\"", "its own answer is judged wrong"},
                  {"\"2*x\"", "\"log(n - 9)\"", "log(n - 9): "},
                  {"\"2*x\"", "\"z\"", "z: "}};
  for (const char* wrong : {"", "ulp", "2 ulps", "2 ulp or", "-1", "2 ulp 3"})
    changes.push_back({"2 ulp or 1e-300", wrong, "within: allowed"});
  check(first_fault, sound_code, changes);
  Exercise own = code_exercise("\"2*x\"", "\"solution_code\"");
  CHECK(learn::faults(own, fake).empty());
  own.solution_code = "nan";
  CHECK_THAT(learn::faults(own, fake)[0], ContainsSubstring("solution_code gives no result"));
  const auto many = [](int count, const std::string& text) {
    std::string all;
    for (int i = 0; i < count; ++i) all += text;
    return all;
  };
  check(refused, sound_code,
        {{"words = [\"double\", ", "words = [", "words: one text"},
         {"[\"1/8\", \"0\"]", "[\"1/8\"]", "cases: one text"},
         {"[[\"1/8\"", "[\"1\", [\"1/8\"", "x.toml:10: cases: texts"},
         {"cases = [", "cases = [" + many(100, "[\"1\", \"1\"], "), "cases: 1 to 100"},
         {"inputs = [", "inputs = [" + many(15, "\"n\", "), "at most 16"},
         {"[[\"2 x\", ", "[[\"3 x\", ", "replace: what is in"},
         {"[[\"2 x\", \"x/2\"]]", "[[\"2 x\"]]", "got 2 x"},
         {"within = \"2 ulp or 1e-300\"\n", "", "within is missing"}});
}

TEST_CASE("A byte order mark, comments and lines of an answer's file are read as typed") {
  const Exercise e = learn::read_exercise(sound, "x.toml");
  CHECK(learn::judge(e, "\xEF\xBB\xBF# mine\r\n  1/(1 + alpha)\r\n\n").mark == learn::Mark::right);
  CHECK(learn::judge(e, "# nothing\n").mark == learn::Mark::unread);
  CHECK(learn::judge(e, std::string(30000, '(')).mark == learn::Mark::unread);
  CHECK(learn::judge(e, "\x1b[2J").feedback.find('\x1b') == std::string::npos);
}
