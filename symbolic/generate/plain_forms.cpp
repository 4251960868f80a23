// SPDX-License-Identifier: GPL-2.0-or-later
// Each domain is data; the generator checks that nothing over- or underflows there.
#include "generate/plain_forms.hpp"

namespace generate {
namespace {
using codegen::Case;
using codegen::Input;
using codegen::PlainForm;
using codegen::Quantity;
using kernel::Theorems;

constexpr double most_cycles = 0x1p50;
/// The paper's forms divide by cos(psi/2) = 1/(1 + alpha), which is lost beside a rounded psi from
/// some alpha on.
constexpr double closed_most = 0x1p20;

Input alpha(double least, double most) {
  return {kernel::real("alpha"), {least, most}, {least, most}};
}
Input whole(kernel::Expr variable, double least, double most) {
  return {variable, {least, most}, {least, most}};
}
const std::string velocity_labels = "eq:a-final eq:b-final eq:c-final eq:c'-final";
const std::string terminal_labels = "eq:NA-ans eq:NB-ans eq:a-terminal eq:b-terminal eq:ct";

Case one(const Theorems& definitions, const Theorems& outputs) {
  return {"all", {}, definitions, outputs, {}, {}};
}
PlainForm velocities(Source& s, const std::string& form, double most, const Theorems& definitions,
                     const Theorems& outputs) {
  return {{"velocities",
           velocity_labels,
           {alpha(0x1p-300, most), whole(kernel::integer("n"), 0, most_cycles)},
           {one(definitions, outputs)},
           s.units},
          form};
}
PlainForm terminal(Source& s, const std::string& form, double least, double most,
                   const Theorems& definitions, const Theorems& outputs) {
  return {{"terminal", terminal_labels, {alpha(least, most)}, {one(definitions, outputs)}, s.units},
          form};
}
std::vector<PlainForm> closed(Source& s) {
  const Theorems psi{s["rotation.psi"]};
  const Theorems mean = psi + Theorems{s["power.V_CM"]};
  const Theorems counts{s["counting.N_A"], s["counting.N_B"]};
  const auto ratio = [&](const std::string& name, const std::string& id, const std::string& label) {
    return PlainForm{
        {name, label, {whole(kernel::integer("k"), 1, most_cycles)}, {one({}, {s[id]})}, {}},
        "closed"};
  };
  return {
      velocities(s, "closed", closed_most, mean, s.all("power", {"a", "b", "c", "c_prime"})),
      terminal(s, "closed", 0x1p-40, closed_most, psi + counts,
               counts + Theorems{s["terminal.a"], s["terminal.b"],
                                 s.part("terminal.definitions", 2), s["evaluators_end.def_rho"]}),
      {{"angle", "def:psi", {alpha(0x1p-300, 0x1p300)}, {one({}, psi)}, {}}, "closed"},
      ratio("magic", "ratios.alpha_k_paper", "exact:ak"),
      ratio("deficient", "ratios.beta_k_paper", "exact:bk")};
}
std::vector<PlainForm> tangent(Source& s) {
  const Theorems angle = s.all("evaluators", {"def_above", "def_w", "def_t", "def_half_h"});
  const Theorems parts = s.all("evaluators", {"def_phase", "def_sine", "def_cosine", "def_t_sine",
                                              "def_w_sine", "def_plus", "def_minus", "def_along"});
  const Theorems counts = s.all("evaluators_end", {"N_A", "N_B"});
  const Theorems rest =
      s.all("evaluators_end",
            {"def_h", "N_A", "N_B", "def_rest", "def_rest_sine", "def_rest_cosine", "def_t_cosine",
             "def_w_cosine", "def_t_plus", "def_t_minus", "def_w_plus", "def_b_form"});
  Theorems ends = counts;
  for (std::size_t i = 0; i < 3; ++i) ends.push_back(s.part("evaluators_end.terminal", i));
  ends.push_back(s["evaluators_end.rho"]);
  return {
      velocities(s, "tangent", 0x1p300, angle + parts,
                 s.all("evaluators", {"a", "b", "c", "c_prime"})),
      terminal(s, "tangent", 0x1p-100, 0x1p100, angle + rest, ends),
      {{"angle", "def:psi", {alpha(0x1p-300, 0x1p300)}, {one(angle, {s["evaluators.psi"]})}, {}},
       "tangent"}};
}
std::vector<PlainForm> exact(Source& s) {
  const codegen::Doubling cosines{s["exact.T_0"], s["exact.T_1"], s["exact.T_even"],
                                  s["exact.T_odd"]};
  const Theorems mean{s["power.V_CM"]};
  const Theorems at_start{s.part("cycle.start_vector", 0), s.part("cycle.start_vector", 1),
                          s["cycle.c_start"], s.part("cycle.start_vector", 2)};
  const Case start{"start", {{"n", {0, 0}}}, {}, at_start, {}, {}};
  const Case later{"later",
                   {{"n", {1, 0x1p62}}},
                   mean + Theorems{s["exact.b_before"]},
                   s.all("exact", {"a", "b", "c", "c_prime"}),
                   {},
                   {}};
  const Theorems ends{s["exact.a_t"], s["exact.b_t"], s.part("terminal.definitions", 2),
                      s["evaluators_end.def_rho"]};
  const auto count = [&](const char* name) {
    return whole(kernel::fun(name, {kernel::real("alpha"), 1}), 1, 0x1p62);
  };
  constexpr double any = 0x1p1000;
  return {{{"velocities",
            velocity_labels,
            {alpha(1 / any, any), whole(kernel::integer("n"), 0, 0x1p62)},
            {start, later},
            s.units,
            {cosines}},
           "exact"},
          {{"terminal",
            terminal_labels,
            {alpha(1 / any, any), count("N_A"), count("N_B")},
            {one(mean, ends)},
            s.units,
            {cosines}},
           "exact"}};
}
std::vector<PlainForm> matrices(Source& s) {
  const Theorems block{s["ball.Gamma"]};
  const auto of = [&](const std::string& name, const std::string& id, const std::string& labels,
                      const Theorems& definitions, const Input& input) {
    return PlainForm{{name, labels, {input}, {one(definitions, {s[id]})}, {}}, "matrices"};
  };
  const Input mass = alpha(0x1p-300, 0x1p300);
  const Input angle{kernel::real("x"), {-0x1p50, 0x1p50}, {-0x1p50, 0x1p50}};
  return {of("Gamma_A", "cycle.Gamma_A", "eq:Gamma", block, mass),
          of("Gamma_B", "cycle.Gamma_B", "eq:Gamma", block, mass),
          of("Lambda", "cycle.Lambda", "eq:Lambda", {}, mass),
          of("R", "rotation.R", "def:R", {}, mass),
          of("lambda_3", "rotation.lambda_3", "eq:lambda-3", {}, angle)};
}
}  // namespace

std::vector<PlainForm> plain_forms(Source& s) {
  std::vector<PlainForm> all = closed(s);
  const Theorems mean{s["rotation.psi"], s["power.V_CM"]};
  all.push_back(
      velocities(s, "product", 0x1p300, mean,
                 s.all("power", {"a_product", "b_product", "c_product", "c_prime_product"})));
  for (const auto& more : {tangent(s), exact(s), matrices(s)})
    all.insert(all.end(), more.begin(), more.end());
  return all;
}
}  // namespace generate
