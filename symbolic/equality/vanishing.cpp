// A sum n of roots and cosines that is 0 divides 0 in the algebra of their equations: n q = 0, q
// being no 0 as a number. The powers of n are linearly dependent: q is what that leaves over n.
#include "equality/normal_form.hpp"

namespace equality {
using algebra::operator+;
using algebra::Theorem;
using algebra::Theorems;
using kernel::le;
using kernel::lt;
namespace {
constexpr int bits = 800, most_powers = 32, most_terms = 64;

const cln::cl_RA& step() {
  static const cln::cl_RA out = cln::cl_RA(1) / cln::ash(cln::cl_I(1), bits);
  return out;
}
cln::cl_RA rounded_down(const cln::cl_RA& q) { return cln::floor1(q / step()) * step(); }
}  // namespace

Enclosures::Bounds Enclosures::shown(Expr e, const cln::cl_RA& low, const cln::cl_RA& high,
                                     const Theorems& above, const Theorems& below) {
  const cln::cl_RA from = rounded_down(low), to = -rounded_down(-high);
  return {from, to, algebra::linear(le(from, e), above), algebra::linear(le(e, to), below)};
}
// x y = (x - a)(y - c) + a y + c x - a c, and c x is at least c a or c b.
Enclosures::Bounds Enclosures::product(Expr e, const Bounds& x, const Bounds& y) {
  const auto least = [](const cln::cl_RA& factor, const Bounds& of) {
    return factor * (factor < 0 ? of.high : of.low);
  };
  const cln::cl_RA low = least(x.low, y) + least(y.low, x) - x.low * y.low,
                   high = -least(-x.high, y) - least(-y.low, x) - x.high * y.low;
  const Theorems both{x.above, x.below, y.above, y.below};
  return shown(e, low, high, both + Theorems{algebra::times(x.above, y.above)},
               both + Theorems{algebra::times(x.below, y.above)});
}
Enclosures::Bounds Enclosures::inverse(Expr e, const Bounds& x) {
  if (x.low <= 0 && x.high >= 0) kernel::refuse("no bounds of " + kernel::text(e));
  const auto side = [&](Expr of) { return x.low > 0 ? lt(0, of) : lt(of, 0); };
  const Theorem sign = algebra::linear(side(e.arg(0)), {x.above, x.below});
  const Theorem same = algebra::certified(side(e), {.products = {{1}}, .multipliers = {sign}});
  const Theorem unit = algebra::equation(e * e.arg(0), 1, {sign});
  return shown(e, 1 / x.high, 1 / x.low, {unit, algebra::times(x.below, same)},
               {unit, algebra::times(x.above, same)});
}
Enclosures::Bounds Enclosures::of(Expr e) {
  if (const auto it = known.find(e); it != known.end()) return it->second;
  return known.emplace(e, found(e)).first->second;
}
Enclosures::Bounds Enclosures::found(Expr e) {
  if (e.op() == Op::Num) return shown(e, e.value(), e.value(), {}, {});
  if (is_call(e, "inv")) return inverse(e, of(e.arg(0)));
  if (e.op() == Op::Fun || e.size() == 0) {
    const Expr plain = algebra::reduced(e, facts);
    if (plain == e) kernel::refuse("no bounds of " + kernel::text(e));
    const Bounds same = of(plain);
    const Theorem is = algebra::equation(e, plain, facts);
    return shown(e, same.low, same.high, {is, same.above}, {is, same.below});
  }
  const Exprs parts = e.op() == Op::Pow ? Exprs(std::size_t(e.exponent()), e.arg(0)) : e.args();
  Bounds out = of(parts[0]);
  Expr so_far = parts[0];
  for (std::size_t i = 1; i < parts.size(); ++i) {
    const Bounds next = of(parts[i]);
    so_far = e.op() == Op::Add ? so_far + parts[i] : so_far * parts[i];
    out = e.op() != Op::Add ? product(so_far, out, next)
                            : shown(so_far, out.low + next.low, out.high + next.high,
                                    {out.above, next.above}, {out.below, next.below});
  }
  return out;
}
Theorem Enclosures::sign(Expr e) {
  const Bounds is = of(e);
  return algebra::linear(is.low > 0 ? lt(0, e) : lt(e, 0), {is.above, is.below});
}
void Enclosures::add_root(const Theorem& is, const Theorems& sign) {
  const Expr root = kernel::canonical(algebra::left(is).arg(0));
  const int n = algebra::left(is).exponent();
  const Bounds base = of(algebra::right(is));
  cln::cl_RA low = rounded_down(enclosure(root, 2 * bits).low()), high = low + step();
  if (n % 2 == 0 && base.low < 0) kernel::refuse("an even root of what may be negative");
  for (cln::cl_RA by = step(); cln::expt(low, n) > base.low; by = 2 * by)
    low = n % 2 == 0 && low < by ? cln::cl_RA(0) : low - by;
  for (cln::cl_RA by = step(); cln::expt(high, n) < base.high; by = 2 * by) high = high + by;
  const auto by_base = [&](Expr goal) {
    return algebra::by_powers(goal, n, sign + Theorems{is, base.above, base.below});
  };
  known.insert_or_assign(root, Bounds{low, high, by_base(le(low, root)), by_base(le(root, high))});
}
void Enclosures::add_cosine(int d, const Theorem& is) {
  const int known_part = d > 12 ? 12 : 6;  // the next zero, cos(3 pi/d), is below its cosine
  const Expr c = kernel::cos(kernel::pi() / d);
  const Theorem falls =
      algebra::cosine_falls(algebra::linear(lt(kernel::pi() / d, kernel::pi() / known_part)));
  const Theorem cosine = algebra::part_of_pi(known_part)->cosine;
  for (Expr part : parts_of(algebra::right(cosine)))
    if (is_call(part, "sqrt"))
      add_root(algebra::root_squared(algebra::not_negative(part.arg(0))),
               {algebra::not_negative(part)});
  const Bounds root = of(algebra::right(cosine));
  const Theorem from = algebra::linear(lt(root.low, c), {falls, cosine, root.above});
  std::vector<cln::cl_RA> p(std::size_t(algebra::left(is).exponent() + 1), 0);
  for (const auto& [monomial, q] : kernel::polynomial(algebra::gap(is)))
    p[std::size_t(kernel::degree(monomial, c))] = -q;
  // p(c) = (c - q) m(c) + p(q) = 0, where all coefficients of m are positive in powers of c - low.
  const auto beside = [&](const cln::cl_RA& q) {
    std::vector<cln::cl_RA> m = p;
    for (std::size_t i = m.size() - 1; i-- > 0;) m[i] = m[i] + q * m[i + 1];
    const cln::cl_RA rest = m[0];
    m.erase(m.begin());
    Expr quotient = 0, power = 1;
    for (std::size_t k = 0; k < m.size(); ++k) {
      for (std::size_t i = m.size() - 1; i-- > k;) m[i] = m[i] + root.low * m[i + 1];
      quotient = quotient + Expr(m[k]) * power;
      power = power * (c - Expr(root.low));
    }
    return algebra::certified(
        rest > 0 ? le(c, q) : le(q, c),
        {.equations = {{rest > 0 ? 1 : -1,
                        algebra::equation((c - Expr(q)) * quotient, -rest, {is})}},
         .products = {{cln::abs(rest)}},
         .multipliers = {algebra::positive(quotient, {from})}});
  };
  const cln::cl_RA low = rounded_down(enclosure(c, 2 * bits).low()), high = low + 2 * step();
  known.insert_or_assign(c, Bounds{low, high, beside(low), beside(high)});
}

Theorem vanishes(Expr sum, const Theorems& facts, Enclosures& bounds) {
  bounds.of(sum);  // where that is not known, powers need not be dependent
  Exprs powers{1, sum};
  Theorems zeros;
  std::optional<Theorem> dependent;
  while (!dependent) {
    if (powers.size() > most_powers || kernel::polynomial(powers.back()).size() > most_terms)
      kernel::refuse("too many powers");
    zeros.push_back(kernel::assume(kernel::eq(powers.back(), 0)));
    powers.push_back(algebra::reduced(sum * powers.back(), facts));
    dependent = algebra::combination(kernel::eq(powers.back(), 0), zeros);
  }
  Expr other = powers[powers.size() - 2];
  const kernel::Certificate found = *dependent->step().certificate;
  for (const auto& [factor, zero] : found.equations)
    for (std::size_t i = 0; i < zeros.size(); ++i)
      if (zeros[i].conclusion() == zero.conclusion()) other = other - factor * powers[i];
  other = kernel::canonical(other);
  const Theorem product = algebra::equation(sum * other, 0, facts);
  const Theorem sign = bounds.sign(other);
  const int side = sign.conclusion().arg(0) == other ? -1 : 1;
  return algebra::certified(kernel::eq(sum, 0),
                            {.equations = {{side, product}}, .multipliers = {sign}});
}
}  // namespace equality
