// SPDX-License-Identifier: MIT
#include "magicmass/numbers/ladder.hpp"

#include <array>
#include <charconv>

#include "magicmass/numbers/accurate.hpp"
#include "magicmass/numbers/counts.hpp"
#include "magicmass/numbers/fast.hpp"

namespace magicmass {
namespace numbers {
namespace {
/// Below, N_A > pi/sqrt(8 alpha) - 3/2 is above 2^63: h < sqrt(2 alpha).
constexpr double too_many_below = 0x1p-126;
/// Counts have so many bits that two doubles leave nearly every row open.
constexpr double slow_settles_few_below = 0x1p-84;

/// The first certain answer of the tiers from this one on.
template <class Value, class... Arguments>
Value certain(bool (*const (&tiers)[4])(Value&, Arguments...), int tier, Arguments... arguments) {
  Value value{};
  while (!tiers[tier](value, arguments...)) ++tier;
  return value;
}
/// Counts of 2^63 or more are INT64_MAX.
[[gnu::noinline]] std::optional<Terminal> settled_terminal(Tier tier, double alpha) {
  if (!is_mass_ratio(alpha) || alpha < too_many_below) return std::nullopt;
  return certain(kernels().terminal, alpha < slow_settles_few_below ? by_mpfr : tier + 1, alpha);
}
/// Each is the largest integer there is where it is that or more.
Counts counts_or_most(double alpha) {
  Counts c;
  if (kernels().counts(c, alpha)) return c;
  const std::optional<Terminal> t = settled_terminal(fast, alpha);
  return t ? t->counts : Counts{INT64_MAX, INT64_MAX};
}
[[gnu::noinline]] std::optional<Velocities> open_velocities(Tier tier, double alpha,
                                                            std::int64_t n) {
  if (!is_mass_ratio(alpha) || n < 0) return std::nullopt;
  if (n == 0) return Velocities{1, 0, 0, 0};
  if (n > counts_or_most(alpha).N_A) return std::nullopt;
  return certain(kernels().velocities, tier + 1, alpha, n);
}

void check(double alpha, const char* name = "alpha") {
  if (!is_mass_ratio(alpha))
    throw InvalidInput(std::string(name) + " must be positive and finite, got " + text_of(alpha));
}
[[noreturn]] void refuse_cycle(double alpha, std::int64_t n) {
  check(alpha);
  const std::int64_t N_A = counts_or_most(alpha).N_A;
  throw InvalidInput("n must be from 0 to N_A" +
                     (N_A == INT64_MAX ? "" : " = " + std::to_string(N_A)) + ", got " +
                     std::to_string(n));
}
Collision collision(Tier tier, double alpha, std::int64_t j) {
  Collision c;
  if (kernels().collision[tier](c, alpha, j)) return c;
  check(alpha);
  if (j == 0) return {0, 1};
  const Counts counts = counts_or_most(alpha);
  const std::uint64_t last = std::uint64_t(counts.N_A) + std::uint64_t(counts.N_B) - 1;
  if (j < 0 || std::uint64_t(j) > last)
    throw InvalidInput("j must be from 0 to N_A + N_B - 1" +
                       (counts.N_A == INT64_MAX ? "" : " = " + std::to_string(last)) + ", got " +
                       std::to_string(j));
  return certain(kernels().collision, tier + 1, alpha, j);
}
void check(const Masses& masses, double e) {
  check(masses.ball, "ball");
  if (!(masses.per_B == 0.0 || is_mass_ratio(masses.per_B)))
    throw InvalidInput("per_B must be finite and not negative, got " + text_of(masses.per_B));
  if (!(e > 0.0 && e <= 1.0))
    throw InvalidInput("e must be above 0 and at most 1, got " + text_of(e));
}
double angle(Tier tier, double alpha) {
  check(alpha);
  return certain(kernels().angle, tier, alpha);
}
Ratios ratios(Tier tier, std::int64_t k) {
  if (k < 1) throw InvalidInput("k must be 1 or more, got " + std::to_string(k));
  return {k == 1 ? 1.0 : certain(kernels().magic, tier, k), certain(kernels().deficient, tier, k)};
}
// Results are written once, where they are returned: to copy them at once is slow.
Velocities velocities_or_throw(Tier tier, double alpha, std::int64_t n) {
  Velocities v;
  if (!kernels().velocities[tier](v, alpha, n)) [[unlikely]] {
    const std::optional<Velocities> settled = open_velocities(tier, alpha, n);
    if (!settled) refuse_cycle(alpha, n);
    v = *settled;
  }
  return v;
}
std::optional<Terminal> terminal_or_throw(Tier tier, double alpha) {
  std::optional<Terminal> t = terminal(tier, alpha);
  if (!t) check(alpha);
  return t;
}
}  // namespace

std::string text_of(double x) {
  std::array<char, 32> text{};
  return {text.data(), std::to_chars(text.data(), text.data() + text.size(), x).ptr};
}
std::optional<Velocities> velocities(Tier tier, double alpha, std::int64_t n) {
  std::optional<Velocities> v(std::in_place);
  if (!kernels().velocities[tier](*v, alpha, n)) v = open_velocities(tier, alpha, n);
  return v;
}
std::optional<Terminal> terminal(Tier tier, double alpha) {
  std::optional<Terminal> t(std::in_place);
  if (kernels().terminal[tier](*t, alpha)) [[likely]]
    return t;
  t = settled_terminal(tier, alpha);
  return t && t->counts.N_A <= INT64_MAX - t->counts.N_B ? t : std::nullopt;
}
}  // namespace numbers

Velocities accurate::velocities(double alpha, std::int64_t n) {
  return numbers::velocities_or_throw(numbers::accurate, alpha, n);
}
Velocities fast::velocities(double alpha, std::int64_t n) {
  return numbers::velocities_or_throw(numbers::fast, alpha, n);
}
std::optional<Terminal> accurate::terminal(double alpha) {
  return numbers::terminal_or_throw(numbers::accurate, alpha);
}
std::optional<Terminal> fast::terminal(double alpha) {
  return numbers::terminal_or_throw(numbers::fast, alpha);
}
std::optional<Terminal> fast::terminal(double alpha, double e) {
  numbers::check(alpha);
  return e == 1.0 ? terminal(alpha) : terminal(Masses{alpha}, e);
}
std::optional<Terminal> fast::terminal(const Masses& masses, double e) {
  numbers::check(masses, e);
  Terminal t;
  Collapse endless;  // or else, but where it is near, MPFR alone would know
  if (numbers::kernels().restitution(t, masses, e)) return t;
  if (!numbers::kernels().collapse(endless, masses, e) &&
      numbers::restitution_by_mpfr(t, masses, e))
    return t;
  return std::nullopt;
}
std::optional<Collapse> accurate::collapse(double alpha, double e) {
  numbers::check(alpha);
  return collapse(Masses{alpha}, e);
}
std::optional<Collapse> accurate::collapse(const Masses& masses, double e) {
  numbers::check(masses, e);
  Collapse c;
  Terminal ended;
  if (numbers::kernels().collapse(c, masses, e)) return c;
  if (!numbers::kernels().restitution(ended, masses, e) && numbers::collapse_by_mpfr(c, masses, e))
    return c;
  return std::nullopt;
}
Collision accurate::collision(double alpha, std::int64_t j) {
  return numbers::collision(numbers::accurate, alpha, j);
}
Collision fast::collision(double alpha, std::int64_t j) {
  return numbers::collision(numbers::fast, alpha, j);
}
double accurate::angle(double alpha) { return numbers::angle(numbers::accurate, alpha); }
double fast::angle(double alpha) { return numbers::angle(numbers::fast, alpha); }
Ratios accurate::ratios(std::int64_t k) { return numbers::ratios(numbers::accurate, k); }
Ratios fast::ratios(std::int64_t k) { return numbers::ratios(numbers::fast, k); }

std::optional<Counts> count_collisions(double alpha) {
  numbers::check(alpha);
  const Counts c = numbers::counts_or_most(alpha);
  return c.N_A <= INT64_MAX - c.N_B ? std::optional(c) : std::nullopt;
}
}  // namespace magicmass
