// Lemmas of Coq, one a step of the kernel, each proved from its premises by what the step records.
// Coq's names that are made here have a ' inside, which no name of the kernel has.
#pragma once

#include <functional>

#include "coq/files.hpp"

namespace coq {
using kernel::Expr, kernel::Exprs, kernel::Op, kernel::Sort, kernel::Step, kernel::Theorem;

extern const char* const prelude;  ///< symbolic/coq/prelude.v

using Names = std::vector<std::string>;
/// Trees that are printed as a name of Coq.
using Atoms = std::map<Expr, std::string>;

/// A name of the kernel; those that Coq or the prelude uses get a mark.
std::string name(const std::string& kernel_name);
/// In Coq's language. `bound`: names of the variables of quantifiers around e, outermost first.
std::string gallina(Expr e, const Names& bound = {}, const Atoms& atoms = {});
/// Names for the indices of e that lead out of it.
Names loose_names(Expr e);
/// "" or " name name".
std::string spaced(const Names& names);
Names names_of(const Exprs& variables);
/// The free variables of all of them, in order of creation.
Exprs variables_of(const Exprs& es);

/// Terms with atoms as variables: x' for a canonical one, y' for one equal to a polynomial in x'.
struct Abstraction {
  /// Adds e, a part that polynomials do not look into, and what it is equal to.
  void add(Expr e);
  void add_atoms_of(Expr term);
  /// For the statement, and for its proof, where each y' is replaced.
  std::string print(Expr e) const { return gallina(e, {}, names); }
  std::string replaced(Expr e) const { return gallina(e, {}, inside); }

  Atoms names = {};
  Atoms inside = {};
  Exprs atoms = {};
};

class Script {
public:
  explicit Script(Proofs of);

  /// The lemma's name; writes it, and before it all that it rests on, where that is new.
  std::string lemma(const Theorem& t);
  /// The lemma's statement, all variables and hypotheses in it.
  static std::string statement(const Theorem& t);
  /// What was written since the last call.
  std::string take() { return std::exchange(written, ""); }
  int size() const { return int(lemmas.size()); }

private:
  struct Context {
    Exprs variables, hypotheses;
  };
  /// How a statement about an abstraction's variables begins, is proved, and for what it is used.
  struct Core {
    std::string statement;  ///< "forall ..., y' = x' -> "
    std::string intros;     ///< " x'0 y'0 ->"
    std::string arguments;  ///< " (a + b) (e'3 a b)"
  };

  // steps.cpp
  std::string with_lost_variables(const Theorem& t, Context c);
  std::string proof(const Theorem& t, const Context& c);
  std::string rewritten(const Theorem& t, const Context& c);
  std::string induction(const Theorem& t, const Context& c);
  std::string applied(const Theorem& premise, const Context& c, const kernel::Substitution& s = {});
  std::string tautology(const Theorem& t, const Context& c);
  // equal.cpp
  std::string arithmetic(const Theorem& t, const Context& c);
  // Proofs of l = r and f <-> g, which have one canonical form
  /// A lemma about e for all values of its variables and loose indices, applied to those here.
  std::string shared(const std::string& kind, Expr e, const Names& bound,
                     const std::function<std::string(const Names&)>& statement,
                     const std::function<std::string()>& proof);
  std::string equal(Expr l, Expr r, const Names& bound);
  std::string to_canonical(Expr e, const Names& bound);
  std::string prove_canonical(Expr e);
  std::string same(Expr f, Expr g, const Names& bound);
  std::string same_entries(Expr f, const Names& bound);
  Core core(const Abstraction& a, const Names& bound);
  // terms.cpp
  void define_all(Expr e);
  std::string definition(const Theorem& t);
  std::string recursion(const Step& s);
  std::string recursive(const Theorem& t);  ///< proves a start or a step

  std::string add_lemma(const std::string& kind, const std::string& statement,
                        const std::string& proof);

  Proofs chosen;
  std::map<std::string, Theorem> definitions = {};  ///< by the name that is defined
  std::map<std::string, bool> is_defined = {};
  std::map<Sequent, std::string> lemmas = {};
  std::map<std::pair<std::string, Expr>, std::string> shared_lemmas = {};
  std::string written = {};
  int serial = 0;
};

bool is_matrix_equation(Expr f);
/// The equations of its entries.
Expr by_entries(Expr equation);
}  // namespace coq
