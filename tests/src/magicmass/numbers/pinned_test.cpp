// SPDX-License-Identifier: GPL-2.0-or-later
// The inputs where the first edition's single numbers, arrays and stream were worst.
#include <fstream>
#include <map>

#include "src/magicmass/numbers/checks.hpp"

using namespace magicmass;
using namespace magicmass::testing;

namespace {
void check_velocities(double alpha, std::int64_t n) {
  const Velocities exact = velocities_by_oracle(alpha, n);
  CHECK(accurate::velocities(alpha, n) == exact);
  CHECK(envelopes_of(fast::velocities(alpha, n), alpha, n) <= 4);
  Velocities v;
  const VelocityColumns row{{&v.a, 1}, {&v.b, 1}, {&v.c, 1}, {&v.c_prime, 1}};
  accurate::velocities({&alpha, 1}, {&n, 1}, row);
  CHECK(v == exact);
  fast::velocities({&alpha, 1}, {&n, 1}, row);
  CHECK(envelopes_of(v, alpha, n) <= 4);
}
void check_terminal(double alpha, std::int64_t) {
  const std::optional<Counts> counts = counts_by_oracle(alpha);
  REQUIRE(counts);
  CHECK(*accurate::terminal(alpha) == terminal_by_oracle(alpha, *counts));
  const Terminal near = *fast::terminal(alpha);
  CHECK(near.counts == *counts);
  CHECK(envelopes_of(near, alpha) <= 4);
}
const std::map<std::string, void (*)(double, std::int64_t)> checks{
    {"velocities", check_velocities},
    {"terminal", check_terminal},
    {"collision", check_collision},
    {"ratios", [](double, std::int64_t k) { check_ratios(k); }},
    {"angle", [](double alpha, std::int64_t) { check_angle(alpha); }}};
}  // namespace

TEST_CASE("pinned inputs") {
  std::ifstream file(MAGICMASS_WORST_INPUTS);
  std::string quantity, alpha, index;
  std::getline(file, quantity);
  REQUIRE(quantity == "quantity,alpha,index");
  int pins = 0;
  for (; std::getline(file, quantity, ','); ++pins) {
    std::getline(file, alpha, ',');
    std::getline(file, index);
    INFO(quantity << " at " << alpha << ", " << index);
    checks.at(quantity)(std::strtod(alpha.c_str(), nullptr), std::stoll(index));
  }
  CHECK(pins == 114);
}
