#include "answers/motion.hpp"

#include "answers/derivation.hpp"
#include "equality/decide.hpp"
#include "magicmass/numbers/counts.hpp"

namespace answers {
namespace {

using namespace magicmass::scenes;
using cln::cl_I, cln::cl_RA;
using namespace notation;

Ball evaluated(const std::string& id, const std::map<kernel::Expr, Ball>& values) {
  return equality::enclosure(written_out(right_side(id)), values);
}

const char* const beyond = "; possible: fewer digits, or a double";

}  // namespace

Ball ball_of(const Alpha& alpha) {
  if (const auto* at = std::get_if<Threshold>(&alpha))
    return evaluated(at->is_magic ? "ratios.alpha_k" : "ratios.beta_k",
                     {{kernel::integer("k"), Ball(cl_RA(at->k))}});
  return *fraction_of(alpha);
}
Alpha alpha_of(const std::string& text) {
  return given_by_user("", [&] { return read_alpha(text); });
}
double nearest(const Alpha& alpha) { return value_of(alpha).to_double(); }
std::optional<cl_RA> fraction_of(const Alpha& alpha) {
  if (const auto* value = std::get_if<double>(&alpha)) return exact(*value);
  if (const auto* fraction = std::get_if<cl_RA>(&alpha)) return *fraction;
  const auto& at = std::get<Threshold>(alpha);
  return at.is_magic && at.k == 1 ? std::optional<cl_RA>(1) : std::nullopt;
}
Ball right_side_at(const char* id, const Ball& alpha, const cl_RA& n) {
  return evaluated(
      id,
      {{kernel::real("alpha"), alpha}, {kernel::real("V"), 1}, {kernel::integer("n"), Ball(n)}});
}

LargeCounts count_collisions(const Alpha& alpha) {
  if (const auto* at = std::get_if<Threshold>(&alpha))
    return {at->is_magic ? at->k : at->k + 1, at->k};  // magic.counts, deficient.counts
  if (*fraction_of(alpha) >= 1) return {1, 1};         // heavy.N_A, heavy.N_B
  if (const auto* value = std::get_if<double>(&alpha))
    if (const auto small = magicmass::count_collisions(*value))
      return {static_cast<long long>(small->N_A), static_cast<long long>(small->N_B)};
  const auto counts = [&] {
    const Ball at = ball_of(alpha);
    return LargeCounts{cln::numerator(right_side_at("counting.N_A", at).low()),
                       cln::numerator(right_side_at("counting.N_B", at).low())};
  };
  return with_bits(17, counts, beyond);
}

Row count_cells(const LargeCounts& counts) {
  return {whole_cell(kernel::digits(counts.N_A)), whole_cell(kernel::digits(counts.N_B))};
}

Balls velocities(const Alpha& alpha, const cl_I& n) {
  const Ball at = ball_of(alpha);
  Balls all;
  for (const char* id : {"power.a", "power.b", "power.c", "power.c_prime"})
    all.push_back(right_side_at(id, at, n));
  if (n == 0) return {all[0], 0, 0, 0};                // cycle.start_vector, cycle.c_start
  const auto* ratio = std::get_if<Threshold>(&alpha);  // alpha_1 = 1 is a number
  if (ratio ? ratio->is_magic && ratio->k == n : n == 1 && fraction_of(alpha) == cl_RA(1))
    return {0, all[1], all[2], 0};  // magic.velocities
  return all;
}
Balls terminal(const Alpha& alpha, const LargeCounts& counts) {
  const Balls after_P = velocities(alpha, counts.N_A), after_Q = velocities(alpha, counts.N_B);
  const bool Q_is_last = counts.N_A == counts.N_B;  // terminal.after_Q, terminal.after_P
  return {after_P[0], after_Q[1], Q_is_last ? after_Q[3] : after_P[2], after_Q[1] * after_Q[1]};
}

Balls terminal(const Trio& trio, std::optional<std::int64_t> N) {
  if (!N) {
    const Trio::Collision c = trio.collapse(trio.shape());
    return {c.v_left, c.v_left, c.v_left, power(c.v_left, 2), c.time};
  }
  const Balls v = trio.velocities(trio.shape(), *N);
  return {v[0], v[2], v[1], v[2] * v[2]};
}

Cell rho(const Alpha& alpha, const cl_RA& e) {
  const Trio trio = Trio::equal_blocks(value_of(alpha), value_of(e));
  const auto N = trio.count();
  return rounded([&] { return Balls{terminal(trio, N)[3]}; })[0];
}

std::optional<int> digits_wanted(const Request& request) {
  if (!request.has("digits")) return {};
  return static_cast<int>(request.size("digits", 1, 10000));
}

Row rounded(const std::function<Balls()>& values, std::optional<int> digits) {
  const auto cells = [&]() -> std::optional<Row> {
    Row row;
    for (const Ball& ball : values()) {
      const auto text = digits ? decimal(ball.low(), ball.high(), *digits) : std::nullopt;
      const auto number = digits ? std::nullopt : nearest_double(ball.low(), ball.high());
      if (!text && !number) return {};
      row.push_back(text ? text_cell(*text) : real_cell(*number));
    }
    return row;
  };
  return with_bits(digits.value_or(17), cells, beyond);
}

}  // namespace answers
