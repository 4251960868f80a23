// SPDX-License-Identifier: GPL-2.0-or-later
// Verdicts on pairs that fell elsewhere, each family with a wrong neighbour.
#include "equality/decide.hpp"

#include <array>
#include <fstream>
#include <sstream>

#include "catch.hpp"

using namespace equality;

namespace {
/// Left, right, domain, verdict.
using Pair = std::array<std::string, 4>;
std::vector<Pair> pairs_of(const std::string& file) {
  std::ifstream in(std::string(MAGICMASS_TEST_FOLDER) + "/" + file);
  std::vector<Pair> out;
  for (std::string line; std::getline(in, line);) {
    if (line.empty() || line[0] == '#') continue;
    std::istringstream fields(line);
    for (std::string& field : out.emplace_back()) std::getline(fields, field, '\t');
  }
  return out;
}
std::string word_of(const std::string& left, const std::string& right, const std::string& domain) {
  try {
    const Expr l = notation::read_typed(left).term;
    const Expr r = notation::read_typed(right).term;
    std::vector<std::string> unused;
    const Domain where = read_domain(domain, notation::symbols_of(eq(l, r)), unused);
    return word(decide(l, r, where).answer);
  } catch (const kernel::Refused&) {
    return "no point";
  }
}
}  // namespace

TEST_CASE("Pairs have the verdict that mathematics gives them, on either side") {
  const std::vector<Pair> all = pairs_of("pairs.tsv");
  REQUIRE(all.size() > 60);
  for (const auto& [left, right, domain, verdict] : all) {
    CAPTURE(left, right, domain);
    CHECK(word_of(left, right, domain) == verdict);
    CHECK(word_of(right, left, domain) == verdict);
  }
}
