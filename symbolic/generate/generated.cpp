// SPDX-License-Identifier: GPL-2.0-or-later
// All of generated/, or a header of one's own.
#include "codegen/generate.hpp"
#include "generate/quantities.hpp"

namespace generate {
namespace {
struct Inventory {
  Source source;
  std::vector<codegen::Quantity> all = evaluators(source);
  std::vector<codegen::PlainForm> plain = plain_forms(source, all);
};
const Inventory& inventory() {
  static const Inventory made;
  return made;
}
}  // namespace

std::map<std::string, std::string> generated() {
  const Inventory& made = inventory();
  std::map<std::string, std::string> texts;
  for (const auto& [path, text] : codegen::generate(made.all, made.plain, made.source.ids))
    texts[path == "manifest.json" ? path : "magicmass/" + path] = text;
  return texts;
}
std::string selected(const std::string& form, const std::set<std::string>& outputs) {
  std::vector<codegen::PlainForm> forms;
  for (const codegen::PlainForm& f : inventory().plain)
    if (f.form == form && form != "matrices") forms.push_back(f);
  if (forms.empty())
    throw codegen::Refused("no form " + form + "; allowed: closed, product, tangent, exact");
  return codegen::emit_plain(forms, inventory().source.ids, outputs).header;
}
}  // namespace generate
