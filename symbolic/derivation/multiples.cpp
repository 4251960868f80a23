// SPDX-License-Identifier: GPL-2.0-or-later
// Chapter 5: cosines and sines of n x as sums, those of (n + 1/2) x and (n + 1/4) x, and the step functions.
#include <ginac/ginac.h>

#include "derivation/chapters.hpp"
#include "derivation/shorthand.hpp"
#include "proof/names.hpp"
#include "proof/text.hpp"

namespace magicmass::derivation {

using namespace proof;
using GiNaC::ex;
using GiNaC::matrix;

namespace {

struct Sums {
  Theorem cosine, sine;
};

// One more angle x, on sums: Pascal's rule, term by term.
Sums sums(Kernel& kernel, const Paper& paper) {
  const ex n = symbol("n"), x = symbol("x");
  const Statement cosine = paper.at("sec:nx, cos"), sine = paper.at("sec:nx, sin");
  const Theorem C_n = kernel.definition({.id = "multiples.C",
                                         .statement = {C(n), cosine.rhs()},
                                         .words = "the sum of even powers of the sine, by name",
                                         .indices = from_zero});
  const Theorem S_n = kernel.definition({.id = "multiples.S",
                                         .statement = {S(n), sine.rhs()},
                                         .words = "the sum of odd powers, by name",
                                         .indices = from_zero});
  const auto before = [&](const Theorem& sum) { return sum.rhs().subs(n == n - 1); };
  const auto recurrence = [&](const std::string& id, const Theorem& sum, const ex& element,
                              const Kernel::SumTerms& terms, const ex& next) {
    ex combination = 0;
    for (const auto& [coefficient, part, shift] : terms) combination += coefficient * part;
    const Theorem by_terms = kernel.sum_recurrence({.id = id + "_terms",
                                                    .statement = {sum.rhs(), combination},
                                                    .words = "Pascal's rule for each coefficient",
                                                    .indices = from_one},
                                                   terms);
    return kernel.rewriting({.id = id + "_next",
                             .statement = {element, next},
                             .words = "so the sums obey the rule for the sum of two angles",
                             .indices = from_one},
                            {C_n, S_n, by_terms});
  };
  const Theorem C_next =
      recurrence("multiples.C", C_n, C(n), {{cos(x), before(C_n), 0}, {-sin(x), before(S_n), -1}},
                 cos(x) * C(n - 1) - sin(x) * S(n - 1));
  const Theorem S_next =
      recurrence("multiples.S", S_n, S(n), {{sin(x), before(C_n), 0}, {cos(x), before(S_n), 0}},
                 sin(x) * C(n - 1) + cos(x) * S(n - 1));
  const Theorem C_0 = kernel.rewriting(
      {.id = "multiples.C_0", .statement = {C(0), 1}, .words = "where it starts"}, {C_n});
  const Theorem S_0 = kernel.rewriting(
      {.id = "multiples.S_0", .statement = {S(0), 0}, .words = "where it starts"}, {S_n});
  const Theorem both =
      kernel.induction({.id = "multiples.sums",
                        .statement = {matrix{{C(n)}, {S(n)}}, matrix{{cos(n * x)}, {sin(n * x)}}},
                        .words = "by induction over n",
                        .indices = from_zero},
                       {C_0, S_0}, {C_next, S_next}, n);
  const auto claim = [&](const char* name, const Statement& statement, const Theorem& named,
                         unsigned row) {
    const std::string id = std::string("multiples.") + name;
    const Theorem part = kernel.component({.id = id + "_named",
                                           .statement = {named.lhs(), both.rhs().op(row)},
                                           .words = "one of the two",
                                           .indices = from_zero},
                                          both, row);
    return kernel.consequence({.id = id + "_n",
                               .statement = statement,
                               .words = "as the paper writes it",
                               .label = std::string("sec:nx, ") + name,
                               .indices = from_zero},
                              {{named, 1}, {part, -1}});
  };
  return {claim("cos", cosine, C_n, 0), claim("sin", sine, S_n, 1)};
}

}  // namespace

void multiples(Kernel& kernel, const Contact& contact, const Rotation& rotation, const Table& table,
               const Paper& paper) {
  const ex n = symbol("n"), x = symbol("x");
  const Sums sum = sums(kernel, paper);
  for (const auto& [angle, cosine, sine] :
       {std::tuple{contact.theta.lhs(), table.cos_theta, table.sin_theta},
        {rotation.psi.lhs(), table.cos_psi, table.sin_psi}})
    for (const auto& [name, general] : {std::pair{"cos", sum.cosine}, {"sin", sum.sine}}) {
      const std::string id = std::string("multiples.") + name + "_n_" + to_text(angle);
      const ex here = general.rhs().subs(x == angle);
      const Theorem special = kernel.instance({.id = id,
                                               .statement = {general.lhs().subs(x == angle), here},
                                               .words = "for x = " + to_text(angle),
                                               .label = std::string("sec:nx, ") + name,
                                               .indices = from_zero},
                                              general, {{x, angle}});
      kernel.rewriting(
          {.id = id + "_values",
           .statement = {special.lhs(), here.subs(GiNaC::lst{cosine.lhs() == cosine.rhs(),
                                                             sine.lhs() == sine.rhs()})},
           .words = "with the table's values: algebraic in alpha",
           .label = std::string("sec:nx, ") + name,
           .indices = from_zero},
          {special, cosine, sine});
    }

  for (const char* part : {"1/2", "1/4"})
    for (const char* name : {"cos", "sin"}) {
      const std::string label = std::string("sec:nhx, ") + name + " " + part;
      const std::string id =
          std::string("multiples.") + name + (part == std::string("1/2") ? "_half" : "_quarter");
      const Theorem general = kernel.identity({.id = id,
                                               .statement = paper.at(label),
                                               .words = "the sum of two angles",
                                               .label = label,
                                               .indices = from_zero});
      for (const ex& angle : {contact.theta.lhs(), rotation.psi.lhs()}) {
        if (part == std::string("1/4") && angle.is_equal(contact.theta.lhs())) continue;
        kernel.instance(
            {.id = id + "_" + to_text(angle),
             .statement = {general.lhs().subs(x == angle),
                           kernel.simplified(general.rhs().subs(x == angle), from_zero)},
             .words = "for x = " + to_text(angle) + ", with the table's values",
             .label = label,
             .indices = from_zero},
            general, {{x, angle}});
      }
    }

  // Integers next to a real number y.
  const ex y = symbol("y");
  const auto step = [&](const char* id, const Statement& statement, const char* words,
                        const char* label) {
    kernel.step_functions({.id = id, .statement = statement, .words = words, .label = label}, {},
                          y);
  };
  step("multiples.ceiling", paper.at("def:ceil"), "0 <= ceil(y) - y < 1", "def:ceil");
  step("multiples.floor", paper.at("def:floor"), "0 <= y - floor(y) < 1", "def:floor");
  step("multiples.sawtooth", paper.at("def:sawtooth"), "what is left", "def:sawtooth");
  step("multiples.sawtooth_range", {floor(sawtooth(y)), 0}, "and so 0 <= sawtooth(y) < 1",
       "def:sawtooth");
  step("multiples.ceiling_only", {ceiling(ceiling(y) - sawtooth(y)), ceiling(y)},
       "no other integer will do: ceil(m - f) = m for an integer m = ceil(y) and 0 <= f < 1",
       "def:ceil");
  step("multiples.floor_only", {floor(floor(y) + sawtooth(y)), floor(y)},
       "no other integer will do: floor(m + f) = m for an integer m = floor(y) and 0 <= f < 1",
       "def:floor");
}

}  // namespace magicmass::derivation
