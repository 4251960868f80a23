// Evaluated forms of the time and distance of a collision, from a sine and a cosine of j psi/4.
#include "derivation/wedge.hpp"

namespace derivation {
namespace {
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
