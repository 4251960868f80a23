// Evaluated forms of alpha_k and beta_k, from the sine or tangent of half of their angle.
#include "derivation/symbols.hpp"

namespace derivation {
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
