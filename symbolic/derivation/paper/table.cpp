// SPDX-License-Identifier: GPL-2.0-or-later
#include <ginac/ginac.h>

#include "derivation/paper/equations.hpp"
#include "proof/names.hpp"

namespace magicmass::derivation {

using namespace proof;
using GiNaC::ex;
using GiNaC::numeric;
using GiNaC::Pi;

Equations table_equations() {
  const ex alpha = symbol("alpha"), theta = symbol("theta"), psi = symbol("psi");
  const ex root = sqrt(alpha), both = sqrt(alpha * (2 + alpha));
  Equations all;
  const auto row = [&](const char* shown, const ex& angle, const ex& cosine, const ex& sine,
                       const ex& tangent) {
    const auto add = [&](const char* name, const ex& function, const ex& value) {
      all.emplace(std::string("table:trig, ") + name + " " + shown, Statement(function, value));
    };
    add("cos", cos(angle), cosine);
    add("sin", sin(angle), sine);
    add("tan", tan(angle), tangent);
  };
  row("theta/2", theta / 2, 1 / sqrt(1 + alpha), sqrt(alpha / (1 + alpha)), root);
  row("theta", theta, (1 - alpha) / (1 + alpha), 2 * root / (1 + alpha), 2 * root / (1 - alpha));
  row("psi/4", psi / 4, sqrt((2 + alpha) / (2 * (1 + alpha))), sqrt(alpha / (2 * (1 + alpha))),
      sqrt(alpha / (2 + alpha)));
  row("psi/2", psi / 2, 1 / (1 + alpha), both / (1 + alpha), both);
  row("psi", psi, (1 - 2 * alpha - pow(alpha, 2)) / pow(1 + alpha, 2), 2 * both / pow(1 + alpha, 2),
      2 * both / (1 - 2 * alpha - pow(alpha, 2)));
  all.emplace("app:Vn, range of theta", Statement(Pi / 2, Relation::greater, theta));
  all.emplace("app:lam-n, range of psi", Statement(2 * Pi / 3, Relation::greater, psi));
  return all;
}

Equations multiples_equations() {
  const ex n = symbol("n"), x = symbol("x"), y = symbol("y");
  const ex& k = summation_index();
  const ex sign = pow(ex(-1), k);
  Equations all{
      {"sec:nx, cos",
       {cos(n * x), finite_sum(sign * factorial(n) / (factorial(2 * k) * factorial(n - 2 * k)) *
                                   pow(sin(x), 2 * k) * pow(cos(x), n - 2 * k),
                               0, floor(n / 2))}},
      {"sec:nx, sin",
       {sin(n * x),
        finite_sum(sign * factorial(n) / (factorial(2 * k + 1) * factorial(n - 2 * k - 1)) *
                       pow(sin(x), 2 * k + 1) * pow(cos(x), n - 2 * k - 1),
                   0, floor((n - 1) / 2))}},
      {"def:ceil", {floor(ceiling(y) - y), 0}},
      {"def:floor", {floor(y - floor(y)), 0}},
      {"def:sawtooth", {sawtooth(y), y - floor(y)}},
  };
  for (const auto& [shown, r] : {std::pair{"1/2", numeric(1, 2)}, {"1/4", numeric(1, 4)}}) {
    all.emplace(std::string("sec:nhx, cos ") + shown,
                Statement(cos((n + r) * x), cos(n * x) * cos(r * x) - sin(n * x) * sin(r * x)));
    all.emplace(std::string("sec:nhx, sin ") + shown,
                Statement(sin((n + r) * x), sin(n * x) * cos(r * x) + cos(n * x) * sin(r * x)));
  }
  return all;
}

}  // namespace magicmass::derivation
