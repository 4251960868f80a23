// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>
#include <csignal>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "program_run.hpp"
#include "refusal.hpp"

namespace {

/// The least that still has every part: two inputs a family, six rounds.
std::vector<std::string> tiny(std::vector<std::string> more) {
  std::vector<std::string> words = {"report",   "--quick", "--size",     "2",
                                    "--rounds", "6",       "--no-growth"};
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

/// Records as --format json gives them; stderr may say what was skipped.
nlohmann::json records(std::vector<std::string> more) {
  more.insert(more.end(), {"--format", "json"});
  const ProgramRun run = run_program(tiny(more));
  INFO(run.errors);
  REQUIRE(run.exit_code == 0);
  return nlohmann::json::parse(run.output);
}

/// Without the targets, which are no one's errors and times.
nlohmann::json rows_of(const nlohmann::json& all) {
  nlohmann::json rows = nlohmann::json::array();
  for (const auto& one : all)
    if (one["target"].is_null()) rows.push_back(one);
  return rows;
}

std::set<std::string> values(const nlohmann::json& all, const std::string& key) {
  std::set<std::string> seen;
  for (const auto& one : all) seen.insert(one[key].get<std::string>());
  return seen;
}

std::size_t count_of(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
    ++count;
  return count;
}

}  // namespace

TEST_CASE("records hold speed and error of each evaluator and family, and what they depend on",
          "[exam]") {
  const nlohmann::json all =
      rows_of(records({"--quantities", "velocities", "--families", "tiny alpha,everyday"}));
  CHECK(values(all, "family") == std::set<std::string>{"tiny alpha", "everyday"});
  CHECK(values(all, "member") == std::set<std::string>{"a", "b", "c", "c_prime"});
  CHECK(values(all, "precision") == std::set<std::string>{"float", "double", "long double"});
  const nlohmann::json manifest = nlohmann::json::parse(
      read_file(std::filesystem::path(MAGICMASS_SOURCE_DIR) / "generated" / "manifest.json"));
  const std::set<std::string> evaluators = values(all, "evaluator");
  for (const auto& one : manifest["evaluators"])
    if (one["quantity"] == "velocities" && one["form"] != "exact")
      CHECK(evaluators.count(one["name"].get<std::string>()) == 1);
  for (const auto& one : all) {
    INFO(one.dump());
    CHECK(one["samples"].get<int>() >= 1);
    CHECK((one["max_ulp"].is_number() || one["max_ulp"] == "inf"));
    CHECK(one["worst_alpha"].get<std::string>().substr(0, 2) == "0x");
    CHECK(one["ns"].get<double>() > 0);
    CHECK(one["ns_minimum"].get<double>() <= one["ns"].get<double>());
    CHECK(one["ratio_low"].get<double>() <= one["ratio"].get<double>());
    CHECK(one["ratio"].get<double>() <= one["ratio_high"].get<double>());
    CHECK(one["rounds"].get<int>() == 6);
    for (const char* key : {"machine", "compiler", "flags", "version"})
      CHECK(!one[key].get<std::string>().empty());
    CHECK(one.dump().find(MAGICMASS_SOURCE_DIR) == std::string::npos);
  }
  CHECK(all.front()["evaluator"] == "naive");  // the canary first
}

TEST_CASE("two runs agree on every error figure of what is reproducible", "[exam]") {
  const std::vector<std::string> what = {
      "--quantities", "angle,ratios", "--evaluators",
      "accurate,fast,batch_accurate,batch_fast,angle_closed,angle_product,"
      "ratios_closed,ratios_product"};
  nlohmann::json first = rows_of(records(what));
  nlohmann::json second = rows_of(records(what));
  REQUIRE(first.size() == second.size());
  int compared = 0;
  for (std::size_t i = 0; i < first.size(); ++i)
    for (const char* key :
         {"evaluator", "family", "member", "precision", "samples", "climbed", "max_ulp",
          "worst_alpha", "worst_index", "ulp_999", "ulp_median", "correctly_rounded", "wrong_signs",
          "over_envelope", "max_eps", "wrong", "promise_kept"}) {
      if (first[i]["reproducible"] != true) continue;
      ++compared;
      CHECK(first[i][key] == second[i][key]);
    }
  CHECK(compared > 100);
}

TEST_CASE("the known-bad canary sings in the report", "[exam]") {
  const nlohmann::json all =
      rows_of(records({"--quantities", "velocities", "--families", "tiny alpha,huge alpha",
                       "--evaluators", "naive,exact_rational"}));
  const auto worst = [&](const std::string& evaluator, const std::string& member) {
    double ulp = 0.0;
    for (const auto& one : all)
      if (one["evaluator"] == evaluator && one["member"] == member && one["precision"] == "double")
        ulp = std::max(ulp, one["max_ulp"].is_number() ? one["max_ulp"].get<double>() : 1e300);
    return ulp;
  };
  CHECK(worst("naive", "b") > 1e15);  // no correct digit
  CHECK(worst("exact_rational", "b") <= 0.5);
}

TEST_CASE("every format has the same rows", "[exam]") {
  const std::vector<std::string> what = {"--quantities", "angle",        "--families",
                                         "everyday",     "--evaluators", "fast,accurate"};
  const nlohmann::json all = records(what);
  const auto run = [&](const std::string& format) {
    std::vector<std::string> words = tiny(what);
    words.insert(words.end(), {"--format", format});
    const ProgramRun one = run_program(words);
    REQUIRE(one.exit_code == 0);
    return one.output;
  };
  const std::vector<std::string> csv = lines_of(run("csv"));
  CHECK(csv.size() == all.size() + 1);
  CHECK(csv[0].starts_with("evaluator,family,quantity,precision,member,samples"));
  const std::string text = run("text");
  for (const std::string& line : lines_of(text)) CHECK(line.size() <= 80);
  const std::string markdown = run("markdown");
  CHECK(markdown.starts_with("# Speed against error\n"));
  for (const auto& one : all) {
    const bool is_target = !one["target"].is_null();
    const auto name = one[is_target ? "target" : "evaluator"].get<std::string>();
    // a long name has a line of its own
    CHECK((text.find("\n" + name + " ") != std::string::npos ||
           text.find("\n" + name + "\n") != std::string::npos));
    CHECK(markdown.find("| " + name + " | ") != std::string::npos);
  }
  CHECK(count_of(text, "\nangle, everyday\n") == 1);
}

TEST_CASE("the targets are in every format, with what was seen of them", "[exam]") {
  const std::vector<std::string> what = {
      "--quantities", "elastic_terminal,sequence",
      "--families",   "everyday,long sequences",
      "--evaluators", "fast,accurate,batch_fast,batch_accurate,stream,copy_loop"};
  const nlohmann::json all = records(what);
  std::set<std::string> seen;
  for (const auto& one : all) {
    if (one["target"].is_null()) continue;
    seen.insert(one["target"].get<std::string>());
    CHECK(one["seen"].is_number());
    CHECK((one["verdict"] == "aim" || one["verdict"] == "yes" || one["verdict"] == "no"));
  }
  for (const char* name :
       {"accurate, time / naive: elastic_terminal", "fast, time / naive: elastic_terminal",
        "accurate, certified arithmetic: elastic_terminal", "accurate, slowest single call",
        "accurate, not correctly rounded", "counts, wrong answers",
        "fast, largest error / envelope", "batch (ii), speed-up over naive",
        "accurate batch (ii), speed-up", "stream (iii), time / copy_loop"}) {
    INFO(name);
    CHECK(seen.count(name) == 1);
  }
  CHECK(seen.count("batch counts alone, speed-up") == 0);  // not asked for
  std::vector<std::string> words = tiny(what);
  const ProgramRun text = run_program(words);
  CHECK(text.output.find("\ntargets\n") != std::string::npos);
  for (const std::string& line : lines_of(text.output)) CHECK(line.size() <= 80);
  words.insert(words.end(), {"--format", "markdown"});
  CHECK(run_program(words).output.find("| stream (iii), time / copy_loop |") != std::string::npos);
}

TEST_CASE("bad options, names and places cost one clear line and exit 2, before any measuring",
          "[exam]") {
  const TemporaryFolder folder;
  write_file(folder / "file", "x");
  write_file(folder / "no_marks.md", "# Title\n");
  const std::vector<std::pair<std::vector<std::string>, std::string>> cases = {
      {{"--families", "every day"}, "did you mean everyday?"},
      {{"--evaluators", "naiv"}, "did you mean naive?"},
      {{"--quantities", "velocity"}, "no quantity is called \"velocity\""},
      {{"--format", "xml"}, "unknown format \"xml\""},
      {{"--rounds", "5"}, "--rounds"},
      {{"--size", "0"}, "--size"},
      {{"--figures", folder / "file"}, "cannot write"},
      {{"--figures", "/proc/none/figures"}, "cannot write"},
      {{"-o", "/nowhere/report.txt"}, "cannot write /nowhere/report.txt"},
      {{"--headline", folder / "no_marks.md"}, "no_marks.md: no place for the headline"},
      {{"--compare", folder / "file", folder / "file", "--format", "json"},
       "--compare is told as text"},
      {{"--compare", folder / "file", "--format", "csv"}, "--compare is told as text"},
      {{"--headline", folder / "missing.md"}, "cannot read"},
      {{"--unknown"}, "--unknown"},
  };
  for (const auto& [words, message] : cases) {
    const ProgramRun run = run_program(tiny(words));
    check_refused(run, message);
  }
}

TEST_CASE("without gnuplot the numbers come out all the same", "[exam]") {
  const TemporaryFolder folder;
  std::vector<std::string> words =
      tiny({"--quantities", "angle", "--families", "everyday", "--figures", folder / "figures"});
  const ProgramRun without = run_program(words, "", {"/usr/bin/env", "PATH=/nowhere"});
  CHECK(without.exit_code == 0);
  CHECK(without.output.find("angle, everyday") != std::string::npos);
  CHECK(without.errors.find("figures skipped: needs gnuplot") != std::string::npos);
  CHECK(lines_of(without.errors).size() == 1);
  // Nor is there a compiler on that path.
  CHECK(without.output.find("skipped: GiNaC's compile_ex needs gcc") != std::string::npos);
  const ProgramRun with = run_program(words);
  CHECK(with.exit_code == 0);
  if (with.errors.find("needs gnuplot") != std::string::npos) {
    WARN("skipped: needs gnuplot");
    return;
  }
  CHECK(read_file(folder / "figures/pareto_angle_everyday.svg").find("<svg") != std::string::npos);
}

TEST_CASE("peers that are not installed are said to be skipped", "[exam]") {
  const ProgramRun run =
      run_program(tiny({"--quantities", "angle", "--families", "everyday", "--peers"}), "",
                  {"/usr/bin/env", "PATH=/nowhere"});
  CHECK(run.exit_code == 0);
  CHECK(run.output.find("skipped: SymPy on NumPy needs python3") != std::string::npos);
}

TEST_CASE("SymPy computes the same formulas", "[exam]") {
  const std::vector<std::string> words =
      tiny({"--quantities", "ratios", "--families", "first k", "--peers", "--format", "json"});
  const ProgramRun run = run_program(words);
  REQUIRE(run.exit_code == 0);
  if (run.errors.find("skipped: SymPy") != std::string::npos) {
    WARN("skipped: needs python3-sympy and python3-numpy");
    return;
  }
  int rows = 0;
  for (const auto& one : nlohmann::json::parse(run.output))
    if (one["evaluator"] == "sympy_product") {
      ++rows;
      CHECK(one["max_ulp"].get<double>() <= 8);  // eight operations of half an ulp, and two sines
      CHECK(one["ns"].get<double>() > 0);
    }
  CHECK(rows == 2);
}

TEST_CASE("Ctrl-C leaves a whole file with what was finished", "[exam]") {
  const TemporaryFolder folder;
  const ProgramRun run =
      run_program({"report", "--quick", "--quantities", "angle,velocities", "--no-growth",
                   "--format", "json", "-o", folder / "report.json"},
                  "", {"timeout", "--signal=INT", "4"});
  if (run.exit_code != 124) FAIL("expected timeout's 124, got " << run.exit_code);
  const std::string text = read_file(folder / "report.json");
  const nlohmann::json all = nlohmann::json::parse(text);
  CHECK(all.is_array());
  CHECK(run.errors.find("magicmass: interrupted") != std::string::npos);
  CHECK(folder.names() == std::vector<std::string>{"report.json"});
}

TEST_CASE("a report with every contestant leaves no file where it runs nor in the temporary folder",
          "[exam]") {
  const TemporaryFolder here;
  const TemporaryFolder temporary;
  const ProgramRun run = run_program(
      tiny({"--peers", "--families", "everyday,first k"}), "",
      {"/usr/bin/env", "-C", here.path().string(), "TMPDIR=" + temporary.path().string()});
  REQUIRE(run.exit_code == 0);
  const bool is_compiled = run.output.find("\ncompile_ex_closed ") != std::string::npos;
  CHECK((is_compiled || run.output.find("skipped: GiNaC's compile_ex") != std::string::npos));
  CHECK(here.names().empty());
  CHECK(temporary.names().empty());
}
