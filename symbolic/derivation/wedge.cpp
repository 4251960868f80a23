// Three bodies of any masses with restitution are a ray in a wedge: its shape, and its angle.
#include "derivation/wedge.hpp"

namespace derivation {
namespace {
/// Where kappa is the cosine of an angle.
void angle_of_the_wedge(Book& book) {
  const Expr x_e = kappa(), rest = 1 - power(x_e, 2), t = sqrt(rest) / x_e;
  const Theorem below_1 = assume(lt(x_e, 1));
  const Known in_an_angle({below_1, linear(lt(0, rest), {times(below_1, x_e), below_1})});
  const Exprs domain = of_wedge({lt(0, e), below_1.conclusion()});
  const Theorem is = book.name("h_e", masses_and_e(), atan(t), domain,
                               "Where kappa is below 1 it is the cosine of an angle,");
  const Expr h = left(is);
  book.show("cosine", "as",
            under(domain, equation(cos(h), x_e,
                                   {chain(rewrite(turned(is), at("cos atan", {{x, t}})),
                                          equation(1 / sqrt(1 + power(t, 2)), x_e,
                                                   {root_is(1 + power(t, 2), 1 / x_e)}))})));
  book.show("acute", "an acute one,", both({positive(is), linear(lt(h, pi() / 2), {is})}));
}

// Collisions that never end: where inelastic collapse begins.

/// kappa < 1 as an inequality of masses and e without roots.
void threshold(Book& book) {
  const Theorem kappa_is = book["wedge.kappa"];
  const Theorem is = book.define("K", masses_and_e(),
                                 power(1 + e, 2) * M_A / (4 * e * (M_A + M_C) * (1 + w_B * M_C)),
                                 of_wedge({lt(0, e)}), "Without roots, with");
  const Expr K = left(is);
  const Theorem square =
      book.show("square", "the square of kappa is",
                equation(power(kappa(), 2), K, squared_shares(book) + Theorems{kappa_is, is}));
  know(positive(kappa_is));
  // K - 1 = (kappa - 1)(kappa + 1)
  const Expr below = lt(kappa(), 1), K_below = lt(K, 1);
  book.show(
      "threshold", "so kappa is below 1, where collisions end, if and only if",
      tautology(iff(below, K_below), {same_sign(iff(K_below, below), kappa() + 1, {square})}));
}
/// What K is for a block of mass M_B, and for a wall.
void special_cases(Book& book) {
  const Expr M_B = real("M_B");
  const Known mass({assume(lt(0, M_B)), positive(1 / M_B, {assume(lt(0, M_B))})});
  const auto special = [&](const char* id, const char* words, Expr inverse, Expr value) {
    const Theorem K = at(book["collapse.def_K"], {{w_B, inverse}});
    book.show(id, words, equation(left(K), value, {K}));
  };
  const Expr over = power(1 + e, 2) * M_A, below = 4 * e * (M_A + M_C);
  special("masses", "For a block of mass M_B that is", 1 / M_B, over * M_B / (below * (M_B + M_C)));
  special("wall", "and for a wall", 0, over / below);
}
/// Where kappa is 1 or more, a number that quotients of neighbouring polynomials stay above.
void neighbours(Book& book) {
  const Theorem from_1 = assume(le(1, kappa()));
  const Expr inside = power(kappa(), 2) - 1, root = sqrt(inside), sum = kappa() + root;
  know(linear(le(0, inside), {times(from_1, linear(lt(0, kappa() + 1), {from_1}))}));
  const Theorem definition =
      book.name("y_e", masses_and_e(), kappa() - root, of_wedge({lt(0, e), le(1, kappa())}),
                "Where kappa is 1 or more, with");
  const Expr y_e = left(definition);
  const Theorem root_sign = at("root not negative", {{x, inside}});
  know(linear(lt(0, sum), {from_1, root_sign}));
  const Theorem inverse = equation(y_e, 1 / sum, {definition});
  const Theorem quadratic = equation(power(y_e, 2), 2 * kappa() * y_e - 1, {definition});
  know(positive(inverse));
  const Theorem at_most_1 =
      scaled(le(y_e, 1), le(1, sum), y_e, {equation(y_e * sum, 1, {inverse}), from_1, root_sign});
  book.show("root", "which solves a quadratic equation and is 1 at most,",
            both({quadratic, positive(y_e), at_most_1}));

  const Theorem mean = equation(kappa(), (y_e + 1 / y_e) / 2, {quadratic});
  const Substitution of_y_e{{x, kappa()}, {y, y_e}};
  const Theorem distance = at(book["chebyshev.distance"], of_y_e, {mean});
  const Theorem powers_next = at(powers_of(book, at_most_1), {{j, j + 1}});
  book.show("neighbours", "and below which quotients of neighbours are,",
            both({distance, part(powers_next, 0), part(powers_next, 1)}));
  book.show("unit", "and with powers of it for the unit,",
            at(book["chebyshev.unit"], of_y_e, {mean}));
}
/// Blocks of one mass M, a ball of mass alpha M.
void equal_blocks(Book& book) {
  const Theorem block = assume(lt(0, M)), mass = assume(alpha_positive);
  const Known here({block, mass, positive(1 / M, {block})});
  const Substitution equal{{M_A, M}, {w_B, 1 / M}, {M_C, alpha * M}};
  const Expr share = 1 / (1 + alpha), s = sqrt(e);
  const auto shared = [&](const char* id) {
    const Theorem r = at(book[id], equal);
    return rewrite(equation(right(r).arg(0), share), r);
  };
  const Theorem of_blocks = book.show(
      "equal_blocks", "For blocks of one mass and a ball of alpha times that,",
      equation(substitute(kappa(), equal), (1 + e) / (2 * s * (1 + alpha)),
               {at(book["wedge.kappa"], equal), shared("wedge.r_A"), shared("wedge.r_B")}));
  book.show(
      "elastic",
      "and without losses that is the cosine of psi/2, below 1: the paper's collisions always end.",
      both({equation(substitute(substitute(kappa(), equal), elastic), cos(psi() / 2),
                     {at(of_blocks, elastic), book["rotation.cos_half_psi"], root_is(1, 1)}),
            linear(lt(1 / (1 + alpha), 1), {times(mass, 1 / (1 + alpha))})}));
}
}  // namespace

Theorem divided(Expr l, Expr by, const Theorem& times_by) {
  return certified(eq(l, right(times_by) / by),
                   {.equations = {{1, times_by}}, .multipliers = {positive(by)}});
}
Theorems squared_shares(const Book& book) {
  Theorems out;
  for (const char* id : {"wedge.r_A", "wedge.r_B"}) {
    const Theorem r = book[id];
    out.push_back(equation(power(left(r), 2), right(r).arg(0), {r}));
  }
  return out;
}

void wedge(Book& book) {
  book.chapter("wedge", "The wedge", of_wedge({le(0, j), lt(0, e)}));
  const auto share = [&](const char* name, Expr of, Expr value, Expr domain, const char* words) {
    know(positive(book.name(name, {of, M_C}, sqrt(value), {domain, lt(0, M_C)}, words)));
  };
  share("r_A", M_A, M_A / (M_A + M_C), lt(0, M_A), "With the roots of the shares of mass");
  share("r_B", w_B, 1 / (1 + w_B * M_C), le(0, w_B), "and, for a block or with 1 for a wall,");
  const Expr side_j = side(j), q = r_A() / r_B();
  const Theorem sides =
      positive(equation(side_j, (power(side_j, 2) + q) / (1 + q), {book["cycle.turn_squared"]}));
  const Theorems pow_is = parts({at(book["multiples.pow"], {{y, sqrt(e)}})});
  const Theorem powers = by_induction(
      j, lt(0, root_power(j)), linear(lt(0, root_power(0)), {pow_is[0]}), [&](const Theorem& now) {
        return linear(lt(0, root_power(j + 1)), {at(pow_is[1]), times(now, sqrt(e))});
      });
  book.show("signs", "These are positive, and so are two more factors of speeds:",
            both({positive(r_A()), positive(r_B()), sides, powers}));
  know(positive(book.name("kappa", masses_and_e(), (1 + e) * r_A() * r_B() / (2 * sqrt(e)),
                          of_wedge({lt(0, e)}), "the shape of the motion is one number:")));
  angle_of_the_wedge(book);
}

Theorem powers_of(const Book& book, const Theorem& at_most_1) {
  const Expr base = left(at_most_1);
  const auto power_of = [&](Expr index) { return fun("pow", {base, index}); };
  const auto in_range = [&](Expr i) { return logic_and({lt(0, power_of(i)), le(power_of(i), 1)}); };
  const Theorems powers = parts({at(book["multiples.pow"], {{y, base}})});
  return by_induction(j, in_range(j), linear(in_range(0), {powers[0]}), [&](const Theorem& now) {
    return linear(in_range(j + 1),
                  {at(powers[1]), times(part(now, 0), base), times(part(now, 1), base), at_most_1});
  });
}

void collapse(Book& book) {
  book.chapter("collapse", "Collapse", of_wedge({le(0, j), lt(0, e)}));
  know(at(book["wedge.signs"], {{j, 0}}));
  threshold(book);
  special_cases(book);
  neighbours(book);
  equal_blocks(book);
}
}  // namespace derivation
