// Forms for evaluation: three bodies of any masses, or two and a wall, with restitution.
#include "derivation/wedge.hpp"

namespace derivation {
namespace {
Expr h_e() { return fun("h_e", masses_and_e()); }

Expr K() { return fun("K", masses_and_e()); }
Expr q_e() { return fun("q_e", masses_and_e()); }

/// Names of quantities of collision j, and the forms that are shown for them.
struct Forms : Names {
  Theorems shared = {};

  /// |- symbol_j = value, of more variables before j; not shown
  Theorem with(const Exprs& more, const std::string& symbol, Expr value, const Exprs& where) const {
    return defined(symbol, masses_and_e() + more + Exprs{j}, value, where);
  }
  /// Shows that what is so named has a form.
  Theorem show(const Theorem& is, const char* words, Expr form, const Theorems& rules) const {
    const Expr named = left(is);
    return book.show(named.name(), words, equation(named, form, Theorems{is} + rules + shared));
  }
  /// What the forms share.
  Theorem share(const std::string& symbol, const std::string& words, Expr value) {
    shared.push_back(with({}, symbol, value, domain));
    return book.show("def_" + symbol, words, shared.back());
  }
};

/// U_j, U_last and sqrt(e)^j, of which only ratios count, in a unit that keeps them near 1.
struct InUnit {
  Theorem now, last, per_unit;
};
InUnit in_unit(Forms& forms) {
  const Exprs where = forms.domain + Exprs{lt(0, unit)};
  const auto name = [&](const std::string& symbol, const char* words, Expr value) {
    forms.shared.push_back(forms.with({unit}, symbol, value, where));
    return forms.book.show("def_" + symbol, words, under(where, forms.shared.back()));
  };
  return {name("now", "In any unit let", unit * U(j)), name("last", "and", unit * U_last(j)),
          name("per_unit", "and", root_power(j) / unit)};
}

/// q_e = 1 - K, above 0 where collisions end; the time of the collapse where they do not.
Theorem definition_of_q_e(Book& book) {
  const Theorem q_is = book.define("q_e", masses_and_e(), 1 - K(), of_wedge({lt(0, e)}),
                                   "Collisions end where this is positive:");
  const Theorem none = assume(le(q_e(), 0));
  const Theorem inside = equation(power(kappa(), 2) - 1, -q_e(), {q_is, book["collapse.square"]});
  const Theorem from_1 =
      tautology(le(1, kappa()), {book["collapse.threshold"], linear(le(1, K()), {q_is, none})});
  const Known here({none, from_1});
  book.show("y_e", "Where they never end,", rewrite(inside, cut(from_1, book["collapse.y_e"])));
  const auto at_end = [&](const std::string& id, const char* words, const Exprs& more) {
    const Exprs hypotheses = of_wedge({lt(0, e), none.conclusion()}) + more;
    const Theorem is = cut(from_1, book["any_start." + id]);
    return book.show(left(is).name(), words, under(hypotheses, is));
  };
  const Exprs ends{lt(0, left(at_end("def_end_speed", "and where", {})))};
  at_end("def_t_any", "is positive, the time of the collapse is", ends);
  at_end("def_x_any", "its place", ends);
  at_end("def_v_any", "and the velocity then", ends);
  return q_is;
}
/// Where q_e is above 0 the angle; |- kappa < 1.
Theorem angle(Book& book, const Theorem& q_is) {
  know(assume(lt(0, q_e())));
  const Theorem below =
      tautology(lt(kappa(), 1), {book["collapse.threshold"], linear(lt(K(), 1), {q_is})});
  know(below);
  know(positive(book["wedge.kappa"]));
  const Theorem inside = equation(1 - power(kappa(), 2), q_e(), {q_is, book["collapse.square"]});
  const Theorem h_is = book.show("h_e", "Where they end the angle is",
                                 rewrite(inside, cut(below, book["wedge.h_e"])));
  know(positive(h_is));
  know(linear(lt(h_e(), pi()), {h_is}));
  book.show("N_e", "and the number of all collisions", cut(below, book["motion.N"]));
  return below;
}
/// Speeds, weighed as the ball's approach to B counts.
Expr weighed(Expr of_A, Expr of_B, Expr now, Expr last) { return of_A * now + of_B * r_e() * last; }
/// Places at tau after collision j, seen from B's first one; velocities: no distance, tau is 1.
void places(const Forms& forms, const InUnit& units) {
  const Substitution as_places = start_with(d_A, d_B);
  const auto name = [&](const std::string& symbol, Expr v) {
    return forms.with({V, W, d_A, d_B, tau}, symbol, tau * v - substitute(v, as_places),
                      forms.domain);
  };
  const auto twice = [&](const Theorem& t) { return Theorems{t, at(t, as_places)}; };
  const Theorem turn_next = at(part(forms.book["cycle.turn"], 1));
  const Theorem pow_next = at(part(at(forms.book["multiples.pow"], {{y, sqrt(e)}}), 1));
  const Theorem speed = forms.book["any_start.speed"];
  const Theorem before = name("before", nearing(j)), after = name("after", nearing(j + 1));
  const Expr of_A = V * tau - d_A, of_B = W * tau - d_B;
  const Expr now = left(units.now), last = left(units.last), share = left(units.per_unit);
  forms.show(before, "For the places at a time tau after collision j let",
             share * forms("now_side") * weighed(of_A, of_B, now, last), twice(speed));
  forms.show(
      after, "and",
      sqrt(e) * share * forms("later_side") * weighed(of_A, of_B, 2 * kappa() * now - last, now),
      twice(at(speed, {{j, j + 1}})) + Theorems{turn_next, pow_next});
  const Expr v = left(after), u = e * left(before), of_C = is_P(j) * v - is_Q(j) * u;
  const Expr momentum = substitute(any_momentum(), start_with(of_A, of_B));
  Theorems rules{turn_next, before, after};
  const auto show = [&](const std::string& body, const char* words, Expr form, const char* id) {
    const Expr velocity = any_velocity(body, j + 1);
    const Theorem is = name(body + "_at", velocity);
    forms.show(is, words, form, twice(solved_for(velocity, forms.book[id])) + rules);
    rules.push_back(is);
    return left(is);
  };
  const Expr B =
      show("B", "so that B is at", (momentum - w_B * (M_A * (v - u) + M_C * of_C)) / mass_of_all(),
           "any_start.B_velocity");
  show("A", "A at", B + (v - u), "any_start.A_B");
  show("C", "and the ball at", B + of_C, "any_start.C_B");
}
/// Whether collision j takes place, and when.
void time(const Forms& forms, const InUnit& units) {
  Book& book = forms.book;
  const Expr now = left(units.now), last = left(units.last);
  const Theorem reach = forms.with({V, W, unit}, "reach", weighed(V, W, now, last), forms.domain);
  book.show("def_reach", "Collision j takes place where this is positive:",
            under(forms.domain + Exprs{lt(0, unit)}, reach));
  know(assume(lt(0, left(reach))));
  const Theorem speed = equation(nearing(j), root_power(j) * side(j) * (left(reach) / unit),
                                 forms.shared + Theorems{book["any_start.speed"], reach});
  know(positive(speed));
  const Theorem going = linear(lt(0, nearing(j)));
  const Theorem when = cut(going, book["any_start.instant"]);
  const Theorem moment =
      forms.with({V, W, d_A, d_B}, "moment", left(when), forms.domain + Exprs{going.conclusion()});
  forms.show(moment, "Its time is", weighed(d_A, d_B, now, last) / left(reach),
             {when, speed, at(book["any_start.speed"], start_with(d_A, d_B))});
}
/// Where collisions end: the unit is the sine of the angle.
void sines(Book& book, const InUnit& units, const Theorem& below) {
  const auto from_any_start = [&](const char* id) { return cut(below, book[id]); };
  const Theorem step = defined("step_sine", masses_and_e(), sin(h_e()), of_wedge({lt(0, e)}));
  book.show("def_step_sine", "With", under({lt(0, q_e())}, step));
  know(positive(step));
  const Theorems quotients =
      quotients_of_sines(book, turned(from_any_start("wedge.cosine"))) + Theorems{step};
  const auto show = [&](const char* id, const char* words, const Theorem& is, Expr times) {
    const Theorem in_sines = at(is, {{unit, left(step)}});
    book.show(id, words,
              equation(left(in_sines), sin(times * h_e()), quotients + Theorems{in_sines}));
  };
  show("now_sine", "for the unit,", units.now, j + 1);
  show("last_sine", "and", units.last, j);
  know(assume(V_positive));
  book.show("phase_e", "Where A approaches the ball, with the angle",
            rewrite(turned(step), from_any_start("any_start.def_phase_e")));
  book.show("N_any", "the number of collisions is", from_any_start("any_start.N"));
}
/// Where they need not end: the unit is a power of y_e, and where q_e is 0 there is none.
void rises(Book& book, const InUnit& units, const Theorem& q_is) {
  const auto show = [&](const char* id, const char* words, const Theorem& is, Expr value,
                        const Theorems& rules) {
    return book.show(id, words, equation(left(is), value, Theorems{is} + rules));
  };
  {
    const Theorem above = assume(lt(q_e(), 0));
    const Known here({above});
    const Theorem y_is = cut(linear(le(q_e(), 0), {above}), book["bodies.y_e"]);
    const Theorem from_1 =
        tautology(le(1, kappa()), {book["collapse.threshold"], linear(le(1, K()), {q_is, above})});
    const Theorems unit_is = parts({cut(from_1, book["collapse.unit"])});
    const Expr y_e = left(y_is), p = fun("pow", {y_e, j});
    know(from_1);
    const Theorems root_is = parts({cut(from_1, book["collapse.root"])});
    know(both(root_is));
    know(part(powers_of(book, root_is[2]), 0));
    const auto of_p = [&](const Theorem& is) { return at(is, {{unit, p}}); };
    const Expr root = sqrt(-q_e());
    const Theorem product = arithmetic(eq(y_e * root, (1 - power(y_e, 2)) / 2),
                                       {.equations = {{rational(-1, 2), root_is[0]}, {y_e, y_is}}});
    const Theorem gap = equation(1 / y_e - y_e, 2 * root, {product});
    const Theorem last =
        show("last_rise", "With a power of it for the unit", of_p(units.last),
             (1 - power(p, 2)) / (2 * root),
             {linear(eq(root * p * U_last(j), (1 - power(p, 2)) / 2), {rewrite(gap, unit_is[1])})});
    show("now_rise", "and", of_p(units.now), 1 + y_e * left(last), {unit_is[0], of_p(units.last)});
  }
  const Theorem even = assume(eq(q_e(), 0));
  const Known here({even, positive(book["wedge.kappa"])});
  const Theorem kappa_is = cancel(eq(kappa(), 1), {positive(kappa() + 1)},
                                  {book["collapse.square"], linear(eq(K(), 1), {q_is, even})});
  const Theorems steps = parts({book["chebyshev.steps"]});
  const auto of_1 = [&](const Theorem& is) { return rewrite(kappa_is, at(is, {{unit, 1}})); };
  show("last_step", "Where it is 0 no unit is needed:", of_1(units.last), j, {steps[1]});
  show("now_step", "and", of_1(units.now), j + 1, {steps[0]});
}
}  // namespace

void bodies(Book& book) {
  const Exprs assumptions = of_wedge({le(0, j), lt(0, e)});
  book.chapter("bodies", "Forms for evaluation: three bodies", assumptions);
  know(at(book["wedge.signs"], {{j, 0}}));
  const Theorem q_is = definition_of_q_e(book);
  Forms forms{{book, {M_A, w_B, M_C, e, j}, assumptions}};
  const InUnit units = in_unit(forms);
  {
    const Known here({assume(lt(0, unit)), book["wedge.signs"]});
    const Expr ratio = r_A() / r_B();
    forms.shared = forms.shared + parts({at(book["chebyshev.last"], {{x, kappa()}})});
    know(positive(forms.share("now_side", "With", is_P(j) + is_Q(j) * ratio)));
    forms.share("later_side", "and", is_Q(j) + is_P(j) * ratio);
    places(forms, units);
    time(forms, units);
  }
  rises(book, units, q_is);
  sines(book, units, angle(book, q_is));
}
}  // namespace derivation
