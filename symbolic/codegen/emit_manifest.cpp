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
    for (const auto* names : {&form.real_inputs, &form.indices})
      for (const std::string& name : *names) inputs.push_back(name);
    Json outputs = Json::array();
    for (std::size_t i = 0; i < form.outputs.size(); ++i) {
      const FormOutput& output = form.outputs[i];
      outputs.push_back({{"name", output.name},
                         {"theorem", output.theorem},
                         {"label", evaluator.outputs[i].front().step().label},
                         {"operations", text(operation_counts(evaluator.single[i]))}});
      if (!output.other_cases.empty()) outputs.back()["other_cases"] = output.other_cases;
    }
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
         {"operations", text(operation_counts(evaluator.program))}});
  }
  return Json{{"generator", "magicmass " MAGICMASS_VERSION}, {"evaluators", all}}.dump(2) + "\n";
}

}  // namespace magicmass::codegen
