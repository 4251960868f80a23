// SPDX-License-Identifier: GPL-2.0-or-later
#include "answers/meanings.hpp"

#include "derivation/book.hpp"

namespace answers {
namespace {

using kernel::Expr;

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

}  // namespace

Expr definition_of(const std::string& name) {
  for (const Definition& d : definitions)
    if (name == d.typed) return derivation::shown(d.id).conclusion();
  const std::size_t from = name.find_last_not_of("0123456789") + 1;
  if (from >= name.size() || name[from] == '0' || name.size() - from > 9) return {};
  const Expr of_k = definition_of(name.substr(0, from) + "k");  // alpha_7
  return of_k ? kernel::substitute(of_k, {{kernel::integer("k"), std::stoi(name.substr(from))}})
              : of_k;
}
Expr written_out(Expr e) {
  if (e.size() == 0) return e;
  if (e.op() == kernel::Op::Fun)
    for (const Definition& d : definitions) {
      if (e.name() != d.function) continue;
      const Expr equation = derivation::shown(d.id).conclusion();
      kernel::Substitution arguments;
      for (std::size_t i = 0; i < e.size(); ++i)
        arguments.emplace(equation.arg(0).arg(i), e.arg(i));
      return written_out(kernel::substitute(equation.arg(1), arguments));
    }
  kernel::Exprs args;
  for (Expr arg : e.args()) args.push_back(written_out(arg));
  return kernel::with_args(e, args);
}
Expr right_side(const std::string& id) { return derivation::shown(id).conclusion().arg(1); }

}  // namespace answers
