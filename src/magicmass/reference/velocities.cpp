// SPDX-License-Identifier: GPL-2.0-or-later
#include "magicmass/reference/velocities.hpp"

#include <algorithm>
#include <optional>

#include "magicmass/errors.hpp"
#include "magicmass/reference/cycle_map.hpp"
#include "magicmass/reference/decimal.hpp"
#include "magicmass/reference/rational.hpp"

namespace magicmass::reference {
namespace {

using cln::cl_I;
using cln::cl_RA;

/// A rational map as integers over one denominator: powers then need no reduction to lowest terms on the way.
struct IntegerMap {
  LinearMap<cl_I> numerators;
  cl_I denominator;
};

cl_I common_denominator(const LinearMap<cl_RA>& map) {
  cl_I common(1);
  for (const BodyVelocities<cl_RA>& column : {map.from_a, map.from_b, map.from_c}) {
    for (const cl_RA& entry : {column.a, column.b, column.c}) {
      common = cln::lcm(common, cln::denominator(entry));
    }
  }
  return common;
}

IntegerMap over_common_denominator(const LinearMap<cl_RA>& map) {
  const cl_I common = common_denominator(map);
  const auto column = [&](const BodyVelocities<cl_RA>& v) {
    return BodyVelocities<cl_I>{cln::numerator(v.a * common), cln::numerator(v.b * common),
                                cln::numerator(v.c * common)};
  };
  return {{column(map.from_a), column(map.from_b), column(map.from_c)}, common};
}

struct IntegerContacts {
  IntegerMap with_A;
  IntegerMap with_B;
};

IntegerContacts integer_contacts(const cl_RA& alpha) {
  using V = BodyVelocities<cl_RA>;
  return {over_common_denominator(map_of<cl_RA>([&](const V& v) { return meet_A(alpha, v); })),
          over_common_denominator(map_of<cl_RA>([&](const V& v) { return meet_B(alpha, v); }))};
}

/// Bits of the common denominator of the velocities after n cycles, before reduction to lowest terms.
cl_I exact_length(const IntegerContacts& contacts, const cl_I& n) {
  const cl_I cycle = contacts.with_A.denominator * contacts.with_B.denominator;
  return n * cl_I(static_cast<unsigned long>(cln::integer_length(cycle - 1)));
}

void require_cycle_index(const cl_I& n) {
  if (cln::minusp(n)) {
    throw InvalidInput("n must be 0 or more, got " + to_text(n));
  }
}

void require_positive(const cl_RA& alpha) {
  if (!cln::plusp(alpha)) {
    throw InvalidInput("alpha must be a positive finite number, got " + to_text(alpha));
  }
}

CycleVelocities<cl_RA> exact_velocities(const IntegerContacts& contacts, const cl_I& n) {
  if (cln::zerop(n)) {
    return {1, 0, 0, 0};
  }
  const auto& [with_A, with_B] = contacts;
  const cl_I cycle = with_A.denominator * with_B.denominator;
  const BodyVelocities<cl_I> before =
      apply_power(compose(with_B.numerators, with_A.numerators), n - 1, initial_velocities<cl_I>());
  const BodyVelocities<cl_I> at_P = apply(with_A.numerators, before);
  const BodyVelocities<cl_I> at_Q = apply(with_B.numerators, at_P);
  const cl_I below = cln::expt_pos(cycle, n);
  return {cl_RA(at_P.a) * with_B.denominator / below, cl_RA(at_Q.b) / below,
          cl_RA(at_P.c) * with_B.denominator / below, cl_RA(at_Q.c) / below};
}

/// alpha and n with what it takes to answer for them.
struct Question {
  MassRatio alpha;
  cl_I n;
  std::optional<cl_RA> rational;

  Question(const MassRatio& ratio, const cl_I& index)
      : alpha(ratio), n(index), rational(exact(ratio)) {
    require_cycle_index(n);
    if (rational) {
      require_positive(*rational);
    }
  }

