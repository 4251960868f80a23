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

// The first ratios in square roots; for pi/17, sums of cosines solve four quadratics (Gauss).

/// u and v from u + v = s, (u - v)^2 = d and v < u.
struct Quadratic {
  Quadratic(const Theorem& sum, const Theorem& square, const Theorem& less)
      : root(root_of(square, linear(lt(0, left(square).arg(0)), {less}))),
        greater(solved(sum, right(less), left(root) / 2)),
        smaller(solved(sum, left(less), -left(root) / 2)) {
    know(linear(le(0, right(square)), {square, not_negative(left(square))}));
  }
  Theorem solved(const Theorem& sum, Expr which, Expr half_gap) const {
    return linear(eq(which, right(sum) / 2 + half_gap), {sum, root});
  }
  Theorem root, greater, smaller;
};

/// The cosines of 2 k pi/p for p = 17, a prime, k = 1, ..., (p - 1)/2.
class Periods {
public:
  Periods() {
    const Theorem product = equation(cos(x) * cos(y), (cos(x + y) + cos(x - y)) / 2, {}, {x, y});
    const Theorem step = equation(2 * cos(x) * sin(y), sin(x + y) - sin(x - y), {}, {x, y});
    const Theorem back = equation(cos(2 * pi() - x), cos(x), {}, {pi(), x});
    const Expr unit = pi() / p;
    Certificate c;  // sin(unit) (1 + 2 sum of cosines) = sin(pi), as a telescope
    c.multipliers = {positive(sin(unit))};
    c.equations = {{1, restate(eq(sin(Expr(p) * unit), 0), axiom("sin pi"))}};
    Expr sum = 0;
    for (int i = 1; 2 * i < p; ++i) {
      sum = sum + 2 * cosine(i);
      c.equations.push_back({1, at(step, {{x, angle(i)}, {y, unit}})});
      rules.push_back(restate(eq(cosine(p - i), cosine(i)), at(back, {{x, angle(i)}})));
      for (int l = 1; l <= i; ++l)
        rules.push_back(restate(eq(cosine(i) * cosine(l), period({i + l, i - l}) / 4),
                                at(product, {{x, angle(i)}, {y, angle(l)}})));
    }
    rules.push_back(arithmetic(eq(sum, -1), c));
  }
  Expr angle(int i) const { return Expr(2 * i) * pi() / p; }
  Expr cosine(int i) const { return cos(angle(i)); }
  /// 2 cos of each, added.
  Expr period(const std::vector<int>& of) const {
    Expr sum = 0;
    for (const int i : of) sum = sum + 2 * cosine(i);
    return sum;
  }
  /// |- cos(2 l pi/p) < cos(2 i pi/p)
  Theorem falls(int i, int l) const { return falls(angle(i), angle(l)); }
  static Theorem falls(Expr smaller, Expr larger) {
    return cosine_falls(linear(lt(smaller, larger)));
  }
  /// A linear relation of periods of the second degree.
  Theorem known(Expr goal) const { return linear(goal, rules); }
  static constexpr int p = 17;
  Theorems rules;  ///< products of two cosines as sums; which ones are equal; the sum of all
};
/// |- cos(pi/17), by four quadratic equations
Theorem seventeenth(Book& book) {
  const Periods of;
  const Expr E = of.period({1, 2, 4, 8}), F = of.period({3, 5, 6, 7}), a = of.period({1, 4}),
             b = of.period({2, 8}), c = of.period({3, 5}), d = of.period({6, 7});
  const Theorem half = book["ratios.third"];
  const Theorem E_positive =
      linear(lt(0, E), {of.falls(of.angle(1), pi() / 3), of.falls(of.angle(2), pi() / 3), half,
                        of.falls(of.angle(4), pi() / 2), of.falls(of.angle(8), pi())});
  const Theorem whole = of.known(eq(E + F, -1));
  const Quadratic first(whole, of.known(eq(power(E - F, 2), 17)),
                        linear(lt(F, E), {E_positive, whole}));
  const auto halves = [&](Expr u, Expr v, const Theorem& sum, const Theorem& less) {
    const Expr s = left(sum);  // (u - v)^2 = s^2 + 4
    const Theorem square = rewrite(sum, of.known(eq(power(u - v, 2), power(s, 2) + 4)));
    const Expr value = right(square), simple = simplified(value);
    return Quadratic(linear(eq(u + v, right(sum)), {sum}), rewrite(equation(value, simple), square),
                     less);
  };
  const Quadratic of_E =
      halves(a, b, first.greater, linear(lt(b, a), {of.falls(1, 2), of.falls(4, 8)}));
  const Quadratic of_F =
      halves(c, d, first.smaller, linear(lt(d, c), {of.falls(3, 6), of.falls(5, 7)}));
  const Expr u = of.period({2}), v = of.period({8});
  const Theorem square = of.known(eq(power(u - v, 2), power(b, 2) - 4 * d));
  const Quadratic last(linear(eq(u + v, right(of_E.smaller)), {of_E.smaller}),
                       rewrite(of_F.smaller, rewrite(of_E.smaller, square)),
                       linear(lt(v, u), {of.falls(2, 8)}));
  const Expr t = pi() / of.p, b_value = right(of_E.smaller), root = left(last.root);
  const Theorem opposite = at(equation(cos(pi() - x), -cos(x), {}, {pi(), x}), {{x, t}});
  return linear(eq(cos(t), (root - b_value) / 4), {opposite, last.smaller});
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

void radicals(Book& book) {
  book.chapter("radicals", "The first ratios in square roots", {});
  const Known in_this_chapter;
  std::map<int, Theorem> cosines{{17, seventeenth(book)}};
  for (const int d : {4, 5, 6, 8, 10, 12, 15, 16, 20}) cosines.emplace(d, part_of_pi(d)->cosine);
  book.show("fifth", "The cosine of a fifth of pi:", cosines.at(5));
  const std::map<int, Expr> forms{{4, sqrt(Expr(2)) - 1}, {5, sqrt(Expr(5)) - 2}};
  for (const auto& [d, cosine_of] : cosines) {
    const bool magic = d % 2 == 1;
    const int index = magic ? (d - 1) / 2 : d / 2 - 1;
    const std::string name = magic ? "alpha_" : "beta_";
    const Theorem definition = at(book["ratios." + name + "k_paper"], {{k, index}});
    const Expr angle = right(definition).arg(1).arg(0).arg(0);
    const Theorem cosine = restate(eq(cos(angle), right(cosine_of)), cosine_of);
    know(linear(lt(0, right(cosine)), {cosine, Periods::falls(angle, pi() / 2)}));
    const Theorem value = rewrite(cosine, definition);
    const auto form = forms.find(d);
    const Expr quotient = right(cosine);  // a number times a sum of roots
    const Expr ratio =
        form == forms.end() ? 1 / quotient.arg(0) / quotient.arg(1) - 1 : form->second;
    book.show(name + std::to_string(index), "The ratio of pi/" + std::to_string(d) + ":",
              chain(value, equation(right(value), ratio)));
  }
}
}  // namespace derivation
