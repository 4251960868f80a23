// SPDX-License-Identifier: GPL-2.0-or-later
// The wedge theorem against an independent oracle: three bodies on a line, moved from event to event in exact
// rational numbers. Nothing here is taken from the derivation but the formulas under test.
#include <random>
#include <vector>

#include <catch2/catch.hpp>
#include <ginac/ginac.h>

#include "derivation/derivation.hpp"
#include "proof/names.hpp"
#include "whole_derivation.hpp"

using namespace magicmass;
using GiNaC::ex;
using GiNaC::ex_to;
using GiNaC::numeric;
using proof::symbol;

namespace {

struct Wedge {
  numeric M_A, M_B, m, e, V, L;
  bool wall;  // then M_B says nothing
  numeric mu_A() const { return M_A / (M_A + m); }
  numeric mu_B() const { return wall ? numeric(1) : M_B / (M_B + m); }
};

struct Event {
  numeric time, distance;  // of A and B
  numeric approach;
  numeric a, b, c;  // after
};

// At most `most` collisions, typed from mechanics: A hits the ball, the ball hits B, and so on.
std::vector<Event> step(const Wedge& w, std::size_t most) {
  numeric x_A = 0, x_C = 0, x_B = w.L, a = w.V, b = 0, c = 0, time = 0;
  std::vector<Event> events;
  while (events.size() < most) {
    const bool with_A = events.size() % 2 == 0;
    const numeric approach = with_A ? a - c : c - b;
    if (!approach.is_positive()) break;
    const numeric wait = (with_A ? x_C - x_A : x_B - x_C) / approach;
    time += wait;
    x_A += a * wait;
    x_B += b * wait;
    x_C += c * wait;
    numeric& block = with_A ? a : b;
    const numeric M = with_A ? w.M_A : w.M_B;
    const numeric impulse_over_m = (1 + w.e) * (block - c) * (M / (M + w.m));
    if (!with_A && w.wall) {
      c = -w.e * c;
    } else {
      block -= impulse_over_m * w.m / M;
      c += impulse_over_m;
    }
    events.push_back({time, x_B - x_A, approach, a, b, c});
  }
  return events;
}

class Precision {
public:
  Precision() { GiNaC::Digits = 60; }
  ~Precision() { GiNaC::Digits = 17; }
  Precision(const Precision&) = delete;
  Precision(Precision&&) = delete;
  Precision& operator=(const Precision&) = delete;
  Precision& operator=(Precision&&) = delete;
};

numeric value(const ex& e, const GiNaC::exmap& at) {
  const ex result = e.subs(at, GiNaC::subs_options::no_pattern).evalf();
  REQUIRE(GiNaC::is_a<numeric>(result));
  return ex_to<numeric>(result);
}

// 60 digits, less what 60 exact steps and powers of e lose at most.
void check_equal(const numeric& formula, const numeric& stepped) {
  const numeric scale = 1 + GiNaC::abs(stepped);
  INFO(formula << " for " << stepped);
  CHECK(GiNaC::abs(formula - stepped) < scale * numeric(10).power(-35));
}

GiNaC::exmap values_of(const Wedge& w) {
  return {{symbol("mu_A"), w.mu_A()},
          {symbol("mu_B"), w.mu_B()},
          {symbol("e"), w.e},
          {symbol("V"), w.V},
          {symbol("L"), w.L}};
}

// 4 e - (1 + e)^2 mu_A mu_B: its sign says whether the collisions end.
numeric ending(const Wedge& w) { return 4 * w.e - (1 + w.e) * (1 + w.e) * w.mu_A() * w.mu_B(); }

class Random {
public:
  explicit Random(unsigned seed) : engine_(seed) {}
  numeric ratio(unsigned long above, unsigned long below) {
    return numeric(static_cast<long>(1 + engine_() % above),
                   static_cast<long>(1 + engine_() % below));
  }
  Wedge wedge() {
    const numeric e(static_cast<long>(1 + engine_() % 50), 50);
    return {ratio(40, 9), ratio(40, 9), ratio(20, 9),      e,
            ratio(9, 9),  ratio(9, 9),  engine_() % 4 == 0};
  }

private:
  std::mt19937_64 engine_;
};

// After P_n the formulas for v_A and v_C hold, after Q_n those for v_A, v_B and v_C'.
template <class Closed>
void check_velocities(const Event& event, bool with_A, const Closed& closed) {
  check_equal(closed("v_A"), event.a);
  check_equal(closed(with_A ? "v_C" : "v_C_prime"), event.c);
  if (!with_A) check_equal(closed("v_B"), event.b);
}

}  // namespace

