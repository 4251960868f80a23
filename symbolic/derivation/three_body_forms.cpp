// SPDX-License-Identifier: GPL-2.0-or-later
// Forms for evaluation: three bodies of any masses, or two and a wall, with restitution.
#include "derivation/wedge.hpp"

namespace derivation {
namespace {
Expr h_e() { return fun("h_e", masses_and_e()); }
Expr sine(Expr times) { return sin(times * h_e()); }

Expr K() { return fun("K", masses_and_e()); }
Expr q_e() { return fun("q_e", masses_and_e()); }

/// Names of quantities of collision j, and the forms that are shown for them.
struct Forms : Names {
  Theorem below;  ///< |- kappa < 1
  Theorems shared = {};

  Expr step_sine() const { return fun("step_sine", masses_and_e()); }
  Theorem from_any_start(const std::string& id) const {
    return cut(below, book["any_start." + id]);
  }
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
  void share(const std::string& symbol, const std::string& words, Expr value) {
    shared.push_back(with({}, symbol, value, domain));
    book.show("def_" + symbol, words, under({lt(0, q_e())}, shared.back()));
  }
};

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
  const Theorem speed = at_end("def_end_speed", "and where", {});
  const Exprs ends{lt(0, left(speed))};
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
Expr weighed(Expr of_A, Expr of_B, Expr sine, Expr sine_before) {
  return of_A * sine + of_B * r_e() * sine_before;
}
/// Places at a time tau after collision j, seen from B's first one; velocities, where no distance
/// is given and tau is 1.
void places(const Forms& forms) {
  const Substitution distances = start_with(d_A, d_B);
  const auto name = [&](const std::string& symbol, Expr v) {
    return forms.with({V, W, d_A, d_B, tau}, symbol, tau * v - substitute(v, distances),
                      forms.domain);
  };
  const auto twice = [&](const Theorem& t) { return Theorems{t, at(t, distances)}; };
  const Theorem turn_next = at(part(forms.book["cycle.turn"], 1));
  const Theorem pow_next = at(part(at(forms.book["multiples.pow"], {{y, sqrt(e)}}), 1));
  const Theorem speed = forms.book["any_start.speed"];
  const Theorem before = name("before", nearing(j)), after = name("after", nearing(j + 1));
  const Expr of_A = V * tau - d_A, of_B = W * tau - d_B, now_sine = forms("now_sine");
  const Expr per = root_power(j) / forms.step_sine();
  forms.show(before, "For the places at a time tau after collision j let",
             per * forms("now_side") * weighed(of_A, of_B, now_sine, forms("last_sine")),
             twice(speed));
  forms.show(
      after, "and",
      sqrt(e) * per * forms("later_side") * weighed(of_A, of_B, forms("later_sine"), now_sine),
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
/// How many collisions there are, and when each of them is.
void count_and_time(const Forms& forms) {
  Book& book = forms.book;
  const Expr step_sine = forms.step_sine();
  const auto with_sine = [&](const char* id) {
    return rewrite(turned(forms.shared[0]), forms.from_any_start(id));
  };
  {
    const Known here({assume(V_positive)});
    book.show("phase_e", "Where A approaches the ball, with the angle", with_sine("def_phase_e"));
    book.show("N_any", "the number of collisions is", forms.from_any_start("N"));
  }
  const Expr now = forms("now_sine"), last = forms("last_sine");
  const Theorem reach = forms.with({V, W}, "reach", weighed(V, W, now, last), forms.domain);
  book.show("def_reach",
            "Collision j takes place where this is positive:", under({lt(0, q_e())}, reach));
  know(assume(lt(0, left(reach))));
  const Theorem speed = equation(nearing(j), root_power(j) * side(j) * (left(reach) / step_sine),
                                 forms.shared + Theorems{book["any_start.speed"], reach});
  know(positive(speed));
  const Theorem going = linear(lt(0, nearing(j)));
  const Theorem when = cut(going, book["any_start.instant"]);
  const Theorem moment =
      forms.with({V, W, d_A, d_B}, "moment", left(when), forms.domain + Exprs{going.conclusion()});
  forms.show(moment, "Its time is", weighed(d_A, d_B, now, last) / left(reach),
             {when, speed, at(book["any_start.speed"], start_with(d_A, d_B))});
}
}  // namespace

void three_body_forms(Book& book) {
  const Exprs assumptions = of_wedge({le(0, j), lt(0, e)});
  book.chapter("bodies", "Forms for evaluation: three bodies", assumptions);
  know(at(book["wedge.signs"], {{j, 0}}));
  Forms forms{{book, {M_A, w_B, M_C, e, j}, assumptions}, angle(book, definition_of_q_e(book))};
  know(book["wedge.signs"]);
  const Expr ratio = r_A() / r_B();
  forms.shared.push_back(defined("step_sine", masses_and_e(), sin(h_e()), of_wedge({lt(0, e)})));
  book.show("def_step_sine", "With", under({lt(0, q_e())}, forms.shared[0]));
  know(positive(forms.shared[0]));
  forms.share("now_side", "and", is_P(j) + is_Q(j) * ratio);
  forms.share("later_side", "and", is_Q(j) + is_P(j) * ratio);
  forms.share("last_sine", "and", sine(j));
  forms.share("now_sine", "and", sine(j + 1));
  forms.share("later_sine", "and", sine(j + 2));
  const Theorems sines = quotients_of_sines(book, turned(cut(forms.below, book["wedge.cosine"])));
  for (const Theorem& is : sines) forms.shared = forms.shared + Theorems{is, at(is, {{j, j + 1}})};
  places(forms);
  count_and_time(forms);
}
}  // namespace derivation
