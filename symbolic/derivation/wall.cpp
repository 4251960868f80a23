// A wall in place of B, masses T^2 and 1: nearly pi T collisions, digits of pi for powers of ten.
#include "derivation/wedge.hpp"

namespace derivation {
void wall(Book& book) {
  book.chapter("wall", "A wall, and digits of pi", {V_positive});
  const Expr T = real("T");
  const Known large({assume(le(1, T))});
  const auto here = [&](const char* id) {
    return at(book[id], {{M_A, power(T, 2)}, {w_B, 0}, {M_C, 1}, {e, 1}});
  };
  const Theorem kappa_is = here("wedge.kappa"), r = here("wedge.r_A");
  const Expr kappa = left(kappa_is), share = right(r).arg(0);
  const Theorem no_share = here("wedge.r_B");
  const Theorem all = rewrite(equation(right(no_share).arg(0), 1), no_share);
  const Theorem root = equation(kappa, sqrt(share), {kappa_is, r, all});
  const Theorem square = equation(power(kappa, 2), share, {root});
  know(positive(root));
  const Theorem rest = positive(equation(1 - power(kappa, 2), 1 / (power(T, 2) + 1), {square}));
  know(scaled(lt(kappa, 1), lt(power(kappa, 2), 1), 1 / (1 + kappa), {rest}));
  const Theorem sine = root_is(1 - power(kappa, 2), kappa / T, {square});
  const Theorem angle = rewrite(equation(left(sine) / kappa, 1 / T, {sine}), here("wedge.h_e"));
  book.show("angle_T", "With masses T^2 and 1, and nothing lost, the angle has the tangent 1/T,",
            angle);
  const Theorem number = here("motion.N");
  const Expr h = left(angle), N = left(number);
  know(positive(angle));
  const Expr quarter = atan(1);  // the angle whose tangent is 1 is pi/4
  const Theorem right_angle =
      equation(cos(2 * quarter), cos(pi() / 2), {at("cos atan", {{x, 1}})}, {quarter, pi() / 2});
  const Theorem at_most_4 = linear(
      le(pi(), 4), {same_angle(right_angle, {positive(quarter)}), at("atan bounds", {{x, 1}})});
  const Theorem near = at("atan bounds", {{x, 1 / T}});
  const Theorem from = times(linear(le(0, 1 / T - h), {angle, near}), pi() * T / h);
  const Theorem many = linear(le(pi() * T - 1, N), {number, from});
  const Expr u = 1 / T;
  const Theorem product =
      times(linear(le(0, h - u + power(u, 3) / 3), {angle, near}), pi() * T + 2 * u);
  const Theorem to = linear(le(pi(), (pi() * T + 2 * u) * h),
                            {product, times(at_most_4, power(u, 2)),
                             times(scaled(le(u, 1), le(1, T), u), (1 + u) * power(u, 2))});
  know(book.show("number_T", "so that the number of collisions is near pi T:",
                 both({many, linear(lt(N, pi() * T + 2 * u), {number, times(to, 1 / h)})})));
  book.show("digits",
            "It is pi T rounded down, unless pi T is less than 2/T below the next integer: for T a "
            "power of ten the first digits of pi, unless about as many nines follow them.",
            linear(imp(logic_and({lt(k, pi() * T), le(pi() * T + 2 * u, k + 1)}), eq(N, k))));
}
}  // namespace derivation
