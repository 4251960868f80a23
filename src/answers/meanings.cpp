#include <algorithm>

#include "answers/derivation.hpp"
#include "derivation/book.hpp"
#include "notation/typed.hpp"

namespace answers {
namespace {

using namespace kernel;

/// What people type, the book's name for it, and the theorem f(params) = term.
struct Definition {
  const char* typed;
  const char* function;
  const char* id;
};
constexpr Definition definitions[]{{"psi", "psi", "rotation.psi"},
                                   {"theta", "theta", "ball.theta"},
                                   {"V_CM", "V_CM", "power.V_CM"},
                                   {"alpha_k", "alpha_k", "ratios.alpha_k"},
                                   {"beta_k", "beta_k", "ratios.beta_k"},
                                   {"rho", "rho", "evaluators_end.def_rho"},
                                   {"a_n", "a", "power.a"},
                                   {"b_n", "b", "power.b"},
                                   {"c_n", "c", "power.c"},
                                   {"c_prime_n", "c'", "power.c_prime"}};

Expr of_each(Expr e, Expr (*f)(Expr)) {
  Exprs args = e.args();
  std::ranges::transform(args, args.begin(), f);
  return args.empty() ? e : with_args(e, args);
}
// A term of the book in the symbols that people type, which some functions of alpha and V are, too.
Expr typed(Expr e) {
  static const std::set<std::string> names{"N_A", "N_B", "a_t", "b_t"};
  if (e.op() == Op::Var || (e.op() == Op::Fun && names.contains(e.name())))
    return notation::symbol(e.name());
  return of_each(e, typed);
}

/// The equation that defines such a name: "a_n", "c_prime_n", "beta_7"; nothing for another one.
Expr definition_of(const std::string& name) {
  for (const Definition& d : definitions)
    if (name == d.typed) return derivation::shown(d.id).conclusion();
  const std::size_t from = name.find_last_not_of("0123456789") + 1;
  const bool is_0 = name.substr(from) == "0";
  if (from >= name.size() || (name[from] == '0' && !is_0) || name.size() - from > 9) return {};
  for (const char* index : {"k", "n"})  // alpha_7, a_7; alpha_0 would be infinite
    if (const Expr of = definition_of(name.substr(0, from) + index); of && !(is_0 && *index == 'k'))
      return substitute(of, {{integer(index), std::stoi(name.substr(from))}});
  return {};
}

}  // namespace

Expr written_out(Expr e) {
  if (e.op() == Op::Fun && e.size() > 0)
    for (const Definition& d : definitions) {
      if (e.name() != d.function) continue;
      const Expr equation = derivation::shown(d.id).conclusion();
      return written_out(substitute(equation.arg(1), equation.arg(0).args(), e.args()));
    }
  return of_each(e, written_out);
}
Expr right_side(const std::string& id) { return derivation::shown(id).conclusion().arg(1); }

Expr with_meanings(Expr e, std::vector<std::string>& notes) {
  Substitution meanings;
  for (const std::string& name : notation::symbols_of(e)) {
    const Expr equation = definition_of(name);
    if (!equation || name == "rho") continue;
    meanings.emplace(notation::symbol(name), typed(written_out(equation.arg(1))));
    notes.push_back(name + " = " + text(equation.arg(1)));
  }
  return substitute(e, meanings);
}

Expr stated_value(const std::string& step) {
  const std::size_t colon = step.find(": ");
  const std::string left = colon == step.npos ? "" : step.substr(colon + 2);
  Exprs open{derivation::shown(step.substr(0, colon)).conclusion()};
  while (!open.empty()) {
    const Expr e = open.back();
    open.pop_back();
    if (e.op() == Op::Imp) open.push_back(e.arg(1));
    for (std::size_t i = e.op() == Op::And ? e.size() : 0; i > 0; --i) open.push_back(e.arg(i - 1));
    if (e.op() == Op::Eq && (left.empty() || text(e.arg(0)) == left))
      return typed(written_out(e.arg(1)));
  }
  refuse(step + ": this step states no such equation");
}

}  // namespace answers
