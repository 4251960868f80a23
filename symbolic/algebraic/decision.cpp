// SPDX-License-Identifier: GPL-2.0-or-later
#include "algebraic/decision.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "algebraic/expansion.hpp"
#include "algebraic/separation_bound.hpp"

namespace magicmass::algebraic {
namespace {

constexpr double digits_per_bit = 0.30102999566398120;

std::string power_of_ten(double bits) {
  return "1e-" + std::to_string(static_cast<long>(std::ceil(bits * digits_per_bit)));
}

/// Evaluates to rising precision, and remembers how close to 0 the term is known to be.
class Refinement {
public:
  Refinement(const Terms& terms, std::size_t id, const Work& work)
      : terms_(terms), id_(id), work_(work) {}

  /// The sign, if it shows at this precision.
  std::optional<int> sign_at(long precision) {
    precision_ = precision;
    try {
      const Interval value = terms_.enclosure(id_, precision, work_);
      if (value.sign() != 2) return value.sign();
      below_ = std::max(below_, -value.top());
    } catch (const Unbounded&) {  // a divisor, known not to be 0, is not yet seen to be
    }
    return {};
  }

  long precision() const { return precision_; }
  /// The term is at most 2^-below() in absolute value.
  long below() const { return below_; }
  long agreeing_digits() const {
    return std::max(0L,
                    static_cast<long>(std::floor(static_cast<double>(below_) * digits_per_bit)));
  }

private:
  const Terms& terms_;
  std::size_t id_;
  const Work& work_;
  long precision_ = 0;
  long below_ = -(1L << 50U);
};

Verdict by_intervals(int sign, long precision) {
  if (sign == 0 || precision == 0) return {sign, "exact arithmetic with rational numbers"};
  const auto digits = static_cast<long>(static_cast<double>(precision) * digits_per_bit);
  return {sign, "interval arithmetic at " + std::to_string(digits) + " digits"};
}

Verdict search(Terms& terms, std::size_t id, const Work& work) {
  Refinement refinement(terms, id, work);
  try {
    for (const long precision : {128L, 256L})
      if (const auto sign = refinement.sign_at(precision)) return by_intervals(*sign, precision);
    if (auto method = proof_of_zero(terms, id, work)) return {0, std::move(*method)};
    const std::optional<SeparationBound> bound = separation_bound(terms, id, work.budget());
    for (long precision = 512;;) {
      if (precision > work.budget().bits)
        throw BeyondBudget(
            "more than " + std::to_string(work.budget().bits) + " bits" +
            (bound ? ", for a separation bound of " + power_of_ten(bound->bits) : ""));
      if (const auto sign = refinement.sign_at(precision)) return by_intervals(*sign, precision);
      if (bound && static_cast<double>(refinement.below()) > bound->bits)
        return {0, "separation bound: an algebraic number of degree at most " +
                       std::to_string(static_cast<long>(bound->degree)) +
                       " made like this one is 0 or larger than " + power_of_ten(bound->bits) +
                       ", and this one is smaller"};
      // Once a zero is likely, straight to the precision that proves it.
      const double missing =
          bound ? bound->bits - static_cast<double>(refinement.below()) + 64 : 1e9;
      precision += std::min(precision, static_cast<long>(std::min(missing, 1e9)));
    }
  } catch (const BeyondBudget& reason) {
    throw SignLeftOpen(reason.what(), refinement.agreeing_digits());
  }
}

}  // namespace

Verdict decide(Terms& terms, std::size_t id, const Work& work) {
  if (const auto sign = terms[id].sign)
    return by_intervals(*sign, terms[id].kind == Kind::rational ? 0 : near_precision);
  Verdict verdict = search(terms, id, work);
  terms.set_sign(id, verdict.sign);
  return verdict;
}

}  // namespace magicmass::algebraic
