// SPDX-License-Identifier: GPL-2.0-or-later
// The evaluators' theorems, case by case.
#include "generate/quantities.hpp"

#include <sstream>

#include "derivation/book.hpp"

namespace generate {
using codegen::Case;
using codegen::Condition;
using codegen::Quantity;

kernel::Theorems Source::at(const std::string& words, const kernel::Substitution& terms) {
  kernel::Theorems out;
  std::istringstream in(words);
  std::string chapter;
  for (std::string word; in >> word;) {
    const std::size_t dot = word.find('.');
    if (dot != std::string::npos) chapter = word.substr(0, dot + 1);
    const std::string name = word.substr(dot == std::string::npos ? 0 : dot + 1);
    const std::size_t slash = name.find('/');
    const std::string id = chapter + name.substr(0, slash);
    kernel::Theorem t = derivation::the_book()[id];
    if (slash != std::string::npos) {
      t = kernel::tautology(t.conclusion().arg(std::stoul(name.substr(slash + 1))), {t});
    }
    out.push_back(kernel::instantiate(t, terms));
    ids.insert({out.back().conclusion(), id});
  }
  return out;
}
Case Source::of(const std::string& name, const std::vector<Condition>& where,
                const std::string& words, kernel::Substitution terms) {
  const std::size_t to = words.find("->"), by = words.find('|');
  if (to == std::string::npos) throw codegen::Refused("no -> before outputs: " + words);
  terms.insert(units.begin(), units.end());
  Case c{name, where, at(words.substr(0, to), terms), {}, {}, {}};
  c.outputs = at(words.substr(to + 2, by - to - 2), terms);
  if (by == std::string::npos) return c;
  for (const kernel::Theorem& t : at(words.substr(by + 1), terms)) c.facts.emplace_back(t);
  return c;
}
std::vector<Quantity> evaluators(Source& source) {
  constexpr double smallest = 0x1p-1074;
  constexpr double largest = 0x1.fffffffffffffp1023;
  const Condition light{"alpha", {smallest, 0x1.fffffffffffffp-1}};
  const Condition heavy{"alpha", {1, largest}};
  const kernel::Expr alpha = kernel::real("alpha"), k = kernel::integer("k");
  const std::string angle = "evaluators.def_above def_w def_z def_t def_half_h ";
  const std::string about = " | evaluators.z_at_most t_squared ";
  const std::string share = "heavy.def_masses def_per_mass def_share def_lead -> ";
  const auto made = [&](const std::string& name, const std::vector<codegen::Input>& inputs,
                        const std::vector<Case>& cases) {
    const bool has_arrays = name == "velocities" || name == "terminal";
    return Quantity{name, labels(name), inputs, cases, source.units, {}, has_arrays};
  };
  const auto ratio = [&](const std::string& kind, double first) {
    const std::string name = "evaluators_ratios.def_" + kind;
    return made(kind, {{k, {first, 0x1p50}, {first, 0x1p63}}},
                {source.of("general", {},
                           name + "_angle " + name + "_sine " + name + "_versed " + name +
                               "_cosine -> evaluators_ratios." + kind)});
  };
  Case velocities = source.of("small", {light},
                              angle +
                                  "def_phase def_sine def_cosine def_t_sine def_w_sine def_plus "
                                  "def_minus def_along -> evaluators.a b c c_prime" +
                                  about + "t_sine_at_most");
  velocities.guards = {{"phase", {-0.001, 2.0945}}};
  Case terminal = source.of(
      "small", {light},
      angle +
          "evaluators_end.def_h N_A N_B def_rest def_rest_sine def_rest_cosine def_t_cosine "
          "def_w_cosine def_t_plus def_t_minus def_w_plus def_b_form "
          "-> evaluators_end.N_A N_B terminal/0 terminal/1 terminal/2 def_rho" +
          about + "evaluators_end.sine_at_most t_cosine_at_most");
  terminal.facts[2].of_computed =
      "rest < h/2 is tested of computed values, and both are of the computed rest";
  Case collision = source.of(
      "small", {light, {"j", {2, 0x1p63}}},
      angle +
          "evaluators_collision.def_half_phase def_half_sine def_t_half_sine def_next_cosine "
          "def_half_cosine def_next_sine def_per_next def_sine_ratio def_time_ratio def_t_ratio "
          "-> evaluators_collision.when apart" +
          about + "evaluators_collision.t_at_most sine_positive ratio_at_most");
  collision.guards = {{"half_phase", {-0.001, 1.5708}}};
  collision.divisors = {"next_cosine"};
  const auto three_bodies = [&](const char* name, const Condition& per_B, const kernel::Expr& w_B) {
    const std::string chapter = "evaluators_restitution.";
    constexpr double third = 0x1.5555555555556p-2;
    Case c = source.of(
        name, {per_B},
        chapter +
            "def_all_e def_both_e def_side_e def_root_e def_rise_e def_loss_e def_share_e "
            "def_gap_e def_whole_e def_z_e def_t_e def_step_e def_sine_e N_e def_span_e "
            "def_left_e def_next_e def_power_e def_odd_e def_even_e def_last_side_e "
            "def_open_side_e def_last_reach_e def_open_reach_e def_last_sine_e def_open_sine_e "
            "def_kept_e def_parted_e def_second_e def_speeds_e def_moved_e def_gained_e "
            "def_taken_e -> " +
            chapter + "N_e a_end b_end c_end def_rho_end | " + chapter + "t_squared",
        {{kernel::real("w_B"), w_B}});
    c.guards = {{"root_e", {0, 1 + 0x1p-42}},
                {"loss_e", {-1, 1}},
                {"span_e", {0, 3.1416}},
                {"share_e", {0x1p-30, 2}, {{0x1p-80, 2}}},
                {"z_e", {0x1p-48, third}, {{0x1p-124, third}}}};
    for (const char* rest : {"left_e", "next_e"}) c.guards.push_back({rest, {0, 1.0473}});
    for (const char* reach : {"last_reach_e", "open_reach_e"})
      c.guards.push_back({reach, {0, 0x1p29}, {{0, 0x1p72}}});
    for (const char* speed : {"kept_e", "parted_e"}) c.guards.push_back({speed, {-1, 8}});
    return c;
  };
  Quantity restitution =
      made("restitution",
           {{kernel::real("M_C"), {0x1p-100, 0x1p60}, {smallest, 0x1p190}},
            {kernel::real("w_B"), {0, 0x1p60}, {0, 0x1p128}},
            {kernel::real("e"), {0x1p-100, 1}, {smallest, 1}}},
           {three_bodies("block", {"w_B", {0x1p-100, 0x1p60}, {{smallest, 0x1p128}}},
                         kernel::real("w_B")),
            three_bodies("wall", {"w_B", {0, 0}}, 0)});
  restitution.units.insert({{kernel::real("M_A"), 1}, {kernel::real("w_B"), 0}});
  restitution.is_tested = false;  // fast's alone
  return {
      made("velocities",
           {{alpha, {0x1p-300, 0x1p300}, {smallest, largest}},
            {kernel::integer("n"), {0, 0x1p50}, {0, 0x1p63}}},
           {velocities, source.of("first", {heavy, {"n", {1, 1}}}, share + "heavy.a b c c_prime")}),
      made("terminal", {{alpha, {0x1p-100, 0x1p300}, {smallest, largest}}},
           {terminal, source.of("first", {heavy},
                                share + "heavy.N_A N_B a_t b_t c_t evaluators_end.def_rho")}),
      ratio("magic", 2),
      ratio("deficient", 1),
      made("collision",
           {{alpha, {0x1p-300, 0x1p300}, {smallest, largest}},
            {kernel::integer("j"), {1, 0x1p50}, {1, 0x1p63}}},
           {collision,
            source.of("first", {{"j", {1, 1}}}, "-> evaluators_collision.when_1 apart_1")}),
      made("angle", {{alpha, {0x1p-300, 1}, {smallest, 1}}},
           {source.of("small", {}, angle + "-> evaluators.psi" + about)}),
      restitution};
}
}  // namespace generate
