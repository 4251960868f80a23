// SPDX-License-Identifier: GPL-2.0-or-later
// The numbers behind the figures against what the collision law alone gives, stepped here in exact rationals.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <string>
#include <vector>

#include <catch2/catch.hpp>
#include <cln/cln.h>

#include "magicmass/reference/count.hpp"
#include "magicmass/reference/rational.hpp"
#include "magicmass/reference/restitution.hpp"
#include "program_run.hpp"

namespace {

using cln::cl_RA;
using magicmass::reference::exact;
using Row = std::vector<std::string>;

std::vector<Row> figure_rows(const std::string& name) {
  const ProgramRun run = run_program({"figure", name, "--format", "csv"});
  REQUIRE(run.exit_code == 0);
  std::vector<Row> rows;
  for (const std::string& line : lines_of(run.output)) {
    Row row(1);
    for (const char character : line) {
      if (character == ',')
        row.emplace_back();
      else
        row.back() += character;
    }
    rows.push_back(row);
  }
  REQUIRE(rows.size() > 1);
  rows.erase(rows.begin());
  return rows;
}

double number(const std::string& text) { return std::strtod(text.c_str(), nullptr); }

struct Moment {
  cl_RA t;
  std::array<cl_RA, 3> x, v;  // A, B, C
};

/// Independent oracle: contact after contact from momentum and restitution alone; first and last moment included.
std::vector<Moment> stepped(const cl_RA& alpha, const cl_RA& e) {
  Moment now{0, {0, 1, 0}, {1, 0, 0}};
  std::vector<Moment> moments = {now};
  for (std::size_t met = 0; met == 0 ? now.v[0] > now.v[2] : now.v[2] > now.v[1]; met = 1 - met) {
    const cl_RA gap = now.x[met] - now.x[2];
    if (gap != 0) {
      const cl_RA step = gap / (now.v[2] - now.v[met]);
      for (std::size_t body = 0; body < 3; ++body) now.x[body] = now.x[body] + now.v[body] * step;
      now.t = now.t + step;
    }
    const cl_RA mean = (now.v[met] + alpha * now.v[2]) / (1 + alpha);
    const cl_RA closing = now.v[met] - now.v[2];
    now.v[met] = mean - alpha * e * closing / (1 + alpha);
    now.v[2] = mean + e * closing / (1 + alpha);
    moments.push_back(now);
  }
  return moments;
}

/// Within some eps of the exact value, for numbers of size 1.
bool is_near(const std::string& got, const cl_RA& expected, double eps = 8.0) {
  const double error = cln::double_approx(exact(number(got)) - expected);
  return !got.empty() && std::abs(error) <= eps * 2.220446049250313e-16;
}

}  // namespace

TEST_CASE("the oracle of the figures refuses a wrong number", "[exam]") {
  const std::vector<Moment> moments = stepped(1, 1);
  CHECK(moments.size() == 3);
  CHECK(moments.back().v == std::array<cl_RA, 3>{0, 1, 0});
  CHECK(is_near("1", moments.back().v[1]));
  CHECK_FALSE(is_near("1.00000000000001", moments.back().v[1]));
  CHECK_FALSE(is_near("", 0));
}

TEST_CASE("counts: between thresholds and at them the exact numbers", "[exam]") {
  const std::vector<Row> rows = figure_rows("counts");
  for (std::size_t i = 1; i < rows.size(); ++i) {
    const double left = number(rows[i - 1][0]);
    const double right = number(rows[i][0]);
    REQUIRE(left < right);
    const auto inside = magicmass::reference::count_collisions(exact((left + right) / 2));
    CHECK(rows[i - 1][1] == magicmass::reference::to_text(inside.N_A));
    CHECK(rows[i - 1][2] == magicmass::reference::to_text(inside.N_B));
    const auto& threshold = rows[i][3];
    if (threshold.empty()) continue;
    const std::string k = threshold.substr(threshold.find(':') + 1);
    CHECK(rows[i][threshold.starts_with("magic") ? 1 : 2] == k);
  }
}

