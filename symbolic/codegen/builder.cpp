// Makers of nodes: the choice of the cheapest operation, powers of two taken outside, ranges.
#include <algorithm>
#include <cmath>

#include "codegen/lower.hpp"
#include "codegen/operations.hpp"

namespace codegen {
namespace {
constexpr double largest_whole = 0x1p51;  // `nearest` of the runtime
const std::map<Op, Interval (*)(Interval)> ranges_of_functions{
    {Op::size, magnitude}, {Op::root, root},     {Op::reciprocal_root, reciprocal_root},
    {Op::sine, sine},      {Op::cosine, cosine}, {Op::arc_tangent, arc_tangent}};
}  // namespace

int Builder::add(Node n) {
  Key key{n.op, n.of, n.factor, n.op == Op::input ? n.name : kernel::digits(n.value), n.of_pi};
  const bool commutes = n.op == Op::sum || n.op == Op::product || n.op == Op::exact_sum ||
                        n.op == Op::cancelling_sum || n.op == Op::whole_sum;
  if (commutes) std::sort(std::get<1>(key).begin(), std::get<1>(key).end());
  if (const auto found = seen.find(key); found != seen.end()) return found->second;
  try {
    n.range = range_of(n);
  } catch (const Refused&) {
    if (numbers != Numbers::field) throw;
    n.range = {-infinity, infinity};  // a field's numbers are of any size
  }
  if (n.op == Op::power)
    n.least = least_power(numbers == Numbers::wide);  // which the program puts in place of less
  else if (n.range.least() > 0)
    n.least = n.range.least();
  else if (n.op == Op::product || n.op == Op::exact_product)
    n.least = program[n.of[0]].least * program[n.of[1]].least;
  // Up to there, and down to its inverse, no product, split or error of a product leaves the range.
  const double most = numbers == Numbers::doubles  ? 0x1p900
                      : numbers == Numbers::plain  ? 0x1p1000
                      : numbers == Numbers::single ? 0x1p120
                                                   : infinity;
  if (!(n.range.size() <= most) || (n.least > 0 && n.least < 1 / most))
    throw Refused("sizes from " + as_power_of_2(n.least) + " to " + as_power_of_2(n.range.size()) +
                  " may over- or underflow");
  program.nodes.push_back(n);
  return seen[key] = program.size() - 1;
}
Interval Builder::range_of(const Node& n) const {
  const auto of = [&](std::size_t i) { return program[n.of[i]].range; };
  switch (n.op) {
    case Op::input:
      return n.range;
    case Op::constant: {
      const double x = codegen::nearest(n.number());
      return !n.of_pi && is_double(n.value) ? Interval{x, x} : around(x, x);
    }
    case Op::exact_sum:
    case Op::whole_sum:
    case Op::sum:
    case Op::cancelling_sum:
      return of(0) + of(1);
    case Op::scale:
      return n.factor < 0 ? Interval{of(0).high * n.factor, of(0).low * n.factor}
                          : Interval{of(0).low * n.factor, of(0).high * n.factor};  // exact
    case Op::product:
    case Op::exact_product:
      return n.of[0] == n.of[1] ? magnitude(of(0)) * magnitude(of(0)) : of(0) * of(1);
    case Op::quotient:
      return of(0) / of(1);
    case Op::ceiling:
      return {std::ceil(of(0).low), std::ceil(of(0).high)};
    case Op::nearest: {
      const Interval ratio = of(0) / of(1);
      if (numbers == Numbers::doubles && !(ratio.size() < largest_whole))
        throw Refused("a ceiling that may be 2^51 or more");
      return {std::floor(ratio.low), std::ceil(ratio.high)};
    }
    case Op::power:
      return {0, 1};
    case Op::turn:
      return {-1, 1};
    case Op::step:
      return of(0) + Interval{-1, 0};
    default:
      return ranges_of_functions.at(n.op)(of(0));
  }
}

int Builder::input(const std::string& name, bool is_whole, Interval range, bool may_be_zero) {
  if (numbers == Numbers::doubles && is_whole && range.size() > largest_whole)
    throw Refused(name + " may be above 2^51");
  Node n{.op = Op::input, .is_exact = !is_plain(), .is_whole = is_whole, .name = name};
  n.formula = name;
  n.range = {may_be_zero ? 0 : range.low, range.high};
  n.least = range.least();
  return add(n);
}
int Builder::constant(const cln::cl_RA& value, bool of_pi) {
  const bool is_exact = !is_plain() && !of_pi && is_double(value);
  Node n{.op = Op::constant, .value = value, .of_pi = of_pi, .is_exact = is_exact};
  n.is_whole = is_exact && cln::denominator(value) == 1;
  return add(n);
}
int Builder::scaled(int x, double by) {
  if (by == 1) return x;
  const Node n = program[x];
  if (n.op == Op::scale) return scaled(n.of[0], by * n.factor);
  if (n.op == Op::constant) return constant(n.value * exact(by), n.of_pi);
  const bool is_whole = n.is_whole && std::fabs(by) >= 1;
  return add(
      {.op = Op::scale, .of = {x}, .factor = by, .is_exact = n.is_exact, .is_whole = is_whole});
}
int Builder::sum(int x, int y) {
  const Node& a = program[x];
  const Node& b = program[y];
  if (a.op == Op::constant && a.value == 0) return y;
  if (b.op == Op::constant && b.value == 0) return x;
  if (a.is_exact && b.is_exact) {
    const double largest = std::max(a.range.size(), b.range.size());
    const bool fits = numbers == Numbers::wide || largest < largest_whole;
    if (!fits || !a.is_whole || !b.is_whole) return add({.op = Op::exact_sum, .of = {x, y}});
    return add({.op = Op::whole_sum, .of = {x, y}, .is_exact = true, .is_whole = true});
  }
  const bool alike =
      (a.range.low >= 0 && b.range.low >= 0) || (a.range.high <= 0 && b.range.high <= 0);
  return add({.op = alike ? Op::sum : Op::cancelling_sum, .of = {x, y}});
}
int Builder::product(int x, int y) {
  if (program[x].is_exact) std::swap(x, y);
  return add({.op = program[y].is_exact ? Op::exact_product : Op::product, .of = {x, y}});
}
int Builder::quotient(int x, int y) { return add({.op = Op::quotient, .of = {x, y}}); }
int Builder::unary(Op op, int x) {
  if (program[x].is_exact && op == Op::size) {
    if (program[x].range.low >= 0) return x;
    throw Refused("the size of an exact number of unknown sign");
  }
  const Interval range = program[x].range;
  const bool turns = (op == Op::sine || op == Op::cosine) && range.size() > small_angle;
  if (turns && !is_plain() && !(range.low >= 0 && range.high <= 2.3561))
    throw Refused("an angle that is not known to be from 0 to 3 pi/4");
  return add({.op = op, .of = {x}});
}
int Builder::power(int x, int k) {
  const Interval base = program[x].range, exponent = program[k].range;
  if (!(base.low >= 0 && base.high <= 1 + 0x1p-40 && exponent.low >= 0) || !program[k].is_whole)
    throw Refused("a power of what is not known to be from 0 to 1, or of no whole number");
  return add({.op = Op::power, .of = {x, k}});
}
int Builder::turn(int k) {
  if (!program[k].is_whole) throw Refused("the turn of no whole number");
  return add({.op = Op::turn, .of = {k}, .is_exact = true, .is_whole = true});
}
int Builder::arc_tangent(int t, int square) {
  if (numbers != Numbers::wide && !(program[square].range.high <= 0x1.5555555555556p-2))
    throw Refused("an arctangent of what is not known to be at most 1/sqrt(3)");
  return add({.op = Op::arc_tangent, .of = {t, square}});
}

int Builder::rest(int p, int q, int k) {
  const Node divisor = program[q];  // a copy: products add nodes
  const int part = divisor.op == Op::scale ? product(divisor.of[0], scaled(k, -divisor.factor))
                                           : product(q, scaled(k, -1));
  // |p - q k| <= q/2, but for the rounding of p/q itself, which the test of the sign finds.
  const double more = divisor.range.high * 0.50000001;
  narrow(part, {-program[p].range.high - more, more - program[p].range.low});
  return sum(p, part);
}
void Builder::need_positive(const std::string& name, int k) {
  if (!program.has(Result::sign, k)) program.results.push_back({Result::sign, name, k});
}
int Builder::nearest(int p, int q) {
  const int k = add({.op = Op::nearest, .of = {p, q}, .is_exact = true, .is_whole = true});
  const int left = rest(p, q, k), size = unary(Op::size, left);
  const double half = program[q].range.high / 2;
  need_positive("to_next", sum(scaled(q, 0.5), scaled(size, -1)));
  narrow(size, {0, half});
  narrow(left, {-half, half});
  return k;
}
int Builder::ceiling(int p, int q, const cln::cl_RA& whole) {
  // With rest = p - q k and 0 < |rest| < q it is k + whole, and one more where rest > 0.
  const int k = nearest(p, q), left = rest(p, q, k);
  need_positive("distance", unary(Op::size, left));
  const int lower = add({.op = Op::step, .of = {k, left}, .is_exact = true, .is_whole = true});
  return sum(lower, constant(whole + 1));
}
}  // namespace codegen
