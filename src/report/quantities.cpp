// SPDX-License-Identifier: GPL-2.0-or-later
#include "report/quantities.hpp"

#include <algorithm>
#include <string_view>

#include "magicmass/errors.hpp"
#include "magicmass/evaluators.hpp"

namespace magicmass::report {
namespace {

/// "alpha,n" as alpha and n.
std::vector<std::string> names_in(std::string_view list) {
  std::vector<std::string> names;
  while (!list.empty()) {
    const std::size_t end = std::min(list.find(','), list.size());
    names.emplace_back(list.substr(0, end));
    list.remove_prefix(std::min(end + 1, list.size()));
  }
  return names;
}

const Quantity* found(const std::string& name) {
  for (const Quantity& quantity : quantities())
    if (quantity.name == name) return &quantity;
  return nullptr;
}

}  // namespace

bool Quantity::takes(const std::string& input) const {
  return std::find(inputs.begin(), inputs.end(), input) != inputs.end();
}

std::string Quantity::index() const {
  for (const char* letter : {"n", "j", "k"})
    if (takes(letter)) return letter;
  return "";
}

const std::vector<Quantity>& quantities() {
  static const std::vector<Quantity> all = [] {
    std::vector<Quantity> known{
        {"velocities", {"a", "b", "c", "c_prime"}, {"alpha", "n"}},
        {"encounters", {"t", "s"}, {"alpha", "j"}},
        {"angle", {"psi"}, {"alpha"}},
        {"ratios", {"magic", "deficient"}, {"k"}},
        {"counts", {"N_A", "N_B"}, {"alpha"}},
        {"elastic_terminal", {"a_t", "b_t", "c_t", "N_A", "N_B"}, {"alpha"}},
        {"sequence", {"a", "b", "c", "c_prime"}, {"alpha", "n"}},
    };
    const auto add = [&]<const auto & table>(const char* name, const char* outputs,
                                             const char* inputs) {
      if (std::none_of(known.begin(), known.end(),
                       [&](const Quantity& one) { return one.name == name; }))
        known.push_back({name, names_in(outputs), names_in(inputs), false});
    };
    generated::visit_tables<double>(add);
    return known;
  }();
  return all;
}

const Quantity& quantity_named(const std::string& name) {
  if (const Quantity* quantity = found(name)) return *quantity;
  std::string names;
  for (const Quantity& quantity : quantities())
    names += (names.empty() ? "" : ", ") + quantity.name;
  throw InvalidInput("no quantity is called \"" + name + "\"; allowed: " + names);
}

bool takes_alpha(const std::string& quantity) {
  const Quantity* one = found(quantity);
  return one == nullptr || one->takes("alpha");
}

bool is_count(const std::string& member) { return member == "N_A" || member == "N_B"; }

bool has_counts(const std::string& quantity) {
  const Quantity* one = found(quantity);
  return one != nullptr && std::any_of(one->members.begin(), one->members.end(), is_count);
}

bool has_last_index(const std::string& quantity) {
  const Quantity* one = found(quantity);
  return one != nullptr && one->takes("alpha") && !one->takes("e") &&
         (one->takes("n") || one->takes("j"));
}

}  // namespace magicmass::report
