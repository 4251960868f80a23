// SPDX-License-Identifier: GPL-2.0-or-later
// What a student hands in: an expression, a matrix of them, or lines of a derivation, and how it is shown to them.
#include "command/learn/expressions.hpp"
#include "command/learn/judgement.hpp"
#include "equality/form.hpp"
#include "equality/tokens.hpp"
#include "equality/typed_text.hpp"
#include "fuzz_target.hpp"

namespace {

using namespace magicmass;
using command::NotUnderstood;

void read(const std::string& typed) {
  for (const std::vector<std::string>& allowed :
       {std::vector<std::string>{}, {"alpha", "n", "M_1", "u_1", "M_2", "u_2", "psi"}}) {
    try {
      const equality::Tree tree = command::read_answer(typed, allowed);
      for (const auto& style :
           {render::TextStyle{}, render::TextStyle{.unicode = true, .colourful = false}})
        fuzz::require(!command::shown(tree, style).empty(), "nothing is shown");
      for (const std::string& form : equality::form_names()) equality::what_lacks_form(tree, form);
      command::replaced(tree, {{"alpha", "-alpha"}, {"n", "n + 1"}}, "answer");
    } catch (const NotUnderstood& refusal) {
      fuzz::require_one_line(refusal);
    }
  }
}

/// An expression that is derived line by line, and an equation.
std::vector<command::Posed> derivations() {
  command::Posed chain;
  chain.exercise.shape = command::Shape::derivation;
  chain.exercise.start = "cos(psi)";
  chain.exercise.form = "no trigonometric functions";
  command::Posed equations;
  equations.exercise.shape = command::Shape::equations;
  equations.exercise.truth = {{"v", "n - alpha"}};
  equations.solution = "v = n - alpha";
  return {chain, equations};
}

void judge(const std::string& typed) {
  static const std::vector<command::Posed> all = derivations();
  for (const command::Posed& posed : all) {
    try {
      fuzz::require(!command::judge_lines(posed, typed, {}).said.empty(), "nothing is said");
    } catch (const NotUnderstood& refusal) {
      fuzz::require_one_line(refusal);
    }
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string typed = fuzz::text_of(data, size);
  read(typed);
  judge(typed);
  try {
    for (const auto& row : equality::matrix_entries(typed))
      for (const std::string& entry : row) read(entry);
  } catch (const equality::NotAnExpression& refusal) {
    fuzz::require_one_line(refusal);
  }
  return 0;
}
