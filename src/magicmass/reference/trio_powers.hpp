// SPDX-License-Identifier: GPL-2.0-or-later
// A ball between two blocks, or a block and a wall, after any number of contacts, without stepping through them.
#pragma once

#include "magicmass/reference/cycle_map.hpp"
#include "magicmass/simulator/line.hpp"
#include "magicmass/simulator/trio_stepping.hpp"

namespace magicmass::reference {

/// Velocities, and where each body would have been at time 0 had it always moved as now. A contact changes both by
/// the same linear map: at the time and place of contact both bodies are at one place, which that map keeps.
template <class Scalar>
struct TrioState {
  BodyVelocities<Scalar> v;  ///< now
  BodyVelocities<Scalar> x;  ///< places at time 0, as a triple
};

/// A meets the ball first, then the ball and B (or the wall) meet, in turn.
template <Arithmetic Scalar>
class TrioPowers {
public:
  /// Bodies A, C and B, or A, C and a right wall.
  explicit TrioPowers(const Line<Scalar>& line)
      : TrioPowers(trio_of(line),
                   {trio_velocities(line),
                    {line.positions[0], line.right_wall ? *line.right_wall : line.positions[2],
                     line.positions[1]}}) {}

  /// From the contacts' weights and the state at time 0.
  TrioPowers(const Trio<Scalar>& trio, TrioState<Scalar> start)
      : P_(map_of<Scalar>([&](BodyVelocities<Scalar> v) {
          trio.P.apply(v.a, v.c);
          return v;
        })),
        Q_(map_of<Scalar>([&](BodyVelocities<Scalar> v) {
          trio.Q.apply(v.b, v.c);
          return v;
        })),
        cycle_(compose(Q_, P_)),
        start_(std::move(start)) {}

  /// After j >= 0 contacts; O(log j) multiplications of maps.
  TrioState<Scalar> after(const cln::cl_I& j) const {
    TrioState<Scalar> state = start_;
    for_each_factor(cycle_, cln::floor1(j, 2), [&](const LinearMap<Scalar>& factor) {
      state = {apply(factor, state.v), apply(factor, state.x)};
    });
    return cln::oddp(j) ? once_more(state) : state;
  }
  /// The velocities of that alone.
  BodyVelocities<Scalar> velocities_after(const cln::cl_I& j) const {
    const BodyVelocities<Scalar> whole = apply_power(cycle_, cln::floor1(j, 2), start_.v);
    return cln::oddp(j) ? apply(P_, whole) : whole;
  }

  /// One contact of A more, after whole cycles.
  TrioState<Scalar> once_more(const TrioState<Scalar>& state) const {
    return {apply(P_, state.v), apply(P_, state.x)};
  }

  /// How fast the next two approach after j contacts, and their gap followed back to time 0: they meet at gap/speed.
  struct Approach {
    Scalar speed;  ///< above 0: they meet
    Scalar gap;    ///< at time 0
  };
  /// Of a state after j contacts.
  static Approach approach(const TrioState<Scalar>& state, const cln::cl_I& j) {
    if (cln::oddp(j)) return {state.v.c - state.v.b, state.x.b - state.x.c};
    return {state.v.a - state.v.c, state.x.c - state.x.a};
  }
  /// Of the state after j contacts.
  Approach approach(const cln::cl_I& j) const { return approach(after(j), j); }

  /// One contact of A, then one of B.
  const LinearMap<Scalar>& cycle() const { return cycle_; }
  /// After no contact.
  const TrioState<Scalar>& start() const { return start_; }

private:
  LinearMap<Scalar> P_, Q_, cycle_;
  TrioState<Scalar> start_;
};

}  // namespace magicmass::reference
