// Evaluated forms of the terminal velocities with restitution, of any masses; that of A is 1.
#include "derivation/wedge.hpp"

namespace derivation {
namespace {
Exprs masses() { return {M_C, w_B, e}; }
Expr of_e(const std::string& name) { return fun(name, masses()); }
const Substitution A_is_1{{M_A, 1}};
Theorem at_1(const Theorem& t) { return at(t, A_is_1); }
Expr at_1(Expr t) { return substitute(t, A_is_1); }
/// (1 + M_C)(1 + w_B M_C)
Expr both_masses() { return (1 + M_C) * (1 + w_B * M_C); }

/// t = tan(h_e/2), without cancellation but in `share_e`, which is 1 or less. |- h_e = step_e.
Theorem angle(Book& book, Names& f, const Theorem& all, const Theorem& rise) {
  const Theorem both_are = f.positive("both_e", sqrt(both_masses()));
  const Theorem A_share = at_1(book["wedge.r_A"]), B_share = book["wedge.r_B"];
  const Expr inverse = 1 / (left(A_share) * left(B_share));
  const Theorem both_is = chain(both_are, root_is(both_masses(), inverse, {A_share, B_share}));
  const Theorem side = f.positive("side_e", of_e("both_e") / (1 + M_C));
  book.show("sides", "the factor of every second collision:",
            equation(left(A_share) / left(B_share), of_e("side_e"), {A_share, both_is, side}));
  f.name("root_e", sqrt(e));
  const Theorem loss = f.name("loss_e", power(1 - e, 2) / of_e("rise_e"));
  const Theorem share = f.name("share_e", 1 - of_e("loss_e"));
  const Theorem ends = assume(lt(0, of_e("share_e")));
  know(ends);
  f.domain.push_back(ends.conclusion());
  const Theorem whole = f.positive("whole_e", 2 * sqrt(e) * of_e("both_e") + (1 + e));
  const Theorem gap_e = f.positive("gap_e", of_e("rise_e") * of_e("share_e"));
  const Expr gap = of_e("gap_e"), W = of_e("whole_e");
  const Theorem z = f.positive("z_e", gap / power(W, 2));
  const Theorem t = f.positive("t_e", sqrt(gap) / W);
  const Expr T = left(t);
  const Theorem square =
      book.show("t_squared", "t^2 is", equation(power(T, 2), of_e("z_e"), {t, z}));
  // gap = (2 sqrt(e) both)^2 - (1 + e)^2
  const Theorem gap_is = equation(gap, power(2 * sqrt(e) * of_e("both_e"), 2) - power(1 + e, 2),
                                  {gap_e, rise, share, loss, all, both_are});
  const Theorem q = at_1(book["bodies.def_q_e"]), K = at_1(book["collapse.def_K"]);
  const Expr q_e = left(q), D = 4 * e * both_masses();
  know(positive(equation(q_e, gap / D, {q, K, gap_e, rise, share, loss, all})));
  const Expr kappa_e = at_1(kappa());
  know(tautology(lt(kappa_e, 1), {at_1(book["collapse.threshold"]), linear(lt(left(K), 1), {q})}));
  // (1 - t^2)/(1 + t^2) = kappa
  const Theorem step = f.positive("step_e", 2 * atan(T));
  const Expr half = atan(T);
  const Theorem parts_of_kappa = equation(kappa_e, (1 + e) / (2 * sqrt(e) * of_e("both_e")),
                                          {at_1(book["wedge.kappa"]), both_is});
  const Theorems of_half{at("cos atan", {{x, T}}), at("sin atan", {{x, T}}), square};
  const Theorem cosine = equation(cos(2 * half), kappa_e,
                                  of_half + Theorems{z, gap_is, whole, parts_of_kappa}, {half});
  const Theorem sine = f.positive("sine_e", 2 * T / (1 + of_e("z_e")));
  book.show("sine", "the sine of step_e:",
            rewrite(turned(step),
                    equation(sin(2 * half), of_e("sine_e"), of_half + Theorems{sine}, {half})));
  const Theorem same = same_angle(chain(cosine, turned(at_1(book["wedge.cosine"]))),
                                  {positive(half), at_1(book["wedge.acute"])});
  return book.show("h_e", "the angle is", linear(eq(of_e("step_e"), right(same)), {same, step}));
}

/// From |- v_B = V w_B taken
void energy_of_B(Book& book, const Names& f, const char* symbol, const char* taken,
                 const Theorem& v_B) {
  const Theorem rho =
      f.name(symbol, w_B * power(f(taken), 2), "B has of the energy the fraction (0 for a wall)");
  book.show(symbol, "as", equation(w_B * left(rho), power(left(v_B) / V, 2), {rho, v_B}));
}
/// Both speeds with which bodies part after the last collision, then the velocities.
void velocities(Book& book, Names& f, const Theorem& step) {
  const Expr N = at_1(fun("N_e", at_rest())), h = of_e("step_e");
  book.show("N_e", "the number of collisions", rewrite(turned(step), at_1(book["bodies.N_e"])));
  f.domain = {le(0, w_B), lt(0, M_C), lt(0, e), V_positive, lt(0, of_e("share_e")), lt(0, N)};
  f.params = {M_C, w_B, e, V};
  const Theorem all_are = book["evaluators_restitution.def_all_e"];
  Theorems names{all_are};
  const auto name = [&](const char* symbol, Expr value, const char* words = "and") {
    names.push_back(f.name(symbol, value, words));
    return f(symbol);
  };
  const Expr left_over = name("left_e", pi() - name("span_e", h * N, "With"));
  const Theorem rest = equation(at_1(fun("delta_e", at_rest())), left_over,
                                names + Theorems{at_1(book["ends.def_delta_e"]), turned(step)});
  const Theorem next = f.name("next_e", h - left_over);
  const Expr S = of_e("sine_e"), side_e = of_e("side_e"), power_e = name("power_e", root_power(N));
  const Expr is_odd = name("odd_e", 1 - turn(N)) / 2;
  const Expr is_even = name("even_e", 1 + turn(N)) / 2;
  const Expr last_side = name("last_side_e", is_odd + is_even * side_e);
  const Expr open_side = name("open_side_e", is_even + is_odd * side_e);
  const Expr last_reach = name("last_reach_e", last_side / S);
  const Expr open_reach = name("open_reach_e", open_side / S);
  const Expr last_sine = name("last_sine_e", sin(left_over));
  const Expr open_sine = name("open_sine_e", sin(left(next)));
  const Expr kept = name("kept_e", power_e * open_sine * open_reach);
  const Expr parted = name("parted_e", sqrt(e) * power_e * last_sine * last_reach);
  const Expr second = name("second_e", is_odd * kept + is_even * parted);
  const Expr speeds = name("speeds_e", kept + parted);
  const Expr gained = name("gained_e", 1 + name("moved_e", speeds + M_C * second));
  const Expr taken_by_B = w_B * name("taken_e", gained / left(all_are));

  const Theorems terms{turned(step), rest, turned(next), book["evaluators_restitution.sine"],
                       book["evaluators_restitution.sides"]};
  const auto speed = [&](const char* id, Expr form) {
    const Theorem is = rewritten(terms, at_1(book[id]));
    return equation(left(is), V * form, names + Theorems{is});
  };
  const Theorems ends = names +
                        Theorems{speed("ends.def_parting_e", parted),
                                 speed("ends.def_opening_e", kept), at_1(book["ends.B"])} +
                        parts({at_1(book["ends.A_and_C"])});
  const auto show = [&](const char* symbol, const char* body, Expr form) {
    const Theorem is = f.name(symbol, at_1(velocity(body, N)), "and so");
    return book.show(symbol, "is",
                     under(f.domain, equation(f(symbol), V * form, Theorems{is} + ends)));
  };
  const Theorem b_end = show("b_end", "B", taken_by_B);
  show("a_end", "A", taken_by_B - speeds);
  show("c_end", "C", taken_by_B - second);
  energy_of_B(book, f, "rho_end", "taken_e", b_end);
}
/// Where two are all: e (1 + M_C)(1 + w_B M_C) >= (1 + e)^2.
void two_collisions(Book& book, Names& f) {
  const Theorem K = at_1(book["collapse.def_K"]);
  const auto compare = [&](const char* symbol, int factor, const char* words) {
    const Theorem is = f.name(symbol, factor * e * both_masses() - power(1 + e, 2));
    book.show(
        symbol, words,
        equation(left(K), rational(factor, 4) - of_e(symbol) / (4 * e * both_masses()), {K, is}));
  };
  compare("ends", 4, "the square of kappa is below 1 where this is positive:");
  compare("two", 1, "and below 1/4, the square of the cosine of pi/3,");
  compare("four", 2, "1/2, that of pi/4,");
  compare("six", 3, "or 3/4, that of pi/6,");
  const Theorems facts = first_collisions(book, 2, A_is_1);
  f.params = {M_C, w_B, e, V};
  f.domain.push_back(V_positive);
  const auto show = [&](const char* symbol, const char* body, Expr form, const Theorems& more) {
    const Theorem is = f.name(symbol, at_1(velocity(body, 2)), "After two collisions");
    return book.show(symbol, "is", equation(left(is), V * form, facts + more + Theorems{is}));
  };
  show("a_two", "A", (1 - e * M_C) / (1 + M_C), {});
  show("c_two", "C", (w_B * M_C - e) * (1 + e) / both_masses(), {});
  const Theorem taken = f.name("taken_two", power(1 + e, 2) * M_C / both_masses(), "With");
  const Theorem b_two = show("b_two", "B", w_B * f("taken_two"), {taken});
  energy_of_B(book, f, "rho_two", "taken_two", b_two);
}
/// Where collisions never end: when that is over, and what B has then.
void collapse_forms(Book& book, Names f, const Theorem& all, const Theorem& rise) {
  const Known here;
  const Names any = f;
  Names of_x = f;
  of_x.params.push_back(x);
  const Theorem taken = f.name("taken_any", 1 / left(all), "Where collisions never end, with");
  const Theorem v_any = at(book["any_start.def_v_any"], {{M_A, 1}, {W, 0}});
  const Theorem v = book.show("v_any", "all go on after them with the velocity",
                              equation(left(v_any), V * (w_B * left(taken)), {v_any, taken, all}));
  energy_of_B(book, f, "rho_any", "taken_any", v);
  f.domain.push_back(lt(e, 1));
  know(assume(lt(e, 1)));
  const Theorem filled = f.name("filled_e", of_e("rise_e") / power(1 - e, 2), "With");
  const Theorem room = f.name("room_e", 1 - of_e("filled_e"));
  know(assume(le(0, of_e("room_e"))));
  f.domain.push_back(le(0, of_e("room_e")));
  const Theorem spread = f.name("spread_e", (1 - e) * sqrt(of_e("room_e")));
  know(linear(le(0, left(spread)), {spread, not_negative(right(spread))}));
  const Theorem A_share = at_1(book["wedge.r_A"]), B_share = at_1(book["wedge.r_B"]);
  const Theorem kappa_is = at_1(book["wedge.kappa"]);
  const Expr S = left(spread), excess = S * left(A_share) * left(B_share) / (2 * sqrt(e));
  const Theorems shares{kappa_is, A_share, B_share, spread, room, filled, rise, all};
  const Theorem square = equation(power(left(kappa_is), 2), 1 + power(excess, 2), shares);
  know(by_powers(le(1, left(kappa_is)), 2,
                 {square, positive(kappa_is), not_negative(power(excess, 2))}));
  const Theorem t_end = at(book["places.def_t_end"], {{M_A, 1}, {j, 0}});
  const Theorem root = root_is(power(left(kappa_is), 2) - 1, excess, {square});
  const Theorem is =
      book.show("t_end", "they come as close as you like to the time",
                equation(left(t_end), 2 * (1 + M_C) / (1 + e + S) * (L / V),
                         Theorems{t_end, at_1(book["collapse.y_e"]), root} + shares));
  const Theorem edge = any.name("edge_e", 2 * (1 + M_C) / (1 + e), "With");
  const Theorem none = root_is(left(room), 0, {assume(eq(left(room), 0))});
  book.show("edge", "at the threshold of collapse that time is",
            equation(left(t_end), left(edge) * (L / V), {is, edge, spread, none}));
  const Theorem closing = of_x.name(
      "closing_e", e * (1 + w_B * M_C) * power(x, 2) - (1 + e) * x + (1 + M_C), "A zero of");
  const Theorem at_end = at(closing, {{x, 2 * (1 + M_C) / (1 + e + S)}});
  book.show("closing", "is the time in units of L/V,",
            equation(left(at_end), 0, Theorems{at_end} + shares));
}
}  // namespace

void loss_forms(Book& book) {
  book.chapter("evaluators_restitution",
               "Forms for evaluation: terminal velocities that lose energy",
               {lt(0, M_C), le(0, w_B), lt(0, e), V_positive, lt(0, L)});
  const Names names{book, masses(), {lt(0, M_C), le(0, w_B), lt(0, e)}};
  Names two = names, many = names;
  two_collisions(book, two);
  const Theorem all = names.positive("all_e", at_1(mass_of_all()), "With");
  const Theorem rise = names.positive("rise_e", 4 * e * (M_C * of_e("all_e")));
  for (const char* share : {"wedge.r_A", "wedge.r_B"}) know(positive(at_1(book[share])));
  collapse_forms(book, names, all, rise);
  velocities(book, many, angle(book, many, all, rise));
}
}  // namespace derivation
