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
}  // namespace derivation
