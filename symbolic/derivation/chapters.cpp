// SPDX-License-Identifier: GPL-2.0-or-later
// The one place where chapters are put in order.
#include "derivation/symbols.hpp"
#include "derivation/wedge.hpp"

namespace derivation {
Book derive() {
  Book book;
  const Known while_deriving;
  for (const Expr& f : {alpha_positive, V_positive}) know_for_good(assume(f));
  for (const auto chapter : {contact,
                             cycle,
                             cycle_matrix,
                             rotation,
                             powers,
                             table,
                             counting,
                             constraints,
                             multiples,
                             thresholds,
                             ratios,
                             terminal,
                             minima,
                             small_alpha,
                             restitution,
                             chebyshev,
                             wedge,
                             transmission,
                             ends,
                             digits_of_pi,
                             when_and_where,
                             collapse,
                             encounters,
                             cradle,
                             billiard,
                             orthogonal,
                             evaluators,
                             exact_forms,
                             radicals,
                             three_body_forms,
                             restitution_forms})
    chapter(book);
  return book;
}
}  // namespace derivation
