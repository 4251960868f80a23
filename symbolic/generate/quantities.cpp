// SPDX-License-Identifier: GPL-2.0-or-later
// Evaluators: their cases, intervals, facts and guards.
#include "generate/quantities.hpp"

#include "generate/source.hpp"

namespace generate {
namespace {
using codegen::Case;
using codegen::Condition;
using codegen::Fact;
using codegen::Interval;
using codegen::Quantity;
using kernel::Theorems;

constexpr double below_1 = 0x1.fffffffffffffp-1;
constexpr double largest = 0x1.fffffffffffffp1023;
constexpr double smallest = 0x1p-1074;
const Condition light{"alpha", {smallest, below_1}};
const Condition heavy{"alpha", {1, largest}};

Theorems angle(Source& source) {
  return source.all("evaluators", {"def_above", "def_w", "def_z", "def_t", "def_half_h"});
}
std::vector<Fact> angle_facts(Source& source) {
  return {source["evaluators.z_at_most"], source["evaluators.t_squared"]};
}
Theorems heavy_names(Source& source) {
  return source.all("heavy", {"def_masses", "def_per_mass", "def_share", "def_lead"});
}

Quantity velocities(Source& source) {
  Case small{"small", {light}, angle(source), {}, angle_facts(source), {}};
  small.definitions =
      small.definitions +
      source.all("evaluators", {"def_phase", "def_sine", "def_cosine", "def_t_sine", "def_w_sine",
                                "def_plus", "def_minus", "def_along"});
  small.outputs = source.all("evaluators", {"a", "b", "c", "c_prime"});
  small.facts.push_back(source["evaluators.t_sine_at_most"]);
  small.guards = {{"phase", {-0.001, 2.0945}}};
  const Case first{"first",
                   {heavy, {"n", {1, 1}}},
                   heavy_names(source),
                   source.all("heavy", {"a", "b", "c", "c_prime"}),
                   {},
                   {}};
  return {"velocities",
          "eq:a-final eq:b-final eq:c-final eq:c'-final",
          {{kernel::real("alpha"), {0x1p-300, 0x1p300}, {smallest, largest}},
           {kernel::integer("n"), {0, 0x1p50}, {0, 0x1p63}}},
          {small, first},
          source.units};
}
Quantity terminal(Source& source) {
  Case small{"small", {light}, angle(source), {}, angle_facts(source), {}};
  small.definitions =
      small.definitions +
      source.all("evaluators_end", {"def_h", "N_A", "N_B", "def_rest", "def_rest_sine",
                                    "def_rest_cosine", "def_t_cosine", "def_w_cosine", "def_t_plus",
                                    "def_t_minus", "def_w_plus", "def_b_form"});
  small.outputs = source.all("evaluators_end", {"N_A", "N_B"});
  for (std::size_t i = 0; i < 3; ++i)
    small.outputs.push_back(source.part("evaluators_end.terminal", i));
  small.outputs.push_back(source["evaluators_end.rho"]);
  small.facts.push_back(
      {source["evaluators_end.sine_at_most"],
       "rest < h/2 is tested of computed values, and both are of the computed rest"});
  small.facts.push_back(source["evaluators_end.t_cosine_at_most"]);
  const Case first{"first",
                   {heavy},
                   heavy_names(source),
                   source.all("heavy", {"N_A", "N_B", "a_t", "b_t", "c_t", "rho"}),
                   {},
                   {}};
  return {"terminal",
          "eq:NA-ans eq:NB-ans eq:a-terminal eq:b-terminal eq:ct",
          {{kernel::real("alpha"), {0x1p-100, 0x1p300}, {smallest, largest}}},
          {small, first},
          source.units};
}
Quantity ratio(Source& source, const std::string& kind, const std::string& label, double first) {
  const std::string prefix = "def_" + kind + "_";
  const Case general{"general",
                     {},
                     {source["evaluators_ratios." + prefix + "angle"],
                      source["evaluators_ratios." + prefix + "sine"],
                      source["evaluators_ratios." + prefix + "versed"],
                      source["evaluators_ratios." + prefix + "cosine"]},
                     {source["evaluators_ratios." + kind]},
                     {},
                     {}};
  return {kind, label, {{kernel::integer("k"), {first, 0x1p50}, {first, 0x1p63}}}, {general}, {}};
}
Quantity psi(Source& source) {
  const Case small{"small", {}, angle(source), {source["evaluators.psi"]}, angle_facts(source), {}};
  return {"angle", "def:psi", {{kernel::real("alpha"), {0x1p-300, 1}, {smallest, 1}}}, {small}, {}};
}
}  // namespace

std::vector<Quantity> evaluators(Source& source) {
  return {velocities(source), terminal(source), ratio(source, "magic", "exact:ak", 2),
          ratio(source, "deficient", "exact:bk", 1), psi(source)};
}
}  // namespace generate
