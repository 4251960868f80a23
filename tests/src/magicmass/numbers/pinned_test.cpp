// SPDX-License-Identifier: GPL-2.0-or-later
// The inputs where the first edition's single numbers, arrays and stream were worst.
#include <fstream>
#include <sstream>

#include "catch.hpp"
#include "magicmass/numbers/fast.hpp"
#include "src/magicmass/numbers/by_oracle.hpp"
#include "src/magicmass/numbers/families.hpp"

using namespace magicmass;
using namespace magicmass::testing;

namespace {
struct Pin {
  std::string quantity;
  double alpha;
  std::int64_t index;
};
std::vector<Pin> pins() {
  std::ifstream file(MAGICMASS_WORST_INPUTS);
  std::string line;
  std::getline(file, line);
  REQUIRE(line == "quantity,alpha,index");
  std::vector<Pin> all;
  while (std::getline(file, line)) {
    std::istringstream fields(line);
    std::string quantity;
    std::string alpha;
    std::string index;
    std::getline(fields, quantity, ',');
    std::getline(fields, alpha, ',');
    std::getline(fields, index);
    all.push_back({quantity, std::strtod(alpha.c_str(), nullptr), std::stoll(index)});
  }
  return all;
}
void check_velocities(double alpha, std::int64_t n) {
  const Velocities exact = velocities_by_oracle(alpha, n);
  CHECK(accurate::velocities(alpha, n) == exact);
  CHECK(envelopes_of(fast::velocities(alpha, n), alpha, n) <= 4);
  double o[4];
  const auto column = [&](int c) { return std::span(o + c, 1); };
  accurate::velocities({&alpha, 1}, {&n, 1}, {column(0), column(1), column(2), column(3)});
  CHECK(Velocities{o[0], o[1], o[2], o[3]} == exact);
  fast::velocities({&alpha, 1}, {&n, 1}, {column(0), column(1), column(2), column(3)});
  CHECK(envelopes_of(Velocities{o[0], o[1], o[2], o[3]}, alpha, n) <= 4);
}
void check_terminal(double alpha) {
  const std::optional<Counts> counts = counts_by_oracle(alpha);
  REQUIRE(counts);
  CHECK(*accurate::terminal(alpha) == terminal_by_oracle(alpha, *counts));
  const Terminal near = *fast::terminal(alpha);
  CHECK(near.counts == *counts);
  CHECK(envelopes_of(near, alpha) <= 4);
}
void check_collision(double alpha, std::int64_t j) {
  CHECK(accurate::collision(alpha, j) == collision_by_oracle(alpha, j));
  CHECK(envelopes_of(fast::collision(alpha, j), alpha, j) <= 4);
}
void check_ratios(std::int64_t k) {
  const Ratios exact = ratios_by_oracle(k);
  CHECK(accurate::ratios(k) == exact);
  CHECK_THAT(fast::ratios(k).magic, WithinULP(exact.magic, 1));
  CHECK_THAT(fast::ratios(k).deficient, WithinULP(exact.deficient, 1));
}
void check_angle(double alpha) {
  const double exact = angle_by_oracle(alpha);
  CHECK(accurate::angle(alpha) == exact);
  CHECK_THAT(fast::angle(alpha), WithinULP(exact, 1));
}
}  // namespace

TEST_CASE("pinned inputs") {
  const std::vector<Pin> all = pins();
  CHECK(all.size() == 114);
  for (const Pin& pin : all) {
    INFO(pin.quantity << " at " << in_hex(pin.alpha) << ", " << pin.index);
    if (pin.quantity == "velocities") {
      check_velocities(pin.alpha, pin.index);
    } else if (pin.quantity == "terminal") {
      check_terminal(pin.alpha);
    } else if (pin.quantity == "collision") {
      check_collision(pin.alpha, pin.index);
    } else if (pin.quantity == "ratios") {
      check_ratios(pin.index);
    } else {
      REQUIRE(pin.quantity == "angle");
      check_angle(pin.alpha);
    }
  }
}
