// The mass ratios where counts change: N_A = k iff alpha_k <= alpha < alpha_(k-1); beta_k for N_B.
#include "derivation/symbols.hpp"

namespace derivation {
namespace {
const Expr edge = pi() / 2;

/// For 0 < x < pi/2: the ratio with psi/2 = x is at most alpha if and only if x <= psi/2.
void ratio_of_angle(Book& book) {
  const Known range({assume(lt(0, x)), assume(lt(x, edge))});
  const Theorem value = book["rotation.cos_half_psi"];
  const Expr ratio = solve({eq(right(value), cos(x))}, {alpha})[0];
  book.show("ratio",
            "The mass ratio at which psi/2 is an angle x between 0 and pi/2, by solving "
            "1/(1 + alpha) = cos(x):",
            equation(cos(half()), cos(x), {value, assume(eq(alpha, ratio))}));
  const Expr cosine = right(value);
  const auto show = [&](const char* name, const char* words, auto less, auto contrary) {
    const Expr ratios = less(ratio, alpha), cosines = less(cosine, cos(x));
    const auto falls = [&](Expr angles, Expr goal) {
      return given(angles, [&](const Theorem& t) {
        return linear(goal, {cosine_falls(t), value});
      });
    };
    book.show(name, words,
              tautology(iff(ratios, less(x, half())),
                        {same_sign(iff(ratios, cosines), (1 + alpha) / cos(x), {}),
                         falls(less(x, half()), cosines),
                         falls(contrary(half(), x), contrary(cos(x), cosine))}));
  };
  show("reached", "Ratios from there on have psi/2 >= x, and no others:", le, lt);
  show("passed", "and larger ratios psi/2 > x:", lt, le);
  know(both({assume(lt(x, y)), assume(lt(y, edge))}));
  book.show("rises", "A larger angle is that of a larger ratio:",
            linear(lt(ratio, substitute(ratio, {{x, y}})),
                   {times(cosine_falls(assume(lt(x, y))), 1 / (cos(x) * cos(y)))}));
}

struct Threshold {
  std::string count, name, label, range_label;
  Expr shift;  // N = ceil(pi/psi - shift)
  Expr denominator(Expr i) const { return 2 * i + 2 * shift.value(); }
};

void threshold(Book& book, const Threshold& which) {
  const Theorem from_1 = assume(le(1, k)), from_2 = assume(le(2, k));
  const Theorem number = book["counting." + which.count];
  const Expr count = left(number), d = which.denominator(k);
  const Expr ratio = left(book["ratios.reached"]).arg(0);
  const Theorems range = range_of(d, {from_1});
  know_for_good(
      book.show(which.name + "k_cosine",
                "The cosine of pi/(" + text(d) + ") is positive:", positive(cos(pi() / d), range)));
  const Theorem definition =
      book.name(which.name, {k}, substitute(ratio, {{x, pi() / d}}), {le(1, k)},
                "The ratio at which psi/2 = pi/(" +
                    std::string(which.count == "N_A" ? "2k + 1" : "2k + 2") + "):",
                "", which.name + "k");
  const Theorem versed = linear(lt(0, 1 - cos(pi() / d)), {cosine_falls(range[0], range)});
  know_for_good(
      book.show(which.name + "k_positive", "a positive one;", positive(definition, {versed})));
  book.show(which.name + "k_paper", which.label, "as the paper writes it:",
            equation(fun(which.name, {k}), Expr(-1) + 1 / cos(pi() / d), {definition}));

  // N = k if and only if k - 1 < z <= k; z <= k means pi/d <= psi/2, so that the ratio is reached.
  const Expr z = pi() / psi() - which.shift;
  const auto t = [&](Expr i) { return fun(which.name, {i}); };
  const auto counted = [&](Expr i) {
    const Expr meaning = logic_and({lt(i - 1, z), le(z, i)});
    const Theorem ceiling = at(book["counting.ceiling"], {{x, z}, {k, i}});
    return restate(iff(eq(count, i), meaning), rewrite(turned(number), ceiling));
  };
  const Theorem of_angle = same_sign(iff(le(pi() / d, half()), le(z, k)), psi() / d, {from_1});
  const Theorem of_ratio =
      rewrite(turned(definition), at(book["ratios.reached"], {{x, pi() / d}}, range));
  const Theorem reached = tautology(iff(le(t(k), alpha), le(z, k)), {of_angle, of_ratio});
  book.show(which.count + "_range", which.range_label,
            which.count + " = k exactly from there up to the ratio before,",
            tautology(iff(eq(count, k), logic_and({le(t(k), alpha), lt(alpha, t(k - 1))})),
                      {counted(k), cut(linear(le(1, k), {from_2}), reached),
                       at(reached, {{k, k - 1}}, {from_2})}));
  // k = 1: the other side always holds, as psi < pi.
  const Theorem always = scaled(lt(Expr(1) - 1, z), lt(psi(), pi()), 1 / psi());
  book.show(
      which.count + "_once", which.range_label, "and " + which.count + " = 1 from the first on:",
      tautology(iff(eq(count, 1), le(t(1), alpha)), {counted(1), at(reached, {{k, 1}}), always}));
}

/// ... < beta_2 < alpha_2 < beta_1 < alpha_1 = 1
void order(Book& book) {
  const Theorem from_1 = assume(le(1, k)), from_2 = assume(le(2, k));
  const auto below = [&](const std::string& smaller, Expr i, Expr ds, const std::string& larger,
                         Expr l, Expr dl, const Theorem& from) {  // pi/ds < pi/dl, as ds > dl > 2
    const Expr gap = pi() * (ds - dl) / (ds * dl);
    const Theorem less =
        linear(lt(pi() / ds, pi() / dl),
               {equation(pi() / dl - pi() / ds, gap, {from}), positive(gap, {from})});
    const Theorem there = at(book["ratios.rises"], {{x, pi() / ds}, {y, pi() / dl}},
                             range_of(ds, {from}) + range_of(dl, {from}) + Theorems{less});
    const auto named = [&](const std::string& name, Expr index) {
      const Theorem definition = at(book["ratios." + name + "k"], {{k, index}}, {from});
      return turned(cut(linear(le(1, index), {from}), definition));
    };
    return rewrite(named(larger, l), rewrite(named(smaller, i), there));
  };
  book.show("order", "Their order: for every k,",
            below("beta_", k, 2 * k + 2, "alpha_", k, 2 * k + 1, from_1));
  book.show("order_next", "and",
            below("alpha_", k, 2 * k + 1, "beta_", k - 1, 2 * (k - 1) + 2, from_2));
  const Theorem third = book.show("third", "The cosine of a third of pi", part_of_pi(3)->cosine);
  book.show("alpha_1", "and the first is 1:",
            equation(fun("alpha_", {1}), 1,
                     {at(book["ratios.alpha_k"], {{k, 1}}),
                      restate(eq(cos(pi() / (2 * Expr(1) + 1)), right(third)), third)}));
}

}  // namespace

Theorems range_of(Expr d, const Theorems& facts) {
  return {positive(pi() / d, facts), scaled(lt(pi() / d, edge), lt(2, d), pi() / d, facts)};
}

void ratios(Book& book) {
  book.chapter("ratios", "Thresholds", {alpha_positive, V_positive});
  ratio_of_angle(book);
  threshold(book, {"N_A", "alpha_", "exact:ak", "NA-range", rational(1, 2)});
  threshold(book, {"N_B", "beta_", "exact:bk", "NB-range", 1});
  order(book);
}
}  // namespace derivation
