// Inverse angles: 2 atan(x) and asin(2x/(1 + x^2)) are one angle up to turns: a point decides.
#include "equality/normal_form.hpp"

namespace equality {
namespace {
constexpr int most_parts = 12;  // q of q (left - right), a whole number of turns

// Of all multiples of angles, 0 where there are none.
int common_denominator(const Sum& sum) {
  cln::cl_I parts = 1;
  bool has_angles = false;
  for (const auto& [product, q] : sum) {
    if (product.size() != 1 || product.begin()->second != exponent(1)) continue;
    const Expr e = product.begin()->first;
    has_angles = has_angles || is_arcus(e);
    if (is_arcus(e) || e == kernel::pi()) parts = cln::lcm(parts, cln::denominator(q));
  }
  return has_angles && parts <= most_parts ? cln::cl_I_to_int(parts) : 0;
}
// Where the requirements hold is the inside of a box, or of what is convex in it, or has with each
// point the way to 0, and a point there, with any part of its boundary.
bool is_connected(const Domain& domain, const std::vector<Requirement>& needs,
                  const std::vector<Requirement>& shape, const std::vector<Point>& inside) {
  Domain box = narrowed(narrowed(domain, shape), needs);
  for (auto& [symbol, range] : box.ranges) {
    if (range.is_integer) return false;
    if (range.is_point()) continue;
    if (range.low) range.low->is_inside = false;
    if (range.high) range.high->is_inside = false;
  }
  const auto is_within = [&](const Point& point) {
    return std::ranges::all_of(
        box.ranges, [&](const auto& of) { return of.second.contains(point.at(of.first)); });
  };
  if (!shape.empty() && std::ranges::none_of(inside, is_within)) return false;
  Forms forms(box);
  for (const Requirement& r : shape) forms.assume(r);
  return std::ranges::all_of(needs, [&](const Requirement& r) { return forms.holds(r); });
}
// An inequality of this kind leaves of a box what is convex.
bool is_affine(Expr e, const Domain& box) {
  Forms forms(box);
  return std::ranges::all_of(forms.of(e), [&](const auto& term) {
    const Expr product = forms.expression(Sum{{term.first, 1}});
    return box.ranges.contains(product) || kernel::free_variables(product).empty();
  });
}
// And of c + h, c positive, h homogeneous, what has with each point the way to 0.
bool leads_to_0(Expr e, const Domain& box) {
  Forms forms(box);
  Sum constant;
  std::set<int> degrees;
  for (const auto& [product, q] : forms.of(e)) {
    int degree = 0;
    for (const auto& [atom, power] : product) {
      if (kernel::free_variables(atom).empty() && number_of(power)) continue;
      const int k = box.ranges.contains(atom) ? whole_number(power).value_or(0) : 0;
      if (k <= 0) return false;
      degree += k;
    }
    if (degree == 0)
      constant[product] = q;
    else
      degrees.insert(degree);
  }
  return degrees.size() == 1 && forms.is_positive(constant);
}
}  // namespace

bool is_same_angle(Expr left, Expr right, const Domain& domain, const std::vector<Point>& common) {
  if (common.empty()) return false;
  return is_proved([&] {
    Domain box;
    for (Expr x : kernel::free_variables(left - right)) box.ranges[x] = domain.ranges.at(x);
    const std::vector<Requirement> needs = requirements(left - right, box);
    std::vector<Requirement> shape = conditions(domain);
    const auto fits = [&](auto rule) {
      return [rule, &box](const Requirement& r) {
        const bool has_two_sides = r.kind == Need::NotZero;
        return !has_two_sides && is_proved([&] { return rule(r.term, box); });
      };
    };
    std::vector<Point> inside = common;
    const bool is_convex = std::ranges::all_of(shape, fits(is_affine));
    if (!is_convex && std::ranges::all_of(shape, fits(leads_to_0))) {
      inside.resize(1);
      for (auto& [symbol, value] : inside[0]) value = 0;
    } else {
      std::erase_if(shape, std::not_fn(fits(is_affine)));
    }
    Forms forms(narrowed(box, shape));
    for (const Requirement& r : needs) forms.assume(r);
    for (const Requirement& r : shape) forms.assume(r);
    const Sum difference = forms.of(left) - forms.of(right);
    const int parts = common_denominator(difference);
    if (parts == 0 || !forms.is_whole_turns(scaled(difference, parts))) return false;
    if (!is_connected(box, needs, shape, inside)) return false;
    const Ball there = enclosure(at(common[0], left - right), 128);
    const cln::cl_RA turn = cln::cl_RA(6) / parts;
    return there.high() < turn && there.low() > -turn;
  });
}

Expr with_one_angle(Expr left, Expr right, const Domain& domain, const std::vector<Point>& common) {
  kernel::Substitution same;
  const auto try_multiple = [&](Expr angle, Expr other, const cln::cl_RA& q) {
    Expr guess = Expr(q) * other;
    const Ball rest = enclosure(at(common[0], angle - guess) / kernel::pi(), 128);
    const auto halves = near_fraction(rest.low(), 2);
    if (!halves) return false;
    if (*halves != 0) guess = guess + Expr(*halves) * kernel::pi();
    return is_same_angle(angle, guess, domain, common) && same.emplace(angle, guess).second;
  };
  for (Expr angle : parts_of(right))
    for (Expr other : parts_of(left))
      for (const int halves : {2, 4, 1, -2, -4, -1}) {
        const bool are_angles = is_arcus(angle) && is_arcus(other) && angle != other;
        if (!are_angles || same.contains(angle) || common.empty()) break;
        is_proved([&] { return try_multiple(angle, other, cln::cl_RA(halves) / 2); });
      }
  for (const auto& [angle, guess] : same) right = kernel::replace(right, angle, guess);
  return right;
}
}  // namespace equality
