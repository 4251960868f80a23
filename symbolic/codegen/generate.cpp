// SPDX-License-Identifier: GPL-2.0-or-later
// Files of all quantities, and the manifest.
#include "codegen/generate.hpp"

#include "codegen/emit_evaluator.hpp"
#include "codegen/emit_plain.hpp"
#include "codegen/polynomials.hpp"
#include "codegen/text.hpp"

namespace codegen {
std::map<std::string, std::string> generate(const std::vector<Quantity>& evaluators,
                                            const std::vector<PlainForm>& plain, const Ids& ids) {
  std::map<std::string, std::string> files;
  std::vector<std::string> manifest;
  const auto put = [&](const std::string& path, const std::string& text) {
    if (!files.insert({path, text}).second) throw Refused("two files are called " + path);
  };
  put("evaluators/polynomials.hpp", emit_polynomials());
  std::string errors =
      "What each value may be off by, in sizes of computed values, tier by tier.\n";
  for (const Quantity& q : evaluators) {
    const Evaluator e = emit_evaluator(q, ids);
    put("evaluators/" + q.name + ".hpp", e.header);
    errors += e.errors;
    manifest.push_back(e.manifest);
  }
  put("evaluators/errors.txt", errors);
  std::map<std::string, std::vector<PlainForm>> by_form;
  for (const PlainForm& p : plain) by_form[p.form].push_back(p);
  for (const auto& [form, forms] : by_form) {
    const PlainHeader h = emit_plain(forms, ids);
    put(h.path, h.header);
    manifest.insert(manifest.end(), h.manifest.begin(), h.manifest.end());
  }
  put("manifest.json", "[\n  " + joined(manifest, ",\n  ") + "\n]\n");
  return files;
}
}  // namespace codegen