TEST_CASE("the wedge theorem agrees with stepping event by event", "[check][shared]") {
  REQUIRE_FALSE(whole_derivation().refused);
  const Precision precision;
  Random random(1);
  int compared = 0;
  while (compared < 40) {
    const Wedge w = random.wedge();
    if (!ending(w).is_positive()) continue;
    ++compared;
    INFO("M_A " << w.M_A << " M_B " << w.M_B << " m " << w.m << " e " << w.e << " wall " << w.wall);
    GiNaC::exmap at = values_of(w);
    const auto closed = [&](const char* id) { return value(whole_derivation().at(id).rhs(), at); };
    at[symbol("g")] = closed("wedge.g");
    at[symbol("h")] = closed("wedge.h");
    const std::vector<Event> events = step(w, 400);
    CHECK(closed("wedge.N_C") == numeric(static_cast<long>(events.size())));
    for (std::size_t j = 0; j < events.size(); ++j) {
      const bool with_A = j % 2 == 0;
      const Event& event = events[j];
      INFO("collision " << j);
      at[symbol("n")] = static_cast<long>(j / 2 + 1);
      at[symbol("j")] = static_cast<long>(j);
      check_equal(closed(with_A ? "wedge.r_P" : "wedge.r_Q"), event.approach);
      check_equal(closed(with_A ? "wedge.tau_P" : "wedge.tau_Q"), event.time);
      check_equal(closed("wedge.tau"), event.time);
      check_equal(closed(with_A ? "wedge.d_P" : "wedge.d_Q"), event.distance);
      check_equal(closed("wedge.v_A"), event.a);
      check_equal(closed(with_A ? "wedge.v_C" : "wedge.v_C_prime"), event.c);
      if (!with_A) check_equal(closed("wedge.v_B"), event.b);
    }
    if (events.empty()) continue;
    at[symbol("k")] = static_cast<long>(events.size() / 2);
    const numeric share = events.back().b / w.V;
    check_equal(closed("wedge.rho"), share * share);
  }
}

TEST_CASE("equal blocks and walls agree with stepping", "[check][shared]") {
  const Precision precision;
  Random random(2);
  int compared = 0;
  while (compared < 20) {
    Wedge w = random.wedge();
    w.M_B = w.M_A;
    if (!ending(w).is_positive()) continue;
    ++compared;
    GiNaC::exmap at = values_of(w);
    const numeric alpha = w.m / w.M_A;
    at[symbol("alpha")] = alpha;
    at[symbol("V_CM")] = w.V / (2 + alpha);
    const auto closed = [&](const std::string& id) {
      return value(whole_derivation().at("special_cases." + id).rhs(), at);
    };
    at[symbol("h_e")] = w.wall ? ex(0) : closed("h_e");
    at[symbol("h_w")] = w.wall ? closed("h_w") : ex(0);
    const std::vector<Event> events = step(w, 400);
    CHECK(closed(w.wall ? "wall_N" : "N_e") == numeric(static_cast<long>(events.size())));
    for (std::size_t j = 0; j < events.size(); ++j) {
      at[symbol("n")] = static_cast<long>(j / 2 + 1);
      const bool with_A = j % 2 == 0;
      const Event& event = events[j];
      check_equal(closed(w.wall ? "wall_A" : "a_e"), event.a);
      check_equal(
          closed(with_A ? (w.wall ? "wall_C" : "c_e") : (w.wall ? "wall_C_prime" : "c_prime_e")),
          event.c);
      if (!with_A) check_equal(closed(w.wall ? "wall_B" : "b_e"), event.b);
      if (w.wall) continue;
      check_equal(closed(with_A ? "tau_P_e" : "tau_Q_e"), event.time);
      check_equal(closed(with_A ? "d_P_e" : "d_Q_e"), event.distance);
    }
  }
}