TEST_CASE("terminal: velocities after the last exact contact", "[exam]") {
  const std::vector<Row> rows = figure_rows("terminal");
  REQUIRE(rows.size() > 900);
  for (std::size_t i = 0; i < rows.size(); i += 13) {
    const std::vector<Moment> moments = stepped(exact(number(rows[i][0])), 1);
    INFO(rows[i][0]);
    CHECK(std::stoul(rows[i][1]) + std::stoul(rows[i][2]) == moments.size() - 1);
    const auto& v = moments.back().v;
    CHECK((is_near(rows[i][3], v[0], 1) && is_near(rows[i][4], v[1], 1) &&
           is_near(rows[i][5], v[2], 1)));
  }
}

TEST_CASE("transmission: rho after the last exact contact, nothing in a collapse", "[exam]") {
  const std::vector<Row> rows = figure_rows("transmission");
  const std::vector<double> restitutions = {1.0, 0.9, 0.8, 0.7};
  std::array<std::size_t, 4> collapses{};
  for (std::size_t i = 0; i < rows.size(); ++i)
    for (std::size_t series = 0; series < 4; ++series) {
      const bool is_last_collapse =
          rows[i][series + 1].empty() && (i + 1 == rows.size() || !rows[i + 1][series + 1].empty());
      collapses[series] += rows[i][series + 1].empty();
      if (i % 97 != 0 && !is_last_collapse) continue;
      INFO(rows[i][0] << " " << restitutions[series]);
      const cl_RA alpha = exact(number(rows[i][0]));
      const cl_RA e = exact(restitutions[series]);
      const auto counts = magicmass::reference::count_collisions(number(rows[i][0]), e);
      CHECK(counts.has_value() != rows[i][series + 1].empty());
      if (is_last_collapse)
        CHECK(magicmass::reference::count_collisions(std::nextafter(number(rows[i][0]), 1.0), e)
                  .has_value());
      if (!counts || counts->N_A > 40) continue;
      const cl_RA b_t = stepped(alpha, e).back().v[1];
      CHECK(is_near(rows[i][series + 1], b_t * b_t));
    }
  CHECK(collapses[0] == 0);
  CHECK((0 < collapses[1] && collapses[1] < collapses[2] && collapses[2] < collapses[3]));
}

TEST_CASE("trajectories: places and times of every exact contact", "[exam]") {
  const std::vector<Row> rows = figure_rows("trajectories");
  std::size_t at = 0;
  for (const std::string panel : {"a", "b", "c"}) {
    INFO(panel);
    const std::vector<Moment> moments = stepped(exact(number(rows[at][1])), 1);
    CHECK(Row(rows[at].begin() + 2, rows[at].end()) == Row{"-1", "-1", "1", "0"});
    for (std::size_t j = 1; j < moments.size(); ++j) {
      const Row& row = rows.at(at + j);
      CHECK((row[0] == panel && is_near(row[2], moments[j].t, 64)));
      for (std::size_t body = 0; body < 3; ++body)
        CHECK(is_near(row[3 + body], moments[j].x[body], 64));
    }
    const Row& last = rows.at(at + moments.size());
    const Moment& end = moments.back();
    for (std::size_t body = 0; body < 3; ++body)
      CHECK(is_near(last[3 + body], end.x[body] + end.v[body] * (exact(number(last[2])) - end.t),
                    128));
    at += moments.size() + 1;
  }
  CHECK(at == rows.size());
}

TEST_CASE("wedge: the collisions lie on one straight line, as fast as V has it", "[exam]") {
  const std::vector<Row> rows = figure_rows("wedge");
  REQUIRE(rows.size() == 6);
  const std::vector<Moment> moments = stepped(exact(number(figure_rows("trajectories")[0][1])), 1);
  const double slope = (number(rows[5][4]) - number(rows[0][4])) / number(rows[5][1]);
  for (std::size_t j = 0; j < rows.size(); ++j) {
    CHECK(is_near(rows[j][1], moments[j + 1].t, 64));
    CHECK(is_near(rows[j][2], moments[j + 1].x[1] - moments[j + 1].x[0], 64));
    CHECK(number(rows[j][5]) == Approx(number(rows[0][5])).epsilon(1e-14));
    CHECK(number(rows[j][4]) ==
          Approx(number(rows[0][4]) + slope * number(rows[j][1])).margin(1e-14));
  }
}

