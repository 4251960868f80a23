// SPDX-License-Identifier: GPL-2.0-or-later
#include "answers/evaluate.hpp"

#include <stdexcept>

#include "answers/errors.hpp"
#include "derivation/book.hpp"

namespace answers {
namespace {

using kernel::Expr;
using kernel::Op;

/// f(params) = term, for the functions that closed forms are made of.
struct Definition {
  kernel::Exprs params;
  Expr term;
};
const std::map<std::string, Definition>& definitions() {
  static const auto all = [] {
    std::map<std::string, Definition> found;
    for (const char* id : {"rotation.psi", "power.V_CM", "ratios.alpha_k", "ratios.beta_k",
                           "evaluators_end.def_rho"}) {
      const Expr equation = derivation::the_book()[id].conclusion();
      found.emplace(equation.arg(0).name(), Definition{equation.arg(0).args(), equation.arg(1)});
    }
    return found;
  }();
  return all;
}

class Evaluation {
public:
  explicit Evaluation(Values known) : values(std::move(known)) {}

  Ball operator()(Expr e) {
    if (const auto it = values.find(e); it != values.end()) return it->second;
    const Ball value = compute(e);
    values.emplace(e, value);
    return value;
  }

private:
  Values values;

  Ball compute(Expr e) {
    switch (e.op()) {
      case Op::Num:
        return Ball(e.value());
      case Op::Add: {
        Ball sum = (*this)(e.arg(0));
        for (std::size_t i = 1; i < e.size(); ++i) sum = sum + (*this)(e.arg(i));
        return sum;
      }
      case Op::Mul: {
        Ball product = (*this)(e.arg(0));
        for (std::size_t i = 1; i < e.size(); ++i) product = product * (*this)(e.arg(i));
        return product;
      }
      case Op::Pow:
        return power((*this)(e.arg(0)), e.exponent());
      case Op::Fun:
        return function(e);
      default:
        throw std::logic_error("no value of " + e.name());
    }
  }
  Ball function(Expr e) {
    const std::string name = e.name();
    if (name == "pi") return Ball::pi();
    const auto known = definitions().find(name);
    if (known != definitions().end()) {
      kernel::Substitution arguments;
      for (std::size_t i = 0; i < e.size(); ++i)
        arguments.emplace(known->second.params[i], e.arg(i));
      return (*this)(kernel::substitute(known->second.term, arguments));
    }
    const std::map<std::string, std::function<Ball(const Ball&)>> functions{
        {"inv", [](const Ball& x) { return Ball(1) / x; }},
        {"sqrt", [](const Ball& x) { return sqrt(x); }},
        {"sin", [](const Ball& x) { return sin(x); }},
        {"cos", [](const Ball& x) { return cos(x); }},
        {"atan", [](const Ball& x) { return atan(x); }},
        {"ceil", [](const Ball& x) { return ceil(x); }},
    };
    const auto function = functions.find(name);
    if (function == functions.end()) throw std::logic_error("the book does not define " + name);
    return function->second((*this)(e.arg(0)));
  }
};

}  // namespace

Ball evaluate(Expr term, Values values) { return Evaluation(std::move(values))(term); }

Expr right_side(const std::string& id) { return derivation::the_book()[id].conclusion().arg(1); }

}  // namespace answers
