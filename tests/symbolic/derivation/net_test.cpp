// SPDX-License-Identifier: GPL-2.0-or-later
// Each theorem of the book at random points, and false statements beside true ones that are seen;
// the paper's labels.
#include "net.hpp"

#include <iterator>
#include <set>
#include <sstream>

#include "catch.hpp"
#include "kernel/print.hpp"
#include "notation/read.hpp"

using derivation::the_book;

TEST_CASE("each theorem is true at random points that satisfy its hypotheses") {
  for (const auto& chapter : the_book().chapters())
    for (const auto& s : chapter.statements) {
      INFO(s.id << ": " << kernel::text(s.theorem));
      const net::Tried t = net::tried(s.theorem.hypotheses(), s.theorem.conclusion(), 100);
      CHECK(t.false_at == "");
      CHECK(t.points >= (kernel::free_variables(s.theorem.conclusion()).empty() ? 1 : 100));
    }
}

TEST_CASE("false statements are seen") {
  const auto [id, from, to] = GENERATE(table<std::string, std::string, std::string>({
      {"contact.v_1", "M_1 - M_2", "M_1 + M_2"},
      {"cycle.P", "2*alpha*c'_(n - 1)", "2*alpha*c_(n - 1)"},
      {"cycle.Lambda_paper", "4*alpha", "2*alpha"},
      {"cycle.Gamma_A", "0, 1, 0", "0, -1, 0"},
      {"cycle.V_squared", "V_(n - 1)^T V_(n - 1)", "V_n^T V_(n - 1)"},
      {"rotation.psi", "2 + alpha", "1 + alpha"},
      {"rotation.Lambda_R", "R lambda_3(psi) R^T", "R^T lambda_3(psi) R"},
      {"power.Lambda_n", "n*psi", "(n + 1)*psi"},
      {"power.a", "1 + cos", "1 - cos"},
      {"power.b", "n + 1/2", "n - 1/2"},
      {"power.c", "n - 1/4", "n + 1/4"},
      {"power.c_prime", "psi/4", "psi/2"},
      {"table.tan_psi", "1 - 2*alpha", "1 + 2*alpha"},
      {"counting.N", " - 1", ""},
      {"counting.N_A", "1/2", "1/3"},
      {"counting.N_B", "- 1", "- 3/4"},
      {"constraints.N_A_last", "a_(N_A) <= c'_(N_A)", "c'_(N_A) < a_(N_A)"},
      {"constraints.N_A_near", "N_A = N_B", "N_A = N_B + 1"},
      {"ratios.N_A_range", "alpha_k <= alpha", "alpha_k < alpha"},
      {"ratios.alpha_k", "2*k + 1", "2*k + 2"},
      {"ratios.order", "beta_k < alpha_k", "alpha_k < beta_k"},
      {"magic.velocities", "a_k = 0", "a_k = V"},
      {"deficient.counts", "N_A = k + 1", "N_A = k"},
      {"terminal.b", "1 - (1 + alpha)", "1 + (1 + alpha)"},
      {"terminal.order", "b_t <= V", "b_t < V"},
      {"minima.minimum", "b_t(beta_k, V) < b_t", "b_t < b_t(beta_k, V)"},
      {"minima.at_least", "<=", "<"},
      {"small_alpha.psi_bounds", "5*alpha/12", "4*alpha/12"},
      {"evaluators_collision.takes_place", "j < N", "j + 1 < N"},
      {"evaluators_collision.apart", "L*", "2*L*"},
      {"orthogonal.rotation", "o_21/(1 + o_11)", "o_12/(1 + o_11)"},
      {"orthogonal.lambda_n", "m_21/(1 + m_11)", "m_12/(1 + m_11)"},
      {"orthogonal.lambda_n", "lambda_3(pi)", "lambda_3(0)"},
      {"orthogonal.Gamma_A", "-theta", "theta"},
      {"radicals.fifth", "1 + sqrt(5)", "1 - sqrt(5)"},
      {"radicals.alpha_7", "5 + sqrt(5)", "5 - sqrt(5)"},
      {"radicals.alpha_8", "17 - sqrt(17)", "17 + sqrt(17)"},
      {"restitution.v_1", "1 + e", "1 - e"},
      {"restitution.energy", "1 - e^2", "1 - e"},
      {"motion.recurrence", "- e*closing_j", "+ e*closing_j"},
      {"restitution.at_wall", "e*u_1", "u_1"},
      {"restitution.inverse_mass", "1 + e", "1 - e"},
      {"motion.B_velocity", "M_A + M_C", "M_A"},
      {"chebyshev.neighbours", " = 1", " = 0"},
      {"chebyshev.rise", "j + 1", "j + 2"},
      {"wedge.kappa", "2*sqrt(e)", "2*e"},
      {"wedge.N", " - 1", ""},
      {"losses.collision", "1 - e^2", "1 - e"},
      {"losses.alike", "r_A^2", "r_A"},
      {"losses.left", " - (1", " + (1"},
      {"transmission.paper", "e*(a_e_(n - 1) - c_e'", "(a_e_(n - 1) - c_e'"},
      {"transmission.paper", "b_e_n - c_e'_n", "b_e_n + c_e'_n"},
      {"transmission.cycle_2", "- 2*e", "- 3*e"},
      {"transmission.rises_1", "(b_e_1/V)^2 <", "(b_e_1/V)^2 + 1 <"},
      {"transmission.rises_2", "b_e_2/V)^2 <", "b_e_2/V)^2 + 1 <"},
      {"ends.rest", "delta_e <= h_e", "2*delta_e <= h_e"},
      {"ends.last", "= -opening_e", "= opening_e"},
      {"ends.B", "V + opening_e", "V - opening_e"},
      {"ends.order", "v_A_(N_e) <= v_C_(N_e)", "v_C_(N_e) <= v_A_(N_e)"},
      {"wall.number_T", "pi*T - 1", "pi*T"},
      {"wall.number_T", "2/T", "0*T"},
      {"places.time", "L*r_B", "L*r_A"},
      {"places.distance", "sqrt(e)", "e"},
      {"places.place", "w_B*M_A*V", "M_A*V"},
      {"encounters.when", "L/V", "V/L"},
      {"encounters.apart", "j + 1", "j + 2"},
      {"cradle.last", "= L", "= 2*L"},
      {"cradle.room", "2*L/(1 + alpha)", "L/(1 + alpha)"},
      {"cradle.speeds", "= V", "= 2*V"},
      {"cradle.collisions", "j + 1", "j"},
      {"billiard.line", "[sqrt(M_1); sqrt(M_2)] =", "[sqrt(M_2); sqrt(M_1)] ="},
      {"billiard.collision", "sqrt(M_1)*v_1", "sqrt(M_2)*v_1"},
      {"unfolded.radius", "radius_j^2", "radius_j"},
      {"unfolded.speed", " - w_B", " + w_B"},
      {"unfolded.line", "scaled_L - ", "scaled_L + "},
      {"collapse.threshold", "K < 1", "K < 2"},
      {"collapse.masses", "4*e", "3*e"},
      {"bodies.after", "later_side", "now_side"},
      {"bodies.def_later_sine", "j + 2", "j + 1"},
      {"bodies.A_at", "after_j(tau) - e", "after_j(tau) + e"},
      {"bodies.moment", "d_A*now_sine", "d_B*now_sine"},
      {"bodies.phase_e", "pi/2 - ", "pi/2 + "},
      {"any_start.speed", "W*r_e", "W*r_A"},
      {"any_start.sine", "+ j*h_e", "- j*h_e"},
      {"any_start.goes_on", "any_x_A_(j + 1)", "any_x_A_(j + 2)"},
      {"any_start.later", "- W*d_A", "+ W*d_A"},
      {"any_start.rises", "(j + 1)*r", "(j + 3)*r"},
      {"any_start.time_left", "pow_(j + 1)", "pow_j"},
      {"bodies.y_e", "-q_e", "1 - q_e"},
      {"places.in_time", "(j + 1)*(", "(j + 2)*("},
  }));
  const kernel::Theorem theorem = the_book()[id];
  std::string words = kernel::text(theorem.conclusion());
  const std::size_t at = words.find(from);
  INFO(id << ": " << to << " in " << words);
  REQUIRE(at != std::string::npos);
  words.replace(at, from.size(), to);
  CHECK_FALSE(net::tried(theorem.hypotheses(), notation::read(words), 400).false_at.empty());
}

