// SPDX-License-Identifier: GPL-2.0-or-later
#include "codegen/evaluator.hpp"

#include <algorithm>

#include <catch2/catch.hpp>

#include "derivation/derivation.hpp"

using namespace magicmass;

namespace {

const std::vector<proof::Theorem>& theorems() {
  static const std::vector<proof::Theorem> all = derivation::derive().theorems;
  return all;
}

codegen::Form form_of(const std::string& function) {
  const auto found =
      std::find_if(codegen::forms().begin(), codegen::forms().end(),
                   [&](const codegen::Form& form) { return form.function() == function; });
  REQUIRE(found != codegen::forms().end());
  return *found;
}

codegen::OperationCounts costs(const std::string& function) {
  return operation_counts(make_evaluator(form_of(function), theorems()).program);
}

}  // namespace

TEST_CASE("the cases of an output must be one formula", "[exam]") {
  codegen::Form form = form_of("terminal_offset");
  CHECK_NOTHROW(make_evaluator(form, theorems()));
  REQUIRE(form.outputs.at(0).name == "a");
  form.outputs[0].other_cases.emplace_back("offset.b_after_P");
  CHECK_THROWS_WITH(make_evaluator(form, theorems()),
                    Catch::Contains("offset.a_after_Q and offset.b_after_P") &&
                        Catch::Contains("right sides differ"));
}

TEST_CASE("what a symbol is bound to must be one formula in all cases", "[exam]") {
  codegen::Form form = form_of("terminal_offset");
  CHECK(std::count(form.bindings.begin(), form.bindings.end(), "offset.b_after_P") == 1);
  form.bindings.emplace_back("power.b_0");  // of another element: no case of it
  CHECK_NOTHROW(make_evaluator(form, theorems()));
  form = form_of("velocities_tangent");
  form.bindings.emplace_back("rotation.psi_paper");
  CHECK_THROWS_WITH(make_evaluator(form, theorems()),
                    Catch::Contains("rotation.psi_half_angle and rotation.psi_paper"));
}

TEST_CASE("forms from one angle compute one sine and one cosine", "[exam]") {
  for (const char* function : {"velocities_tangent", "encounters_tangent", "terminal_offset"}) {
    INFO(function);
    const codegen::OperationCounts counts = costs(function);
    CHECK(counts.sine_cosine_pairs == 1);
    CHECK(counts.sines_or_cosines == 0);
    CHECK(counts.arctangents == 1);
    CHECK(counts.square_roots == 1);
  }
  CHECK(costs("velocities_product").sines_or_cosines == 5);
}

TEST_CASE("an input that nothing names is refused", "[exam]") {
  codegen::Form form = form_of("terminal_offset");
  form.indices = {"N_A"};
  CHECK_THROWS_WITH(make_evaluator(form, theorems()), Catch::Contains("nothing says what N_B is"));
}
