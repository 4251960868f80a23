// SPDX-License-Identifier: GPL-2.0-or-later
// A kernel's first collisions are those of its theorems.
#include "codegen/make_kernel.hpp"

#include <algorithm>

#include <catch2/catch.hpp>

#include "whole_derivation.hpp"

using namespace magicmass;
using codegen::KernelForm;

namespace {

KernelForm form_named(const std::string& name) {
  const auto& all = codegen::kernel_forms();
  const auto found = std::find_if(all.begin(), all.end(),
                                  [&name](const KernelForm& form) { return form.name == name; });
  REQUIRE(found != all.end());
  return *found;
}

}  // namespace

TEST_CASE("what a kernel puts in from alpha = 1 on is checked", "[exam][shared]") {
  const auto& theorems = whole_derivation().theorems;
  const auto refused = [&theorems](const KernelForm& form, const char* message) {
    CHECK_THROWS_WITH(codegen::make_kernel(form, theorems), message);
  };
  for (const KernelForm& form : codegen::kernel_forms())
    CHECK_NOTHROW(codegen::make_kernel(form, theorems));

  KernelForm form = form_named("velocities");
  std::swap(form.first[0], form.first[1]);
  refused(form, "tangent.a does not become tangent.first_b from alpha = 1 on");

  form = form_named("velocities");  // an index of the wrong kind: sine and cosine change places
  form.first_index.clear();
  refused(form, "tangent.a does not become tangent.first_a from alpha = 1 on");

  form = form_named("encounters");
  form.first.back() = "tangent.first_t";
  refused(form, "tangent.s_product does not become tangent.first_t from alpha = 1 on");

  form = form_named("velocities_in_rows");  // names for products are written out
  std::swap(form.first[2], form.first[3]);
  refused(form, "tangent.c_sum does not become tangent.first_c_prime from alpha = 1 on");

  form = form_named("terminal_in_rows");
  form.small_angle[0] = "offset.not_negative_after_Q";
  refused(form, "offset.not_negative_after_Q does not say that r_t is psi/4 at most");

  form = form_named("terminal_in_rows");
  form.not_negative[0] = "offset.at_most_after_Q";
  refused(form, "offset.at_most_after_Q does not say that r_t is not negative");
  form = form_named("terminal_in_rows");
  form.not_negative.pop_back();
  refused(form, "terminal_in_rows has not one theorem a case of an r_t that is not negative");
  form = form_named("terminal_in_rows");
  form.small_angle.pop_back();
  refused(form, "terminal_in_rows has not one theorem a case of a small r_t");
  form = form_named("velocities");
  form.arcsecant = "rotation.psi_half_angle";
  refused(form, "rotation.psi_half_angle does not say that cos(psi/2) is 1/(1 + alpha)");
  form = form_named("ratios");
  form.arcsecant = "rotation.cos_half_psi";
  refused(form, "nothing says that psi is 4 atan(tan_quarter)");

  form = form_named("velocities_in_rows");
  std::replace(form.bindings.begin(), form.bindings.end(), std::string("tangent.root"),
               std::string("tangent.cot_half"));
  refused(form, "tangent.cot_half has another root than alpha (2 + alpha)");
}
