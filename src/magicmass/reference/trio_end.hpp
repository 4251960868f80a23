// SPDX-License-Identifier: GPL-2.0-or-later
// How three bodies, or two and a wall, end: counts, velocities and times of any contact, or a collapse.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "magicmass/reference/exact_line.hpp"
#include "magicmass/reference/trio_powers.hpp"

namespace magicmass::reference {

/// Infinitely many contacts, in finite time.
struct Collapse {
  double time;      ///< of the last of them, in the scene's units
  double position;  ///< of all bodies then, in the scene's units
};

/// A moves towards C while C and B move alike (a wall: C rests): the state of the theorems, in any frame and with
/// any gap between A and C.
bool is_theorems_start(const ExactLine& line);

/// A line that is_theorems_start, with answers from the powers of one cycle's linear map. Signs are decided exactly where
/// numbers stay short, else by enclosures at raised precision. Each member throws Undecided where further_bits more than
/// its first precision did not do: a value halfway between two doubles is seldom decided.
class TrioEnd {
public:
  /// Keeps a reference to the line. known: the number of contacts, where a theorem has it already.
  explicit TrioEnd(const ExactLine& line, const std::optional<cln::cl_I>& known = {},
                   long further_bits = 1L << 14U);

  /// Where the map of the approach speeds has real eigenvalues (theorems collapse.*), there is no last contact: its
  /// dominant left eigenvector says when.
  const std::optional<Collapse>& collapse() const { return collapse_; }
  /// Number of contacts, without a collapse: those before the first pair that does not approach.
  const cln::cl_I& contacts() const { return contacts_; }
  /// Velocities after j contacts, as the nearest doubles: 0 where it is 0 or underflows.
  BodyVelocities<double> velocities(const cln::cl_I& j) const;
  /// Contact j, the first being 0.
  struct Contact {
    double time;                   ///< in the scene's units
    double position;               ///< of the ball, in the scene's units
    BodyVelocities<double> after;  ///< just after it
  };
  /// The nearest doubles; 0 <= j < contacts().
  Contact contact(const cln::cl_I& j) const;
  /// Where A, B and C are at a time >= 0.
  BodyPositions<double> positions(const FieldNumber& time) const;
  /// Exactly, where the scene is of one field and that is short enough.
  std::optional<BodyVelocities<FieldNumber>> exact_velocities(const cln::cl_I& j) const;

private:
  const ExactLine& line_;
  std::optional<TrioPowers<FieldNumber>> exact_;
  long bits_ = 64;
  long further_bits_;
  cln::cl_I contacts_ = 0;
  std::optional<Collapse> collapse_;

  bool stays_short(const cln::cl_I& j) const;
  TrioPowers<Interval> enclosed(long precision) const;
  /// A number that depends on the state after j contacts.
  using OfInterval = std::function<Interval(const TrioState<Interval>&, const cln::cl_I& j)>;
  using OfExact = std::function<FieldNumber(const TrioState<FieldNumber>&, const cln::cl_I& j)>;
  /// The first j < most, or most, from which its sign is below `least`, which it is not before. One application of a
  /// power of the cycle's map for each bit of j.
  cln::cl_I first_below(int least, const std::optional<cln::cl_I>& most, const OfInterval& at,
                        const OfExact& exactly) const;
  /// Numbers that depend on the state after about j contacts, by powers enclosed at some precision.
  using Enclosures = std::function<std::vector<Interval>(const TrioPowers<Interval>&, long)>;
  std::vector<double> nearest_doubles(const cln::cl_I& j, const Enclosures& at) const;
  void find_collapse();
};

}  // namespace magicmass::reference
