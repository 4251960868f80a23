#include <numbers>

#include "magicmass/exact/exact.hpp"
#include "magicmass/numbers/accurate.hpp"
#include "magicmass/numbers/counts.hpp"
#include "magicmass/numbers/fast.hpp"
#include "magicmass/oracle/certain.hpp"
#include "magicmass/plain/closed.hpp"
#include "magicmass/plain/product.hpp"
#include "magicmass/plain/tangent.hpp"
#include "magicmass/simulator/three_bodies.hpp"
#include "report/measure.hpp"

namespace report {
namespace {

using namespace magicmass;

// The paper's formulas typed by hand, as anybody would who needs the numbers, V = 1: the baseline
// of ratios; known to be bad near thresholds. Nobody else may call this.
namespace naive {
/// Ee & Lee eq. def:psi.
double psi(double alpha) { return 2 * std::atan(std::sqrt(alpha * (2 + alpha))); }

/// Ee & Lee eqs. eq:a-final to eq:c'-final, with V_CM = V/(2 + alpha); shares its trigonometry.
Velocities velocities(double alpha, std::int64_t n) {
  const double V_CM = 1 / (2 + alpha), turn = psi(alpha), k = double(n);
  const double cosine = std::cos(turn / 2), sine = std::sin(turn / 4);
  return {V_CM * (1 + std::cos(k * turn) / cosine),
          V_CM * (1 - std::cos((k + 0.5) * turn) / cosine),
          V_CM * (1 + std::sin((k - 0.25) * turn) / sine),
          V_CM * (1 - std::sin((k + 0.25) * turn) / sine)};
}

/// A straight line across mirror images of one wedge meets the j-th of them.
Collision collision(double alpha, std::int64_t j) {
  const double h = psi(alpha) / 2, sine = std::sin((double(j) + 1) * h);
  return {std::sin(double(j) * h) / sine, std::sin(h) / sine};
}

/// Ee & Lee eqs. eq:NA-ans and eq:NB-ans.
Counts counts_of(double turn) {
  const double cycles = std::numbers::pi / turn;
  return {std::int64_t(std::ceil(cycles - 0.5)), std::int64_t(std::ceil(cycles - 1))};
}
Counts counts(double alpha) { return counts_of(psi(alpha)); }

/// Ee & Lee eqs. eq:a-terminal, eq:b-terminal and eq:ct, with these counts.
Terminal terminal(double alpha) {
  const double turn = psi(alpha);
  const Counts N = counts_of(turn);
  const double V_CM = 1 / (2 + alpha);
  const double a_t = V_CM * (1 + (1 + alpha) * std::cos(double(N.N_A) * turn));
  const double b_t = V_CM * (1 - (1 + alpha) * std::cos((double(N.N_B) + 0.5) * turn));
  return {N, a_t, b_t, (1 - a_t - b_t) / alpha, b_t * b_t};
}

/// Ee & Lee eqs. exact:ak and exact:bk.
Ratios ratios(std::int64_t k) {
  const auto secant = [](double x) { return 1 / std::cos(x); };
  return {secant(std::numbers::pi / (2 * double(k) + 1)) - 1,
          secant(std::numbers::pi / (2 * double(k) + 2)) - 1};
}

}  // namespace naive

Velocities stepped(double alpha, std::int64_t n) {
  if (n > 1000) throw std::domain_error("stepping: allowed: n to 1000");
  simulator::Body<double> A{1, 0, 1}, C{alpha, 0, 0}, B{1, 1, 0};
  double c = 0;
  for (std::int64_t i = 0; i < n; ++i) {
    collide(A, C);
    c = C.velocity;
    collide(C, B);
  }
  return {A.velocity, B.velocity, c, C.velocity};
}

Terminal stepped_to_the_end(double alpha) {
  if (alpha < 1e-6) throw std::domain_error("stepping: allowed: alpha from 1e-6");
  simulator::ThreeBodies<double> motion(alpha);
  Counts counts;
  while (const auto event = motion.step()) ++(event->gap == 1 ? counts.N_A : counts.N_B);
  const auto& [A, C, B] = motion.bodies();
  return {counts, A.velocity, B.velocity, C.velocity, B.velocity * B.velocity};
}

/// alpha, where the rational numbers after n cycles are short.
cln::cl_RA short_rational(double alpha, std::int64_t n) {
  constexpr long most_bits = 1L << 13;
  const cln::cl_RA ratio = oracle::exact(alpha);
  if (oracle::exact_length(ratio, 2 * cln::cl_I(static_cast<long long>(n))) > most_bits)
    throw std::domain_error("exact rational: allowed: numbers of 8192 bits");
  return ratio;
}
auto rational_velocities(double alpha, std::int64_t n) {
  return generated::velocities_exact(short_rational(alpha, n), n);
}
auto rational_terminal(double alpha) {
  const auto [N_A, N_B] = count_collisions(alpha).value();
  const auto t = generated::terminal_exact(short_rational(alpha, N_A), N_A, N_B);
  const auto nearest = oracle::nearest;
  return Terminal{{N_A, N_B}, nearest(t.a_t), nearest(t.b_t), nearest(t.c_t), nearest(t.rho)};
}

double rounded(double x) { return x; }
double rounded(const cln::cl_RA& x) { return oracle::nearest(x); }

/// Our results and the generated ones have the same fields, some of them.
void store(Columns& to, std::size_t i, const auto& r) {
  const auto values = [&](const auto&... x) {
    std::size_t column = 0;
    ((to.values[column++][i] = rounded(x)), ...);
  };
  if constexpr (requires { r.value(); }) store(to, i, r.value());
  if constexpr (requires { r.c_prime; }) values(r.a, r.b, r.c, r.c_prime);
  if constexpr (requires { r.s; }) values(r.t, r.s);
  if constexpr (requires { r.rho; }) values(r.a_t, r.b_t, r.c_t, r.rho);
  if constexpr (requires { r.magic; }) values(r.magic, r.deficient);
  if constexpr (requires { r.alpha_; }) values(r.alpha_, r.beta_);
  if constexpr (requires { r.counts; }) store(to, i, r.counts);
  if constexpr (requires { r.N_A; }) {
    to.counts[0][i] = std::int64_t(r.N_A);
    to.counts[1][i] = std::int64_t(r.N_B);
  }
}

/// One call after the other, each result stored: nothing else is in the loop.
std::function<void(Columns&)> each(auto of) {
  return [of](Columns& columns) {
    for (std::size_t i = 0; i < columns.size(); ++i) {
      if constexpr (requires { of(0.5, std::int64_t{1}); })
        store(columns, i, of(columns.alpha[i], columns.index[i]));
      else if constexpr (
          requires { of(1).magic; } || requires { of(1).alpha_; })
        store(columns, i, of(columns.index[i]));
      else
        store(columns, i, of(columns.alpha[i]));
    }
  };
}

VelocityColumns velocity_columns(Columns& c) {
  return {c.values[0], c.values[1], c.values[2], c.values[3]};
}
TerminalColumns terminal_columns(Columns& c) {
  return {c.counts[0], c.counts[1], c.values[0], c.values[1], c.values[2], c.values[3]};
}

}  // namespace

Columns::Columns(std::span<const Input> inputs) {
  for (const Input& input : inputs) {
    alpha.push_back(input.alpha);
    index.push_back(input.index);
  }
  for (auto& column : values) column.resize(inputs.size());
  for (auto& column : counts) column.resize(inputs.size());
}

const std::vector<Implementation>& implementations() {
  using enum Quantity;
  using AtCycle = Velocities (*)(double, std::int64_t);
  using AtEnd = std::optional<Terminal> (*)(double);
  constexpr std::size_t few = 50;
  static const std::vector<Implementation> all{
      {"naive", velocities, each(naive::velocities)},
      {"closed", velocities, each(generated::velocities_closed<double>)},
      {"product", velocities, each(generated::velocities_product<double>)},
      {"tangent", velocities, each(generated::velocities_tangent<double>)},
      {"stepping", velocities, each(stepped), few},
      {"exact rational", velocities, each(rational_velocities), few},
      {"fast", velocities, each(AtCycle(fast::velocities))},
      {"accurate", velocities, each(AtCycle(accurate::velocities))},
      {"fast arrays", velocities,
       [](Columns& c) { fast::velocities(c.alpha, c.index, velocity_columns(c)); }},
      {"accurate arrays", velocities,
       [](Columns& c) { accurate::velocities(c.alpha, c.index, velocity_columns(c)); }},
      {"naive", collisions, each(naive::collision)},
      {"fast", collisions, each(fast::collision)},
      {"accurate", collisions, each(accurate::collision)},
      {"naive", terminal, each(naive::terminal)},
      {"closed", terminal, each(generated::terminal_closed<double>)},
      {"product", terminal, each(generated::terminal_product<double>)},
      {"tangent", terminal, each(generated::terminal_tangent<double>)},
      {"stepping", terminal, each(stepped_to_the_end), few},
      {"exact rational", terminal, each(rational_terminal), few},
      {"fast", terminal, each(AtEnd(fast::terminal))},
      {"accurate", terminal, each(AtEnd(accurate::terminal))},
      {"fast arrays", terminal, [](Columns& c) { fast::terminal(c.alpha, terminal_columns(c)); }},
      {"accurate arrays", terminal,
       [](Columns& c) { accurate::terminal(c.alpha, terminal_columns(c)); }},
      {"naive", counts, each(naive::counts)},
      {"count_collisions", counts, each([](double alpha) { return count_collisions(alpha); })},
      {"count arrays", counts,
       [](Columns& c) { count_collisions(c.alpha, c.counts[0], c.counts[1]); }},
      {"naive", ratios, each(naive::ratios)},
      {"closed", ratios, each(generated::ratios_closed<double>)},
      {"product", ratios, each(generated::ratios_product<double>)},
      {"tangent", ratios, each(generated::ratios_tangent<double>)},
      {"fast", ratios, each(fast::ratios)},
      {"accurate", ratios, each(accurate::ratios)},
  };
  return all;
}

}  // namespace report
