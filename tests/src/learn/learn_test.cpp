// SPDX-License-Identifier: GPL-2.0-or-later
// What is said to answers, to exercises that are not sound, and to files that are no exercises.
#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "answers/errors.hpp"
#include "catch.hpp"
#include "learn/judge.hpp"
#include "refusal.hpp"

using learn::Exercise;

namespace {

const std::string source = MAGICMASS_SOURCE;

std::string text_of(const std::filesystem::path& path) {
  std::ifstream file(path);
  REQUIRE(file);
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}

/// All variants of the tutorials' exercises, by id.
const std::map<std::string, std::vector<Exercise>>& exercises() {
  static const std::map<std::string, std::vector<Exercise>> all = [] {
    std::map<std::string, std::vector<Exercise>> found;
    for (const auto& file : std::filesystem::recursive_directory_iterator(source + "/tutorials"))
      if (file.path().parent_path().filename() == "exercises" &&
          file.path().extension() == ".toml") {
        const std::string text = text_of(file.path());
        const Exercise first = learn::read_exercise(text, file.path());
        std::vector<Exercise>& variants = found[first.id] = {first};
        while (variants.size() < first.variants.size())
          variants.push_back(learn::read_exercise(text, file.path(), variants.size()));
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
  std::string all;
  for (const std::string& fault : learn::faults(learn::read_exercise(text, "x.toml")))
    all += fault + "\n";
  return all;
}
std::string refused_text(const std::string& text) {
  return refusal<answers::InvalidInput>([&] { learn::read_exercise(text, "x.toml"); });
}

}  // namespace

TEST_CASE("Answers are judged as in answers.tsv") {
  std::istringstream rows(text_of(source + "/tests/src/learn/answers.tsv"));
  std::string id, answer, verdict, part;
  int judged = 0;
  for (std::string line; std::getline(rows, line);) {
    if (line.starts_with('#')) continue;
    std::istringstream fields(line);
    std::getline(fields, id, '\t');
    std::getline(fields, answer, '\t');
    std::getline(fields, verdict, '\t');
    part.clear();
    std::getline(fields, part);
    const learn::Judgement said = learn::judge(exercises().at(id)[0], answer);
    INFO(line << "\n" << said.feedback);
    CHECK(word(said.mark) == verdict);
    CHECK_THAT(said.feedback, ContainsSubstring(part));
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
  REQUIRE(all_faults(sound + misconception) == "");
  const auto faults = [](const std::string& from, const std::string& to) {
    return all_faults(changed(sound + misconception, from, to));
  };
  // A condition counts only where all of its symbols are.
  CHECK(faults("[\"alpha\"]\nanswer = \"1",
               "[\"alpha\", \"n\"]\ndomain = \"n*alpha < 3\"\nanswer = \"n") == "");
  CHECK_THAT(faults("1 + alpha\"]", "1/(alpha + 1)\"]"), ContainsSubstring("is judged right"));
  CHECK_THAT(faults("1 + alpha\"]", "1 + alpha\", \"1 - (\"]"),
             ContainsSubstring("1 - ( is judged unread"));
  CHECK_THAT(faults("answer =", "answer_from = \"rotation.psi\"\nanswer ="),
             ContainsSubstring("its own answer is judged wrong"));
  CHECK_THAT(faults("answer =", "form = \"no difference\"\nanswer_from = \"nowhere.x\"\nanswer ="),
             ContainsSubstring("nowhere.x"));
  CHECK_THAT(faults("1/(1 + alpha)\"", "1/(1 + alpha\""),
             ContainsSubstring("1/(1 + alpha: column"));
  CHECK_THAT(faults("answer = \"1/", "form = \"factored\"\nanswer = \"0 + 1/"),
             ContainsSubstring("judged other form"));
  CHECK_THAT(faults("hints = [\"x\"]", "hints = []"), ContainsSubstring("hints are missing"));
  CHECK_THAT(faults("symbolic\"", "predict\"\nrun = \"walk --alpha 1\""),
             ContainsSubstring("run: allowed"));
  CHECK_THAT(
      faults("symbolic\"", "predict\"\nchoices = [\"x\", \"y\"]\nwhen = [\"1 = 1\", \"0 < 1\"]"),
      ContainsSubstring("2 choices are right"));
}

TEST_CASE("A file that is no exercise is refused by line") {
  REQUIRE(refused_text(sound) == "not refused");
  const auto refused = [](const std::string& from, const std::string& to) {
    return refused_text(changed(sound + misconception, from, to));
  };
  CHECK_THAT(refused("title = \"x\"\n", ""), ContainsSubstring("title is missing"));
  CHECK_THAT(refused("hints", "hint"),
             ContainsSubstring("x.toml:8: no such key: hint; is hints meant?"));
  CHECK_THAT(refused("symbolic", "code"), ContainsSubstring("starter is missing"));
  CHECK_THAT(refused("symbolic", "riddle"), ContainsSubstring("kind: allowed: symbolic"));
  CHECK_THAT(refused("answer =", "form = \"nice\"\nanswer ="),
             ContainsSubstring("form: allowed: no trig"));
  CHECK_THAT(refused("[\"alpha\"]", "\"alpha\""), ContainsSubstring("x.toml:6: symbols: texts"));
  CHECK_THAT(refused("[\"alpha\"]", "[1]"), ContainsSubstring("symbols: a text is expected"));
  CHECK_THAT(refused("answer = \"1/(1 + alpha)\"\n", ""), ContainsSubstring("answer is missing"));
  CHECK_THAT(refused("feedback", "says"), ContainsSubstring("no such key in a misconception"));
  CHECK_THAT(refused("feedback = \"Upside down.\"\n", ""), ContainsSubstring("and feedback"));
  CHECK_THAT(refused("symbolic", "derivation"), ContainsSubstring("laws are missing"));
  CHECK_THAT(refused("kind = ", "kind "), ContainsSubstring("allowed: an exercise in TOML"));
  CHECK_THAT(refused("answer =", "choices = [\"x\"]\nwhen = []\nvalues = 3\nanswer ="),
             ContainsSubstring("values: names and texts"));
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
  const auto fault = [](const std::string& from, const std::string& to) {
    const learn::Texts all = learn::faults(code_exercise(from, to), fake);
    return all.empty() ? "" : all[0];
  };
  CHECK_THAT(fault("\"zero\"", "\"x\""), ContainsSubstring("the starter is judged right"));
  CHECK_THAT(fault("\"zero\"", "\"junk\""), ContainsSubstring("the starter is judged unread"));
  CHECK_THAT(fault("\"x/2\"", "\"3 x\""), ContainsSubstring("the misconception half is judged"));
  CHECK_THAT(fault("\"2*x\"", "\"3*x\""), ContainsSubstring("its own answer is judged wrong"));
  CHECK_THAT(fault("\"2*x\"", "\"log(n - 9)\""), ContainsSubstring("log(n - 9): "));
  CHECK_THAT(fault("\"2*x\"", "\"z\""), ContainsSubstring("z: "));
  Exercise own = code_exercise("\"2*x\"", "\"solution_code\"");
  CHECK(learn::faults(own, fake).empty());
  own.solution_code = "nan";
  CHECK_THAT(learn::faults(own, fake)[0], ContainsSubstring("solution_code gives no result"));
  for (const char* wrong : {"", "ulp", "2 ulps", "2 ulp or", "-1", "2 ulp 3"})
    CHECK_THAT(fault("2 ulp or 1e-300", wrong), ContainsSubstring("within: allowed"));
  const auto refused = [](const std::string& from, const std::string& to) {
    return refused_text(changed(sound_code, from, to));
  };
  CHECK_THAT(refused("words = [\"double\", ", "words = ["), ContainsSubstring("words: one text"));
  CHECK_THAT(refused("[\"1/8\", \"0\"]", "[\"1/8\"]"), ContainsSubstring("cases: one text"));
  CHECK_THAT(refused("[[\"1/8\"", "[\"1\", [\"1/8\""),
             ContainsSubstring("x.toml:10: cases: texts"));
  std::string many;
  for (int i = 0; i < 100; ++i) many += "[\"1\", \"1\"], ";
  CHECK_THAT(refused("cases = [", "cases = [" + many), ContainsSubstring("cases: 1 to 100"));
  many = "";
  for (int i = 0; i < 15; ++i) many += "\"n\", ";
  CHECK_THAT(refused("inputs = [", "inputs = [" + many), ContainsSubstring("at most 16"));
  CHECK_THAT(refused("[[\"2 x\", ", "[[\"3 x\", "), ContainsSubstring("replace: what is in"));
  CHECK_THAT(refused("[[\"2 x\", \"x/2\"]]", "[[\"2 x\"]]"), ContainsSubstring("got 2 x"));
  CHECK_THAT(refused("within = \"2 ulp or 1e-300\"\n", ""), ContainsSubstring("within is missing"));
}

TEST_CASE("A byte order mark, comments and lines of an answer's file are read as typed") {
  const Exercise e = learn::read_exercise(sound, "x.toml");
  CHECK(learn::judge(e, "\xEF\xBB\xBF# mine\r\n  1/(1 + alpha)\r\n\n").mark == learn::Mark::right);
  CHECK(learn::judge(e, "# nothing\n").mark == learn::Mark::unread);
  CHECK(learn::judge(e, std::string(30000, '(')).mark == learn::Mark::unread);
  CHECK(learn::judge(e, "\x1b[2J").feedback.find('\x1b') == std::string::npos);
}
