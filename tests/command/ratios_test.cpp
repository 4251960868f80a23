// SPDX-License-Identifier: GPL-2.0-or-later
#include "magicmass/reference/ratios.hpp"

#include <bit>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <string>

#include <catch2/catch.hpp>

#include "command/demo/paper_table_two.hpp"
#include "magicmass/reference/rational.hpp"
#include "program_run.hpp"

using magicmass::Deficient;
using magicmass::Magic;
namespace reference = magicmass::reference;

namespace {

/// The paper rounds all entries of Table II but alpha_6 and alpha_8, which it cuts off: 0.0299278.., 0.0173218...
bool has_printed_digits(const std::string& printed, double value) {
  const int decimals = printed.find('.') == std::string::npos
                           ? 0
                           : static_cast<int>(printed.size() - printed.find('.') - 1);
  const double unit = std::pow(10.0, -decimals);
  return std::abs(std::stod(printed) - std::round(value / unit) * unit) < unit / 2 ||
         std::abs(std::stod(printed) - std::floor(value / unit) * unit) < unit / 2;
}

/// Both numbers are positive doubles: neighbours differ by 1 in their bits.
std::int64_t ulps_apart(double x, double y) {
  return std::abs(std::bit_cast<std::int64_t>(x) - std::bit_cast<std::int64_t>(y));
}

}  // namespace

TEST_CASE("ten ratios agree with the paper's Table II in all printed digits", "[exam]") {
  const nlohmann::json rows = json_of({"ratios", "--count", "10"});
  REQUIRE(rows.size() == 10);
  int cut = 0;
  for (const magicmass::command::PaperRatios& paper : magicmass::command::paper_table_two) {
    const nlohmann::json& row = rows.at(static_cast<std::size_t>(paper.k - 1));
    INFO(row);
    CHECK(row.at("k") == paper.k);
    CHECK(has_printed_digits(std::string(paper.magic), row.at("magic")));
    CHECK(has_printed_digits(std::string(paper.deficient), row.at("deficient")));
    if (std::abs(row.at("magic").get<double>() - std::stod(std::string(paper.magic))) > 5e-7) ++cut;
    CHECK(std::abs(row.at("deficient").get<double>() - std::stod(std::string(paper.deficient))) <=
          5e-7);
  }
  CHECK(cut == 2);
}

TEST_CASE("100000 ratios are within 1 ulp, and the naive formula is not", "[exam]") {
  const std::vector<std::string> lines =
      lines_of(run_program({"ratios", "--count", "100000", "--format", "csv"}).output);
  REQUIRE(lines.size() == 100001);
  CHECK(
      lines.front() ==
      "k,magic,deficient,magic_radicals,magic_polynomial,deficient_radicals,deficient_polynomial");
  std::int64_t worst_naive = 0;
  for (std::int64_t k = 1; k <= 100000; k = k == 99910 ? 100000 : k + 97) {
    const std::string& line = lines[static_cast<std::size_t>(k)];
    const std::size_t first = line.find(',');
    const std::size_t second = line.find(',', first + 1);
    const double magic = std::stod(line.substr(first + 1));
    const double deficient = std::stod(line.substr(second + 1));
    const auto exact = reference::nearest_ratio<double>(Magic{k});
    INFO(line);
    CHECK(std::stoll(line) == k);
    CHECK(ulps_apart(magic, exact) <= 1);
    CHECK(ulps_apart(deficient, reference::nearest_ratio<double>(Deficient{k})) <= 1);
    const double naive = 1.0 / std::cos(std::numbers::pi / static_cast<double>(2 * k + 1)) - 1.0;
    worst_naive = std::max(worst_naive, ulps_apart(naive, exact));
  }
  CHECK(worst_naive > 1000);
}

TEST_CASE("digits of ratios are certified", "[exam]") {
  const nlohmann::json rows = json_of({"ratios", "--count", "2", "--digits", "40"});
  CHECK(rows[0].at("deficient") == "0.4142135623730950488016887242096980785697");  // sqrt(2) - 1
  CHECK(rows[1].at("magic") == "0.2360679774997896964091736687312762354406");      // sqrt(5) - 2
}

TEST_CASE("a thousand digits begin with fifty", "[exam]") {
  const nlohmann::json rows = json_of({"ratios", "--count", "3", "--digits", "1000"});
  const nlohmann::json fewer = json_of({"ratios", "--count", "3", "--digits", "50"});
  for (std::size_t i = 0; i < 3; ++i)
    for (const char* name : {"magic", "deficient"}) {
      const std::string digits = rows.at(i).at(name);
      INFO(digits);
      if (i == 0 && name == std::string("magic")) continue;  // 1 and zeros
      CHECK(digits.size() >= 1002);
      const std::string rounded = fewer.at(i).at(name);
      CHECK(digits.substr(0, 48) == rounded.substr(0, 48));
    }
}

TEST_CASE("ratios come with radicals or minimal polynomials", "[exam]") {
  const nlohmann::json rows = json_of({"ratios", "--count", "9"});
  CHECK(rows[0].at("magic_radicals") == "1");
  CHECK(rows[0].at("deficient_radicals") == "sqrt(2) - 1");
  CHECK(rows[1].at("magic_radicals") == "sqrt(5) - 2");
  CHECK(rows[1].at("magic_polynomial") == "x^2 + 4*x - 1");
  CHECK(rows[1].at("deficient_radicals") == "2/sqrt(3) - 1");
  CHECK(rows[2].at("magic_radicals").is_null());  // the heptagon
  CHECK(rows[2].at("magic_polynomial") == "x^3 - x^2 - 9*x + 1");
  CHECK(rows[2].at("deficient_radicals") == "sqrt(4 - 2*sqrt(2)) - 1");
  CHECK(rows[3].at("deficient_radicals") == "sqrt(2 - 2/sqrt(5)) - 1");
  CHECK(rows[4].at("deficient_radicals") == "sqrt(6) - sqrt(2) - 1");
  CHECK(rows[8].at("magic_polynomial").is_null());  // longer than a line
  const nlohmann::json exact = json_of({"ratios", "--count", "9", "--exact"});
  CHECK(exact[8].at("magic_polynomial").get<std::string>().starts_with("x^9 - x^8 - "));
}

TEST_CASE("every ratio to 200 has its polynomial, and none after it", "[exam]") {
  const nlohmann::json rows = json_of({"ratios", "--count", "201", "--exact"});
  for (std::size_t i = 0; i < 200; ++i) {
    CHECK(rows[i].at("magic_polynomial").is_string());
    CHECK(rows[i].at("deficient_polynomial").is_string());
  }
  CHECK(rows[200].at("magic_polynomial").is_null());
}

TEST_CASE("the text of the ratios keeps to 80 columns", "[exam]") {
  for (const bool exact : {false, true}) {
    std::vector<std::string> arguments = {"ratios", "--count", "40"};
    if (exact) arguments.emplace_back("--exact");
    const std::vector<std::string> lines = lines_of(run_program(arguments).output);
    CHECK(lines.size() > 81);
    for (const std::string& line : lines) {
      INFO(line);
      CHECK(line.size() <= 80);
      CHECK_FALSE(line.ends_with(' '));
    }
  }
}
