// The forms that are evaluated: from tan(psi/4) and cot(psi/2), without cancellation or overflow.
#include "derivation/symbols.hpp"

namespace derivation {
namespace {
void angle(Book& book) {
  const Names names{book, {alpha}, {alpha_positive}};
  const Theorem above = names.name("above", 2 + alpha, "With");
  know_for_good(positive(above));
  const Theorem w = rewrite(above, names.name("w", 1 / sqrt(alpha * of_alpha("above"))));
  const Theorem z = rewrite(above, names.name("z", alpha / of_alpha("above")));
  const Theorem t = names.name("t", alpha * of_alpha("w"));
  const Theorem half_h = names.name("half_h", atan(of_alpha("t")));
  const Expr T = of_alpha("t");
  know_for_good(linear(lt(0, T), {t, times(positive(w), alpha)}));
  const Theorem t_squared =
      book.show("t_squared", "t^2 is", equation(power(T, 2), of_alpha("z"), {t, w, z}));
  const Theorem T_is = root_is(alpha / (2 + alpha), T, {t_squared, z});
  const Theorem light = assume(le(alpha, 1));
  book.show(
      "z_at_most", "a third at most for a ball that is not heavier than a block:",
      linear(le(of_alpha("z"), rational(1, 3)), {z, times(light, rational(2, 3) / (2 + alpha))}));
  book.show("psi", "psi is four times the arctangent of t:",
            rewrite(turned(half_h), rewrite(T_is, book["table.quarter_psi"])));
}

/// Both velocities after P_n and both after Q_n, from one sine and one cosine.
void velocities(Book& book, const Angle& a) {
  const Names f{book, {alpha, n}, {alpha_positive, n_from_0}};
  const Theorem def_x = f.name("phase", 2 * of_alpha("half_h") * n, "With");
  const auto at_angle = [&](const std::string& name, Expr value) {
    return rewrite(a.quarter, rewrite(def_x, f.name(name, value)));
  };
  const Theorems parts{
      at_angle("sine", sin(f("phase"))),           at_angle("cosine", cos(f("phase"))),
      f.name("t_sine", of_alpha("t") * f("sine")), f.name("w_sine", of_alpha("w") * f("sine")),
      f.name("plus", f("cosine") + f("t_sine")),   f.name("minus", f("cosine") - f("t_sine")),
      f.name("along", f("cosine") + f("w_sine"))};
  book.show("t_sine_at_most", "where for a ball that is not heavier than a block",
            linear(le(f("t_sine"), f("w_sine")),
                   {parts[2], parts[3], times(a.t_small, assume(le(0, f("sine"))))}));
  const auto show = [&](const std::string& name, const std::string& id, Expr velocity, Expr form) {
    book.show(name, name == "a" ? "the velocities are" : "and",
              equation(velocity, V * form, Theorems{book["power." + id]} + parts + a.rules,
                       {n * psi() / 2, psi() / 4}));
  };
  show("a", "a_product", derivation::a(n), f("plus") * f("minus"));
  show("b", "b_product", b(n), 2 * f("along") * f("t_sine"));
  show("c", "c_product", c(n), 2 * f("plus") * f("w_sine"));
  show("c_prime", "c_prime_product", c_prime(n), -2 * f("minus") * f("w_sine"));
}
}  // namespace

Angle evaluated_angle(const Book& book) {
  const Expr T = of_alpha("t"), W = of_alpha("w"), q = psi() / 4;
  const Theorem t = book["evaluators.def_t"], quarters = book["power.quarter"];
  const Theorem w = rewrite(book["evaluators.def_above"], book["evaluators.def_w"]);
  const Theorem tangent = cancel(eq(T, sin(q) / cos(q)), {positive(cos(q))}, {t, w, quarters});
  return {linear(eq(of_alpha("half_h"), q), {book["evaluators.psi"]}),
          tangent,
          linear(le(T, W), {t, times(assume(le(alpha, 1)), positive(w))}),
          {equation(W, T / alpha, {t}), tangent, part(quarters, 1), book["power.V_CM"]}};
}
void evaluators(Book& book) {
  book.chapter("evaluators", "Forms for evaluation", {alpha_positive, n_from_0});
  angle(book);
  velocities(book, evaluated_angle(book));
}
/// Of alpha_k and beta_k, from the sine or tangent of half of their angle.
void ratio_forms(Book& book) {
  const Names names{book, {k}, {le(1, k)}};
  book.chapter("evaluators_ratios", "Forms for evaluation: ratios", {le(1, k)});
  for (const auto& [name, d] :
       {std::pair{"alpha_", 2 * (1 + 2 * k)}, std::pair{"beta_", 4 * (1 + k)}}) {
    const std::string kind = std::string(name) == "alpha_" ? "magic" : "deficient";
    const auto f = [&](const std::string& part) { return names(kind + "_" + part); };
    const Theorem y_is = names.name(kind + "_angle", pi() / d, "With");
    const Theorem sine = names.name(kind + "_sine", sin(f("angle")));
    const Theorem versed = names.name(kind + "_versed", 2 * power(f("sine"), 2));
    const Theorem cosine = names.name(kind + "_cosine", 1 - f("versed"));
    const Theorem definition = book[std::string("ratios.") + name + "k"];
    const Expr whole = right(definition).arg(1).arg(0);  // cos(pi/d)
    const Theorem twice =
        equation(cos(2 * f("angle")), 1 - 2 * power(sin(f("angle")), 2), {}, {f("angle")});
    const Theorem angle_is = equation(2 * f("angle"), whole.arg(0), {y_is});
    const Theorem is =
        equation(f("cosine"), whole, {cosine, versed, sine, rewrite(angle_is, twice)});
    know(linear(lt(0, f("cosine")), {is}));
    const Theorem ratio = book.show(
        kind, "the ratio is",
        rewrite(turned(is),
                equation(fun(name, {k}), f("versed") / whole,
                         {definition, linear(eq(f("versed"), 1 - whole), {is, cosine})})));
    const Expr c = cos(f("angle"));
    know(rewrite(turned(y_is), positive(cos(pi() / d), range_of(d))));
    const Theorem tangent = names.name(kind + "_tangent", f("sine") / c, "and, with");
    const Expr below = 1 - power(f("tangent"), 2);
    const Theorems rules{tangent, cosine, versed,
                         equation(power(c, 2), 1 - power(f("sine"), 2), {sine}, {f("angle")})};
    know(positive(equation(below, f("cosine") / power(c, 2), rules)));
    book.show(
        kind + "_by_tangent", "the same is",
        equation(fun(name, {k}), 2 * power(f("tangent"), 2) / below, rules + Theorems{ratio}));
  }
}
}  // namespace derivation
