// SPDX-License-Identifier: GPL-2.0-or-later
#include <cstdint>
#include <limits>

#include "magicmass/simulator/three_body.hpp"
#include "magicmass/simulator/velocity_stepping.hpp"
#include "report/contestants.hpp"
#include "report/last_collision.hpp"
#include "report/make_contestant.hpp"

namespace magicmass::report {
namespace {

constexpr std::int64_t most_collisions = 4096;
constexpr double ns_per_collision = 6.0;
constexpr double ns_per_event = 10.0;

auto expected(double ns, std::int64_t (*collisions)(const Input&)) {
  return [=](const Input& in) { return ns * static_cast<double>(collisions(in) + 10); };
}

/// Where rounding ends the run too early there is no answer: NaN.
template <class Real>
constexpr Real none = std::numeric_limits<Real>::quiet_NaN();

template <class Real>
generated::Velocities<Real> velocities(const Input& in) {
  if (in.index == 0) return {1, 0, 0, 0};
  generated::Velocities<Real> found{none<Real>, none<Real>, none<Real>, none<Real>};
  step_velocities<Real>(static_cast<Real>(in.alpha), Real(1), 2 * in.index,
                        [&](const VelocityEvent<Real>& event) {
                          if (event.n != in.index) return;
                          if (event.body == Body::A) {
                            found.a = event.after.a;
                            found.c = event.after.c;
                          } else {
                            found.b = event.after.b;
                            found.c_prime = event.after.c;
                          }
                        });
  return found;
}

template <class Real>
generated::Encounters<Real> encounters(const Input& in) {
  generated::Encounters<Real> found{none<Real>, none<Real>};
  std::int64_t j = 0;
  try {
    simulate_three_body<Real>(static_cast<Real>(in.alpha), Real(1), Real(1), in.index + 1,
                              [&](const Event<Real>& event) {
                                if (j++ == in.index)
                                  found = {event.time, event.positions.b - event.positions.a};
                              });
  } catch (const Undecided&) {  // a time or place out of the number type's range
  }
  return found;
}

template <class Real>
Counts counts(const Input& in) {
  return step_velocities<Real>(static_cast<Real>(in.alpha), Real(1), 2 * most_collisions).counts;
}

template <class Real>
Ending<Real> ending(const Input& in) {
  const auto run = step_velocities<Real>(static_cast<Real>(in.alpha), Real(1), 2 * most_collisions);
  return {run.terminal.a, run.terminal.b, run.terminal.c, run.counts};
}

template <class Real>
Contestant stepping(const std::string& quantity) {
  const auto make = [&](auto evaluate) {
    return make_contestant("stepping", quantity, "event stepping", precision_name<Real>(),
                           evaluate);
  };
  if (quantity == "velocities") {
    Contestant one = make([](const Input& in) { return velocities<Real>(in); });
    one.can = [](const Input& in) { return 2 * in.index <= most_collisions; };
    one.expected_ns = expected(ns_per_collision, [](const Input& in) { return 2 * in.index; });
    return one;
  }
  if (quantity == "encounters") {
    Contestant one = make([](const Input& in) { return encounters<Real>(in); });
    one.can = [](const Input& in) { return in.index < most_collisions; };
    one.expected_ns = expected(ns_per_event, [](const Input& in) { return in.index; });
    return one;
  }
  Contestant one = quantity == "counts" ? make([](const Input& in) { return counts<Real>(in); })
                                        : make([](const Input& in) { return ending<Real>(in); });
  one.can = [](const Input& in) { return last_collision(in.alpha).total() <= most_collisions; };
  one.expected_ns =
      expected(ns_per_collision, [](const Input& in) { return last_collision(in.alpha).total(); });
  return one;
}

}  // namespace

std::vector<Contestant> stepping_contestants(const std::string& quantity) {
  if (quantity == "ratios" || quantity == "angle" || quantity == "sequence") return {};
  return {stepping<double>(quantity), stepping<float>(quantity), stepping<long double>(quantity)};
}

}  // namespace magicmass::report
