// SPDX-License-Identifier: GPL-2.0-or-later
// JSON, whose strings here need no escapes.
#include <algorithm>

#include "codegen/emit.hpp"

namespace codegen {
namespace {
std::string quoted(const std::string& text) { return "\"" + text + "\""; }
std::string list(const Words& words) {
  return words.empty() ? "[]" : "[" + quoted(joined(words, "\", \"")) + "]";
}
}  // namespace

Words ids_of(const std::vector<Case>& cases, const Ids& ids) {
  Words r;
  for (const Case& c : cases) {
    for (const auto* theorems : {&c.definitions, &c.outputs}) {
      for (const kernel::Theorem& t : *theorems) {
        const auto found = ids.find(t.conclusion());
        if (found == ids.end()) continue;
        if (std::ranges::count(r, found->second) == 0) r.push_back(found->second);
      }
    }
  }
  return r;
}
std::string manifest_entry(const Quantity& q, const std::string& form, const std::string& header,
                           const Ids& ids, const std::vector<Words>& bounds) {
  Words inputs, outputs, cases;
  for (const Output& o : outputs_of(q.cases.at(0))) outputs.push_back(o.name);
  for (const Input& i : q.inputs) inputs.push_back(i.name());
  for (std::size_t k = 0; k < q.cases.size(); ++k) {
    const Case& c = q.cases[k];
    cases.push_back("{\"name\": " + quoted(c.name) +
                    ", \"domain\": " + quoted(domain_in_words(q, c, form == "exact")) +
                    ", \"bounds\": " + list(bounds.empty() ? Words() : bounds[k]) +
                    ",\n     \"theorems\": " + list(ids_of({c}, ids)) + "}");
  }
  return "{\"name\": " + quoted(q.name) + ", \"form\": " + quoted(form) +
         ", \"header\": " + quoted("magicmass/" + header) + ", \"labels\": " + quoted(q.labels) +
         ",\n   \"inputs\": " + list(inputs) + ", \"outputs\": " + list(outputs) +
         ",\n   \"cases\": [" + joined(cases, ",\n    ") + "]}";
}
}  // namespace codegen
