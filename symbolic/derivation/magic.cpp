// At alpha = alpha_k B takes everything; at beta_k B and the ball go on together.
#include "derivation/symbols.hpp"

namespace derivation {
void at_threshold(Book& book, const Kind& kind, const std::vector<Velocity>& velocities) {
  const Theorem is = assume(eq(alpha, fun(kind.ratio, {k})));
  book.chapter(kind.chapter, kind.title, {alpha_positive, V_positive, le(1, k), is.conclusion()});
  const Theorems range = range_of(kind.d);
  const Theorem solved = chain(is, book["ratios." + kind.ratio + "k"]);
  const Theorem cosines = at(book["ratios.ratio"], {{x, pi() / kind.d}}, range + Theorems{solved});
  const Theorem angle = book.show("angle", "Half of psi is then", same_angle(cosines, range));
  const Theorem turn =
      equation(kind.d * psi(), 2 * pi(), {linear(eq(psi(), 2 * pi() / kind.d), {angle})});
  const Theorem quotient =
      equation(pi() / psi(), kind.d / 2, {linear(eq(pi(), kind.d / 2 * psi()), {turn})});
  const Theorem N_A_is = linear(eq(N_A(), kind.N_A_is), {book["counting.N_A"], quotient});
  const Theorem N_B_is = linear(eq(N_B(), k), {book["counting.N_B"], quotient});
  book.show("counts", kind.count_label, kind.count_words,
            both({N_A_is, N_B_is, linear(eq(k, kind.unrounded), {quotient})}));
  Theorems values, terminal;
  for (const Velocity& v : velocities) {
    const Theorem left_over = linear(eq(v.angle, pi() - v.rest), {turn});
    const Theorem velocity = rewrite(left_over, at(book["power." + v.id], {{n, v.index}}));
    values.push_back(equation(v.left, v.right,
                              {velocity, book["power.V_CM"], book["rotation.cos_half_psi"]},
                              {pi(), v.base}));
    const bool of_A = v.id == "a" || v.id == "c";
    terminal.push_back(rewrite(turned(of_A ? N_A_is : N_B_is), values.back()));
  }
  book.show("velocities", kind.velocity_label, kind.velocity_words, both(values));
  book.show("terminal", "These are the terminal velocities:", both(terminal));
}

void magic(Book& book) {
  at_threshold(book,
               {"magic", "Magic mass ratios", "alpha_", "eq:Naatcritical",
                "Each block has had k collisions,", "",
                "after which A and C are at rest and B has what A had:", 2 * k + 1, k,
                pi() / psi() - rational(1, 2)},
               {{a(k), 0, "a", k, k * psi(), half(), half()},
                {b(k), V, "b", k, (k + rational(1, 2)) * psi(), 0, half()},
                {c_prime(k), 0, "c_prime", k, (k + rational(1, 4)) * psi(), quarter(), quarter()}});
}

void deficient(Book& book) {
  at_threshold(book,
               {"deficient", "Deficient mass ratios", "beta_", "eq:Nbatcritical",
                "A has had one collision more than B,", "eq:defb-terminal",
                "after which B and C go on together:", 2 * k + 2, k + 1, pi() / psi() - 1},
               {{a(k + 1), -alpha * V / (2 + alpha), "a", k + 1, (k + 1) * psi(), 0, half()},
                {b(k), 2 * V / (2 + alpha), "b", k, (k + rational(1, 2)) * psi(), half(), half()},
                {c(k + 1), 2 * V / (2 + alpha), "c", k + 1, (k + 1 - rational(1, 4)) * psi(),
                 quarter(), quarter()}});
}
}  // namespace derivation
