// The rest of the paper's table: roots in one piece, and tangents.
#include "derivation/symbols.hpp"

namespace derivation {
namespace {
Expr tan(Expr angle) { return fun("tan", {angle}); }
/// t is tan(psi/4), p nearly psi/2.
const Expr s = sqrt(alpha), root = sqrt(alpha * (2 + alpha)), p = sqrt(2 * alpha),
           t = sqrt(alpha / (2 + alpha));

/// The quarter of psi: cosine and sine as roots, psi as four times an arctangent, its tangent.
Theorem quarter(Book& book) {
  const Expr q = psi() / 4;
  const Theorem cosine_squared = part(book["power.quarter"], 1);
  const Theorems squares = angles({}, {q}) + Theorems{cosine_squared};
  book.show("cos_quarter_psi", "table:trig", "The quarter of psi:",
            turned(root_is((2 + alpha) / (2 * (1 + alpha)), cos(q), {cosine_squared})));
  book.show("sin_quarter_psi", "table:trig", "and",
            turned(root_is(alpha / (2 * (1 + alpha)), sin(q), squares)));
  const Theorem hypotenuse = root_is(1 + power(t, 2), 1 / cos(q), squares);
  const Theorem same =
      same_angle(equation(cos(q), cos(atan(t)), {rewrite(hypotenuse, at("cos atan", {{x, t}}))}),
                 {positive(atan(t))});
  book.show("quarter_psi", "so that", linear(eq(psi(), 4 * atan(t)), {same}));
  return turned(root_is(alpha / (2 + alpha), sin(q) / cos(q), squares));
}

// Small mass ratios: ranges of theta and psi; what the paper approximates, as bounds on both sides.

/// 2 p (1 - 5 alpha/12) <= psi and psi < 2 p, as psi = 4 atan(t), t^2 = alpha/(2 + alpha).
void psi_bounds(Book& book) {
  const Theorem mass = positive(alpha), t_positive = positive(t);
  const Theorem p_squared = root_squared(positive(2 * alpha));
  const Theorem t_squared = equation((2 + alpha) * power(t, 2), alpha);
  const Theorem t_below = scaled(lt(2 * t, p), lt(4 * power(t, 2), power(p, 2)), 1 / (p + 2 * t),
                                 {positive(alpha * power(t, 2))});
  const cln::cl_RA half = rational(1, 2).value();
  // (p + 2t)(2t - p + alpha p/4) = alpha^2 t^2/2 + alpha t (p - 2t)/2
  const Theorem t_above =
      arithmetic(le(p - alpha * p / 4, 2 * t),
                 {.equations = {{1 - alpha / 4, p_squared}, {alpha / 2 - 2, t_squared}},
                  .products = {{half, {mass, mass}, {t}}, {half, {mass, t_positive, t_below}, {}}},
                  .multipliers = {positive(p + 2 * t)}});
  const Theorem t_squared_below =
      linear(le(0, alpha / 2 - power(t, 2)), {positive(alpha * power(t, 2))});
  const Theorems facts{
      book["table.quarter_psi"],          at("atan bounds", {{x, t}}), t_above, t_below,
      times(t_positive, t_squared_below), times(mass, t_below)};
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

void table(Book& book) {
  book.chapter("table", "Table of sines, cosines and tangents", {alpha_positive});
  const Theorem sine_half = book["ball.sin_half_theta"];
  book.show("sin_half_theta", "table:trig", "Half of theta, in one root:",
            chain(sine_half, turned(root_is(alpha / (1 + alpha), s / sqrt(1 + alpha)))));
  const Theorem of_quarter = quarter(book);

  const Theorem is = book.name("tan", {x}, sin(x) / cos(x), {neq(cos(x), 0)}, "The tangent:");
  const auto show = [&](const std::string& name, Expr angle, Expr value, const Theorems& facts) {
    book.show("tan_" + name, "table:trig", name == "half_theta" ? "Their tangents:" : "and",
              equation(tan(angle), value, Theorems{at(is, {{x, angle}})} + facts));
  };
  const Theorem cos_half = book["ball.cos_half_theta"];
  know(positive(cos_half));
  show("half_theta", theta() / 2, s, {sine_half, cos_half});
  show("quarter_psi", psi() / 4, t, {turned(of_quarter)});
  show("half_psi", psi() / 2, root, {book["rotation.sin_half_psi"], book["rotation.cos_half_psi"]});
  // cos = numerator/d is not 0 where the numerator is not.
  const auto show_where = [&](const std::string& name, Expr angle, Expr numerator, Expr d,
                              Expr above, const Theorems& values) {
    const Theorem moves = assume(neq(numerator, 0));
    const Theorem none = given(eq(cos(angle), 0), [&](const Theorem& is_0) {
      return linear(eq(numerator, 0), {rewrite(is_0, equation(d * cos(angle), numerator, values))});
    });
    const Theorem divisor = tautology(neq(cos(angle), 0), {none, moves});
    know(divisor);
    show(name, angle, above / numerator, values + Theorems{moves, divisor});
  };
  show_where("theta", theta(), 1 - alpha, 1 + alpha, 2 * s,
             {book["ball.cos_theta"], book["ball.sin_theta"]});
  show_where("psi", psi(), 1 - 2 * alpha - power(alpha, 2), power(1 + alpha, 2), 2 * root,
             {book["rotation.cos_psi"], book["rotation.sin_psi"]});
}

void small_alpha(Book& book) {
  book.chapter("small_alpha", "Small mass ratios", {alpha_positive, V_positive});
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
