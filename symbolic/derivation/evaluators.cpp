// The forms that are evaluated: from tan(psi/4) and cot(psi/2), without cancellation or overflow.
#include "derivation/wedge.hpp"

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

// Evaluated forms of the time and distance of a collision, from a sine and a cosine of j psi/4.

Expr sine_of(Expr times) { return sin(times * (psi() / 2)); }

/// (1 + alpha)/2 = sin(psi/2)/sin(psi), for both.
void first_of_B(Book& book) {
  const Known second({linear(lt(1, N()), {book["counting.shares"]})});
  const Theorem twice =
      equation(sine_of(Expr(1) + 1), 2 * sin(psi() / 2) * cos(psi() / 2), {}, {psi() / 2});
  for (const char* id : {"when", "apart"}) {
    const bool is_time = id == std::string("when");
    const Theorem t = at(book["encounters." + std::string(id)], {{j, 1}});
    const Theorem is = rewrite(equation(sine_of(1), sin(psi() / 2)), rewrite(twice, t));
    book.show(std::string(id) + "_1", is_time ? "That of B's first is" : "and",
              equation(left(is), (is_time ? L / V : L) * (rational(1, 2) * (1 + alpha)),
                       {is, book["rotation.cos_half_psi"]}));
  }
}
}  // namespace

