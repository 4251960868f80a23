// SPDX-License-Identifier: GPL-2.0-or-later
// Plain and exact forms, one by one; then all that is generated.
#include "codegen/emit_evaluator.hpp"
#include "codegen/polynomials.hpp"
#include "codegen/text.hpp"
#include "generate/quantities.hpp"

namespace generate {
namespace {
using codegen::Case;
using codegen::Condition;
using codegen::Input;
using codegen::PlainForm;
using codegen::Quantity;
using kernel::fun;
using kernel::integer;
using kernel::real;

Input input(kernel::Expr variable, double least, double most) {
  return {variable, {least, most}, {least, most}};
}
Input alpha(double least, double most) { return input(real("alpha"), least, most); }
std::vector<Input> three_bodies() {
  constexpr double most = 0x1p128;
  return {input(real("M_A"), 1 / most, most), input(real("w_B"), 0, most),
          input(real("M_C"), 1 / most, most), input(real("e"), 1 / most, 1)};
}

class Forms {
public:
  std::vector<PlainForm> all;
  Forms(Source& source, const std::vector<Quantity>& evaluators) : s(source) {
    exact();
    restitution();
    tangent(evaluators);
    of_paper();
  }

private:
  const Input n = input(integer("n"), 0, 0x1p50), mass = alpha(0x1p-300, 0x1p300);
  Source& s;
  std::string form;                           // of those that are added
  std::optional<codegen::Doubling> doubling;  // of those

  /// Of the counts and the velocities without error.
  void exact() {
    form = "exact";
    constexpr double most = 0x1p62;
    const kernel::Theorems T = s("exact.T_0 T_1 T_even T_odd");
    doubling = codegen::Doubling{T[0], T[1], T[2], T[3]};
    const Input any = alpha(0x1p-1000, 0x1p1000);
    add("velocities", {any, input(integer("n"), 0, most)},
        {s.of("start", {{"n", {0, 0}}},
              "-> cycle.start_vector/0 start_vector/1 c_start start_vector/2"),
         s.of("later", {{"n", {1, most}}}, "power.V_CM exact.b_before -> exact.a b c c_prime")});
    add("terminal",
        {any, input(fun("N_A", {real("alpha"), 1}), 1, most),
         input(fun("N_B", {real("alpha"), 1}), 1, most)},
        "power.V_CM -> exact.a_t b_t terminal.definitions/2 evaluators_end.def_rho");
    add("shape", three_bodies(), "-> collapse.def_K bodies.def_q_e");
    add("two_collisions", {three_bodies()[2], three_bodies()[1], three_bodies()[3]},
        "evaluators_restitution.def_taken_two -> evaluators_restitution.def_ends def_two def_four "
        "def_six a_two b_two c_two def_rho_two");
  }
  /// Three bodies of any masses, or two and a wall, from any start: q_e comes from the exact form,
  /// turn and pow are of the number of the collision.
  void restitution() {
    form = "restitution";
    constexpr double most = 0x1p128, far = 0x1p32;
    kernel::Exprs names;
    for (const Input& i : three_bodies()) names.push_back(i.variable);
    const auto of_bodies = [&](const char* name, double least, double largest) {
      return input(fun(name, names), least, largest);
    };
    const auto with = [](std::vector<Input> these, const std::vector<Input>& more) {
      these.insert(these.end(), more.begin(), more.end());
      return these;
    };
    const kernel::Expr j = integer("j");
    const std::string roots = "wedge.r_A r_B ", speeds_of_C = roots + "any_start.def_r_e ",
                      sines = speeds_of_C + "bodies.def_step_sine ";
    const std::string sides =
        sines + "def_now_side def_later_side def_last_sine def_now_sine def_later_sine ";
    const Condition step{"step_sine", {1 / most, 2}};
    const std::vector<Condition> guards{step, {"now_side", {1 / most, most}}};
    const std::vector<Input> speeds{input(real("V"), 1 / far, far), input(real("W"), -far, far)};
    const std::vector<Input> distances{input(real("d_A"), 0, far), input(real("d_B"), 0, far)};
    std::vector<Input> inputs = three_bodies();
    inputs.push_back(of_bodies("q_e", 1 / most, 1));
    add("angle", inputs, roots + "kappa -> bodies.h_e");
    inputs = with(with(inputs, {of_bodies("h_e", 1 / most, 4)}), speeds);
    add("count", inputs, sines + "wedge.kappa bodies.phase_e -> bodies.N_any", {step});
    const std::vector<Input> of_collision{input(j, 0, 0x1p62), input(fun("turn", {j}), -1, 1),
                                          input(fun("pow", {kernel::sqrt(real("e")), j}), 0, 1)};
    inputs = with(inputs, distances);
    add("at", with(with(inputs, {input(real("tau"), 0, far)}), of_collision),
        sides + "before after -> bodies.B_at A_at C_at", guards);
    add("time", with(inputs, {of_collision[0]}),
        sines + "def_last_sine def_now_sine def_reach -> bodies.moment",
        {step, {"reach", {1 / most, most}}});
    inputs = three_bodies();
    inputs.push_back(of_bodies("q_e", -most, 0));
    add("collapse", with(with(inputs, speeds), distances),
        speeds_of_C + "wedge.kappa bodies.y_e -> bodies.end_speed t_any x_any v_any",
        {{"end_speed", {1 / most, most}}});
  }
  /// The evaluators' theorems where alpha < 1; they hold everywhere.
  void tangent(const std::vector<Quantity>& evaluators) {
    form = "tangent";
    for (const Quantity& q : evaluators) {
      const Case all_alpha{"all", {}, q.cases[0].definitions, q.cases[0].outputs, {}, {}};
      if (q.name == "velocities") add(q.name, {mass, n}, {all_alpha});
      if (q.name == "terminal") add(q.name, {alpha(0x1p-100, 0x1p100)}, {all_alpha});
      if (q.name == "angle") add(q.name, {mass}, {all_alpha});
    }
  }
  void of_paper() {
    // cos(psi/2) = 1/(1 + alpha), a divisor, is lost beside a rounded psi from some alpha on.
    const Input k = input(integer("k"), 1, 0x1p50);
    const std::string psi = "rotation.psi ", mean = psi + "power.V_CM -> power.";
    const std::string counts = "counting.N_A N_B ";
    form = "closed";
    add("velocities", {alpha(0x1p-300, 0x1p20), n}, mean + "a b c c_prime");
    add("terminal", {alpha(0x1p-40, 0x1p20)},
        psi + counts + "-> " + counts + "terminal.a b definitions/2 evaluators_end.def_rho");
    add("angle", {mass}, "-> " + psi);
    add("magic", {k}, "-> ratios.alpha_k_paper");
    add("deficient", {k}, "-> ratios.beta_k_paper");
    form = "product";
    add("velocities", {mass, n}, mean + "a_product b_product c_product c_prime_product");
    form = "matrices";
    add("Gamma_A", {mass}, "ball.Gamma -> cycle.Gamma_A");
    add("Gamma_B", {mass}, "ball.Gamma -> cycle.Gamma_B");
    add("Lambda", {mass}, "-> cycle.Lambda");
    add("R", {mass}, "-> rotation.R");
    add("lambda_3", {input(real("x"), -0x1p50, 0x1p50)}, "-> rotation.lambda_3");
  }

