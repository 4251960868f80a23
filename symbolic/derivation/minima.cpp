// B's terminal velocity: V at the magic ratios only, least at the deficient ones.
#include "derivation/symbols.hpp"

namespace derivation {
namespace {
Expr angle() { return (N_B() + rational(1, 2)) * psi(); }

/// Four ways to say that N_B psi is as at a threshold: by B's velocity, a cosine, N_B, the ratio.
struct Condition {
  std::string name, ratio, cosine_label, count_label, cosine_words;
  Expr velocity, cosine, shift, target;  // cos(target) = cosine
  Expr denominator(Expr i) const { return 2 * i + 2 * shift; }
};
void conditions(Book& book, const Condition& which) {
  const Theorem cos_half = book["rotation.cos_half_psi"];
  const Expr fast = eq(b_t(), which.velocity), turned_back = eq(cos(angle()), which.cosine);
  const Theorem b_is = book["terminal.b"];
  const Theorem same = linear(eq(which.velocity, right(b_is)), {assume(fast), b_is});
  const Theorem from_fast =
      arithmetic(turned_back, {.equations = {{2 + alpha, same}},
                               .multipliers = {positive(V), positive(1 + alpha)},
                               .nonzero = {positive(1 + alpha), positive(2 + alpha)}});
  book.show(which.name + "_cosine", which.cosine_label, which.cosine_words,
            equivalent(from_fast, equation(fast, {b_is, assume(turned_back)})));

  // cos(angle) = cos(target) from 0 to pi; beyond pi the angle is 2 pi - target.
  const Expr y = angle(), t = which.target;
  const Theorem target_is = equation(cos(t), which.cosine, {cos_half}, {pi(), half()});
  const Theorem same_cosine = chain(assume(turned_back), turned(target_is));
  const Theorem mirrored = equation(cos(2 * pi() - y), cos(t), {same_cosine}, {pi(), y});
  const Theorem is_target = follows(
      eq(y, t),
      {given(le(y, pi()), [&](const Theorem& lower) { return same_angle(same_cosine, {lower}); }),
       given(lt(pi(), y), [&](const Theorem& upper) {
         return linear(eq(y, t), {same_angle(mirrored, {upper})});
       })});
  const Expr count = eq(N_B(), pi() / psi() - which.shift);
  const Theorem counted = assume(count), at_target = equation(y, t, {counted});
  book.show(which.name + "_count", which.count_label, "which means that nothing is rounded in N_B,",
            equivalent(equation(count, {linear(eq(psi() * N_B(), t - psi() / 2), {is_target})}),
                       restate(turned_back, rewrite(turned(at_target), target_is))));

  const Expr is_ratio = eq(alpha, fun(which.ratio, {N_B()}));
  const Expr quotient = pi() / which.denominator(N_B());
  const Theorem solved = equation(alpha, (1 - cos(half())) / cos(half()), {cos_half});
  const Theorem turn = equation(psi() * N_B(), pi() - which.shift * psi(), {counted});
  const Theorem reached = chain(rewrite(equation(half(), quotient, {turn}), solved),
                                turned(at(book["ratios." + which.ratio + "k"], {{k, N_B()}})));
  const Theorem back = at(book[which.name + ".angle"], {{k, N_B()}}, {assume(is_ratio)});
  book.show(which.name + "_only", "and that the ratio is a threshold:",
            equivalent(reached, equation(count, {linear(eq(psi(), 2 * quotient), {back})})));
}

/// Where B and C go on together, momentum and energy leave one velocity for both.
void together(Book& book) {
  const Theorem same = assume(eq(c_t(), b_t()));
  const Theorem momentum = rewrite(same, part(book["terminal.energy"], 0));
  const Theorem energy = rewrite(same, part(book["terminal.energy"], 1));
  const Theorem coupled = book.show(
      "coupled", "Where B and C end with the same velocity, two equations are left,",
      both({linear(eq((1 + alpha) * b_t() + a_t(), V), {momentum}),
            linear(eq((1 + alpha) * power(b_t(), 2) + power(a_t(), 2), power(V, 2)), {energy})}));
  // (1 + alpha) b ((2 + alpha) b - 2V) = 0
  const Theorem fast = certified(
      eq(b_t(), 2 * V / (2 + alpha)),
      {.equations = {{1, part(coupled, 1)}, {-(V - (1 + alpha) * b_t() + a_t()), part(coupled, 0)}},
       .multipliers = {positive(2 + alpha), positive(1 + alpha), part(book["terminal.order"], 2)}});
  book.show(
      "together", "eq:defb-terminal", "with one solution in which B moves:",
      both({equation(a_t(), -alpha * V / (2 + alpha), {solved_for(a_t(), part(coupled, 0)), fast}),
            fast}));
}

/// 2V/(2 + alpha) <= b_t, as b_t = 2V/(2 + alpha) - 2V (1 + alpha)/(2 + alpha) cos(...) cos(...)
Theorem at_least(Book& book) {
  const Expr early = N_B() * half(), late = (N_B() + 1) * half();
  const Theorem cos_late = linear(le(0, -cos(late)), {cosine_falls(linear(le(pi() / 2, late)))});
  const Theorem form = equation(
      b_t(), 2 * V / (2 + alpha) - 2 * V * (1 + alpha) / (2 + alpha) * cos(late) * cos(early),
      {book["terminal.b"],
       equation(cos(angle()), 2 * cos(late) * cos(early) - cos(half()), {}, {early, half()}),
       book["rotation.cos_half_psi"]});
  const Theorem lack = product_of(
      {positive(V), positive((1 + alpha) / (2 + alpha)), cos_late, positive(cos(early))});
  return book.show("at_least", "B never has less than that,",
                   linear(le(2 * V / (2 + alpha), b_t()), {form, lack}));
}

/// beta_k < alpha, alpha < alpha_k |- b_t at beta_k < b_t
Theorem after_minimum(Book& book, const Theorem& velocity) {
  // Between them pi/(2k + 2) < psi/2 < pi/(2k + 1), so N_B = k.
  const Expr d = 2 * k + 2, e = 2 * k + 1, x_k = pi() / d;
  const auto compared = [&](Expr goal, const std::string& id, const std::string& ratio, Expr per,
                            Expr given_ratio) {
    const Theorem there = at(book[id], {{x, pi() / per}}, range_of(per));
    return tautology(goal, {rewrite(turned(book[ratio]), there), assume(given_ratio)});
  };
  const Theorem from =
      compared(lt(x_k, half()), "ratios.passed", "ratios.beta_k", d, lt(fun("beta_", {k}), alpha));
  const Theorem to = compared(lt(half(), pi() / e), "ratios.reached", "ratios.alpha_k", e,
                              lt(alpha, fun("alpha_", {k})));
  const Known between({from, times(from, k), times(to, e)});
  const Expr z = pi() / psi();
  const Theorem count =
      linear(eq(N_B(), k), {book["counting.N_B"], scaled(lt(k, z), lt(k * psi(), pi()), 1 / psi()),
                            scaled(lt(z, k + 1), lt(pi(), (k + 1) * psi()), 1 / psi())});
  // V - b_t = V (cos(u)/cos(psi/4))^2 with u = (k + 1/2) psi/2; at beta_k tan(x/2) in its place.
  const Expr u = (k + rational(1, 2)) * half(), q = psi() / 4, v = x_k / 2, w = pi() / 2 - v;
  const auto falls = [&](Expr p, Expr r) { return cosine_falls(linear(lt(p, r))); };
  const Theorem smaller =
      linear(lt(cos(u) * cos(v), sin(v) * cos(q)),
             {falls(w + q, u + v), falls(w - q, u - v),
              equation(cos(u + v) + cos(u - v), 2 * cos(u) * cos(v), {}, {u, v}),
              equation(cos(w + q) + cos(w - q), 2 * sin(v) * cos(q), {}, {pi() / 2, v, q})});
  const Theorem lack =
      equation(b_t(), V - V * power(cos(u) / cos(q), 2),
               {rewrite(count, book["terminal.b"]), part(book["power.quarter"], 1)}, {u});
  const Theorem lack_there = equation(left(velocity), V - V * power(sin(v) / cos(v), 2),
                                      {velocity, book["ratios.beta_k"]}, {v});
  const Theorems cosines{positive(cos(q)), positive(cos(v))};
  const Theorem values = certified(
      lt(right(lack_there), right(lack)),
      {.products = {{1, {positive(V), smaller, positive(sin(v) * cos(q) + cos(u) * cos(v))}}},
       .multipliers = cosines + cosines});
  return linear(lt(left(lack_there), b_t()), {values, lack, lack_there});
}
}  // namespace

void minima(Book& book) {
  book.chapter("minima", "What B takes", {alpha_positive, V_positive, le(1, k)});
  conditions(book,
             {"magic", "alpha_", "eq:magic-b-cond", "eq:magic-b-cond-simple",
              "B takes everything if and only if a cosine is -1,", V, -1, rational(1, 2), pi()});
  conditions(book, {"deficient", "beta_", "eq:def-b-cond", "",
                    "B has 2V/(2 + alpha) if and only if another cosine is the negative of "
                    "cos(psi/2),",
                    2 * V / (2 + alpha), -1 / (1 + alpha), 1, pi() - half()});
  together(book);
  const Theorem least = at_least(book);
  const Expr ratio = fun("beta_", {k});
  const auto at_ratio = [&](const char* id) { return part(at(book[id], {{alpha, ratio}}), 1); };
  const Theorem velocity =  // 2V/(2 + beta_k)
      book.show("at_deficient", "and has just that at beta_k,",
                chain(at_ratio("terminal.definitions"), at_ratio("deficient.terminal")));
  const Theorem after = after_minimum(book, velocity);
  const Theorem before = given(lt(alpha, ratio), [&](const Theorem& t) {
    const Theorem gap = times(t, 2 * V / ((2 + alpha) * (2 + ratio)));
    return linear(after.conclusion(), {gap, least, velocity});
  });
  book.show("minimum", "where it has less than at any other ratio below alpha_k:",
            follows(after.conclusion(),
                    {discharge(lt(ratio, alpha), after), before, assume(neq(alpha, ratio))}));
}

// At alpha = alpha_k B takes everything; at beta_k B and the ball go on together.
void at_threshold(Book& book, const Kind& kind, const std::vector<Velocity>& velocities) {
  const Theorem is = assume(eq(alpha, fun(kind.ratio, {k})));
  book.chapter(kind.chapter, kind.title, {alpha_positive, V_positive, le(1, k), is.conclusion()});
  const Theorems range = range_of(kind.d);
  const Theorem solved = chain(is, book["ratios." + kind.ratio + "k"]);
  const Theorem cosines = at(book["ratios.ratio"], {{x, pi() / kind.d}}, range + Theorems{solved});
  const Theorem angle = book.show("angle", "Half of psi is then", same_angle(cosines, range));
  const Theorem turn =
      equation(kind.d * psi(), 2 * pi(), {linear(eq(psi(), 2 * pi() / kind.d), {angle})});
  const Theorem quotient =
      equation(pi() / psi(), kind.d / 2, {linear(eq(pi(), kind.d / 2 * psi()), {turn})});
  const Theorem N_A_is = linear(eq(N_A(), kind.N_A_is), {book["counting.N_A"], quotient});
  const Theorem N_B_is = linear(eq(N_B(), k), {book["counting.N_B"], quotient});
  book.show("counts", kind.count_label, kind.count_words,
            both({N_A_is, N_B_is, linear(eq(k, kind.unrounded), {quotient})}));
  Theorems values, terminal;
  for (const Velocity& v : velocities) {
    const Theorem left_over = linear(eq(v.angle, pi() - v.rest), {turn});
    const Theorem velocity = rewrite(left_over, at(book["power." + v.id], {{n, v.index}}));
    values.push_back(equation(v.left, v.right,
                              {velocity, book["power.V_CM"], book["rotation.cos_half_psi"]},
                              {pi(), v.base}));
    const bool of_A = v.id == "a" || v.id == "c";
    terminal.push_back(rewrite(turned(of_A ? N_A_is : N_B_is), values.back()));
  }
  book.show("velocities", kind.velocity_label, kind.velocity_words, both(values));
  book.show("terminal", "These are the terminal velocities:", both(terminal));
}

void magic(Book& book) {
  at_threshold(book,
               {"magic", "Magic mass ratios", "alpha_", "eq:Naatcritical",
                "Each block has had k collisions,", "",
                "after which A and C are at rest and B has what A had:", 2 * k + 1, k,
                pi() / psi() - rational(1, 2)},
               {{a(k), 0, "a", k, k * psi(), half(), half()},
                {b(k), V, "b", k, (k + rational(1, 2)) * psi(), 0, half()},
                {c_prime(k), 0, "c_prime", k, (k + rational(1, 4)) * psi(), quarter(), quarter()}});
}

void deficient(Book& book) {
  at_threshold(book,
               {"deficient", "Deficient mass ratios", "beta_", "eq:Nbatcritical",
                "A has had one collision more than B,", "eq:defb-terminal",
                "after which B and C go on together:", 2 * k + 2, k + 1, pi() / psi() - 1},
               {{a(k + 1), -alpha * V / (2 + alpha), "a", k + 1, (k + 1) * psi(), 0, half()},
                {b(k), 2 * V / (2 + alpha), "b", k, (k + rational(1, 2)) * psi(), half(), half()},
                {c(k + 1), 2 * V / (2 + alpha), "c", k + 1, (k + 1 - rational(1, 4)) * psi(),
                 quarter(), quarter()}});
}
}  // namespace derivation
