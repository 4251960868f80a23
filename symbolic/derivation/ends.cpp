// How three bodies of any masses end where their collisions do: velocities, and their order.
#include "derivation/wedge.hpp"

namespace derivation {
void ends(Book& book) {
  const Exprs assumptions = of_wedge({lt(0, e), lt(kappa(), 1), V_positive});
  book.chapter("ends", "Where collisions end", assumptions);
  const Expr N = fun("N_e", at_rest()), h = fun("h_e", masses_and_e());
  know(book["wedge.acute"]);
  const Theorem number = book["motion.N"];
  know(scaled(le(1, N), lt(h, pi() / 2), 1 / h, {number}));
  for (const Expr i : {N - 1, N}) know(at(book["wedge.signs"], {{j, i}}));

  const Names names{book, at_rest(), assumptions};
  const Theorem rest_is =
      names.name("delta_e", pi() - N * h, "The last collision leaves of half a turn");
  const Expr rest = left(rest_is);
  know(book.show("rest", "an angle that is not above that of the wedge:",
                 both({scaled(lt(0, rest), lt(N, pi() / h), h, {number, rest_is}),
                       scaled(le(rest, h), le(pi() / h, N + 1), h, {number, rest_is})})));
  const auto size = [&](Expr of_last, Expr angle) {  // of a speed that has the side of one kind
    return V * root_power(N) * of_last * (sin(angle) / sin(h));
  };
  const Expr last_side = is_Q(N) + is_P(N) * (r_A() / r_B());
  const Theorem parting_is =
      names.name("parting_e", sqrt(e) * size(last_side, rest), "The last two bodies part with");
  const Theorem opening_is =
      names.name("opening_e", size(side(N), h - rest),
                 "and the ball leaves the third body, or rests with it, with");
  const Expr parting = left(parting_is), opening = left(opening_is);
  // Collision N - 1 is the last, and there is no collision N.
  const auto after = [&](const Theorem& t) { return canonical_form(at(t, {{j, N - 1}})); };
  const Theorems from_last{after(part(at(book["multiples.pow"], {{y, sqrt(e)}}), 1)),
                           after(part(book["cycle.turn"], 1))};
  const auto approach_is = [&](Expr i, Expr angle, Expr value, const Theorem& definition) {
    const Theorem speed = at(book["motion.speed_sine"], {{j, i}});
    const Theorem turned_by = linear(eq((i + 1) * h, pi() - angle), {rest_is});
    return equation(eq(closing(i), value),
                    Theorems{rewrite(turned_by, speed), definition} + from_last, {pi(), rest, h});
  };
  const Theorem last = approach_is(N - 1, rest, parting / e, parting_is);
  const Theorem next = approach_is(N, rest - h, -opening, opening_is);
  know(sine_not_negative(h - rest));
  know(positive(equation(last_side, side(N - 1), from_last)));
  know(positive(parting_is));
  know(linear(le(0, opening), {opening_is, not_negative(right(opening_is))}));
  book.show("last", "for these are the approach speeds then:",
            both({linear(lt(0, parting)), linear(le(0, opening)), last, next}));

  const Theorem square = at(book["cycle.turn_squared"], {{j, N}});
  const Expr t = turn(N), A = velocity("A", N), B = velocity("B", N), C = velocity("C", N);
  const Expr C_B = is_Q(N) * opening + is_P(N) * parting;
  const auto of_last = [&](const char* id) { return after(from_rest(book, book[id])); };
  const auto beyond_B = [&](Expr v, const char* id, Expr value) {
    return equation(v, B + value, {solved_for(v, of_last(id)), last, next});
  };
  const Theorem A_is = beyond_B(A, "any_start.A_B", -(opening + parting));
  const Theorem C_is = beyond_B(C, "any_start.C_B", -C_B);
  const Expr mass = mass_of_all();
  know(positive(mass));
  const Theorem B_is = equation(B, w_B * (M_A * (V + opening + parting) + M_C * C_B) / mass,
                                {of_last("any_start.B_velocity"), last, next});
  book.show("B", "So B has at the end", B_is);
  book.show("A_and_C", "and A and the ball have", both({A_is, C_is}));
  for (const Expr& one : {1 + t, 1 - t}) {
    const Theorem share = linear(le(0, one), {square, not_negative(power(one, 2))});
    know(times(share, linear(lt(0, parting))));
    know(times(share, linear(le(0, opening))));
  }
  book.show("order", "in the order of the bodies:",
            linear(logic_and({le(A, C), le(C, B), le(0, B)}),
                   {A_is, C_is, B_is, not_negative(right(B_is))}));
}

// A wall in place of B, masses T^2 and 1: nearly pi T collisions, digits of pi for powers of ten.
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
