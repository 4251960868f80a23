// When and where the paper's collisions take place: blocks of mass 1, a ball of mass alpha, e = 1.
#include "derivation/wedge.hpp"

namespace derivation {
namespace {
Expr sine(Expr times) { return sin(times * half()); }
}  // namespace

Theorems quotients_of_sines(const Book& book, const Theorem& kappa_is) {
  const Expr angle = right(kappa_is).arg(0);
  const auto quotient = [&](const char* id) {
    const Theorem product = rewrite(turned(kappa_is), at(book[id], {{y, angle}}));
    return divided(left(product).arg(0), sin(angle), product);
  };
  return {quotient("chebyshev.sine"), quotient("chebyshev.sine_last")};
}
Theorems without_losses(const Book& book, const Theorem& kappa_is) {
  const Theorem root = root_is(1, 1);
  const auto power = [](Expr i) { return fun("pow", {sqrt(Expr(1)), i}); };
  const Theorems powers = parts({at(book["multiples.pow"], {{y, sqrt(Expr(1))}})});
  const Theorem power_is = by_induction(j, eq(power(j), 1), {powers[0]}, {at(powers[1]), root});
  return Theorems{power_is, root} + quotients_of_sines(book, kappa_is);
}

void encounters(Book& book) {
  const Exprs assumptions{alpha_positive, V_positive, lt(0, L), le(0, j), lt(j, N())};
  book.chapter("encounters", "When and where, in the paper's case", assumptions);
  know(in_paper(book["wedge.signs"]));
  // In the paper's case kappa is a cosine and the ratio of the sides is 1.
  const Theorem is_cosine = part(at(book["collapse.elastic"], {{M, 1}}), 0);
  const Theorems rules =
      without_losses(book, restate(eq(in_paper(kappa()), cos(half())), is_cosine)) +
      Theorems{chain(in_paper(book["wedge.r_A"]), turned(in_paper(book["wedge.r_B"])))};
  const Theorem speed =
      book.show("speed", "In the paper's case the approach speeds are those that we know,",
                equation(in_paper(closing(j)), approach(j),
                         rules + Theorems{in_paper(book["motion.speed"]), book["counting.speed"]}));

  const Theorem going = at(part(book["counting.happens"], 0));
  know(book.show("going", "and positive:", linear(lt(0, in_paper(closing(j))), {going, speed})));
  const Exprs params{alpha, V, L, j};
  const Theorem when = defined("when", params, in_paper(at_collision("time", j)), assumptions);
  const Theorem distance = defined("apart", params, in_paper(apart(j)), assumptions);
  book.show("definitions",
            "Collision j takes place at the time when_j, with the blocks apart_j from each other:",
            under(assumptions, both({when, distance})));
  const Theorem positive_sine =
      tautology(lt(0, sin((j + 1) * psi() / 2)), {book["counting.approaches"], going});
  know(restate(lt(0, sine(j + 1)), positive_sine));
  know(positive(rules[2]));
  book.show("when", "For a collision that takes place that is",
            equation(left(when), L / V * (sine(j) / sine(j + 1)),
                     rules + Theorems{when, in_paper(book["places.time"])}));
  book.show("apart", "and",
            equation(left(distance), L * (sin(half()) / sine(j + 1)),
                     rules + Theorems{distance, solved_for(in_paper(at_collision("x_B", j)),
                                                           in_paper(book["places.distance"]))}));
}
}  // namespace derivation