Angle evaluated_angle(const Book& book) {
  const Expr T = of_alpha("t"), T_per_alpha = of_alpha("w"), q = psi() / 4;
  const Theorem t = book["evaluators.def_t"], quarters = book["power.quarter"];
  const Theorem w = rewrite(book["evaluators.def_above"], book["evaluators.def_w"]);
  const Theorem tangent = cancel(eq(T, sin(q) / cos(q)), {positive(cos(q))}, {t, w, quarters});
  return {linear(eq(of_alpha("half_h"), q), {book["evaluators.psi"]}),
          tangent,
          linear(le(T, T_per_alpha), {t, times(assume(le(alpha, 1)), positive(w))}),
          {equation(T_per_alpha, T / alpha, {t}), tangent, part(quarters, 1), book["power.V_CM"]}};
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

// Evaluated forms of the terminal velocities and counts.
void end_forms(Book& book) {
  book.chapter("evaluators_end", "Forms for evaluation: terminal velocities",
               {alpha_positive, V_positive});
  const Angle a = evaluated_angle(book);
  const Names f{book, {alpha, V}, {alpha_positive, V_positive}};
  const Theorem h = book.define("h", {alpha}, 2 * of_alpha("half_h"), {alpha_positive}, "With");
  const Theorem psi_is = linear(eq(psi(), 2 * of_alpha("h")), {h, a.quarter});
  const Theorem h_is = linear(eq(of_alpha("h"), psi() / 2), {psi_is});
  know(linear(lt(0, of_alpha("h")), {psi_is}));
  const Theorem quotient = equation(pi() / psi(), pi() / (2 * of_alpha("h")), {h_is});
  for (const auto& [name, shift] : {std::pair{"N_A", rational(1, 2)}, {"N_B", Expr(1)}})
    book.show(name, name == std::string("N_A") ? "the counts are" : "and",
              restate(eq(f(name), ceil(pi() / (2 * of_alpha("h")) - shift)),
                      rewrite(quotient, book["counting." + std::string(name)])));

  const Expr angle = N_A() * psi() / 2, r = pi() / 2 - angle;
  const Theorem def_rest = f.name("rest", sqrt(power(pi() / 2 - of_alpha("h") * N_A(), 2)),
                                  "What is left of a quarter turn:");
  const Theorem rest_is = restate(eq(f("rest"), sqrt(power(r, 2))), rewrite(h_is, def_rest));
  const Theorem def_sine = f.name("rest_sine", sin(f("rest")));
  const Theorem def_cosine = f.name("rest_cosine", cos(f("rest")));
  const Theorems of_name{f.name("t_cosine", of_alpha("t") * f("rest_cosine")),
                         f.name("w_cosine", of_alpha("w") * f("rest_cosine")),
                         f.name("t_plus", f("t_cosine") + f("rest_sine")),
                         f.name("t_minus", f("t_cosine") - f("rest_sine")),
                         f.name("w_plus", f("w_cosine") + f("rest_sine")),
                         f.name("b_form", 2 * f("w_plus") * f("t_cosine"))};
  const auto size_of_rest = [&](Expr value, const Theorem& sign) {
    return chain(rest_is, root_of(equation(power(value, 2), power(r, 2)), sign));
  };

  // Q_n last: r > 0; P_n last: r <= 0.
  const auto in_case = [&](bool Q_last) {
    const Expr z = 2 * pi() / psi(), count = Q_last ? 2 * N_A() : 2 * N_A() - 1;
    return given(eq(N(), count), [&](const Theorem& N_is) {
      const Theorem end =
          at(book[Q_last ? "terminal.after_Q" : "terminal.after_P"], {{n, N_A()}}, {N_is});
      const Theorem bound =
          linear(Q_last ? lt(0, z - 2 * N_A()) : le(0, 2 * N_A() - z), {N_is, book["counting.N"]});
      const Expr value_is = Q_last ? r : -r;
      const Theorem sign = linear(le(0, value_is), {times(bound, psi())});
      const Theorem size = size_of_rest(value_is, sign);
      const Exprs quarter_turn{pi() / 2, angle};
      const Theorem sine = equation(f("rest_sine"), Q_last ? cos(angle) : -cos(angle),
                                    {rewrite(size, def_sine)}, quarter_turn);
      const Theorem cosine =
          equation(f("rest_cosine"), sin(angle), {rewrite(size, def_cosine)}, quarter_turn);
      const auto value = [&](std::size_t i, const std::string& id, Expr index, Expr goal) {
        const Theorem is = part(end, i);
        const Theorem form = at(book["power." + id], {{n, index}});
        return equation(left(is), V * goal, Theorems{is, form, sine, cosine} + of_name + a.rules,
                        {angle, psi() / 4});
      };
      return both({value(2, "a_product", N_A(), -f("t_minus") * f("t_plus")),
                   value(3, "b_product", Q_last ? N_A() : N_A() - 1, f("b_form")),
                   value(4, Q_last ? "c_prime_product" : "c_product", N_A(),
                         2 * f("t_minus") * f("w_cosine"))});
    });
  };
  const Theorem Q = in_case(true), P = in_case(false);
  const Theorem terminal =
      book.show("terminal", "The terminal velocities are, whichever collision is the last,",
                tautology(right(Q), {Q, P, book["terminal.last"]}));
  const Expr V_lead = 2 * V_CM(), next = psi() / 4 - f("rest");
  book.show("rest", "As products, with what is left by psi,", rest_is);
  const auto as_product = [&](std::size_t i, const std::string& name, Expr value) {
    const Theorem is = part(terminal, i);
    book.show(name, "and",
              equation(left(is), value, Theorems{is, def_sine, def_cosine} + of_name + a.rules,
                       {psi() / 4, f("rest")}));
  };
  as_product(0, "a_product", -V_lead * (1 + alpha) * sin(next) * sin(psi() / 4 + f("rest")));
  as_product(1, "b_product", V_lead * (1 + alpha) * cos(f("rest")) * cos(psi() / 2 - f("rest")));
  as_product(2, "c_product", V_lead * cos(f("rest")) * sin(next) / sin(psi() / 4));
  f.name("rho", power(f("b_t") / V, 2), "and B has of the energy the fraction");

  // |r| <= h/2, so sin|r| <= tan(h/2) cos(r).
  const Expr half_h = of_alpha("h") / 2, z = pi() / psi(), half = rational(1, 2), q = psi() / 4;
  const Theorems count{book["counting.N_A"], psi_is};
  const Theorem r_up = scaled(le(r, half_h), le(z, N_A() + half), psi(), count);
  const Theorem r_down = scaled(le(-r, half_h), le(N_A(), z + half), psi(), count);
  const Expr bounds_of_rest = logic_and({le(0, f("rest")), le(f("rest"), half_h)});
  const auto with_sign = [&](Expr sign, Expr value_is) {
    return given(sign, [&](const Theorem& t) {
      const Theorem is = size_of_rest(value_is, linear(le(0, value_is), {t}));
      return linear(bounds_of_rest, {is, t, r_up, r_down});
    });
  };
  const Theorem bounds =
      book.show("rest_bounds", "where what is left is half a step at most:",
                follows(bounds_of_rest, {with_sign(le(0, r), r), with_sign(lt(r, 0), -r)}));
  const Expr gap_angle = q - f("rest");
  const Theorem difference =
      equation(sin(gap_angle), sin(q) * f("rest_cosine") - cos(q) * f("rest_sine"),
               {turned(def_sine), turned(def_cosine)}, {q, f("rest")});
  book.show("t_cosine_at_most", "For a ball that is not heavier than a block",
            linear(le(f("t_cosine"), f("w_cosine")),
                   {of_name[0], of_name[1], times(a.t_small, assume(le(0, f("rest_cosine"))))}));
  book.show("sine_at_most", "and so",
            scaled(le(f("rest_sine"), f("t_cosine")),
                   le(cos(q) * f("rest_sine"), cos(q) * f("t_cosine")), 1 / cos(q),
                   {difference, sine_not_negative(gap_angle, {bounds, psi_is}),
                    equation(cos(q) * f("t_cosine"), sin(q) * f("rest_cosine"),
                             {of_name[0], a.tangent})}));
}

// A ball that is not lighter than a block has one collision with each: rational velocities.
void heavy(Book& book) {
  const Names names{book, {alpha}, {alpha_positive}};
  book.chapter("heavy", "A heavy ball", {le(1, alpha), V_positive});
  const Theorem is_heavy = assume(le(1, alpha)), mass = linear(alpha_positive, {is_heavy});
  const Theorem alpha_1 = book["ratios.alpha_1"], beta_below = at(book["ratios.order"], {{k, 1}});
  const auto once = [&](const char* id, const Theorems& facts) {
    const Theorem t = cut(mass, book[id]);  // N = 1 if and only if the first ratio is <= alpha
    return tautology(left(t), {t, linear(right(t), facts + Theorems{alpha_1})});
  };
  const Theorem counts =
      both({book.show("N_A", "Both blocks have one collision each, A", once("ratios.N_A_once", {})),
            book.show("N_B", "and B:", once("ratios.N_B_once", {beta_below}))});
  const Theorem sum = names.name("masses", 1 + alpha, "With");
  know(positive(sum));
  const Theorem part_of = names.name("per_mass", 1 / of_alpha("masses"));
  const Theorem share = names.name("share", alpha * of_alpha("per_mass"));
  const Theorem less = names.name("lead", 1 - alpha);
  const Expr i = of_alpha("per_mass"), f = of_alpha("share"), D = of_alpha("lead");
  Theorems steps{book["cycle.start_vector"]};
  for (const char* id : {"cycle.P", "cycle.Q"})
    steps = steps + parts({rewrite(equation(Expr(1) - 1, 0), at(book[id], {{n, 1}}))});
  const Theorems rules{share, less, rewrite(sum, part_of)};
  const auto show = [&](const std::string& name, Expr velocity, Expr form) {
    return book.show(name, name == "a" ? "the first velocities are" : "and",
                     equation(velocity, V * form, steps + rules));
  };
  const Theorems after{show("a", a(1), D * i), show("b", b(1), 4 * f * i), show("c", c(1), 2 * i),
                       show("c_prime", c_prime(1), -2 * D * power(i, 2))};
  const Theorem N_is = linear(eq(N(), 2 * Expr(1)), {cut(mass, book["counting.shares"]), counts});
  const Theorem end = cut(mass, cut(N_is, at(book["terminal.after_Q"], {{n, 1}}, {N_is})));
  for (const auto& [name, which, velocity] :
       {std::tuple{"a_t", 2U, 0U}, std::tuple{"b_t", 3U, 1U}, std::tuple{"c_t", 4U, 3U}})
    book.show(name, which == 2U ? "which are the terminal ones:" : "and",
              chain(part(end, which), cut(mass, after[velocity])));
}

void collision_forms(Book& book) {
  book.chapter("evaluators_collision", "Forms for evaluation: a collision",
               {alpha_positive, V_positive, lt(0, L), le(0, j)});
  const Angle a = evaluated_angle(book);
  first_of_B(book);

  const Expr T = of_alpha("t"), q = of_alpha("half_h"), quarter = psi() / 4;
  const Names of_j{book, {alpha, j}, {alpha_positive, le(0, j)}};
  const Theorem phase_is = rewrite(a.quarter, of_j.name("half_phase", q * j, "With"));
  const Expr angle = right(phase_is);
  Theorems parts{a.tangent};
  const auto name = [&](const std::string& symbol, Expr value) {
    parts.push_back(rewrite(phase_is, of_j.name(symbol, value)));
    return of_j(symbol);
  };
  const Expr S = name("half_sine", sin(of_j("half_phase")));
  const Expr tS = name("t_half_sine", T * S);
  const Expr cosine = name("next_cosine", cos(of_j("half_phase")) - tS);
  const Expr C = name("half_cosine", cosine + tS);
  const Expr sine = name("next_sine", S + T * C);

  // cos(psi/4) next_cosine = cos(next) > 0 where next = (j + 1) psi/4 < pi: it is below pi/2, then.
  const Expr next = angle + quarter;
  const Theorem c = positive(cos(quarter));
  const Theorem is_positive = assume(lt(0, cosine));
  const Theorem is_near = assume(le(of_j("half_phase"), pi() - 2 * q));
  const Theorem near = linear(le(next, pi() - quarter), {is_near, phase_is, a.quarter});
  const auto times_c = [&](Expr l, Expr r) { return equation(l, r, parts, {angle, quarter}); };
  const Theorem next_cosine = times_c(cos(next), cos(quarter) * cosine);
  const Theorem falls = cosine_falls(assume(le(pi() / 2, next)), {near});
  const Theorem below = otherwise(lt(next, pi() / 2), {falls, next_cosine, times(c, is_positive)});
  const Theorem room = times(linear(lt(0, 2 * pi() - (j + 1) * psi()), {below}), 1 / psi());
  const Theorem takes_place =
      book.show("takes_place", "Collision j takes place where that is positive:",
                linear(lt(j, N()), {room, book["counting.N"]}));

  const Theorem S_from_0 = linear(le(0, S), parts + Theorems{sine_not_negative(angle, {near})});
  const Theorem C_positive = linear(lt(0, C), parts + Theorems{is_positive, times(S_from_0, T)});
  const Theorem sine_positive = linear(lt(0, sine), {parts.back(), S_from_0, times(C_positive, T)});
  book.show("sine_positive", "and so is", sine_positive);
  const Known divisors({sine_positive, is_positive, takes_place});
  const Names in_time{
      book, {alpha, j}, {alpha_positive, le(0, j), lt(0, cosine), is_near.conclusion()}};
  const Theorem per_next = in_time.name("per_next", 1 / cosine);
  const Theorem ratio = in_time.name("sine_ratio", S / sine);
  const Theorem t_ratio = in_time.name("t_ratio", T / sine);
  const Theorem of_time = in_time.name("time_ratio", (1 + of_alpha("z")) * of_j("sine_ratio"));
  const Theorem more = linear(lt(0, sine - S), {parts.back(), times(C_positive, T)});
  book.show("ratio_at_most", "where",
            linear(le(of_j("sine_ratio"), 1), {ratio, times(more, 1 / sine)}));
  // cos(psi/4)^2 (1 + t^2) = 1
  const Theorem square =
      equation(power(cos(quarter), 2) * of_alpha("z"), 1 - power(cos(quarter), 2),
               {turned(book["evaluators.t_squared"]), a.tangent}, {quarter});
  const Theorem after = times_c(sine_of(j + 1), 2 * power(cos(quarter), 2) * sine * cosine);
  const Theorem before = times_c(sine_of(j), 2 * S * C);
  const Theorem step = times_c(sin(psi() / 2), 2 * power(cos(quarter), 2) * T);
  const auto show = [&](const std::string& id, const char* words, const Theorem& above, Expr form) {
    const Theorem t = cut(takes_place, cut(linear(le(0, 1)), book["encounters." + id]));
    const Theorem is = rewrite(above, rewrite(after, t));
    book.show(id, words, equation(left(is), form, {is, square, per_next, ratio, of_time, t_ratio}));
  };
  show("when", "In these terms", before, L / V * (of_j("time_ratio") * C * of_j("per_next")));
  show("apart", "and", step, L * (of_j("t_ratio") * of_j("per_next")));

  // From the second collision of A on, sin(angle) >= sin(psi/2) = t (1 + cos(psi/2)).
  const Expr middle = angle / 2 + quarter, off = angle / 2 - quarter;
  const Theorem rises =
      equation(sin(angle), sin(psi() / 2) + 2 * cos(middle) * sin(off), {}, {middle, off});
  const Theorem product =
      times(linear(le(0, cos(middle)), {cosine_falls(linear(le(middle, pi() / 2), {near}))}),
            sine_not_negative(off, {times(assume(le(2, j)), psi()), near}));
  const Theorem double_t = times_c(sin(psi() / 2), T + T * cos(psi() / 2));
  book.show("t_at_most", "where from the second collision of A on",
            linear(le(T, S),
                   parts + Theorems{rises, product, double_t, times(positive(cos(psi() / 2)), T)}));
}
}  // namespace derivation
