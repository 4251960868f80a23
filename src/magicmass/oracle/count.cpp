// Large counts are found by bisection on the signs of closing speeds.
#include "magicmass/oracle/certain.hpp"

namespace magicmass::oracle {
namespace {

/// Nothing where the interval leaves it open.
std::optional<bool> closes(const Interval& speed) {
  const Sign sign = speed.sign();
  return sign == Sign::open ? std::nullopt : std::optional(sign == Sign::positive);
}

/// The search at one precision; nothing if some sign stayed open.
/// A collision is a reflection of (a, b, sqrt(alpha) c), so a cycle is a rotation by a fixed angle
/// 2 h about the direction of common motion, which closing speeds do not see. Before collisions 0,
/// 1, 2, ... these run as sin h, sin 2h, sin 3h, ..., positive up to the last collision, not so for
/// as many after it; A's after n cycles run as sin((2n+1) h). So n = 2^i up to the first failure
/// stays below the second zero, 2 pi, and the largest n with a positive one has its bits found from
/// the top; powers of one map commute, so in any order. Where a speed is exactly zero its sign
/// stays open unless all intervals are points: alpha = 1 is the one rational threshold.
std::optional<Counts> search(const Interval& alpha) {
  const Cycle<Interval> cycle = cycle_of(alpha);
  const auto A_closes = [](const Velocity<Interval>& v) { return closes(v(0) - v(2)); };
  Velocity<Interval> last(1, 0, 0);
  std::vector<Map<Interval>> powers{cycle.with_B * cycle.with_A};  // to the 2^i
  for (;;) {
    const std::optional<bool> meet = A_closes(powers.back() * last);
    if (!meet) return std::nullopt;
    if (!*meet) break;
    powers.push_back(powers.back() * powers.back());
  }
  cl_I cycles(0);
  for (auto i = static_cast<long>(powers.size()) - 2; i >= 0; --i) {
    const Velocity<Interval> v = powers[static_cast<std::size_t>(i)] * last;
    const std::optional<bool> meet = A_closes(v);
    if (!meet) return std::nullopt;
    if (*meet) {
      last = v;
      cycles = cycles + cln::ash(cl_I(1), i);
    }
  }
  // `last` is just before A's last collision; B may or may not be met once more after it.
  const Velocity<Interval> after = cycle.with_A * last;
  const std::optional<bool> meet_again = closes(after(2) - after(1));
  if (!meet_again) return std::nullopt;
  const cl_I N_A = cycles + 1;
  return Counts{N_A, *meet_again ? N_A : cycles};
}

}  // namespace

Counts count_collisions(const cl_RA& alpha) {
  const MassRatio source = ratio(alpha);
  // A squaring costs a few bits, up to n = alpha^(-1/2), and telling alpha from a threshold takes
  // what alpha's own digits take: the first precision mostly does.
  const long first = 16 + source.length;
  for (long precision = first; precision <= 64 * first; precision *= 2)
    if (const std::optional<Counts> counts = search(source.enclosed(precision))) return *counts;
  throw Undecided("alpha is closer to a threshold than " + std::to_string(64 * first) +
                  " bits can tell");
}

}  // namespace magicmass::oracle
