// SPDX-License-Identifier: MIT
// The paper's vector and matrices as Eigen's, and the batch functions on Eigen's arrays. Link magicmass::eigen.
#pragma once

#include <concepts>
#include <cstdint>
#include <span>
#include <string>
#include <type_traits>
#include <utility>

#include <Eigen/Core>

#include "magicmass/batch.hpp"
#include "magicmass/cycle_matrices.hpp"
#include "magicmass/errors.hpp"

namespace magicmass {

/// A column of three.
template <class Scalar>
using Vector3 = Eigen::Matrix<Scalar, 3, 1>;
/// Three by three.
template <class Scalar>
using Matrix3 = Eigen::Matrix<Scalar, 3, 3>;

namespace eigen {

/// A generated matrix as one of Eigen's.
template <class Scalar>
Matrix3<Scalar> matrix(const generated::Rows<Scalar>& rows) {
  Matrix3<Scalar> result;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      result(i, j) = rows[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)];
  return result;
}

}  // namespace eigen

/// (a_n, b_n, sqrt(alpha) c'_n) in units of V (Ee & Lee eq. def:Vn), a vector of length 1 for every n from 0 to N_B. For float, double
/// and long double within 10 eps of 1 in each component, alpha normal; without error in a field that has sqrt(alpha).
template <class Scalar, class Integer>
Vector3<Scalar> V_n(const Scalar& alpha, const Integer& n) {
  if constexpr (std::is_floating_point_v<Scalar>) {
    const auto [a, b, c] = generated::V_n_tangent(alpha, static_cast<std::int64_t>(n));
    return {a, b, c};
  } else {
    const auto [a, b, c] = generated::V_n_exact(alpha, n);
    return {a, b, c};
  }
}

/// One cycle: V_n = Lambda V_(n-1) (eq:Lambda), each entry within 4 eps of 1; without error in a field that has sqrt(alpha).
template <class Scalar>
Matrix3<Scalar> Lambda(const Scalar& alpha) {
  return eigen::matrix(generated::Lambda(alpha));
}

/// The frame in which Lambda turns by psi about the third axis: Lambda = R lambda_3(psi) R^T (eq:R-app), each entry within 4 eps
/// of 1.
template <class Scalar>
Matrix3<Scalar> R(const Scalar& alpha) {
  return eigen::matrix(generated::R(alpha));
}

namespace eigen {

/// A dense column or row of Number in memory: an array, a vector, a Map, a Ref, a column of a matrix. An expression has no
/// memory and is refused here; evaluate it into an array first.
template <class Array, class Number>
concept ColumnOf = requires(std::remove_reference_t<Array>& array) {
  { array.data() } -> std::convertible_to<const Number*>;
  { array.size() } -> std::convertible_to<Eigen::Index>;
  { array.innerStride() } -> std::convertible_to<Eigen::Index>;
  requires bool(std::remove_cvref_t<Array>::IsVectorAtCompileTime);
};

/// The same memory as a span. Throws InvalidInput where elements are not side by side.
template <class Number, class Array>
auto column(Array&& array) {
  if (array.size() > 1 && array.innerStride() != 1)
    throw InvalidInput("elements of an array must be side by side, but their stride is " +
                       std::to_string(array.innerStride()) + "; copy the array first");
  return std::span(array.data(), static_cast<std::size_t>(array.size()));
}

template <class Array>
concept Doubles = ColumnOf<Array, double>;
template <class Array>
concept Integers = ColumnOf<Array, std::int64_t>;

/// What can be written to.
template <class Array>
concept WritableDoubles = Doubles<Array> && requires(Array& array) {
  { array.data() } -> std::same_as<double*>;
};
template <class Array>
concept WritableIntegers = Integers<Array> && requires(Array& array) {
  { array.data() } -> std::same_as<std::int64_t*>;
};

}  // namespace eigen

/// The batch functions of magicmass/batch.hpp on Eigen's arrays, which are not copied: what is said there holds here.
template <eigen::Doubles Alpha, eigen::WritableIntegers A, eigen::WritableIntegers B>
void count_collisions(const Alpha& alpha, A&& N_A, B&& N_B) {
  count_collisions(eigen::column<double>(alpha), eigen::column<std::int64_t>(N_A),
                   eigen::column<std::int64_t>(N_B));
}
template <eigen::WritableDoubles A, eigen::WritableDoubles B, eigen::WritableDoubles C,
          eigen::WritableDoubles D>
