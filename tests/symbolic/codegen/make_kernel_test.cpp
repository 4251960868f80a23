// SPDX-License-Identifier: GPL-2.0-or-later
// What a kernel's form says of its theorems is checked.
#include "codegen/make_kernel.hpp"

#include <algorithm>

#include <catch2/catch.hpp>

#include "derivation/derivation.hpp"

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

TEST_CASE("a kernel's form that says what its theorems do not is refused", "[exam]") {
  const auto theorems = derivation::derive().theorems;
  const auto refused = [&theorems](const KernelForm& form, const char* message) {
    CHECK_THROWS_WITH(codegen::make_kernel(form, theorems), message);
  };
  for (const KernelForm& form : codegen::kernel_forms())
    CHECK_NOTHROW(codegen::make_kernel(form, theorems));

  KernelForm form = form_named("terminal");
  form.other_cases[0].second = {"offset.b_after_P"};
  refused(form, "offset.a_after_Q and offset.b_after_P have different right sides");

  form = form_named("velocities");
  std::swap(form.first[0], form.first[1]);
  refused(form, "tangent.a does not become tangent.first_b from alpha = 1 on");

  form = form_named("velocities");  // an index of the wrong kind: sine and cosine change places
  form.first_index.clear();
  refused(form, "tangent.a does not become tangent.first_a from alpha = 1 on");

  form = form_named("encounters");
  form.first.back() = "tangent.first_t";
  refused(form, "tangent.s_product does not become tangent.first_t from alpha = 1 on");

  form = form_named("angle");
  form.bindings.push_back("tangent.no_such");
  CHECK_THROWS_WITH(codegen::make_kernel(form, theorems), "no theorem is called tangent.no_such");
}
