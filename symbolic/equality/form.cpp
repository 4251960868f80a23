// SPDX-License-Identifier: GPL-2.0-or-later
#include "equality/form.hpp"

#include <algorithm>
#include <functional>
#include <map>

#include "equality/paper_names.hpp"

namespace magicmass::equality {
namespace {

bool any_node(const Tree& tree, const std::function<bool(const Node&)>& holds) {
  return holds(*tree) || std::any_of(tree->parts.begin(), tree->parts.end(),
                                     [&](const Tree& part) { return any_node(part, holds); });
}

bool is_trigonometric(const Node& node) {
  return node.kind == Kind::function && node.name != "abs" && node.name != "exp" &&
         node.name != "log";
}

bool is_radical(const Node& node) {
  return node.kind == Kind::root || (node.kind == Kind::power && is_number(node.parts[1]) &&
                                     !is_integer(node.parts[1]->value));
}

std::string no_trigonometry(const Tree& tree) {
  return any_node(tree, is_trigonometric) ? "a trigonometric function is left in it" : "";
}

std::string no_radicals(const Tree& tree) {
  return any_node(tree, is_radical) ? "a root is left in it" : "";
}

// Rational numbers are folded where they are read, so 2/6 is 1/3 here.
std::string one_number(const Tree& tree) {
  return is_number(tree) ? "" : "it is not one whole number or fraction yet";
}

std::string no_names(const Tree& tree) {
  const auto is_defined = [](const Node& node) {
    return node.kind == Kind::symbol && meaning(node.name).has_value();
  };
  return any_node(tree, is_defined) ? "it still has a name that stands for another expression" : "";
}

std::string a_product(const Tree& tree) {
  const Tree& inner = tree->kind == Kind::quotient ? tree->parts[0] : tree;
  return inner->kind == Kind::sum
             ? "it is a sum of " + std::to_string(inner->parts.size()) + " terms"
             : "";
}

std::string a_sum_of_products(const Tree& tree) {
  const auto is_unexpanded = [](const Node& node) {
    return (node.kind == Kind::product &&
            std::any_of(node.parts.begin(), node.parts.end(),
                        [](const Tree& part) { return part->kind == Kind::sum; })) ||
           (node.kind == Kind::power && node.parts[0]->kind == Kind::sum);
  };
  return any_node(tree, is_unexpanded) ? "a product or power of a sum is left in it" : "";
}

std::string one_fraction(const Tree& tree) {
  const auto is_fraction = [](const Node& node) { return node.kind == Kind::quotient; };
  const bool inner = std::any_of(tree->parts.begin(), tree->parts.end(),
                                 [&](const Tree& part) { return any_node(part, is_fraction); });
  return tree->kind == Kind::quotient && !inner ? "" : "it is not a single fraction";
}

using Form = std::function<std::string(const Tree&)>;

const std::map<std::string, Form>& forms() {
  static const std::map<std::string, Form> table{
      {"factored", a_product},
      {"expanded", a_sum_of_products},
      {"a single fraction", one_fraction},
      {"a number", one_number},
      {"no trigonometric functions", no_trigonometry},
      {"no roots", no_radicals},
      {"no abbreviations", no_names},
  };
  return table;
}

}  // namespace

const std::vector<std::string>& form_names() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> list;
    for (const auto& [name, form] : forms()) list.push_back(name);
    return list;
  }();
  return names;
}

std::string what_lacks_form(const Tree& tree, const std::string& form) {
  return forms().at(form)(tree);
}

}  // namespace magicmass::equality
