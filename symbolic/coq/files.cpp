// SPDX-License-Identifier: GPL-2.0-or-later
#include "coq/files.hpp"

#include <set>
#include <sstream>

#include "coq/prelude.hpp"
#include "coq/script.hpp"

namespace coq {
using kernel::Theorem;

namespace {
/// All definitions that a theorem rests on.
void collect(const Theorem& t, std::set<std::pair<kernel::Exprs, kernel::Expr>>& seen,
             Script::Definitions& out) {
  if (!seen.emplace(t.hypotheses(), t.conclusion()).second) return;
  const kernel::Step s = t.step();
  for (const Theorem& p : s.premises) collect(p, seen, out);
  if (s.rule == "define" || s.rule == "least") out.emplace(s.extras[0].name(), t);
  if (s.rule == "start" || s.rule == "next")
    for (std::size_t k = 1; k < s.extras.size(); k += 4) out.emplace(s.extras[k].name(), t);
}
}  // namespace

Files files(const std::vector<Chapter>& chapters) {
  std::set<std::pair<kernel::Exprs, kernel::Expr>> seen;
  Script::Definitions definitions;
  for (const Chapter& chapter : chapters)
    for (const auto& [id, t] : chapter.shown) collect(t, seen, definitions);
  Script script(definitions);
  Files out{{{"prelude.v", prelude}}};
  std::string last = "prelude";
  for (const Chapter& chapter : chapters) {
    std::string shown;
    for (const auto& [id, t] : chapter.shown) {
      const std::string lemma = script.lemma(t);
      shown += "\n(* " + id + " *)\nTheorem t'" + std::to_string(++out.shown) + " : " +
               Script::statement(t) + ".\nProof. exact " + lemma + ". Qed.\n";
    }
    out.texts.emplace_back(chapter.name + ".v", "From Magicmass Require Export " + last +
                                                    ".\nOpen Scope R_scope.\n" + script.take() +
                                                    shown);
    last = chapter.name;
  }
  std::string all = "t'1";
  for (int k = 2; k <= out.shown; ++k) all += ", t'" + std::to_string(k);
  out.texts.emplace_back("assumptions.v", "From Magicmass Require Import " + last +
                                              ".\nDefinition all'shown := (" + all +
                                              ").\nPrint Assumptions all'shown.\n");
  out.steps = script.size();
  return out;
}

// coqc prints each axiom's name at the beginning of a line, and what belongs to it indented.
std::string foreign_assumption(const std::string& said) {
  static const std::set<std::string> of_library = {
      "ClassicalDedekindReals.sig_forall_dec",
      "ClassicalDedekindReals.sig_not_dec",
      "FunctionalExtensionality.functional_extensionality_dep",
      "ClassicalEpsilon.constructive_indefinite_description",
      "constructive_indefinite_description",
      "Classical_Prop.classic",
      "classic"};
  if (said.rfind("Closed under the global context", 0) == 0) return "";
  if (said.rfind("Axioms:", 0) != 0) return "what coqc does not say";
  std::istringstream lines(said);
  for (std::string line; std::getline(lines, line);) {
    const std::string word = line.substr(0, line.find(' '));
    if (!word.empty() && word != "Axioms:" && !of_library.count(word)) return word;
  }
  return "";
}
}  // namespace coq
