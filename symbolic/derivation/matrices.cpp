// SPDX-License-Identifier: GPL-2.0-or-later
#include "derivation/matrices.hpp"

#include <stdexcept>

#include <ginac/ginac.h>

namespace magicmass::derivation {

using GiNaC::ex;
using GiNaC::ex_to;
using GiNaC::matrix;

ex plane_rotation(const ex& phi) { return matrix{{cos(phi), -sin(phi)}, {sin(phi), cos(phi)}}; }
ex rotation_1(const ex& phi) {
  return matrix{{1, 0, 0}, {0, cos(phi), -sin(phi)}, {0, sin(phi), cos(phi)}};
}
ex rotation_2(const ex& phi) {
  return matrix{{cos(phi), 0, sin(phi)}, {0, 1, 0}, {-sin(phi), 0, cos(phi)}};
}
ex rotation_3(const ex& phi) {
  return matrix{{cos(phi), -sin(phi), 0}, {sin(phi), cos(phi), 0}, {0, 0, 1}};
}
ex reflection_3() { return matrix{{1, 0, 0}, {0, 1, 0}, {0, 0, -1}}; }

ex transpose(const ex& m) { return ex_to<matrix>(m).transpose(); }
ex determinant(const ex& m) { return ex_to<matrix>(m).determinant(); }
ex unit(unsigned size) { return GiNaC::unit_matrix(size); }

ex cross(const ex& x, const ex& y) {
  return matrix{{x.op(1) * y.op(2) - x.op(2) * y.op(1)},
                {x.op(2) * y.op(0) - x.op(0) * y.op(2)},
                {x.op(0) * y.op(1) - x.op(1) * y.op(0)}};
}

ex columns(const std::vector<ex>& parts) {
  const auto rows = static_cast<unsigned>(parts.front().nops());
  matrix result(rows, static_cast<unsigned>(parts.size()));
  for (unsigned column = 0; column < parts.size(); ++column)
    for (unsigned row = 0; row < rows; ++row) result(row, column) = parts[column].op(row);
  return result;
}

ex collected(const ex& quotient, const std::vector<ex>& elements) {
  const ex parts = quotient.numer_denom();
  const ex above = parts.op(0).expand();
  ex rest = above;
  ex sum = 0;
  for (const ex& element : elements) {
    const ex coefficient = above.coeff(element, 1);
    rest = (rest - coefficient * element).expand();
    sum += GiNaC::factor(coefficient) * element;
  }
  return (sum + rest) / GiNaC::factor(parts.op(1));
}

LinearSolution solve_linear(const std::vector<proof::Statement>& equations,
                            const std::vector<ex>& unknowns) {
  const auto size = static_cast<unsigned>(unknowns.size());
  matrix coefficients(size, size);
  matrix rest(size, 1);
  for (unsigned row = 0; row < size; ++row) {
    ex remaining = (equations[row].lhs() - equations[row].rhs()).expand();
    for (unsigned column = 0; column < size; ++column) {
      coefficients(row, column) = remaining.coeff(unknowns[column], 1);
      remaining = (remaining - coefficients(row, column) * unknowns[column]).expand();
    }
    rest(row, 0) = remaining;
  }
  const matrix inverse = coefficients.inverse();
  const matrix values = inverse.mul(rest).mul_scalar(-1);
  LinearSolution solution;
  for (unsigned row = 0; row < size; ++row) {
    solution.values.push_back(values(row, 0).normal());
    solution.cofactors.emplace_back();
    for (unsigned column = 0; column < size; ++column)
      solution.cofactors.back().push_back(inverse(row, column));
  }
  return solution;
}

ex null_vector(const ex& m, const std::function<ex(const ex&)>& simplified) {
  matrix work = ex_to<matrix>(simplified(m));
  const unsigned size = work.cols();
  std::vector<unsigned> pivot_columns;
  unsigned row = 0;
  // Columns from the last on, so that the free one is the first that can be.
  for (unsigned column = size; column-- > 0 && row < work.rows();) {
    unsigned pivot = row;
    while (pivot < work.rows() && work(pivot, column).is_zero()) ++pivot;
    if (pivot == work.rows()) continue;
    for (unsigned j = 0; j < size; ++j) std::swap(work(row, j), work(pivot, j));
    const ex divisor = work(row, column);
    for (unsigned j = 0; j < size; ++j) work(row, j) = simplified(work(row, j) / divisor);
    for (unsigned i = 0; i < work.rows(); ++i) {
      if (i == row) continue;
      const ex multiple = work(i, column);
      for (unsigned j = 0; j < size; ++j)
        work(i, j) = simplified(work(i, j) - multiple * work(row, j));
    }
    pivot_columns.push_back(column);
    ++row;
  }
  if (pivot_columns.size() + 1 != size) throw std::runtime_error("the null space is not a line");
  unsigned free = 0;
  while (std::find(pivot_columns.begin(), pivot_columns.end(), free) != pivot_columns.end()) ++free;
  matrix result(size, 1);
  result(free, 0) = 1;
  for (unsigned i = 0; i < pivot_columns.size(); ++i)
    result(pivot_columns[i], 0) = simplified(-work(i, free));
  return result;
}

}  // namespace magicmass::derivation
