// SPDX-License-Identifier: GPL-2.0-or-later
#include "codegen/pipelines.hpp"

#include "codegen/passes/canonical_order.hpp"
#include "codegen/passes/common_subexpressions.hpp"
#include "codegen/passes/dead_code.hpp"
#include "codegen/passes/flat_products.hpp"
#include "codegen/passes/half_arcsecants.hpp"
#include "codegen/passes/paired_sine_cosine.hpp"
#include "codegen/passes/reciprocal_square_roots.hpp"
#include "codegen/passes/secants_of_parts.hpp"
#include "codegen/passes/shared_products.hpp"
#include "codegen/passes/shared_reciprocals.hpp"
#include "codegen/passes/strength_reduction.hpp"
#include "codegen/passes/turned_differences.hpp"

namespace magicmass::codegen {

Program prepared(const Program& lowered) {
  return common_subexpressions(strength_reduction(common_subexpressions(canonical_order(lowered))));
}

Program finished(const Program& program, const std::vector<std::string>& wanted) {
  return paired_sine_cosine(shared_reciprocals(dead_code(program, wanted)));
}

Program in_plain_numbers(const Program& lowered) {
  return paired_sine_cosine(shared_reciprocals(prepared(lowered)));
}

namespace {

Program in_number_types(const Program& prepared) {
  return paired_sine_cosine(
      turned_differences(common_subexpressions(shared_products(common_subexpressions(
          flat_products(flat_products(reciprocal_square_roots(secants_of_parts(prepared)))))))));
}

}  // namespace

Program for_kernel(const Program& lowered) { return in_number_types(prepared(lowered)); }

Program for_kernel_with_arcsecant(const Program& lowered) {
  return in_number_types(half_arcsecants(prepared(lowered)));
}

}  // namespace magicmass::codegen
