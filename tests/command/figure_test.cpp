// SPDX-License-Identifier: GPL-2.0-or-later
// Figures as files: well-formed, described, the same each time, and nothing half-written.
#include <filesystem>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "program_run.hpp"
#include "refusal.hpp"

namespace {

struct Expected {
  std::string name;
  std::size_t curves;
};

const std::vector<Expected> all_figures = {
    {"setup", 3},  {"counts", 2}, {"trajectories", 9}, {"terminal", 3}, {"transmission", 4},
    {"cradle", 9}, {"wedge", 2},  {"sphere", 7},       {"error", 18}};

std::size_t occurrences(const std::string& text, const std::string& word) {
  std::size_t count = 0;
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1))
    ++count;
  return count;
}

/// Every tag is closed by its own name, in order, and no '&' is bare. Enough of XML for what gnuplot writes.
bool is_well_formed(const std::string& xml) {
  std::vector<std::string> open;
  std::size_t at = 0;
  std::size_t roots = 0;
  while ((at = xml.find_first_of("<&", at)) != std::string::npos) {
    const std::size_t end = xml.find(xml[at] == '&' ? ';' : '>', at);
    if (end == std::string::npos) return false;
    const std::string inside = xml.substr(at + 1, end - at - 1);
    const bool is_entity = xml[at] == '&';
    at = end + 1;
    if (is_entity) {
      if (inside.empty() || inside.find_first_of(" <&") != std::string::npos) return false;
    } else if (inside.starts_with("/")) {
      if (open.empty() || open.back() != inside.substr(1)) return false;
      open.pop_back();
    } else if (!inside.starts_with("?") && !inside.starts_with("!")) {
      if (inside.find('<') != std::string::npos) return false;
      if (open.empty() && ++roots > 1) return false;
      if (!inside.ends_with("/")) open.push_back(inside.substr(0, inside.find_first_of(" \n\t")));
    }
  }
  return open.empty() && roots == 1;
}

bool can_draw() {
  const bool can = run_program({"figure", "setup", "-o", "/dev/null"}).exit_code == 0;
  if (!can) WARN("skipped: needs gnuplot");
  return can;
}

}  // namespace

TEST_CASE("what is no XML is told from what is", "[exam]") {
  CHECK(is_well_formed("<?xml version='1.0'?>\n<a b='c'><d/>&lt;<e>x</e></a>\n"));
  for (const char* bad : {"<a><b></a></b>", "<a>", "</a>", "<a>x & y</a>", "<a/><a/>", "<a", ""})
    CHECK_FALSE(is_well_formed(bad));
}

TEST_CASE("each figure is an SVG with a description and all its curves", "[exam]") {
  if (!can_draw()) return;
  for (const auto& [name, curves] : all_figures) {
    INFO(name);
    const TemporaryFolder folder;
    const ProgramRun run = run_program({"figure", name, "-o", folder / "figure.svg"});
    CHECK(run.exit_code == 0);
    CHECK(run.output.empty());
    CHECK(run.errors.empty());
    CHECK(folder.names() == std::vector<std::string>{"figure.csv", "figure.svg"});
    const std::string svg = read_file(folder / "figure.svg");
    CHECK(is_well_formed(svg));
    CHECK(occurrences(svg, "id=\"gnuplot_plot_") == curves);
    CHECK(occurrences(svg, "<desc id=\"desc\">") == 1);
    CHECK(occurrences(svg, "role=\"img\" aria-labelledby=\"title desc\"") == 1);
    CHECK(svg.find("</desc>") > svg.find("<desc") + 150);
    CHECK(occurrences(svg, "GNUPLOT") == 0);
    CHECK(occurrences(svg, "/tmp") == 0);
    CHECK(run_program({"figure", name}).output == svg);
    CHECK(run_program({"figure", name, "--format", "csv"}).output ==
          read_file(folder / "figure.csv"));
  }
}

TEST_CASE("PNG and PDF have the same bytes each time", "[exam]") {
  if (!can_draw()) return;
  const ProgramRun png = run_program({"figure", "setup", "--format", "png"});
  const ProgramRun pdf = run_program({"figure", "setup", "--format", "pdf"});
  CHECK(png.output.starts_with("\x89PNG"));
  CHECK(pdf.output.starts_with("%PDF"));
  CHECK(pdf.output.find("CreationDate") == std::string::npos);
  CHECK(run_program({"figure", "setup", "--format", "png"}).output == png.output);
  CHECK(run_program({"figure", "setup", "--format", "pdf"}).output == pdf.output);
}

