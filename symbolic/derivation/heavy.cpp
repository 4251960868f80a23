// A ball that is not lighter than a block has one collision with each: rational velocities.
#include "derivation/symbols.hpp"

namespace derivation {
void heavy(Book& book) {
  const Names names{book, {alpha}, {alpha_positive}};
  book.chapter("heavy", "A heavy ball", {le(1, alpha), V_positive});
  const Theorem is_heavy = assume(le(1, alpha)), mass = linear(alpha_positive, {is_heavy});
  const Theorem alpha_1 = book["ratios.alpha_1"], beta_below = at(book["ratios.order"], {{k, 1}});
  const auto once = [&](const char* id, const Theorems& facts) {
    const Theorem t = cut(mass, book[id]);  // N = 1 if and only if the first ratio is <= alpha
    return tautology(left(t), {t, linear(right(t), facts + Theorems{alpha_1})});
  };
  const Theorem counts =
      both({book.show("N_A", "Both blocks have one collision each, A", once("ratios.N_A_once", {})),
            book.show("N_B", "and B:", once("ratios.N_B_once", {beta_below}))});
  const Theorem sum = names.name("masses", 1 + alpha, "With");
  know(positive(sum));
  const Theorem part_of = names.name("per_mass", 1 / of_alpha("masses"));
  const Theorem share = names.name("share", alpha * of_alpha("per_mass"));
  const Theorem less = names.name("lead", 1 - alpha);
  const Expr i = of_alpha("per_mass"), f = of_alpha("share"), D = of_alpha("lead");
  Theorems steps{book["cycle.start_vector"]};
  for (const char* id : {"cycle.P", "cycle.Q"})
    steps = steps + parts({rewrite(equation(Expr(1) - 1, 0), at(book[id], {{n, 1}}))});
  const Theorems rules{share, less, rewrite(sum, part_of)};
  const auto show = [&](const std::string& name, Expr velocity, Expr form) {
    return book.show(name, name == "a" ? "the first velocities are" : "and",
                     equation(velocity, V * form, steps + rules));
  };
  const Theorems after{show("a", a(1), D * i), show("b", b(1), 4 * f * i), show("c", c(1), 2 * i),
                       show("c_prime", c_prime(1), -2 * D * power(i, 2))};
  const Theorem N_is = linear(eq(N(), 2 * Expr(1)), {cut(mass, book["counting.shares"]), counts});
  const Theorem end = cut(mass, cut(N_is, at(book["terminal.after_Q"], {{n, 1}}, {N_is})));
  for (const auto& [name, which, velocity] :
       {std::tuple{"a_t", 2U, 0U}, std::tuple{"b_t", 3U, 1U}, std::tuple{"c_t", 4U, 3U}})
    book.show(name, which == 2U ? "which are the terminal ones:" : "and",
              chain(part(end, which), cut(mass, after[velocity])));
}
}  // namespace derivation
