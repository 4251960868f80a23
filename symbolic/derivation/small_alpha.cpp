// Small mass ratios: ranges of theta and psi; what the paper approximates, as bounds on both sides.
#include "derivation/symbols.hpp"

namespace derivation {
namespace {
const Expr p = sqrt(2 * alpha), q = sqrt(alpha / (2 + alpha));

/// 2 p (1 - 5 alpha/12) <= psi and psi < 2 p, as psi = 4 atan(q), q^2 = alpha/(2 + alpha).
void psi_bounds(Book& book) {
  const Theorem mass = positive(alpha), q_positive = positive(q);
  const Theorem p_squared = root_squared(positive(2 * alpha));
  const Theorem q_squared = equation((2 + alpha) * power(q, 2), alpha);
  const Theorem q_below = scaled(lt(2 * q, p), lt(4 * power(q, 2), power(p, 2)), 1 / (p + 2 * q),
                                 {positive(alpha * power(q, 2))});
  const cln::cl_RA half = rational(1, 2).value();
  // (p + 2q)(2q - p + alpha p/4) = alpha^2 q^2/2 + alpha q (p - 2q)/2
  const Theorem q_above =
      arithmetic(le(p - alpha * p / 4, 2 * q),
                 {.equations = {{1 - alpha / 4, p_squared}, {alpha / 2 - 2, q_squared}},
                  .products = {{half, {mass, mass}, {q}}, {half, {mass, q_positive, q_below}, {}}},
                  .multipliers = {positive(p + 2 * q)}});
  const Theorem q_squared_below =
      linear(le(0, alpha / 2 - power(q, 2)), {positive(alpha * power(q, 2))});
  const Theorems facts{
      book["table.quarter_psi"],          at("atan bounds", {{x, q}}), q_above, q_below,
      times(q_positive, q_squared_below), times(mass, q_below)};
  book.show("psi_bounds", "eq:NA-approx", "psi is about 2 sqrt(2 alpha):",
            linear(logic_and({le(2 * p * (1 - rational(5, 12) * alpha), psi()), lt(psi(), 2 * p)}),
                   facts));
}

void counts(Book& book) {
  const Theorem bounds = book["small_alpha.psi_bounds"];
  const Expr share = 1 - rational(5, 12) * alpha;
  const Known small({linear(lt(0, share), {assume(lt(alpha, rational(12, 5)))})});
  const Expr fewest = pi() / (2 * p), most = pi() / (2 * p * share);
  const Theorem at_least =
      linear(le(fewest, pi() / psi()), {times(part(bounds, 1), pi() / 2 / (psi() * p))});
  const Theorem at_most =
      linear(le(pi() / psi(), most), {times(part(bounds, 0), pi() / 2 / (psi() * p * share))});
  for (const auto& [name, count, shift, below] :
       {std::tuple{"N_A", N_A(), rational(1, 2), most + rational(1, 2)},
        std::tuple{"N_B", N_B(), Expr(1), most}})
    book.show(name, "eq:NA-approx",
              std::string(name) == "N_A" ? "So A has about pi/(2 sqrt(2 alpha)) collisions,"
                                         : "and so has B:",
              linear(logic_and({le(fewest - shift, count), lt(count, below)}),
                     {at_least, at_most, book["counting." + std::string(name)]}));
}
}  // namespace

void small_alpha(Book& book) {
  book.chapter("small_alpha", "Small mass ratios", {alpha_positive, V_positive});
  const Expr s = sqrt(alpha);
  const Theorem definition = book["ball.theta"];
  book.show("theta_range", "The range of theta:",
            both({positive(definition), linear(lt(theta(), pi()), {definition})}));
  const Theorems bounds{definition, at("atan bounds", {{x, s}})};
  book.show("theta_bounds", "theta is about 2 sqrt(alpha):",
            linear(logic_and({le(2 * s * (1 - alpha / 3), theta()), le(theta(), 2 * s)}), bounds));
  const Expr third = pi() / 3;
  const Theorem falls = cosine_falls(assume(le(third, psi() / 2)));
  const Theorem less =
      otherwise(lt(psi() / 2, third), {falls, book["rotation.cos_half_psi"], book["ratios.third"],
                                       times(assume(lt(alpha, 1)), 1 / (1 + alpha))});
  book.show("psi_light",
            "The range of psi for such a ball:", linear(lt(psi(), 2 * pi() / 3), {less}));
  psi_bounds(book);
  counts(book);
}
}  // namespace derivation
