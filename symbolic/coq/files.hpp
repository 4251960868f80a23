// The derivation as files of Coq.
#pragma once

#include <utility>

#include "kernel/theorem.hpp"

namespace coq {
/// What a theorem says.
using Sequent = std::pair<kernel::Exprs, kernel::Expr>;
Sequent sequent_of(const kernel::Theorem& t);
/// All different theorems that `shown` rest on, and they, each with a proof; none rests on itself.
using Proofs = std::map<Sequent, kernel::Theorem>;
Proofs proofs_of(const kernel::Theorems& shown);

struct Chapter {
  std::string name;
  std::vector<std::pair<std::string, kernel::Theorem>> shown;  ///< by id
};
struct Files {
  std::vector<std::pair<std::string, std::string>> texts;  ///< by name, in the order of compiling
  int steps = 0;                                           ///< different ones, each a lemma
  int shown = 0;
};
/// prelude.v, a file for each chapter, and assumptions.v, which prints the axioms they all rest on.
Files files(const std::vector<Chapter>& chapters);
/// The first axiom in what coqc says of assumptions.v that is not of Coq's library of real numbers
/// and of classical logic; "" where there is none.
std::string foreign_assumption(const std::string& said);
}  // namespace coq