TEST_CASE("the ending of a file says what is drawn, and --format overrides it", "[exam]") {
  if (!can_draw()) return;
  const TemporaryFolder folder;
  for (const char* ending : {"svg", "png", "pdf", "dat"})
    REQUIRE(
        run_program({"figure", "setup", "-o", folder / ("a." + std::string(ending))}).exit_code ==
        0);
  CHECK(read_file(folder / "a.svg").starts_with("<?xml"));
  CHECK(read_file(folder / "a.png").starts_with("\x89PNG"));
  CHECK(read_file(folder / "a.pdf").starts_with("%PDF"));
  CHECK(read_file(folder / "a.dat").starts_with("<?xml"));
  REQUIRE(run_program({"figure", "setup", "--format", "svg", "-o", folder / "b.pdf"}).exit_code ==
          0);
  CHECK(read_file(folder / "b.pdf").starts_with("<?xml"));
}

TEST_CASE("solid lines are solid in SVG beside dashed ones", "[exam]") {
  if (!can_draw()) return;
  const auto dashed = [](const std::string& svg, const std::string& colour) {
    return occurrences(svg, "stroke='rgb(" + colour + ")' stroke-dasharray");
  };
  const std::string wedge = run_program({"figure", "wedge"}).output;
  CHECK(dashed(wedge, "  1,   1,   1") > 0);
  CHECK(dashed(wedge, "  0,   0,   0") == 0);
  const std::string error = run_program({"figure", "error"}).output;
  CHECK(dashed(error, "119, 119, 119") > 0);
  CHECK(dashed(error, "153, 153, 153") == 0);
}

TEST_CASE("the user's own gnuplot settings change nothing", "[exam]") {
  if (!can_draw()) return;
  const TemporaryFolder home;
  write_file(home / ".gnuplot", "set xrange [5:6]\nset title 'mine'\n");
  CHECK(run_program({"figure", "terminal"}, "", {"/usr/bin/env", "HOME=" + home.path().string()})
            .output == run_program({"figure", "terminal"}).output);
}

TEST_CASE("figure --list names the figures", "[exam]") {
  const std::vector<std::string> lines = lines_of(run_program({"figure", "--list"}).output);
  REQUIRE(lines.size() == all_figures.size());
  for (std::size_t i = 0; i < lines.size(); ++i)
    CHECK(lines[i].starts_with(all_figures[i].name + " "));
}

TEST_CASE("without gnuplot a figure is one line, code 2 and no file, and CSV still comes",
          "[exam]") {
  const TemporaryFolder folder;
  const std::vector<std::string> nowhere = {"/usr/bin/env", "PATH=/nowhere"};
  const ProgramRun run =
      run_program({"figure", "counts", "-o", folder / "counts.svg"}, "", nowhere);
  CHECK(run.exit_code == 2);
  CHECK(lines_of(run.errors).size() == 1);
  CHECK(run.errors.find("needs gnuplot (Debian: gnuplot-nox)") != std::string::npos);
  CHECK(run.errors.find("--format csv") != std::string::npos);
  CHECK(folder.names().empty());
  const ProgramRun csv = run_program(
      {"figure", "counts", "--format", "csv", "-o", folder / "counts.csv"}, "", nowhere);
  CHECK(csv.exit_code == 0);
  CHECK(folder.names() == std::vector<std::string>{"counts.csv"});
}

TEST_CASE("what figure does not understand is one line and code 2", "[exam]") {
  const TemporaryFolder folder;
  const std::vector<std::pair<std::vector<std::string>, std::string>> refused = {
      {{"figure", "cuonts"}, "did you mean counts?"},
      {{"figure", ""}, "which figure? allowed: setup, counts"},
      {{"figure"}, "which figure? allowed: setup, counts"},
      {{"figure", "counts", "--list"}, "exclude each other"},
      {{"figure", "counts", "--format", "gif"}, "allowed: svg, png, pdf, csv"},
      {{"figure", "counts", "-o", folder / "counts.csv"}, "another ending"},
      {{"figure", "counts", "-o", folder / "none/counts.svg"}, "cannot write"},
      {{"figure", "counts", "terminal"}, "terminal"}};
  for (const auto& [arguments, expected] : refused) {
    const ProgramRun run = run_program(arguments);
    check_refused(run, expected);
  }
  CHECK(folder.names().empty());
}
