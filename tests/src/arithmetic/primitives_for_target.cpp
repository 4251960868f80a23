// SPDX-License-Identifier: GPL-2.0-or-later
// Compiled once for each instruction set. Everything here is a template over a closure, so of this file alone.
#include <type_traits>

#include "arithmetic/primitive_numbers.hpp"
#include "arithmetic/primitives.hpp"
#include "arithmetic/rough_primitives.hpp"
#include "magicmass/arithmetic/arctangent.hpp"
#include "magicmass/arithmetic/error_free.hpp"
#include "magicmass/arithmetic/estrin.hpp"
#include "magicmass/arithmetic/lanes.hpp"
#include "magicmass/arithmetic/product.hpp"
#include "magicmass/arithmetic/rooted.hpp"
#include "magicmass/arithmetic/secant.hpp"
#include "magicmass/arithmetic/sine_cosine.hpp"

namespace magicmass::testing {
namespace {

using namespace arithmetic;
using Usual = Tabled<double, Alphas::usual>;
using Vanishing = Tabled<double, Alphas::vanishing>;

template <class Operation, std::size_t inputs, std::size_t outputs, class T>
void each(const double* in, double* out, std::size_t size) {
  for (std::size_t i = 0; i < size; i += lane_count<T>) {
    T x[inputs], y[outputs];
    for (std::size_t k = 0; k < inputs; ++k) x[k] = load<T>(in + k * size + i);
    Operation{}(static_cast<const T*>(x), static_cast<T*>(y));
    for (std::size_t k = 0; k < outputs; ++k) store(y[k], out + k * size + i);
  }
}

template <int lanes, class Operation, std::size_t inputs, std::size_t outputs>
constexpr Primitive::Run in_lanes() {
  if constexpr (lanes <= widest)
    return each<Operation, inputs, outputs, Lanes<lanes>>;
  else
    return nullptr;
}

template <std::size_t inputs, std::size_t outputs, class Operation>
constexpr Primitive of(const char* name, Operation) {
  return {name,
          inputs,
          outputs,
          {each<Operation, inputs, outputs, double>, in_lanes<2, Operation, inputs, outputs>(),
           in_lanes<4, Operation, inputs, outputs>(), in_lanes<8, Operation, inputs, outputs>()}};
}

/// For what takes one double at a time.
template <std::size_t inputs, std::size_t outputs, class Operation>
constexpr Primitive of_single(const char* name, Operation) {
  return {name, inputs, outputs, {each<Operation, inputs, outputs, double>}};
}

constexpr double some_coefficients[] = {0.3, -0.7, 0x1.1p-3, 5.0, -0.01, 0x1.fp1, -1.0};
constexpr double even_coefficients[] = {0.3, -0.7, 0x1.1p-3, 5.0};
constexpr double table[] = {0.0,  1.0,  2.0,  3.0,  4.0,  5.0,  6.0,  7.0,  8.0,  9.0,
                            10.0, 11.0, 12.0, 13.0, 14.0, 15.0, 16.0, 17.0, 18.0, 19.0};

}  // namespace

const Primitive primitives::MAGICMASS_TARGET[primitive_count] = {
    of<2, 7>("operations",
             [](const auto* x, auto* y) {
               y[0] = x[0] + x[1];
               y[1] = x[0] - x[1];
               y[2] = x[0] * x[1];
               y[3] = x[0] / x[1];
               y[4] = -x[0];
               y[5] = magnitude(x[0]);
               y[6] = square_root(magnitude(x[0]));
             }),
    of<2, 5>("comparisons",
             [](const auto* x, auto* y) {
               const auto one = decltype(x[0] + x[0])(1.0);
               y[0] = where(x[0] < x[1], one);
               y[1] = where(x[0] > x[1], one);
               y[2] = where(x[0] <= x[1], one);
               y[3] = where(x[0] >= x[1], one);
               y[4] = where(x[0] == x[1], one);
             }),
    of<4, 4>("choices",
             [](const auto* x, auto* y) {
               y[0] = select(x[0] < x[1], x[2], x[3]);
               y[1] = where(x[0] < x[1], x[2]);
               y[2] = smaller(x[2], x[3]);
               y[3] = times_sign_of(x[1], x[0]);
             }),
    of<1, 7>("table_columns",
             [](const auto* x, auto* y) {
               const auto node = nearest_node(x[0]);
               const auto two = two_columns(table, node.place);
               const auto four = four_columns(table, node.place);
               y[0] = four.first;
               y[1] = four.second;
               y[2] = four.third;
               y[3] = four.fourth;
               y[4] = two.first;
               y[5] = two.second;
               y[6] = node.at;
             }),
    of<1, 1>("nearest_whole", [](const auto* x, auto* y) { put(nearest_whole(x[0]), y); }),
    of<1, 2>("estimates",
             [](const auto* x, auto* y) {
               y[0] = reciprocal_estimate(x[0]);
               y[1] = reciprocal_square_root_estimate(x[0]);
             }),
    of<1, 1>("polynomial",
             [](const auto* x, auto* y) { put(polynomial(some_coefficients, x[0]), y); }),
    of<2, 2>("two_sum", [](const auto* x, auto* y) { put(two_sum(x[0], x[1]), y); }),
    of<2, 2>("two_difference", [](const auto* x, auto* y) { put(two_difference(x[0], x[1]), y); }),
    of<2, 2>("ordered_sum", [](const auto* x, auto* y) { put(ordered_sum(x[0], x[1]), y); }),
    of<2, 2>("ordered_difference",
             [](const auto* x, auto* y) { put(ordered_difference(x[0], x[1]), y); }),
    of<2, 2>("two_product", [](const auto* x, auto* y) { put(two_product(x[0], x[1]), y); }),
    of<2, 1>("one_minus_product",
             [](const auto* x, auto* y) { put(one_minus_product(x[0], x[1]), y); }),

    of<4, 2>("pair_sum", [](const auto* x, auto* y) { put(pair(x) + pair(x + 2), y); }),
    of<4, 2>("pair_difference", [](const auto* x, auto* y) { put(pair(x) - pair(x + 2), y); }),
    of<3, 2>("pair_plus_number", [](const auto* x, auto* y) { put(pair(x) + x[2], y); }),
    of<4, 2>("pair_product", [](const auto* x, auto* y) { put(pair(x) * pair(x + 2), y); }),
    of<3, 2>("pair_times_number", [](const auto* x, auto* y) { put(pair(x) * x[2], y); }),
    of<4, 2>("pair_quotient", [](const auto* x, auto* y) { put(pair(x) / pair(x + 2), y); }),
    of<2, 2>("pair_reciprocal", [](const auto* x, auto* y) { put(reciprocal(pair(x)), y); }),
    of<2, 2>("pair_root", [](const auto* x, auto* y) { put(reciprocal_square_root(pair(x)), y); }),
    of<4, 1>("rounded_product",
             [](const auto* x, auto* y) {
               put(rounded(Product<decltype(pair(x))>{pair(x), pair(x + 2), -2.0}), y);
             }),
    of<2, 2>("pair_arctangent", [](const auto* x, auto* y) { put(arctangent(pair(x)), y); }),
    of<2, 4>("pair_sine_cosine",
             [](const auto* x, auto* y) {
               const auto both = sine_cosine(pair(x));
               put(both.sine, y);
               put(both.cosine, y + 2);
             }),

    of<1, 1>("two_chains",
             [](const auto* x, auto* y) { put(two_chains(some_coefficients, x[0]), y); }),
    of<1, 1>("two_even_chains",
             [](const auto* x, auto* y) { put(two_chains(even_coefficients, x[0]), y); }),
    of<1, 1>("one_chain",
             [](const auto* x, auto* y) { put(one_chain(some_coefficients, x[0]), y); }),
    of<1, 1>("leading_half", [](const auto* x, auto* y) { put(leading<26>(x[0]), y); }),
    of<4, 2>("rough_product", [](const auto* x, auto* y) { put(rough(x) * rough(x + 2), y); }),
    of<3, 2>("rough_times_number", [](const auto* x, auto* y) { put(rough(x) * x[2], y); }),
    of<3, 2>("angle_times_whole", angle_times_whole),
    of<2, 2>("rough_from_pi", rough_from_pi),
    of<4, 2>("cut_product",
             [](const auto* x, auto* y) { put(parts(rough(x)) * parts(rough(x + 2)), y); }),
    of<2, 2>("rough_square", rough_square),
    of<3, 3>("rounded_rest", rounded_rest),
    of<4, 4>("cut_sums", cut_sums),
    of<4, 4>("cut_difference",
             [](const auto* x, auto* y) {
               put(parts(rough(x)) - parts(rough(x + 2)), y);
               put(parts(rough(x)) + parts(rough(x + 2)), y + 2);
             }),
    of<3, 2>("cut_times_number", [](const auto* x, auto* y) { put(parts(rough(x)) * x[2], y); }),
    of<3, 2>("cut_times_near_one", cut_times_near_one),
    of<4, 2>("wide_sums", wide_sums),
    of<1, 4>("rough_root", rough_root),
    of<1, 4>("rough_reciprocal", rough_reciprocal),
    of<1, 4>("rough_tangent", rough_tangent),
    of<2, 2>("rough_arctangent", rough_arctangent),
    of<2, 7>("rough_sine_cosine", rough_sine_cosine),

    of<6, 3>("tracked_sum", [](const auto* x, auto* y) { put(tracked(x) + tracked(x + 3), y); }),
    of<6, 3>("tracked_difference",
             [](const auto* x, auto* y) { put(tracked(x) - tracked(x + 3), y); }),
    of<4, 3>("tracked_plus_number", [](const auto* x, auto* y) { put(tracked(x) + x[3], y); }),
    of<6, 3>("tracked_product",
             [](const auto* x, auto* y) { put(tracked(x) * tracked(x + 3), y); }),
    of<4, 3>("tracked_times_number", [](const auto* x, auto* y) { put(tracked(x) * x[3], y); }),
    of<6, 3>("tracked_quotient",
             [](const auto* x, auto* y) { put(tracked(x) / tracked(x + 3), y); }),
    of<3, 3>("tracked_root",
             [](const auto* x, auto* y) { put(reciprocal_square_root(tracked(x)), y); }),
    of<3, 2>("tracked_rounding",
             [](const auto* x, auto* y) {
               y[0] = rounded(tracked(x));
               y[1] = where(certainly_rounded(tracked(x)), decltype(x[0] + x[0])(1.0));
             }),
    of<3, 3>("tracked_arctangent", [](const auto* x, auto* y) { put(arctangent(tracked(x)), y); }),
    of<3, 6>("tracked_sine_cosine",
             [](const auto* x, auto* y) {
               const auto both = sine_cosine(tracked(x));
               put(both.sine, y);
               put(both.cosine, y + 3);
             }),

    of<6, 3>("fused_product", [](const auto* x, auto* y) { put(fused(x) * fused(x + 3), y); }),
    of<4, 3>("fused_times_number", [](const auto* x, auto* y) { put(fused(x) * x[3], y); }),
    of<2, 3>("fused_root_argument",
             [](const auto* x, auto* y) {
               using Number = decltype(fused(x));
               put(Number::root_argument(x[0], x[0] >= x[1]), y);
             }),
    of<3, 3>("fused_root",
             [](const auto* x, auto* y) { put(reciprocal_square_root(fused(x)), y); }),
    of<3, 2>("fused_rounding",
             [](const auto* x, auto* y) {
               y[0] = rounded(fused(x));
               y[1] = where(certainly_rounded(fused(x)), decltype(x[0] + x[0])(1.0));
             }),
    of<3, 3>("fused_arctangent", [](const auto* x, auto* y) { put(arctangent(fused(x)), y); }),
    of<3, 6>("fused_sine_cosine",
             [](const auto* x, auto* y) {
               const auto both = sine_cosine(fused(x));
               put(both.sine, y);
               put(both.cosine, y + 3);
             }),

    of<6, 3>("bounded_sum", [](const auto* x, auto* y) { put(bounded(x) + bounded(x + 3), y); }),
    of<4, 3>("bounded_plus_number", [](const auto* x, auto* y) { put(bounded(x) + x[3], y); }),
    of<6, 3>("bounded_product",
             [](const auto* x, auto* y) { put(bounded(x) * bounded(x + 3), y); }),
    of<4, 3>("bounded_times_number", [](const auto* x, auto* y) { put(bounded(x) * x[3], y); }),
    of<6, 3>("bounded_quotient",
             [](const auto* x, auto* y) { put(bounded(x) / bounded(x + 3), y); }),
    of<3, 3>("bounded_root",
             [](const auto* x, auto* y) { put(reciprocal_square_root(bounded(x)), y); }),
    of<3, 2>("bounded_rounding",
             [](const auto* x, auto* y) {
               y[0] = rounded(bounded(x));
               y[1] = where(certainly_rounded(bounded(x)), decltype(x[0] + x[0])(1.0));
             }),
    of<3, 3>("bounded_arctangent", [](const auto* x, auto* y) { put(arctangent(bounded(x)), y); }),
    of<3, 6>("bounded_sine_cosine",
             [](const auto* x, auto* y) {
               const auto both = sine_cosine(bounded(x));
               put(both.sine, y);
               put(both.cosine, y + 3);
             }),

    of_single<2, 2>("tabled_reciprocal",
                    [](const double* x, double* y) { put(reciprocal(tabled(x)), y); }),
    of_single<2, 2>("tabled_root",
                    [](const double* x, double* y) { put(reciprocal_square_root(tabled(x)), y); }),
    of_single<2, 2>("tabled_arctangent",
                    [](const double* x, double* y) { put(arctangent(tabled(x)), y); }),
    of_single<3, 4>("tabled_sine_cosine",
                    [](const double* x, double* y) {
                      const auto both =
                          sine_cosine(EarlyAngle<Alphas::usual>{Pair<double>(x[0], x[1]), x[2]});
                      put(both.sine.pair, y);
                      put(both.cosine.pair, y + 2);
                    }),
    of_single<1, 2>(
        "usual_tangent",
        [](const double* x, double* y) { put(Usual::half_arcsecant_tangent(x[0]).pair, y); }),
    of_single<1, 2>(
        "vanishing_tangent",
        [](const double* x, double* y) { put(Vanishing::half_arcsecant_tangent(x[0]).pair, y); }),
    of_single<1, 3>("early_half_arcsecant",
                    [](const double* x, double* y) {
                      const auto angle = half_arcsecant(x[0], Usual());
                      put(angle.pair, y);
                      y[2] = angle.early;
                    }),
    of_single<3, 4>("usual_small_sine_cosine",
                    [](const double* x, double* y) {
                      const auto both =
                          small_sine_cosine(Usual::Magnitude{{Pair<double>(x[0], x[1]), x[2]}});
                      put(both.sine.pair, y);
                      put(both.cosine.pair, y + 2);
                    }),
    of_single<2, 2>("vanishing_small_sine",
                    [](const double* x, double* y) {
                      const auto both =
                          small_sine_cosine(Vanishing::Magnitude{{Pair<double>(x[0], x[1]), x[0]}});
                      put(both.sine.pair, y);
                    }),
    of_single<1, 1>("root_arctangent",
                    [](const double* x, double* y) { y[0] = atan(sqrt(Rooted(x[0]))).value; }),
    of_single<1, 1>("rounded_half_arcsecant",
                    [](const double* x, double* y) { y[0] = rounded_half_arcsecant_of(x[0]); }),
    of_single<1, 2>("half_arcsecant",
                    [](const double* x, double* y) { put(half_arcsecant_of(x[0]), y); }),
    of_single<4, 4>("secants",
                    [](const double* x, double* y) {
                      const auto both = secants_less_one(tabled(x), tabled(x + 2));
                      put(both.first, y);
                      put(both.second, y + 2);
                    }),
    of_single<2, 4>("whole_secants",
                    [](const double* x, double* y) {
                      const auto both = secants_less_one(Whole(x[0]), Whole(x[1]));
                      put(both.first.pair, y);
                      put(both.second.pair, y + 2);
                    }),
};

}  // namespace magicmass::testing
