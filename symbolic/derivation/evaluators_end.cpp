// Evaluated forms of the terminal velocities and counts.
#include "derivation/symbols.hpp"

namespace derivation {
void end_forms(Book& book) {
  book.chapter("evaluators_end", "Forms for evaluation: terminal velocities",
               {alpha_positive, V_positive});
  const Angle a = evaluated_angle(book);
  const Names f{book, {alpha, V}, {alpha_positive, V_positive}};
  const Theorem h = book.define("h", {alpha}, 2 * of_alpha("half_h"), {alpha_positive}, "With");
  const Theorem psi_is = linear(eq(psi(), 2 * of_alpha("h")), {h, a.quarter});
  const Theorem h_is = linear(eq(of_alpha("h"), psi() / 2), {psi_is});
  know(linear(lt(0, of_alpha("h")), {psi_is}));
  const Theorem quotient = equation(pi() / psi(), pi() / (2 * of_alpha("h")), {h_is});
  for (const auto& [name, shift] : {std::pair{"N_A", rational(1, 2)}, {"N_B", Expr(1)}})
    book.show(name, name == std::string("N_A") ? "the counts are" : "and",
              restate(eq(f(name), ceil(pi() / (2 * of_alpha("h")) - shift)),
                      rewrite(quotient, book["counting." + std::string(name)])));

  const Expr angle = N_A() * psi() / 2, r = pi() / 2 - angle;
  const Theorem def_rest = f.name("rest", sqrt(power(pi() / 2 - of_alpha("h") * N_A(), 2)),
                                  "What is left of a quarter turn:");
  const Theorem rest_is = restate(eq(f("rest"), sqrt(power(r, 2))), rewrite(h_is, def_rest));
  const Theorem def_sine = f.name("rest_sine", sin(f("rest")));
  const Theorem def_cosine = f.name("rest_cosine", cos(f("rest")));
  const Theorems of_name{f.name("t_cosine", of_alpha("t") * f("rest_cosine")),
                         f.name("w_cosine", of_alpha("w") * f("rest_cosine")),
                         f.name("t_plus", f("t_cosine") + f("rest_sine")),
                         f.name("t_minus", f("t_cosine") - f("rest_sine")),
                         f.name("w_plus", f("w_cosine") + f("rest_sine")),
                         f.name("b_form", 2 * f("w_plus") * f("t_cosine"))};
  const auto size_of_rest = [&](Expr value, const Theorem& sign) {
    return chain(rest_is, root_of(equation(power(value, 2), power(r, 2)), sign));
  };

  // Q_n last: r > 0; P_n last: r <= 0.
  const auto in_case = [&](bool Q_last) {
    const Expr z = 2 * pi() / psi(), count = Q_last ? 2 * N_A() : 2 * N_A() - 1;
    return given(eq(N(), count), [&](const Theorem& N_is) {
      const Theorem end =
          at(book[Q_last ? "terminal.after_Q" : "terminal.after_P"], {{n, N_A()}}, {N_is});
      const Theorem bound =
          linear(Q_last ? lt(0, z - 2 * N_A()) : le(0, 2 * N_A() - z), {N_is, book["counting.N"]});
      const Expr value_is = Q_last ? r : -r;
      const Theorem sign = linear(le(0, value_is), {times(bound, psi())});
      const Theorem size = size_of_rest(value_is, sign);
      const Exprs quarter_turn{pi() / 2, angle};
      const Theorem sine = equation(f("rest_sine"), Q_last ? cos(angle) : -cos(angle),
                                    {rewrite(size, def_sine)}, quarter_turn);
      const Theorem cosine =
          equation(f("rest_cosine"), sin(angle), {rewrite(size, def_cosine)}, quarter_turn);
      const auto value = [&](std::size_t i, const std::string& id, Expr index, Expr goal) {
        const Theorem is = part(end, i);
        const Theorem form = at(book["power." + id], {{n, index}});
        return equation(left(is), V * goal, Theorems{is, form, sine, cosine} + of_name + a.rules,
                        {angle, psi() / 4});
      };
      return both({value(2, "a_product", N_A(), -f("t_minus") * f("t_plus")),
                   value(3, "b_product", Q_last ? N_A() : N_A() - 1, f("b_form")),
                   value(4, Q_last ? "c_prime_product" : "c_product", N_A(),
                         2 * f("t_minus") * f("w_cosine"))});
    });
  };
  const Theorem Q = in_case(true), P = in_case(false);
  const Theorem terminal =
      book.show("terminal", "The terminal velocities are, whichever collision is the last,",
                tautology(right(Q), {Q, P, book["terminal.last"]}));
  const Expr V_lead = 2 * V_CM(), next = psi() / 4 - f("rest");
  book.show("rest", "As products, with what is left by psi,", rest_is);
  const auto as_product = [&](std::size_t i, const std::string& name, Expr value) {
    const Theorem is = part(terminal, i);
    book.show(name, "and",
              equation(left(is), value, Theorems{is, def_sine, def_cosine} + of_name + a.rules,
                       {psi() / 4, f("rest")}));
  };
  as_product(0, "a_product", -V_lead * (1 + alpha) * sin(next) * sin(psi() / 4 + f("rest")));
  as_product(1, "b_product", V_lead * (1 + alpha) * cos(f("rest")) * cos(psi() / 2 - f("rest")));
  as_product(2, "c_product", V_lead * cos(f("rest")) * sin(next) / sin(psi() / 4));
  f.name("rho", power(f("b_t") / V, 2), "and B has of the energy the fraction");

  // |r| <= h/2, so sin|r| <= tan(h/2) cos(r).
  const Expr half_h = of_alpha("h") / 2, z = pi() / psi(), half = rational(1, 2), q = psi() / 4;
  const Theorems count{book["counting.N_A"], psi_is};
  const Theorem r_up = scaled(le(r, half_h), le(z, N_A() + half), psi(), count);
  const Theorem r_down = scaled(le(-r, half_h), le(N_A(), z + half), psi(), count);
  const Expr bounds_of_rest = logic_and({le(0, f("rest")), le(f("rest"), half_h)});
  const auto with_sign = [&](Expr sign, Expr value_is) {
    return given(sign, [&](const Theorem& t) {
      const Theorem is = size_of_rest(value_is, linear(le(0, value_is), {t}));
      return linear(bounds_of_rest, {is, t, r_up, r_down});
    });
  };
  const Theorem bounds =
      book.show("rest_bounds", "where what is left is half a step at most:",
                follows(bounds_of_rest, {with_sign(le(0, r), r), with_sign(lt(r, 0), -r)}));
  const Expr gap_angle = q - f("rest");
  const Theorem difference =
      equation(sin(gap_angle), sin(q) * f("rest_cosine") - cos(q) * f("rest_sine"),
               {turned(def_sine), turned(def_cosine)}, {q, f("rest")});
  book.show("t_cosine_at_most", "For a ball that is not heavier than a block",
            linear(le(f("t_cosine"), f("w_cosine")),
                   {of_name[0], of_name[1], times(a.t_small, assume(le(0, f("rest_cosine"))))}));
  book.show("sine_at_most", "and so",
            scaled(le(f("rest_sine"), f("t_cosine")),
                   le(cos(q) * f("rest_sine"), cos(q) * f("t_cosine")), 1 / cos(q),
                   {difference, sine_not_negative(gap_angle, {bounds, psi_is}),
                    equation(cos(q) * f("t_cosine"), sin(q) * f("rest_cosine"),
                             {of_name[0], a.tangent})}));
}
}  // namespace derivation
