// SPDX-License-Identifier: GPL-2.0-or-later
// Plain and exact forms: a row each; then all that is generated.
#include "codegen/emit_evaluator.hpp"
#include "codegen/polynomials.hpp"
#include "codegen/text.hpp"
#include "generate/quantities.hpp"

namespace generate {
namespace {
using codegen::Case;
using codegen::Input;
using codegen::PlainForm;
using codegen::Quantity;

Input input(kernel::Expr variable, double least, double most) {
  return {variable, {least, most}, {least, most}};
}
Input alpha(double least, double most) { return input(kernel::real("alpha"), least, most); }

std::vector<Input> three_bodies() {
  constexpr double most = 0x1p128;
  return {input(kernel::real("M_A"), 1 / most, most), input(kernel::real("w_B"), 0, most),
          input(kernel::real("M_C"), 1 / most, most), input(kernel::real("e"), 1 / most, 1)};
}

/// Of the counts and the velocities without error.
std::vector<PlainForm> exact(Source& s) {
  const kernel::Theorems T = s("exact.T_0 T_1 T_even T_odd");
  const codegen::Doubling cosines{T[0], T[1], T[2], T[3]};
  constexpr double most = 0x1p62;
  const Input any = alpha(0x1p-1000, 0x1p1000);
  const auto count = [&](const char* name) {
    return input(kernel::fun(name, {kernel::real("alpha"), 1}), 1, most);
  };
  const Case start = s.of("start", {{"n", {0, 0}}},
                          "-> cycle.start_vector/0 start_vector/1 c_start start_vector/2");
  const Case later =
      s.of("later", {{"n", {1, most}}}, "power.V_CM exact.b_before -> exact.a b c c_prime");
  const Case end =
      s.of("all", {}, "power.V_CM -> exact.a_t b_t terminal.definitions/2 evaluators_end.def_rho");
  const auto made = [&](const std::string& name, const std::vector<Input>& inputs,
                        const std::vector<Case>& cases) {
    return PlainForm{{name, labels(name), inputs, cases, s.units, {cosines}}, "exact"};
  };
  const Case shape = s.of("all", {}, "-> collapse.def_K bodies.def_q_e");
  const Case two =
      s.of("all", {},
           "-> evaluators_restitution.def_ends def_two def_tie a_two b_two c_two def_rho_two");
  return {made("velocities", {any, input(kernel::integer("n"), 0, most)}, {start, later}),
          made("terminal", {any, count("N_A"), count("N_B")}, {end}),
          {{"shape", "", three_bodies(), {shape}, s.units}, "exact"},
          made("two_collisions", {any, input(kernel::real("e"), 0x1p-1000, 1)}, {two})};
}
/// Three bodies of any masses, or two and a wall, with restitution: q_e comes from the exact form,
/// turn and pow are of the number of the collision.
std::vector<PlainForm> restitution(Source& s) {
  constexpr double most = 0x1p128;
  std::vector<Input> inputs = three_bodies();
  kernel::Exprs names;
  for (const Input& i : inputs) names.push_back(i.variable);
  const auto with = [&](const char* name, double least, double largest) {
    std::vector<Input> more = inputs;
    more.push_back(input(kernel::fun(name, names), least, largest));
    return more;
  };
  const std::vector<Input> ends = with("q_e", 1 / most, 1), ends_not = with("q_e", -most, 0);
  inputs = ends;
  inputs = with("h_e", 1 / most, 4);
  const std::vector<Input> of_angle = inputs;
  const kernel::Expr j = kernel::integer("j"), e = kernel::real("e");
  inputs.push_back(input(j, 0, 0x1p62));
  inputs.push_back(input(kernel::fun("turn", {j}), -1, 1));
  inputs.push_back(input(kernel::fun("pow", {kernel::sqrt(e), j}), 0, 1));
  const std::string roots = "wedge.r_A r_B ";
  const std::string parts = roots + "bodies.def_step_sine def_now_side def_now_sine ";
  Case after = s.of("all", {},
                    parts +
                        "def_later_side def_later_sine before after -> "
                        "bodies.B_next A_next C_next");
  after.guards = {{"step_sine", {1 / most, 2}}, {"now_side", {1 / most, most}}};
  Case at = s.of("all", {}, parts + "def_rest_e -> bodies.moment blocks place");
  at.guards = after.guards;
  at.guards.push_back({"now_sine", {1 / most, 2}});
  at.guards.push_back({"rest_e", {1 / most, 4}});
  const auto made = [&](const char* name, const std::vector<Input>& of, const Case& c) {
    return PlainForm{{name, "", of, {c}, s.units}, "restitution"};
  };
  return {made("angle", ends, s.of("all", {}, roots + "kappa -> bodies.h_e")),
          made("count", of_angle, s.of("all", {}, "-> bodies.N_e")), made("after", inputs, after),
          made("at", inputs, at),
          made("collapse", ends_not,
               s.of("all", {}, roots + "kappa bodies.y_e -> bodies.t_end def_x_end def_v_end"))};
}
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

std::string labels(const std::string& quantity) {
  static const std::map<std::string, std::string> all{
      {"velocities", "eq:a-final eq:b-final eq:c-final eq:c'-final"},
      {"terminal", "eq:NA-ans eq:NB-ans eq:a-terminal eq:b-terminal eq:ct"},
      {"magic", "exact:ak"},
      {"deficient", "exact:bk"},
      {"angle", "def:psi"},
      {"collision", "def:psi"},
      {"restitution", "eq:a-terminal eq:b-terminal eq:ct"},
      {"two_collisions", "eq:a-terminal eq:b-terminal eq:ct"},
      {"Gamma_A", "eq:Gamma"},
      {"Gamma_B", "eq:Gamma"},
      {"Lambda", "eq:Lambda"},
      {"R", "def:R"},
      {"lambda_3", "eq:lambda-3"}};
  return all.at(quantity);
}
std::vector<PlainForm> plain_forms(Source& s, const std::vector<Quantity>& evaluators) {
  constexpr double most_cycles = 0x1p50;
  // The paper's forms divide by cos(psi/2) = 1/(1 + alpha), which is lost beside a rounded psi from
  // some alpha on.
  constexpr double closed_most = 0x1p20;
  const Input n = input(kernel::integer("n"), 0, most_cycles);
  const Input k = input(kernel::integer("k"), 1, most_cycles);
  const Input x = input(kernel::real("x"), -0x1p50, 0x1p50);
  const Input mass = alpha(0x1p-300, 0x1p300);
  const std::string psi = "rotation.psi ";
  const std::string mean = psi + "power.V_CM -> power.";
  const std::string counts = "counting.N_A N_B ";
  const struct {
    const char* form;
    const char* name;
    std::vector<Input> inputs;
    std::string words;
  } rows[] = {
      {"closed", "velocities", {alpha(0x1p-300, closed_most), n}, mean + "a b c c_prime"},
      {"closed",
       "terminal",
       {alpha(0x1p-40, closed_most)},
       psi + counts + "-> " + counts + "terminal.a b definitions/2 evaluators_end.def_rho"},
      {"closed", "angle", {mass}, "-> " + psi},
      {"closed", "magic", {k}, "-> ratios.alpha_k_paper"},
      {"closed", "deficient", {k}, "-> ratios.beta_k_paper"},
      {"product", "velocities", {mass, n}, mean + "a_product b_product c_product c_prime_product"},
      {"matrices", "Gamma_A", {mass}, "ball.Gamma -> cycle.Gamma_A"},
      {"matrices", "Gamma_B", {mass}, "ball.Gamma -> cycle.Gamma_B"},
      {"matrices", "Lambda", {mass}, "-> cycle.Lambda"},
      {"matrices", "R", {mass}, "-> rotation.R"},
      {"matrices", "lambda_3", {x}, "-> rotation.lambda_3"}};
  std::vector<PlainForm> all = exact(s);
  for (PlainForm& f : restitution(s)) all.push_back(std::move(f));
  // The evaluators' theorems where alpha < 1; they hold everywhere.
  for (Quantity q : evaluators) {
    if (q.name != "velocities" && q.name != "terminal" && q.name != "angle") continue;
    q.inputs = {q.name == "terminal" ? alpha(0x1p-100, 0x1p100) : mass};
    if (q.name == "velocities") q.inputs.push_back(n);
    q.cases = {{"all", {}, q.cases[0].definitions, q.cases[0].outputs, {}, {}}};
    all.push_back({q, "tangent"});
  }
  for (const auto& r : rows) {
    all.push_back(
        {{r.name, labels(r.name), r.inputs, {s.of("all", {}, r.words)}, s.units}, r.form});
  }
  return all;
}
Texts texts(const std::vector<Quantity>& evaluators, const std::vector<PlainForm>& plain,
            const codegen::Ids& ids) {
  std::vector<codegen::Emitted> all;
  for (const Quantity& q : evaluators) all.push_back(codegen::emit_evaluator(q, ids));
  std::map<std::string, std::vector<PlainForm>> by_form;
  for (const PlainForm& f : plain) by_form[f.form].push_back(f);
  for (const auto& [form, forms] : by_form) all.push_back(codegen::emit_plain(forms, ids));
  std::string errors =
      "What each value may be off by, in sizes of computed values, tier by tier.\n";
  std::vector<std::string> manifest;
  Texts files{{"magicmass/evaluators/polynomials.hpp", codegen::emit_polynomials()}};
  for (const codegen::Emitted& e : all) {
    if (!files.insert({"magicmass/" + e.path, e.header}).second)
      throw codegen::Refused("two files are called " + e.path);
    errors += e.errors;
    manifest.insert(manifest.end(), e.manifest.begin(), e.manifest.end());
  }
  files["magicmass/evaluators/errors.txt"] = errors;
  files["manifest.json"] = "[\n  " + codegen::joined(manifest, ",\n  ") + "\n]\n";
  return files;
}
Texts generated() {
  const Inventory& made = inventory();
  return texts(made.all, made.plain, made.source.ids);
}
std::string selected(const std::string& form, const std::set<std::string>& outputs) {
  std::vector<codegen::PlainForm> forms;
  for (const codegen::PlainForm& f : inventory().plain)
    if (f.form == form && form != "matrices") forms.push_back(f);
  if (forms.empty())
    throw codegen::Refused("no form " + form +
                           "; allowed: closed, product, tangent, exact, restitution");
  return codegen::emit_plain(forms, inventory().source.ids, outputs).header;
}
}  // namespace generate
