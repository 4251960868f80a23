// At alpha = beta_k B and the ball go on together.
#include "derivation/symbols.hpp"

namespace derivation {
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
