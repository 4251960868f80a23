// SPDX-License-Identifier: GPL-2.0-or-later
#include "answers/motion.hpp"

#include <cmath>

#include "answers/errors.hpp"
#include "answers/evaluate.hpp"
#include "magicmass/numbers/counts.hpp"

namespace answers {
namespace {

using cln::cl_I;
using cln::cl_RA;
using notation::Alpha;
using notation::Deficient;
using notation::Magic;

const auto alpha_name = [] { return kernel::real("alpha"); };
const auto V_name = [] { return kernel::real("V"); };
const auto n_name = [] { return kernel::integer("n"); };
const auto k_name = [] { return kernel::integer("k"); };

/// Whether alpha >= 1: alpha_1 = 1 is the largest threshold (ratios.alpha_1, ratios.order).
bool is_heavy(const Alpha& alpha) { return !(*value_of(alpha).exact() < 1); }
/// At alpha_k after k cycles; alpha_1 = 1.
bool takes_everything(const Alpha& alpha, const cl_I& n) {
  if (const auto* magic = std::get_if<Magic>(&alpha)) return magic->k == n;
  const auto value = value_of(alpha);
  return n == 1 && value.exact() && *value.exact() == 1;
}
Ball velocity(const char* id, const Ball& alpha, const cl_I& n) {
  return evaluate(right_side(id),
                  {{alpha_name(), alpha}, {V_name(), 1}, {n_name(), Ball(cl_RA(n))}});
}

const char* const beyond = "; a mass ratio that is a double is decided";

}  // namespace

Ball ball_of(const Alpha& alpha) {
  if (const auto* magic = std::get_if<Magic>(&alpha))
    return evaluate(right_side("ratios.alpha_k"), {{k_name(), Ball(cl_RA(magic->k))}});
  if (const auto* deficient = std::get_if<Deficient>(&alpha))
    return evaluate(right_side("ratios.beta_k"), {{k_name(), Ball(cl_RA(deficient->k))}});
  return Ball(value_of(alpha).exact()->rational_part());
}
Alpha alpha_of(const std::string& text) {
  try {
    return notation::read_alpha(text);
  } catch (const kernel::Refused& refused) {
    throw InvalidInput(refused.what());
  }
}
double nearest(const Alpha& alpha) { return value_of(alpha).to_double(); }

LargeCounts count_collisions(const Alpha& alpha) {
  if (const auto* magic = std::get_if<Magic>(&alpha)) return {magic->k, magic->k};  // magic.counts
  if (const auto* deficient = std::get_if<Deficient>(&alpha))
    return {deficient->k + 1, deficient->k};  // deficient.counts
  if (is_heavy(alpha)) return {1, 1};         // heavy.N_A, heavy.N_B
  if (const auto* value = std::get_if<double>(&alpha)) {
    if (const auto small = magicmass::count_collisions(*value))
      return {static_cast<long long>(small->N_A), static_cast<long long>(small->N_B)};
  }
  const auto counts = [&] {
    const Values at{{alpha_name(), ball_of(alpha)}};
    return LargeCounts{cln::numerator(evaluate(right_side("counting.N_A"), at).low()),
                       cln::numerator(evaluate(right_side("counting.N_B"), at).low())};
  };
  return with_bits(17, counts, beyond);
}

Balls velocities(const Alpha& alpha, const cl_I& n) {
  const Ball at = ball_of(alpha);
  Balls all{velocity("power.a", at, n), velocity("power.b", at, n), velocity("power.c", at, n),
            velocity("power.c_prime", at, n)};
  if (n == 0) return {all[0], 0, 0, 0};  // cycle.start_vector, cycle.c_start
  if (takes_everything(alpha, n)) return {0, all[1], all[2], 0};  // magic.velocities
  return all;
}
Balls terminal(const Alpha& alpha, const LargeCounts& counts) {
  const Balls after_P = velocities(alpha, counts.N_A), after_Q = velocities(alpha, counts.N_B);
  const bool Q_is_last = counts.N_A == counts.N_B;  // terminal.after_Q, terminal.after_P
  return {after_P[0], after_Q[1], Q_is_last ? after_Q[3] : after_P[2], after_Q[1] * after_Q[1]};
}

Trio with_restitution(const Alpha& alpha, const cl_RA& e) {
  return Trio::equal_blocks(value_of(alpha), e);
}
Balls terminal(const Trio& trio, std::int64_t N) {
  const Balls v = trio.velocities(trio.shape(), N);
  return {v[0], v[2], v[1], v[2] * v[2]};
}

Cell rho(const Alpha& alpha, const cl_RA& e) {
  const Trio trio = with_restitution(alpha, e);
  const auto N = trio.count();
  return N ? rounded([&] { return Balls{terminal(trio, *N)[3]}; })[0] : missing_cell();
}

Row rounded(const std::function<Balls()>& values, std::optional<int> digits) {
  const auto cells = [&]() -> std::optional<Row> {
    Row row;
    for (const Ball& ball : values()) {
      const auto text = digits ? decimal(ball.low(), ball.high(), *digits) : std::nullopt;
      const auto number = digits ? std::nullopt : nearest_double(ball.low(), ball.high());
      if (!text && !number) return {};
      row.push_back(text ? exact_cell(*text) : real_cell(*number));
    }
    return row;
  };
  return with_bits(digits.value_or(17), cells, beyond);
}

}  // namespace answers
