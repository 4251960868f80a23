// SPDX-License-Identifier: GPL-2.0-or-later
// What people type: how it is read.
#include "notation/typed.hpp"

#include "catch.hpp"
#include "notation/alpha.hpp"
#include "refusal.hpp"
#include "rows.hpp"

using namespace notation;

namespace {
std::string reading(const std::string& typed) {
  const Typed read = read_typed(typed);
  if (read.term.sort() != kernel::Sort::Matrix) return typed_text(read.term);
  std::string out;
  for (kernel::Expr e : kernel::entries(read.term))
    out += (out.empty() ? "" : "; ") + typed_text(e);
  return out;
}
std::string refused(const std::string& typed) {
  return refusal<kernel::Refused>([&] { reading(typed); });
}
}  // namespace

TEST_CASE("Plain text, Unicode and LaTeX are read alike, and a chosen reading is said") {
  const auto rows = rows_of("symbolic/notation/readings.tsv", 3);
  REQUIRE(rows.size() > 55);
  for (const auto& row : rows) {
    INFO(row[0]);
    CHECK(reading(row[0]) == row[1]);
    if (row[1].find(';') == std::string::npos) CHECK(reading(row[1]) == row[1]);
    std::string said;
    for (const std::string& note : read_typed(row[0]).notes)
      said += (said.empty() ? "" : "; ") + note;
    CHECK(said == row[2]);
  }
  CHECK(reading("\xef\xbb\xbfx") == "x");
  CHECK(reading("cos\u2061〖𝜓∕2〗 𝑉\u2062𝐋 ＋ 𝟏⁄2") == "cos(psi/2)*V*L + 1/2");
}

TEST_CASE("Sizes are bounded from both sides") {
  const auto nested = [](const std::string& open, int times, const std::string& close) {
    std::string out = "x";
    for (; times > 0; --times) out = open + out + close;
    return out;
  };
  CHECK(reading(nested("(", 199, ")")) == "x");
  for (const auto& [open, close] : {std::pair{"(", ")"}, {"√", ""}, {"x^", ""}})
    CHECK_THAT(refused(nested(open, 6000, close)), ContainsSubstring("nested more than 200 deep"));
  CHECK(reading(std::string(15000, '-') + "x") == "x");
  CHECK_THAT(refused(std::string(20001, '-') + "x"), ContainsSubstring("longer than 20000"));
  CHECK(reading("2^10000") == "2^10000");
}

TEST_CASE("Names that are known are read in what is written without blanks") {
  CHECK(typed_text(read_typed("2M2u2", {"M_2", "u_2"}).term) == "2*M_2*u_2");
  const Typed apart = read_typed("2M_2u_2^2", {"M_2", "u_2"});
  CHECK(typed_text(apart.term) == "2*M_2*u_2^2");
  CHECK(apart.notes == std::vector<std::string>{"M_2u_2 is read as M_2 u_2"});
  CHECK(read_typed("cos(n*psi)*V_CM*Gamma*xy", {"xy"}).notes.empty());
  CHECK(alike("M", {"m"}).empty());
}

TEST_CASE("A column may have commas, in brackets, where one is asked for") {
  CHECK(read_equation("v = (1, 2)/3", {}, true).right.rows() == 2);
  CHECK_THROWS_WITH(read_equation("1, 2", {}, true), ContainsSubstring("written with semicolons"));
  CHECK_THAT(refused("(1, 2)/3"), ContainsSubstring("column 3: unexpected comma"));
}

TEST_CASE("Comparisons come in chains") {
  const std::vector<Comparison> read = read_comparisons("0 < alpha <= 1");
  REQUIRE(read.size() == 2);
  CHECK(read[1].relation == "<=");
  CHECK_THROWS_WITH(read_comparisons("alpha"), ContainsSubstring("a relation is missing"));
}

TEST_CASE("of mass ratios, decimals and hex floats are the nearest double, p/q is exact") {
  for (const auto& [words, value] : {std::pair{"0.1", 0.1},
                                     {"1e-9", 1e-9},
                                     {"0x1.8p-3", 0.1875},
                                     {".5", 0.5},
                                     {"017", 17},
                                     {"0x10", 16}})
    CHECK(std::get<double>(read_alpha(words)) == value);
  CHECK(std::get<double>(read_alpha("5e-324")) > 0);
  CHECK(std::get<cln::cl_RA>(read_alpha("02/14")) == cln::cl_RA("1/7"));
  const auto third = std::get<Threshold>(read_alpha("magic:3"));
  CHECK((third.is_magic && third.k == 3));
  CHECK_FALSE(std::get<Threshold>(read_alpha("deficient:1000000000000000000")).is_magic);
  for (std::string words : {"0.1", "1/7", "3/1", "magic:3", "deficient:2", "1e-09", "5e-324"})
    CHECK(text(read_alpha(words)) == words);
  CHECK(std::get<cln::cl_RA>(read_alpha("1/" + std::string(4094, '1'))) > 0);
}
