// SPDX-License-Identifier: GPL-2.0-or-later
// The evaluators' theorems, case by case.
#include "generate/quantities.hpp"

namespace generate {
namespace {
using codegen::Case;
using codegen::Condition;
using codegen::Fact;
using codegen::Input;
using codegen::Quantity;

constexpr double below_1 = 0x1.fffffffffffffp-1;
constexpr double largest = 0x1.fffffffffffffp1023;
constexpr double smallest = 0x1p-1074;

Input alpha(double least, double most, double wide_most) {
  return {kernel::real("alpha"), {least, most}, {smallest, wide_most}};
}
Input whole(const char* name, double first) {
  return {kernel::integer(name), {first, 0x1p50}, {first, 0x1p63}};
}
}  // namespace

std::string labels(const std::string& quantity) {
  static const std::map<std::string, std::string> all{
      {"velocities", "eq:a-final eq:b-final eq:c-final eq:c'-final"},
      {"terminal", "eq:NA-ans eq:NB-ans eq:a-terminal eq:b-terminal eq:ct"},
      {"magic", "exact:ak"},
      {"deficient", "exact:bk"},
      {"angle", "def:psi"},
      {"Gamma_A", "eq:Gamma"},
      {"Gamma_B", "eq:Gamma"},
      {"Lambda", "eq:Lambda"},
      {"R", "def:R"},
      {"lambda_3", "eq:lambda-3"}};
  return all.at(quantity);
}
std::vector<Quantity> evaluators(Source& source) {
  const Condition light{"alpha", {smallest, below_1}};
  const Condition heavy{"alpha", {1, largest}};
  const std::string angle = "evaluators.def_above def_w def_z def_t def_half_h ";
  const std::string share = "heavy.def_masses def_per_mass def_share def_lead";
  const auto facts = [&](const std::string& words) {
    std::vector<Fact> r;
    for (const kernel::Theorem& t : source("evaluators.z_at_most t_squared " + words)) {
      r.emplace_back(t);
    }
    return r;
  };
  const auto made = [&](const std::string& name, const std::vector<Input>& inputs,
                        const std::vector<Case>& cases) {
    return Quantity{name, labels(name), inputs, cases, source.units};
  };
  const auto ratio = [&](const std::string& kind, double first) {
    const std::string prefix = " def_" + kind;
    return made(kind, {whole("k", first)},
                {{"general",
                  {},
                  source("evaluators_ratios." + prefix.substr(1) + "_angle" + prefix + "_sine" +
                         prefix + "_versed" + prefix + "_cosine"),
                  source("evaluators_ratios." + kind),
                  {},
                  {}}});
  };
  Case velocities{"small",
                  {light},
                  source(angle + "def_phase def_sine def_cosine def_t_sine def_w_sine def_plus "
                                 "def_minus def_along"),
                  source("evaluators.a b c c_prime"),
                  facts("t_sine_at_most"),
                  {{"phase", {-0.001, 2.0945}}}};
  Case terminal{"small",
                {light},
                source(angle + "evaluators_end.def_h N_A N_B def_rest def_rest_sine "
                               "def_rest_cosine def_t_cosine def_w_cosine def_t_plus def_t_minus "
                               "def_w_plus def_b_form"),
                source("evaluators_end.N_A N_B terminal/0 terminal/1 terminal/2 rho"),
                facts("evaluators_end.t_cosine_at_most"),
                {}};
  terminal.facts.emplace_back(
      source("evaluators_end.sine_at_most")[0],
      "rest < h/2 is tested of computed values, and both are of the computed rest");
  return {
      made("velocities", {alpha(0x1p-300, 0x1p300, largest), whole("n", 0)},
           {velocities,
            {"first",
             {heavy, {"n", {1, 1}}},
             source(share),
             source("heavy.a b c c_prime"),
             {},
             {}}}),
      made("terminal", {alpha(0x1p-100, 0x1p300, largest)},
           {terminal,
            {"first", {heavy}, source(share), source("heavy.N_A N_B a_t b_t c_t rho"), {}, {}}}),
      ratio("magic", 2), ratio("deficient", 1),
      made("angle", {alpha(0x1p-300, 1, 1)},
           {{"small", {}, source(angle), source("evaluators.psi"), facts(""), {}}})};
}
}  // namespace generate