TEST_CASE("sphere: V_n on the unit sphere and on a circle about the axis", "[exam]") {
  const std::vector<Row> rows = figure_rows("sphere");
  const auto vector = [](const Row& row) {
    return std::array<double, 3>{number(row[2]), number(row[3]), number(row[4])};
  };
  const auto product = [](const std::array<double, 3>& x, const std::array<double, 3>& y) {
    return x[0] * y[0] + x[1] * y[1] + x[2] * y[2];
  };
  const std::array<double, 3> axis = vector(rows.at(6));
  REQUIRE(rows[6][0] == "axis");
  const double alpha = std::pow(axis[2] / axis[0], 2);  // the axis is along (1, 1, sqrt(alpha))
  const std::vector<Moment> moments = stepped(exact(alpha), 1);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    CHECK(product(vector(rows[i]), vector(rows[i])) == Approx(1.0).epsilon(1e-14));
    if (i != 6)
      CHECK(product(vector(rows[i]), axis) ==
            Approx(product(vector(rows[0]), axis)).epsilon(1e-14));
    if (i > 5) continue;
    CHECK(rows[i][1] == std::to_string(i));
    const auto& v = moments.at(2 * i).v;
    CHECK(number(rows[i][2]) == Approx(cln::double_approx(v[0])).margin(1e-14));
    CHECK(number(rows[i][3]) == Approx(cln::double_approx(v[1])).margin(1e-14));
    CHECK(number(rows[i][4]) == Approx(std::sqrt(alpha) * cln::double_approx(v[2])).margin(1e-14));
  }
}

TEST_CASE("setup: A comes with V, C and B rest at 0 and L", "[exam]") {
  const std::vector<Row> rows = figure_rows("setup");
  REQUIRE(rows.size() == 3);
  CHECK(rows[0] == Row{"A", "1", "-1", "1"});
  CHECK(Row{rows[1][0], rows[1][2], rows[1][3]} == Row{"C", "0", "0"});
  CHECK(rows[2] == Row{"B", "1", "1", "0"});
}

TEST_CASE("cradle: the shipped scene, its counts by the theorem, and back to the start", "[exam]") {
  const std::vector<Row> rows = figure_rows("cradle");
  REQUIRE(rows.size() == 44);  // both ends, twice the 2 + 4 + 6 + 8 contacts, two walls
  const std::string shipped =
      read_file(std::string(MAGICMASS_SOURCE_DIR) + "/tutorials/scenes/cradle.toml");
  const TemporaryFolder folder;
  write_file(folder / "round_trip.toml",
             shipped.substr(0, shipped.find("until")) + "until = 20\noutputs = [\"events\"]\n");
  const auto scene = json_of({"simulate", folder / "round_trip.toml"});
  REQUIRE(scene["events"].size() == 42);
  for (std::size_t i = 0; i < 42; ++i)
    CHECK(number(rows[i + 1][0]) == scene["events"][i]["time"].get<double>());
  CHECK(rows.back()[0] == "20");
  for (std::size_t body = 0; body < 9; ++body)
    CHECK(number(rows.back()[2 + body]) == Approx(static_cast<double>(body)).margin(1e-12));
}

TEST_CASE("error: tier accurate within half an ulp, the paper's formulas not", "[exam]") {
  const ProgramRun run = run_program({"figure", "error", "--format", "csv"});
  CHECK(lines_of(run.output)[0].starts_with("member,alpha,envelope,ulp_naive,"));
  CHECK(lines_of(run.output)[0].ends_with(",ulp_fast,ulp_accurate"));
  std::array<double, 2> worst{};  // naive, accurate
  const std::vector<Row> rows = figure_rows("error");
  REQUIRE(rows.size() == 800);
  for (const Row& row : rows) {
    worst[0] = std::max(worst[0], number(row[3]));
    worst[1] = std::max(worst[1], number(row.back()));
    const double envelope = number(row[2]), fast = number(row[row.size() - 2]);
    CHECK(fast <= 4 * envelope);
  }
  CHECK(worst[0] > 100);
  CHECK(worst[1] <= 0.5);
}
