// SPDX-License-Identifier: GPL-2.0-or-later
#include "answers/restitution.hpp"

#include "answers/errors.hpp"
#include "answers/evaluate.hpp"
#include "derivation/book.hpp"
#include "kernel/polynomial.hpp"

namespace answers {
namespace {

using cln::cl_I;
using cln::cl_RA;
using kernel::Expr;

Expr symbol(const char* name) { return kernel::real(name); }
Expr index() { return kernel::integer("j"); }

Values values_of(const Inelastic& motion) {
  return {{symbol("M_A"), 1},
          {symbol("w_B"), 1},
          {symbol("M_C"), ball_of(motion.alpha)},
          {symbol("e"), Ball(motion.e)},
          {symbol("V"), 1},
          {symbol("L"), 1}};
}
/// The square of kappa, where alpha is rational: exactly.
std::optional<cl_RA> exact_square(const Inelastic& motion) {
  const auto* rational = std::get_if<cl_RA>(&motion.alpha);
  const auto* value = std::get_if<double>(&motion.alpha);
  if (rational == nullptr && value == nullptr) return {};
  const kernel::Substitution at{
      {symbol("M_A"), 1},
      {symbol("w_B"), 1},
      {symbol("M_C"), Expr(rational != nullptr ? *rational : exact(*value))},
      {symbol("e"), Expr(motion.e)}};
  return kernel::canonical(kernel::substitute(right_side("collapse.def_K"), at)).value();
}
/// The approach speed before collision number `at`.
Ball approach(const Inelastic& motion, const cl_I& at) {
  Values values = values_of(motion);
  values.emplace(index(), Ball(cl_RA(at)));
  values.emplace(kernel::fun("turn", {index()}), cln::evenp(at) ? 1 : -1);
  const Ball root = sqrt(values.at(symbol("e")));
  Ball power = cln::oddp(at) ? root : Ball(1);
  power = power * Ball(cln::expt(motion.e, cl_I(cln::floor1(at, 2))));
  values.emplace(kernel::fun("pow", {kernel::sqrt(symbol("e")), index()}), power);
  return evaluate(right_side("wedge.speed_sine"), values);
}

}  // namespace

std::optional<cl_I> count_collisions(const Inelastic& motion) {
  if (const auto square = exact_square(motion)) {
    if (*square >= 1) return {};
    // By Niven's theorem pi/h_e is whole for these squares of its cosine alone.
    for (const auto& [cosine_squared, turns] :
         {std::pair{cl_RA(1) / 4, 3}, {cl_RA(1) / 2, 4}, {cl_RA(3) / 4, 6}})
      if (*square == cosine_squared) return turns - 1;
  }
  std::optional<cl_I> N;
  with_bits(
      17,
      [&] {
        const Values values = values_of(motion);
        const Ball kappa = evaluate(right_side("wedge.kappa"), values);
        if (kappa.low() >= 1) return true;
        if (kappa.high() >= 1) return false;
        N = cln::numerator(evaluate(right_side("wedge.N"), values).low());
        return true;
      },
      "more digits would be needed than are allowed to tell how many collisions there are");
  return N;
}
Balls terminal(const Inelastic& motion, const cl_I& N) {
  Values values = values_of(motion);
  const Expr next = index() + 1;
  const auto closing = [](Expr at) {
    return kernel::fun("closing",
                       {symbol("M_A"), symbol("w_B"), symbol("M_C"), symbol("e"), symbol("V"), at});
  };
  values.emplace(closing(index()), approach(motion, N - 1));
  values.emplace(closing(next), approach(motion, N));
  values.emplace(kernel::fun("turn", {next}), cln::evenp(N) ? 1 : -1);
  const Ball b = evaluate(right_side("motion.B_velocity"), values);
  const auto relative = [&](const char* id) { return b + evaluate(right_side(id), values); };
  return {relative("motion.A_B"), b, relative("motion.C_B"), b * b};
}
Ball collapse_time(const Inelastic& motion) {
  Values values = values_of(motion);
  if (exact_square(motion) == cl_RA(1)) {  // a root of 0 in y_e, which no digits show
    const kernel::Exprs params{symbol("M_A"), symbol("w_B"), symbol("M_C"), symbol("e")};
    values.emplace(kernel::fun("y_e", params), 1);
  }
  return evaluate(right_side("collapse.def_t_end"), values);
}

}  // namespace answers
