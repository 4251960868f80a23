// SPDX-License-Identifier: GPL-2.0-or-later
#include "equality/angle.hpp"

namespace magicmass::equality {
namespace {

void collect(const Tree& tree, const cln::cl_RA& factor, LinearForm& form) {
  const auto add_rest = [&] {
    if (!is_number(tree, 0)) form.rest.push_back(product({number(factor), tree}));
  };
  switch (tree->kind) {
    case Kind::pi:
      form.of_pi = form.of_pi + factor;
      return;
    case Kind::sum:
      for (const Tree& part : tree->parts) collect(part, factor, form);
      return;
    case Kind::product: {
      cln::cl_RA numbers = factor;
      std::vector<Tree> others;
      for (const Tree& part : tree->parts) {
        if (is_number(part))
          numbers = numbers * part->value;
        else
          others.push_back(part);
      }
      if (others.size() == 1) return collect(others[0], numbers, form);
      return add_rest();
    }
    case Kind::quotient:
      if (is_number(tree->parts[1]) && tree->parts[1]->value != 0)
        return collect(tree->parts[0], factor / tree->parts[1]->value, form);
      return add_rest();
    case Kind::function: {
      const std::string& name = tree->name;
      if (name != "asin" && name != "acos" && name != "atan" && name != "log") return add_rest();
      for (auto& [known, function] : form.terms)
        if (identical(function, tree)) {
          known = known + factor;
          return;
        }
      form.terms.emplace_back(factor, tree);
      return;
    }
    default:
      return add_rest();
  }
}

}  // namespace

LinearForm linear_form(const Tree& tree) {
  LinearForm form;
  collect(tree, 1, form);
  std::erase_if(form.terms, [](const auto& term) { return term.first == 0; });
  return form;
}

}  // namespace magicmass::equality
