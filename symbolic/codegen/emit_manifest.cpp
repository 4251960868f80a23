// SPDX-License-Identifier: GPL-2.0-or-later
#include <nlohmann/json.hpp>

#include "codegen/emit.hpp"

namespace magicmass::codegen {

std::string emit_manifest(const std::vector<Evaluator>& evaluators) {
  using Json = nlohmann::ordered_json;
  Json all = Json::array();
  for (const Evaluator& evaluator : evaluators) {
    const Form& form = evaluator.form;
    Json inputs = Json::array();
    if (!form.real_input.empty()) inputs.push_back(form.real_input);
    if (!form.restitution.empty()) inputs.push_back(form.restitution);
    if (!form.index.empty()) inputs.push_back(form.index);
    Json outputs = Json::array();
    for (std::size_t i = 0; i < form.outputs.size(); ++i)
      outputs.push_back({{"name", form.outputs[i].first},
                         {"theorem", evaluator.outputs[i].id()},
                         {"label", evaluator.outputs[i].step().label},
                         {"operations", to_text(operation_counts(evaluator.single[i]))}});
    Json bindings = Json::array();
    for (const proof::Theorem& theorem : evaluator.bindings) bindings.push_back(theorem.id());
    all.push_back(
        {{"name", form.function()},
         {"quantity", form.quantity},
         {"form", form.name},
         {"header", form.header()},
         {"precisions", form.exact ? Json{"any field"} : Json{"float", "double", "long double"}},
         {"inputs", inputs},
         {"outputs", outputs},
         {"bindings", bindings},
         {"domain", form.domain},
         {"ulp_bound", form.bound.ulp == no_bound ? Json() : Json(form.bound.ulp)},
         {"eps_bound", form.bound.eps == no_bound ? Json() : Json(form.bound.eps)},
         {"error", form.stated_error()},
         {"operations", to_text(operation_counts(evaluator.program))}});
  }
  return Json{{"generator", "magicmass " MAGICMASS_VERSION}, {"evaluators", all}}.dump(2) + "\n";
}

}  // namespace magicmass::codegen
