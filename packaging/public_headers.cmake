# SPDX-License-Identifier: GPL-2.0-or-later
# The public interface: what is installed to be included by others, and what the reference (reference/) documents.
# What these include is in the list as well; tests/install/public_headers_test.sh checks that.
set(runtime_headers
  src/magicmass/accurate.hpp
  src/magicmass/batch.hpp
  src/magicmass/batch/instruction_set.hpp
  src/magicmass/counts.hpp
  src/magicmass/eigen.hpp
  src/magicmass/errors.hpp
  src/magicmass/fast.hpp
  src/magicmass/nearest_threshold.hpp
  src/magicmass/parallel.hpp
  src/magicmass/scenes/mass_ratio.hpp
  src/magicmass/scenes/scene.hpp
  src/magicmass/scenes/value.hpp
  src/magicmass/simulator/conservation_audit.hpp
  src/magicmass/simulator/contact.hpp
  src/magicmass/simulator/due_times.hpp
  src/magicmass/simulator/field.hpp
  src/magicmass/simulator/line.hpp
  src/magicmass/simulator/line_audit.hpp
  src/magicmass/simulator/line_motion.hpp
  src/magicmass/simulator/motion.hpp
  src/magicmass/simulator/rounding_margin.hpp
  src/magicmass/simulator/stalled_clock.hpp
  src/magicmass/simulator/three_body.hpp
  src/magicmass/simulator/trio_stepping.hpp
  src/magicmass/simulator/valid_input.hpp
  src/magicmass/simulator/velocity_stepping.hpp
  src/magicmass/terminal.hpp)
# Each generated evaluator for number types that the tiers do not have: any floating-point type, any exact field. Not what was
# surpassed (the paper's forms and the products, which the report and the course measure), what a tier has whole, and the
# table of all; the kernels beside them are compiled into the library.
file(GLOB generated_headers CONFIGURE_DEPENDS RELATIVE ${PROJECT_SOURCE_DIR}
  ${PROJECT_SOURCE_DIR}/generated/magicmass/*.hpp)
list(FILTER generated_headers EXCLUDE REGEX
  "/([a-z]+_closed|(velocities|encounters|collapse)_product|terminal_after_[PQ]|two_collisions_rational|evaluators)[.]hpp$")
# What a header that `generate --quantity` writes computes in. Installed for that, and no further promise is made of it.
file(GLOB arithmetic_headers CONFIGURE_DEPENDS RELATIVE ${PROJECT_SOURCE_DIR}
  ${PROJECT_SOURCE_DIR}/src/magicmass/arithmetic/*.hpp)

# The symbolic part.
set(reference_headers
  src/magicmass/reference/count.hpp
  src/magicmass/reference/cycle_map.hpp
  src/magicmass/reference/decimal.hpp
  src/magicmass/reference/enclosure.hpp
  src/magicmass/reference/exact_line.hpp
  src/magicmass/reference/exact_value.hpp
  src/magicmass/reference/interval.hpp
  src/magicmass/reference/number_field.hpp
  src/magicmass/reference/rational.hpp
  src/magicmass/reference/ratios.hpp
  src/magicmass/reference/restitution.hpp
  src/magicmass/reference/scene_plan.hpp
  src/magicmass/reference/trio_end.hpp
  src/magicmass/reference/trio_powers.hpp
  src/magicmass/reference/velocities.hpp)
set(symbolic_headers
  symbolic/algebraic/budget.hpp
  symbolic/algebraic/constant.hpp
  symbolic/algebraic/minimal_polynomial.hpp
  symbolic/algebraic/polynomial.hpp
  symbolic/algebraic/radicals.hpp
  symbolic/algebraic/ratio_polynomials.hpp
  symbolic/codegen/generate.hpp
  symbolic/codegen/specialised.hpp
  symbolic/derivation/derivation.hpp
  symbolic/derivation/index/paper_labels.hpp
  symbolic/derivation/laws.hpp
  symbolic/derivation/paper.hpp
  symbolic/equality/bounded.hpp
  symbolic/equality/decide.hpp
  symbolic/equality/domain.hpp
  symbolic/equality/expression.hpp
  symbolic/equality/parse.hpp
  symbolic/equality/tokens.hpp
  symbolic/proof/definitions.hpp
  symbolic/proof/domain.hpp
  symbolic/proof/kernel.hpp
  symbolic/proof/names.hpp
  symbolic/proof/normal_form.hpp
  symbolic/proof/statement.hpp
  symbolic/proof/text.hpp
  symbolic/proof/theorem.hpp
  symbolic/render/derivation_pages.hpp
  symbolic/render/formula.hpp
  symbolic/render/formula_mathml.hpp
  symbolic/render/formula_text.hpp
  symbolic/render/premises.hpp
  symbolic/render/text_box.hpp
  symbolic/render/theorem_index.hpp)

set(public_headers ${runtime_headers} ${generated_headers})
if(MAGICMASS_SYMBOLIC)
  list(APPEND public_headers ${reference_headers} ${symbolic_headers})
endif()