TEST_CASE("hypotheses that nothing satisfies are seen") {
  const kernel::Expr alpha = kernel::real("alpha");
  const kernel::Exprs impossible{kernel::lt(alpha, 0), kernel::lt(0, alpha)};
  CHECK(net::tried(impossible, kernel::eq(alpha, 1), 20).points == 0);
}

// All labels of the paper's equations and tables, in its order, sec:nx and sec:nhx for equations
// that have none; not table:akbk, which claims nothing: its decimals are computed.
TEST_CASE("each label of the paper has a statement, and no statement has another") {
  const std::string paper =
      "NA-range NB-range def:Vn eq:conservation eq:ac eq:Euc-Pn eq:bcp eq:Euc-Qn "
      "eq:energy-conservation-PnQn eq:Euc-Pn-linear eq:Euc-Qn-linear eq:V2 eq:V-n eq:V-n-0 "
      "eq:Lam-G-G theta-txt eq:Lambda eq:Lambda-n-final-txt def:psi eq:a-final eq:b-final "
      "eq:c-final eq:c'-final eq:NANB-ans-txt eq:Naatcritical eq:Nbatcritical exact:ak "
      "exact:bk eq:a-terminal eq:b-terminal eq:ct eq:inelastic eq:lambda-1 eq:lambda-2 eq:lambda-3 "
      "eq:lambda-n def:R eq:abc-n eq:abcp-n eq:Gamma def:gamma def:theta eq:V-n-app "
      "eq:V-n-0-app Lam-GAM eq:Lambda-app eq-app:lambda-R eq:Lambda-n-final eq:R-app "
      "def:psi-app sec:nx sec:nhx def:ceil def:floor def:sawtooth eq:NA-constraint "
      "eq:NA-constraint-simple eq:NA-ans eq:NB-constraint eq:NB-constraint-simple "
      "eq:NB-ans eq:NANB-ans eq:NA-approx eq:magic-b-cond eq:magic-b-cond-simple "
      "eq:defb-terminal eq:def-b-cond table:trig";
  const auto words = [](const std::string& text) {
    std::istringstream in(text);
    return std::set<std::string>(std::istream_iterator<std::string>(in), {});
  };
  std::string claimed;
  for (const auto& chapter : the_book().chapters())
    for (const auto& s : chapter.statements) claimed += s.label + " ";
  CHECK(words(claimed) == words(paper));
  CHECK(words(paper).size() == 68);
}
