#include "coq/files.hpp"

#include <sstream>

#include "coq/script.hpp"

namespace coq {
Sequent sequent_of(const Theorem& t) { return {t.hypotheses(), t.conclusion()}; }
namespace {
/// The first proof of each that is at its end: what it rests on was so before it.
void choose(const Theorem& t, Proofs& chosen) {
  if (chosen.count(sequent_of(t))) return;
  for (const Theorem& p : t.step().premises) choose(p, chosen);
  chosen.emplace(sequent_of(t), t);
}
void keep(const Theorem& t, const Proofs& chosen, Proofs& kept) {
  const auto [it, is_new] = kept.emplace(sequent_of(t), chosen.at(sequent_of(t)));
  if (!is_new) return;
  for (const Theorem& p : it->second.step().premises) keep(p, chosen, kept);
}
}  // namespace
Proofs proofs_of(const kernel::Theorems& shown) {
  Proofs chosen, kept;
  for (const Theorem& t : shown) choose(t, chosen);
  for (const Theorem& t : shown) keep(t, chosen, kept);
  return kept;
}

Files files(const std::vector<Chapter>& chapters) {
  kernel::Theorems all_shown;
  for (const Chapter& chapter : chapters)
    for (const auto& [id, t] : chapter.shown) all_shown.push_back(t);
  Script script(proofs_of(all_shown));
  Files out{{{"prelude.v", prelude}}};
  std::string last = "prelude";
  for (const Chapter& chapter : chapters) {
    std::string shown;
    for (const auto& [id, t] : chapter.shown)
      shown += "\n(* " + id + " *)\nTheorem t'" + std::to_string(++out.shown) + " : " +
               Script::statement(t) + ".\nProof. exact " + script.lemma(t) + ". Qed.\n";
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
