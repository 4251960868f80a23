// SPDX-License-Identifier: GPL-2.0-or-later
#include "proof/normal_form.hpp"

#include <algorithm>

#include "proof/generators.hpp"
#include "proof/text.hpp"

namespace magicmass::proof {

using GiNaC::ex;
using GiNaC::ex_to;
using GiNaC::is_a;

NormalForm::NormalForm(const Domain& domain, const Definitions& definitions)
    : generators_(std::make_unique<Generators>(domain, definitions)) {}

NormalForm::~NormalForm() = default;

bool NormalForm::is_zero(const ex& e) {
  if (is_a<GiNaC::matrix>(e))
    return std::all_of(e.begin(), e.end(), [this](const ex& element) { return is_zero(element); });
  return generators_->reduced_parts(generators_->translate(e)).first.is_zero();
}

bool NormalForm::are_equal(const ex& left, const ex& right) {
  if (is_a<GiNaC::matrix>(left)) {
    for (std::size_t i = 0; i < left.nops(); ++i)
      if (!are_equal(left.op(i), right.op(i))) return false;
    return true;
  }
  generators_->translate(right);  // for its angles: both sides must divide them alike
  const ex one = generators_->translate(left);
  if (left.is_equal(right)) return true;
  const auto [left_above, left_below] = generators_->reduced_parts(one);
  const auto [right_above, right_below] = generators_->reduced_parts(generators_->translate(right));
  return generators_->reduced(left_above * right_below - right_above * left_below).is_zero();
}

void NormalForm::require_defined(const ex& e) {
  if (!is_a<GiNaC::matrix>(e)) {
    generators_->translate(e);
    return;
  }
  for (const ex& element : e) require_defined(element);
}

ex NormalForm::simplified(const ex& e) {
  if (is_a<GiNaC::matrix>(e)) {
    GiNaC::matrix result = ex_to<GiNaC::matrix>(e);
    for (unsigned row = 0; row < result.rows(); ++row)
      for (unsigned column = 0; column < result.cols(); ++column)
        result(row, column) = simplified(result(row, column));
    return result;
  }
  const auto [above, below] = generators_->quotient(generators_->translate(e));
  return generators_->back(generators_->tidied(above) / generators_->tidied(below));
}

bool NormalForm::is_positive(const ex& e) {
  return generators_->positive(generators_->translate(e));
}

bool NormalForm::is_not_negative(const ex& e) {
  return generators_->not_negative(generators_->translate(e));
}

const Conditions& NormalForm::conditions() const { return generators_->conditions; }

}  // namespace magicmass::proof