TEST_CASE("a ball between a block and a wall counts digits of pi", "[exam][shared]") {
  const Precision precision;
  const long digits[] = {3, 31, 314, 3141};
  for (long k = 0; k < 4; ++k) {
    const numeric M = numeric(100).power(numeric(k));
    CHECK(value(whole_derivation().at("special_cases.digits_of_pi").rhs(), {{symbol("k"), k}}) ==
          digits[k]);
    if (k < 3)
      CHECK(step({M, 1, 1, 1, 1, 1, true}, 10000).size() == static_cast<std::size_t>(digits[k]));
  }
}

TEST_CASE("where collisions never end, times approach the collapse", "[check][shared]") {
  const Precision precision;
  Random random(3);
  int compared = 0;
  while (compared < 15) {
    const Wedge w = random.wedge();
    if (!ending(w).is_negative()) continue;
    ++compared;
    INFO("M_A " << w.M_A << " M_B " << w.M_B << " m " << w.m << " e " << w.e << " wall " << w.wall);
    GiNaC::exmap at = values_of(w);
    const auto closed = [&](const std::string& id) {
      return value(whole_derivation().at("collapse." + id).rhs(), at);
    };
    at[symbol("xi")] = closed("exp_eta");
    const numeric end = closed("t_P_infinity");
    check_equal(closed("t_Q_infinity"), end);
    const std::vector<Event> events = step(w, 40);
    REQUIRE(events.size() == 40);
    for (std::size_t j = 0; j < events.size(); ++j) {
      const bool with_A = j % 2 == 0;
      const Event& event = events[j];
      at[symbol("n")] = static_cast<long>(j / 2 + 1);
      check_equal(closed(with_A ? "beyond_r_P" : "beyond_r_Q"), event.approach);
      check_equal(closed(with_A ? "beyond_tau_P" : "beyond_tau_Q"), event.time);
      check_equal(closed(with_A ? "beyond_d_P" : "beyond_d_Q"), event.distance);
      check_equal(closed(with_A ? "left_P" : "left_Q"), end - event.time);
      check_velocities(event, with_A,
                       [&](const char* id) { return closed(std::string("beyond_") + id); });
      CHECK(event.time < end);
    }
  }
}

TEST_CASE("the heaviest ball with a collapse", "[check][shared]") {
  const Precision precision;
  Random random(4);
  for (int tries = 0; tries < 40; ++tries) {
    Wedge w = random.wedge();
    w.M_B = w.M_A;
    w.wall = false;
    const numeric heaviest =
        value(whole_derivation().at("collapse.alpha_c").rhs(), {{symbol("e"), w.e}});
    CHECK((w.m / w.M_A > heaviest) == ending(w).is_positive());
  }
}

TEST_CASE("at the threshold itself speeds grow linearly", "[exam][shared]") {
  const Precision precision;
  // mu_A mu_B = 4 e/(1 + e)^2 in rational numbers: e = 1/4 gives 16/25 = (4/5)^2.
  const Wedge w{4, 4, 1, numeric(1, 4), 1, 1, false};
  REQUIRE(ending(w).is_zero());
  GiNaC::exmap at = values_of(w);
  const std::vector<Event> events = step(w, 30);
  REQUIRE(events.size() == 30);
  for (std::size_t j = 0; j < events.size(); ++j) {
    const bool with_A = j % 2 == 0;
    at[symbol("n")] = static_cast<long>(j / 2 + 1);
    const auto closed = [&](const std::string& id) {
      return value(whole_derivation().at("collapse.threshold_" + id).rhs(), at);
    };
    check_equal(closed(with_A ? "tau_P" : "tau_Q"), events[j].time);
    check_equal(closed(with_A ? "r_P" : "r_Q"), events[j].approach);
    check_equal(closed(with_A ? "d_P" : "d_Q"), events[j].distance);
    check_velocities(events[j], with_A, closed);
    CHECK(events[j].time < closed("t_infinity"));
  }
}