/// As of spans in batch.hpp.
void velocity_stream(double alpha, std::int64_t first_n, A&& a, B&& b, C&& c, D&& c_prime) {
  velocity_stream(alpha, first_n, eigen::column<double>(a), eigen::column<double>(b),
                  eigen::column<double>(c), eigen::column<double>(c_prime));
}

namespace fast {
template <eigen::Doubles Alpha, eigen::Integers N, eigen::WritableDoubles A,
          eigen::WritableDoubles B, eigen::WritableDoubles C, eigen::WritableDoubles D>
/// As of spans in batch.hpp.
void velocities(const Alpha& alpha, const N& n, A&& a, B&& b, C&& c, D&& c_prime) {
  velocities(eigen::column<double>(alpha), eigen::column<std::int64_t>(n), eigen::column<double>(a),
             eigen::column<double>(b), eigen::column<double>(c), eigen::column<double>(c_prime));
}
template <eigen::Doubles Alpha, eigen::WritableDoubles A, eigen::WritableDoubles B,
          eigen::WritableDoubles C, eigen::WritableDoubles D>
/// As of spans in batch.hpp.
void velocities(const Alpha& alpha, std::int64_t n, A&& a, B&& b, C&& c, D&& c_prime) {
  velocities(eigen::column<double>(alpha), n, eigen::column<double>(a), eigen::column<double>(b),
             eigen::column<double>(c), eigen::column<double>(c_prime));
}
template <eigen::Doubles Alpha, eigen::WritableIntegers NA, eigen::WritableIntegers NB,
          eigen::WritableDoubles A, eigen::WritableDoubles B, eigen::WritableDoubles C>
/// As of spans in batch.hpp.
void terminal(const Alpha& alpha, NA&& N_A, NB&& N_B, A&& a_t, B&& b_t, C&& c_t) {
  terminal(eigen::column<double>(alpha), eigen::column<std::int64_t>(N_A),
           eigen::column<std::int64_t>(N_B), eigen::column<double>(a_t), eigen::column<double>(b_t),
           eigen::column<double>(c_t));
}
/// As of spans in batch.hpp.
template <eigen::Doubles Alpha, eigen::WritableDoubles Rho>
void transmission(const Alpha& alpha, double e, Rho&& rho) {
  transmission(eigen::column<double>(alpha), e, eigen::column<double>(rho));
}
/// As of spans in batch.hpp.
template <eigen::WritableDoubles M, eigen::WritableDoubles D>
void ratios(std::int64_t first_k, M&& magic, D&& deficient) {
  ratios(first_k, eigen::column<double>(magic), eigen::column<double>(deficient));
}
}  // namespace fast

namespace accurate {
template <eigen::Doubles Alpha, eigen::Integers N, eigen::WritableDoubles A,
          eigen::WritableDoubles B, eigen::WritableDoubles C, eigen::WritableDoubles D>
/// As of spans in batch.hpp.
void velocities(const Alpha& alpha, const N& n, A&& a, B&& b, C&& c, D&& c_prime) {
  velocities(eigen::column<double>(alpha), eigen::column<std::int64_t>(n), eigen::column<double>(a),
             eigen::column<double>(b), eigen::column<double>(c), eigen::column<double>(c_prime));
}
template <eigen::Doubles Alpha, eigen::WritableDoubles A, eigen::WritableDoubles B,
          eigen::WritableDoubles C, eigen::WritableDoubles D>
/// As of spans in batch.hpp.
void velocities(const Alpha& alpha, std::int64_t n, A&& a, B&& b, C&& c, D&& c_prime) {
  velocities(eigen::column<double>(alpha), n, eigen::column<double>(a), eigen::column<double>(b),
             eigen::column<double>(c), eigen::column<double>(c_prime));
}
template <eigen::Doubles Alpha, eigen::WritableIntegers NA, eigen::WritableIntegers NB,
          eigen::WritableDoubles A, eigen::WritableDoubles B, eigen::WritableDoubles C>
/// As of spans in batch.hpp.
void terminal(const Alpha& alpha, NA&& N_A, NB&& N_B, A&& a_t, B&& b_t, C&& c_t) {
  terminal(eigen::column<double>(alpha), eigen::column<std::int64_t>(N_A),
           eigen::column<std::int64_t>(N_B), eigen::column<double>(a_t), eigen::column<double>(b_t),
           eigen::column<double>(c_t));
}
/// As of spans in batch.hpp.
template <eigen::WritableDoubles M, eigen::WritableDoubles D>
void ratios(std::int64_t first_k, M&& magic, D&& deficient) {
  ratios(first_k, eigen::column<double>(magic), eigen::column<double>(deficient));
}
}  // namespace accurate

}  // namespace magicmass
