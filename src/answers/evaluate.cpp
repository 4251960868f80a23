// SPDX-License-Identifier: GPL-2.0-or-later
#include "answers/evaluate.hpp"

#include "derivation/book.hpp"

namespace answers {
namespace {

using kernel::Expr;

/// By the name that people type: theorems f(params) = term.
const std::map<std::string, Expr>& definitions() {
  const auto of = [](const char* id) { return derivation::the_book()[id].conclusion(); };
  static const std::map<std::string, Expr> all{
      {"psi", of("rotation.psi")},     {"theta", of("ball.theta")},
      {"V_CM", of("power.V_CM")},      {"alpha_k", of("ratios.alpha_k")},
      {"beta_k", of("ratios.beta_k")}, {"rho", of("evaluators_end.def_rho")},
      {"a_n", of("power.a")},          {"b_n", of("power.b")},
      {"c_n", of("power.c")},          {"c_prime_n", of("power.c_prime")}};
  return all;
}

}  // namespace

Expr definition_of(const std::string& name) {
  const auto it = definitions().find(name);
  return it == definitions().end() ? Expr() : it->second;
}
Expr written_out(Expr e, const Values& values) {
  if (e.size() == 0 || values.contains(e)) return e;
  if (e.op() == kernel::Op::Fun)
    for (const auto& [name, equation] : definitions()) {
      const Expr defined = equation.arg(0);
      if (defined.name() != e.name()) continue;
      kernel::Substitution arguments;
      for (std::size_t i = 0; i < e.size(); ++i) arguments.emplace(defined.arg(i), e.arg(i));
      return written_out(kernel::substitute(equation.arg(1), arguments), values);
    }
  kernel::Exprs args;
  for (Expr arg : e.args()) args.push_back(written_out(arg, values));
  return kernel::with_args(e, args);
}
Ball evaluate(Expr term, const Values& values) {
  return equality::enclosure(written_out(term, values), values);
}
Expr right_side(const std::string& id) { return derivation::the_book()[id].conclusion().arg(1); }

}  // namespace answers
