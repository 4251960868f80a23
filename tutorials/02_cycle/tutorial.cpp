// SPDX-License-Identifier: GPL-2.0-or-later
// One cycle as a matrix: derived, then applied again and again in exact fractions.
#include <cstdio>
#include <string>

#include <ginac/ginac.h>

#include "derivation/chapters.hpp"
#include "proof/names.hpp"
#include "proof/text.hpp"

using GiNaC::ex;
using GiNaC::ex_to;
using GiNaC::matrix;
using magicmass::proof::to_text;
namespace derivation = magicmass::derivation;
namespace proof = magicmass::proof;

// The mass ratio is a square, so that its root is a fraction and every number
// below is one too.
const ex alpha = GiNaC::numeric(1, 4);

matrix at_alpha(const ex& formula) {
  return ex_to<matrix>(formula.subs(proof::symbol("alpha") == alpha).evalm());
}

void print_matrix(const char* name, const matrix& m) {
  std::printf("%s:\n  entry | 1 | 2 | 3\n", name);
  for (unsigned row = 0; row < m.rows(); ++row)
    std::printf("  row %u | %s | %s | %s\n", row + 1, to_text(m(row, 0)).c_str(),
                to_text(m(row, 1)).c_str(), to_text(m(row, 2)).c_str());
}

int main() {
  // The derivation up to this chapter; each of these functions proves its steps
  // in the kernel.
  proof::Kernel kernel(
      {.positive = {"M", "M_1", "M_2", "V", "alpha"}, .integer = {}});
  derivation::orthogonal(kernel, derivation::paper());
  const auto contact = derivation::contact(kernel, derivation::conservation_laws(),
                                           derivation::paper());
  const auto cycle = derivation::cycle(kernel, contact, derivation::paper());

  const matrix Gamma_A = at_alpha(cycle.Gamma_A.rhs()),
               Gamma_B = at_alpha(cycle.Gamma_B.rhs());
  const matrix Lambda = at_alpha(cycle.Lambda.rhs());
  std::printf("alpha: %s\n", to_text(alpha).c_str());
  print_matrix("Lambda", Lambda);
  print_matrix("mirror_twice", Gamma_A.mul(Gamma_A));
  print_matrix("other_order", Gamma_A.mul(Gamma_B));

  // V_n = Lambda^n V_0. Its third component is the ball's velocity times the root
  // of the mass ratio.
  matrix V_n(3, 1);
  V_n(0, 0) = 1;
  std::printf(
      "cycles:\n  n | a(n) | b(n) | third component | sum of squares | does a "
      "contact follow?\n");
  for (int n = 0; n <= 4; ++n) {
    const ex length = (V_n.transpose().mul(V_n))(0, 0);
    const bool catches_up = V_n(0, 0) > V_n(2, 0) / sqrt(alpha);
    std::printf("  %d | %s | %s | %s | %s | %s\n", n, to_text(V_n(0, 0)).c_str(),
                to_text(V_n(1, 0)).c_str(), to_text(V_n(2, 0)).c_str(),
                to_text(length).c_str(), catches_up ? "yes" : "no");
    V_n = Lambda.mul(V_n);
  }
}
