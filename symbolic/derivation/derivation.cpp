// SPDX-License-Identifier: GPL-2.0-or-later
#include "derivation/derivation.hpp"

#include <stdexcept>

#include "derivation/chapters.hpp"
#include "derivation/wedge.hpp"

namespace magicmass::derivation {

const proof::Theorem& Derivation::at(const std::string& id) const {
  for (const proof::Theorem& theorem : theorems)
    if (theorem.id() == id) return theorem;
  throw std::out_of_range("no theorem is called " + id);
}

const std::vector<std::string>& chapter_names() {
  static const std::vector<std::string> names{
      "contact", "cycle", "rotation",    "power", "chebyshev",     "counting",
      "ratios",  "times", "restitution", "wedge", "special_cases", "collapse"};
  return names;
}

Derivation derive(const Laws& laws, const Paper& paper) {
  Kernel kernel({.positive = {"L", "M", "M_1", "M_2", "M_A", "M_B", "V", "alpha", "e", "m", "mu_A",
                              "mu_B", "lambda", "tan_h", "C"},
                 .integer = {}});
  Derivation result;
  try {
    const Contact first = contact(kernel, laws, paper);
    const Cycle second = cycle(kernel, first, paper);
    const Rotation third = rotation(kernel, second, paper);
    const Power fourth = power(kernel, laws, first, second, third, paper);
    const Chebyshev polynomials = chebyshev(kernel, third, fourth);
    const Counting counts = counting(kernel, third, fourth, paper);
    ratios(kernel, third, fourth, counts, paper);
    const Times when = times(kernel, laws, fourth, counts, polynomials);
    const Restitution inelastic = restitution(kernel, laws, second);
    const Wedge general = wedge(kernel, laws, inelastic);
    special_cases(kernel, general, inelastic, fourth, counts, when, paper);
    collapse(kernel, general);
  } catch (const proof::NotProved& refused) {
    result.refused = refused;
  } catch (const std::runtime_error& stuck) {  // a singular system, a null space that is not a line
    proof::Step step{
        .id = "derivation",
        .rule = "solving",
        .from = {},
        .relation = "=",
        .to = {},
        .conditions = {},
        .label = {},
        .words =
            "after " + (kernel.theorems().empty() ? "the start" : kernel.theorems().back().id()),
        .verdict = "refused",
        .premises = {}};
    result.refused = proof::NotProved(step, std::string(stuck.what()) + ", " + step.words);
  }
  result.theorems = kernel.theorems();
  return result;
}

Derivation derive() { return derive(conservation_laws(), paper()); }

}  // namespace magicmass::derivation
