// SPDX-License-Identifier: GPL-2.0-or-later
#include "render/step_names.hpp"

#include <catch2/catch.hpp>

#include "render/steps.hpp"
#include "whole_derivation.hpp"

using namespace magicmass;
using namespace magicmass::render;

namespace {
std::vector<std::string> ids(const std::string& name) {
  static const std::vector<proof::Step> steps = steps_of(whole_derivation());
  std::vector<std::string> result;
  for (const proof::Step& step : steps_called(name, steps)) result.push_back(step.id);
  return result;
}
using Ids = std::vector<std::string>;
}  // namespace

TEST_CASE("a result is found by the paper's symbol, its label or its id", "[exam][shared]") {
  CHECK(ids("a_n") == Ids{"power.a"});
  CHECK(ids("b_n") == Ids{"power.b"});
  CHECK(ids("c_n") == Ids{"power.c"});
  for (const char* name : {"c'_n", "c_prime_n", "c'(n)", "eq:c'-final", "power.c_prime"})
    CHECK(ids(name) == Ids{"power.c_prime"});
  CHECK(ids("alpha_k") == Ids{"ratios.alpha_k_paper"});
  CHECK(ids("beta_k") == Ids{"ratios.beta_k_paper"});
  CHECK(ids("N_A") == Ids{"counting.N_A"});
  CHECK(ids("psi") == Ids{"rotation.psi_paper"});
  CHECK(ids("theta") == Ids{"contact.theta_paper"});
  CHECK(ids("t_j") == Ids{"times.t"});
  CHECK(ids("s_j") == Ids{"times.s"});
  CHECK(ids("t_P_n") == Ids{"times.t_P"});
  for (const char* name : {"Lambda", "R", "N_B", "V_CM"}) CHECK(ids(name).size() == 1);
  CHECK(ids("eq:Lam-G-G") == ids("Lam-GAM"));
  CHECK(ids("app:Vn, Gamma_A") == Ids{"cycle.Gamma_A_rotation"});
  CHECK(ids("a_m").empty());
  CHECK(ids("").empty());
}
