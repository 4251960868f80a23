// SPDX-License-Identifier: GPL-2.0-or-later
#include "command/specialised_header.hpp"

#include <algorithm>
#include <filesystem>
#include <map>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "command/nearest_name.hpp"
#include "magicmass/errors.hpp"
#include "magicmass/scenes/mass_ratio.hpp"
#include "magicmass/scenes/scene.hpp"
#include "magicmass/scenes/shown_text.hpp"

namespace magicmass::command {
namespace {

std::vector<std::string> names_in(const std::string& list) {
  std::vector<std::string> names(1);
  for (const char character : list) {
    if (character == ',')
      names.emplace_back();
    else if (character != ' ')
      names.back() += character;
  }
  return names;
}

std::vector<std::string> all_names() {
  std::vector<std::string> names;
  for (const codegen::PaperQuantity& quantity : codegen::paper_quantities())
    names.push_back(quantity.name);
  return names;
}

/// "a, b, c, c_prime, psi (of alpha and n)" and so on: the sets that one function can give.
std::string sets_that_agree() {
  std::string text;
  for (const codegen::QuantityGroup& group : codegen::grouped(all_names())) {
    std::vector<std::string> names;
    for (const codegen::PaperQuantity& quantity : group)
      if (quantity.name != "psi") names.push_back(quantity.name);
    if (group[0].kernel != "ratios") names.emplace_back("psi");
    text += fmt::format("{}{} (of {})", text.empty() ? "" : "; ", fmt::join(names, ", "),
                        group[0].inputs);
  }
  return text;
}

std::vector<std::string> names_of(const codegen::QuantityGroup& group) {
  std::vector<std::string> names;
  for (const codegen::PaperQuantity& quantity : group) names.push_back(quantity.name);
  return names;
}

/// What each output of a scene is made of.
const std::map<Output, std::vector<std::string>>& quantities_of_outputs() {
  static const std::map<Output, std::vector<std::string>> all{
      {Output::counts, {"N_A", "N_B"}},
      {Output::terminal, {"a_t", "b_t", "c_t", "rho"}},
      {Output::events, {"t", "a", "b", "c", "c_prime"}},
      {Output::trajectory, {"t", "s", "a", "b", "c", "c_prime"}},
      {Output::energy, {"rho"}}};
  return all;
}

/// A C++ name made of a file's.
std::string scope_of(const std::string& path) {
  std::string name = "scene_";
  for (const char character : std::filesystem::path(path).stem().string()) {
    const bool is_letter =
        (character >= 'a' && character <= 'z') || (character >= 'A' && character <= 'Z');
    name += is_letter || (character >= '0' && character <= '9') ? character : '_';
  }
  return name;
}

}  // namespace

SpecialisedHeader header_of_quantities(const std::string& names) {
  const std::vector<std::string> wanted = names_in(names);
  for (const std::string& name : wanted) require_name("quantity", name, all_names());
  const std::vector<codegen::QuantityGroup> groups = codegen::grouped(wanted);
  if (groups.size() > 1)
    throw InvalidInput(fmt::format(
        "{} takes {} and {} takes {}: one header has one set of inputs; allowed together: {}",
        groups[0][0].name, groups[0][0].inputs, groups[1][0].name, groups[1][0].inputs,
        sets_that_agree()));
  const std::vector<std::string> sorted = names_of(groups[0]);
  return {
      groups, "", fmt::format("magicmass generate --quantity {}", fmt::join(sorted, ",")),
      fmt::format("Of {}: {}, and nothing else.", groups[0][0].inputs, fmt::join(sorted, ", "))};
}

SpecialisedHeader header_of_scene(const std::string& path) {
  const Scene scene = read_scene(path);
  // The generated formulas are those of the paper's state.
  if (!scene.alpha)
    refuse_key(scene, "kind", "no generated formula holds for this scene",
               "three-body with a ball of mass ratio alpha between equal blocks");
  if (scene.restitution != Value(1.0))
    refuse_key(scene, "restitution", "generated headers are of elastic collisions", "1.0");
  std::vector<std::string> wanted, outputs;
  for (const Output output : scene.outputs) {
    outputs.emplace_back(to_text(output));
    for (const std::string& name : quantities_of_outputs().at(output)) wanted.push_back(name);
  }
  const std::string file = std::filesystem::path(path).filename().string();
  return {codegen::grouped(wanted), scope_of(path),
          "magicmass generate --scene " + shown_text(file, 100),
          fmt::format(
              "For the outputs {} of that scene, where alpha = {}, V = {} and L = {}: alpha is an "
              "argument here, and velocities are in units of V, distances of L, times of L/V.",
              fmt::join(outputs, ", "), to_text(*scene.alpha), to_text(scene.V), to_text(scene.L))};
}

}  // namespace magicmass::command