  /// Bits that alpha's own size can take from or add to what is wanted.
  long length_of_alpha() const {
    return rational ? static_cast<long>(cln::integer_length(cln::numerator(*rational)) +
                                        cln::integer_length(cln::denominator(*rational)))
                    : 64;
  }
};

/// The exact velocities where they are short; this also settles exact zeros and decimal ties.
std::optional<CycleVelocities<cl_RA>> short_exact_velocities(const Question& question,
                                                             long longest) {
  if (!question.rational) {
    return std::nullopt;
  }
  const IntegerContacts contacts = integer_contacts(*question.rational);
  if (exact_length(contacts, question.n) > longest) {
    return std::nullopt;
  }
  return exact_velocities(contacts, question.n);
}

/// Doubles the guard bits until convert(Interval) -> optional<Value> gives an answer for each velocity. Intervals
/// widen by a few bits a squaring, the matrix is up to alpha^(+-1/2) in size: the start is generous. The cap is far
/// beyond what an alpha of that length can ask for unless a velocity is exactly zero.
template <class Value, class Convert>
CycleVelocities<Value> refined(const Question& question, long bits, const Convert& convert) {
  const Enclosure alpha = enclosure(question.alpha);
  const auto cycles = static_cast<long>(cln::integer_length(question.n));
  const long first_guard = 64 + 6 * cycles + 2 * question.length_of_alpha();
  const long last_guard = 64 * first_guard;
  for (long guard = first_guard; guard <= last_guard; guard *= 2) {
    const CycleVelocities<Interval> v = enclosed_velocities(alpha, question.n, bits + guard);
    const std::optional<Value> a = convert(v.a);
    const std::optional<Value> b = convert(v.b);
    const std::optional<Value> c = convert(v.c);
    const std::optional<Value> c_prime = convert(v.c_prime);
    if (a && b && c && c_prime) {
      return {*a, *b, *c, *c_prime};
    }
  }
  throw Undecided("a velocity at alpha = " + to_text(question.alpha) +
                  ", n = " + to_text(question.n) + " could not be told from zero with " +
                  std::to_string(bits + last_guard) + " bits");
}

}  // namespace

CycleVelocities<cl_RA> exact_velocities(const cl_RA& alpha, const cl_I& n) {
  require_positive(alpha);
  require_cycle_index(n);
  const IntegerContacts contacts = integer_contacts(alpha);
  const cl_I length = exact_length(contacts, n);
  if (length > longest_exact_velocity) {
    throw Undecided("the exact velocities have " + to_text(length) + " bits, more than the " +
                    std::to_string(longest_exact_velocity) +
                    " that are computed; ask for digits instead");
  }
  return exact_velocities(contacts, n);
}

CycleVelocities<Interval> enclosed_velocities(const Enclosure& alpha, const cl_I& n,
                                              long precision) {
  require_cycle_index(n);
  if (cln::zerop(n)) {
    return {1, 0, 0, 0};
  }
  const Interval ratio = alpha(precision);
  const BodyVelocities<Interval> before =
      apply_power(cycle_map(ratio), n - 1, initial_velocities<Interval>());
  const BodyVelocities<Interval> at_P = meet_A(ratio, before);
  const BodyVelocities<Interval> at_Q = meet_B(ratio, at_P);
  return {at_P.a, at_Q.b, at_P.c, at_Q.c};
}

CycleVelocities<cl_RA> velocities_within(const MassRatio& alpha, const cl_I& n, long bits) {
  if (bits < 1) {
    throw InvalidInput("the number of bits must be 1 or more, got " + std::to_string(bits));
  }
  const Question question(alpha, n);
  constexpr long short_length = 1L << 14;
  if (const auto velocities = short_exact_velocities(question, short_length)) {
    return *velocities;
  }
  return refined<cl_RA>(question, bits, [&](const Interval& v) -> std::optional<cl_RA> {
    if (v.sign() == Sign::open) {
      return std::nullopt;
    }
    const cl_RA low = v.low();
    const cl_RA high = v.high();
    const cl_RA smallest = cln::min(cln::abs(low), cln::abs(high));
    const bool close = v.sign() == Sign::zero || (high - low) * cln::ash(cl_I(1), bits) < smallest;
    return close ? std::optional(low) : std::nullopt;
  });
}

CycleVelocities<std::string> certified_digits(const MassRatio& alpha, const cl_I& n, int digits) {
  if (digits < 1) {
    throw InvalidInput("the number of digits must be 1 or more, got " + std::to_string(digits));
  }
  const Question question(alpha, n);
  // A tie at this many digits is a fraction no longer than about 4 bits a digit.
  const long short_length = std::max(1L << 14, 8L * (digits + 1L));
  if (const auto v = short_exact_velocities(question, short_length)) {
    return {to_decimal(v->a, digits), to_decimal(v->b, digits), to_decimal(v->c, digits),
            to_decimal(v->c_prime, digits)};
  }
  return refined<std::string>(
      question, 4L * digits, [&](const Interval& v) -> std::optional<std::string> {
        if (v.sign() == Sign::open) {
          return std::nullopt;
        }
        const std::string low = to_decimal(v.low(), digits);
        return low == to_decimal(v.high(), digits) ? std::optional(low) : std::nullopt;
      });
}

}  // namespace magicmass::reference