  void add(const std::string& name, const std::vector<Input>& inputs,
           const std::vector<Case>& cases) {
    const bool of_paper = form != "restitution";
    const auto units = of_paper ? s.units : kernel::Substitution();
    all.push_back({{name, of_paper ? labels(name) : "", inputs, cases, units, doubling}, form});
  }
  void add(const std::string& name, const std::vector<Input>& inputs, const std::string& words,
           const std::vector<Condition>& guards = {}) {
    kernel::Substitution as_they_are;
    if (form == "restitution") as_they_are = {{real("V"), real("V")}, {real("L"), real("L")}};
    Case c = s.of("all", {}, words, as_they_are);
    c.guards = guards;
    add(name, inputs, std::vector{c});
  }
};
struct Inventory {
  Source source;
  std::vector<Quantity> all = evaluators(source);
  std::vector<PlainForm> plain = Forms(source, all).all;
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
  return all.contains(quantity) ? all.at(quantity) : "";
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
  static const std::set<std::string> of_scenes{"shape", "two_collisions"};
  std::vector<PlainForm> forms;
  for (const PlainForm& f : inventory().plain)
    if (f.form == form && form != "matrices" && !of_scenes.contains(f.quantity.name))
      forms.push_back(f);
  if (forms.empty())
    throw codegen::Refused("no form " + form +
                           "; allowed: closed, product, tangent, exact, restitution");
  return codegen::emit_plain(forms, inventory().source.ids, outputs).header;
}
}  // namespace generate
