// SPDX-License-Identifier: GPL-2.0-or-later
#include <nlohmann/json.hpp>

#include "render/derivation_pages.hpp"
#include "render/formula_latex.hpp"

namespace magicmass::render {

std::string derivation_json(const std::vector<proof::Step>& steps) {
  std::string text;
  for (const proof::Step& step : steps) {
    const nlohmann::ordered_json object{
        {"id", step.id},
        {"rule", step.rule},
        {"from", step.from},
        {"relation", step.relation},
        {"to", step.to},
        {"conditions", step.conditions},
        {"label", step.label},
        {"words", step.words},
        {"verdict", step.verdict},
        {"premises", step.premises},
        {"statement", step.statement},
        {"latex", latex(equation(step.from, step.relation, step.to))}};
    text += (text.empty() ? "[\n" : ",\n") + object.dump();
  }
  return text.empty() ? "[]\n" : text + "\n]\n";
}

}  // namespace magicmass::render
