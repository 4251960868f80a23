// Redner's billiard: with each place times the root of the mass a collision is a mirror. Its path,
// unfolded in the wedge, is a straight line.
#include "derivation/wedge.hpp"

namespace derivation {
namespace {
/// Where a body touches the next one, in the space of places times roots of masses.
void walls(Book& book, const Theorem& cosine) {
  const Expr s = sqrt(M_C), z = real("Z"), B = sqrt(w_B);
  const Expr place = column({sqrt(M_A) * x, s * y, z});
  const Expr A_C = column({s * r_A() / sqrt(M_A), -r_A(), 0});
  const Expr C_B = column({0, r_B(), -B * s * r_B()});
  const auto dot = [](Expr a, Expr b, Expr value) {
    return eq(times(transpose(a), b), matrix(1, {value}));
  };
  book.show("walls",
            "With A at x, the ball at y and B at sqrt(w_B) Z, two of them touch where one of these "
            "products is 0:",
            both({equation(dot(A_C, place, s * r_A() * (x - y))),
                  equation(dot(C_B, place, s * r_B() * (y - B * z)))}));
  const Theorems shares = squared_shares(book);
  book.show("enclosed", "Those two vectors have length 1, and their walls enclose the angle h:",
            both({equation(dot(A_C, A_C, 1), shares), equation(dot(C_B, C_B, 1), shares),
                  equation(dot(A_C, C_B, -right(cosine)),
                           {turned(cosine), lossless(book, "wedge.kappa"), root_is(1, 1)})}));
}

// Newton's cradle of the paper: equal blocks with balls of magic ratios between them, and how much
// room each ball must leave for the one before it.

/// When and where the last collision takes place at a magic ratio.
void last_collision(Book& book) {
  const Expr last = 2 * k - 1, half = psi() / 2;
  const Theorem number =
      book.show("number", "At a magic ratio there are 2k collisions,",
                linear(eq(N(), 2 * k), {book["counting.shares"], book["magic.counts"]}));
  const Theorem whole_turn =
      equation((2 * k + 1) * psi(), 2 * pi(),
               {linear(eq(psi(), 2 * (pi() / (2 * k + 1))), {book["magic.angle"]})});
  know(linear(lt(last, N()), {number}));
  const auto at_last = [&](const char* id) { return at(book[id], {{j, last}}); };
  const Theorem mirrored = equation(sin(pi() - half), sin(half), {}, {pi(), half});
  const Theorem before = linear(eq((last + 1) * half, pi() - half), {whole_turn});
  const Theorem two_before = linear(eq(last * half, pi() - 2 * half), {whole_turn});
  const auto shown = [&](const char* id, Expr value) {
    const Theorem t = rewrite(mirrored, rewrite(before, rewrite(two_before, at_last(id))));
    return equation(left(t), value, {t, book["rotation.cos_half_psi"]}, {pi(), half});
  };
  const Theorem when = shown("encounters.when", 2 * L / ((1 + alpha) * V));
  const Theorem apart = shown("encounters.apart", L);
  book.show("last", "the last of them when and where", both({when, apart}));
  // Where B is: from the centre of mass, as it is with the ball and at a distance L from A.
  const Theorem going = at_last("encounters.going");
  const auto lossless_at_last = [&](const char* id) {
    return cut(going, for_blocks(book[id], {{e, 1}, {j, last}}));
  };
  know(going);
  const auto there = [&](const char* name) { return in_paper(at_collision(name, last)); };
  const Expr x_B = there("x_B"), x_C = there("x_C"), time = there("time");
  const Theorem names = at_last("encounters.definitions");
  const Theorem is_Q = restate(eq(turn(last), -1), at(part(book["cycle.turns"], 1), {{n, k - 1}}));
  const Theorem touches = linear(eq(x_C, x_B), {rewrite(is_Q, lossless_at_last("places.met"))});
  const Theorem centre =
      linear(eq(alpha * x_B, V * time + 2 * L - 2 * x_B),
             {rewrite(touches, lossless_at_last("places.carried")), part(names, 1), apart});
  const Expr place = 2 * L / (1 + alpha);
  const Theorem time_is = chain(turned(part(names, 0)), when);
  const Theorem B_is = cancel(eq(x_B, place), {positive(2 + alpha)}, {centre, time_is});
  book.show("room", "B has moved by less than L, so a next ball at a distance L waits untouched:",
            both({B_is, linear(lt(x_B, 2 * L), {B_is, positive(alpha * place)})}));
}
/// B is the next A: velocities and collisions of the whole cradle, ball k of the ratio alpha_k.
void hand_on(Book& book) {
  know(assume(le(0, j)));
  const Expr ratio = fun("alpha_", {j + 1});
  const auto with = [&](const char* name, Expr speed) { return fun(name, {ratio, speed}); };
  const Theorems motion =
      defined_by_recursion({"cradle_speed", "cradle_count"}, {V}, j, {V_positive, le(0, j)}, {V, 0},
                           [&](const Exprs& before) {
                             return Exprs{with("b_t", before[0]), before[1] + with("N", before[0])};
                           });
  const auto speed = [](Expr i) { return fun("cradle_speed", {V, i}); };
  book.show("start",
            "In a cradle of blocks with ball k of the ratio alpha_k behind block k, the speed with "
            "which block j + 1 sets off, and the number of collisions until then:",
            both({motion[0], motion[1]}));
  know(at(book["ratios.alpha_k_positive"], {{k, j + 1}}));
  const auto there = [&](const char* id, const Theorem& known) {
    return at(book[id], {{alpha, ratio}, {V, speed(j)}, {k, j + 1}}, {known});
  };
  // How it goes on for a speed that is V.
  const auto all_handed_on = [&](const Theorem& known) {
    const Theorems velocities = parts({there("magic.terminal", known)}),
                   names = parts({there("terminal.definitions", known)});
    const Theorem a_is = chain(names[0], velocities[0]), b_is = chain(names[1], velocities[1]);
    return Theorems{a_is, b_is, equation(with("c_t", speed(j)), 0, {names[2], a_is, b_is})};
  };
  const Theorem speeds = by_induction(j, eq(speed(j), V), motion[0], [&](const Theorem& now) {
    return chain(chain(at(motion[2]), all_handed_on(now)[1]), now);
  });
  know(linear(lt(0, speed(j)), {speeds}));
  book.show("next", "As the next ball waits untouched, each pair is as before,",
            both({motion[2], motion[3]}));
  book.show("speeds", "so each block sets off with V in its turn", speeds);
  const Theorems ends = all_handed_on(speeds);
  book.show("left", "and the block and the ball before it are left at rest,",
            both({ends[0], ends[2]}));
  book.show("collisions", "after k collisions of each with ball k:",
            by_induction(j, eq(fun("cradle_count", {V, j}), j * (j + 1)), {motion[1]},
                         {at(motion[3]), there("cradle.number", speeds)}));
}
}  // namespace

/// A collision of two bodies of masses M_1 and M_2 in the plane of the scaled velocities.
void billiard(Book& book) {
  const Expr s_1 = sqrt(M_1), s_2 = sqrt(M_2);
  book.chapter("billiard", "Redner's billiard", {lt(0, M_1), lt(0, M_2)});
  const Expr sum = M_1 + M_2, across = 2 * s_1 * s_2 / sum;
  const Theorem is = book.name("mirror", {M_1, M_2},
                               matrix(2, {(M_1 - M_2) / sum, across, across, (M_2 - M_1) / sum}),
                               {lt(0, M_1), lt(0, M_2)}, "For two bodies, the matrix");
  const Expr m = left(is);
  const Theorems after{lossless(book, "restitution.v_1"), lossless(book, "restitution.v_2")};
  const Expr along = column({s_1, s_2}), normal = column({s_2, -s_1});
  book.show("line", "leaves the line on which both are at one place,",
            equation(times(m, along), along, {is}));
  book.show("normal", "and turns what is across it: it is a mirror.",
            equation(times(m, normal), column({-s_2, s_1}), {is}));
  const Expr image = column({s_1 * v_1, s_2 * v_2}), before = column({s_1 * u_1, s_2 * u_2});
  book.show("collision", "Velocities times the roots of the masses are reflected by it,",
            equation(image, times(m, before), Theorems{is} + after));
  book.show("speed", "and the speed in that plane is kept:",
            equation(M_1 * power(v_1, 2) + M_2 * power(v_2, 2),
                     M_1 * power(u_1, 2) + M_2 * power(u_2, 2), after));
}

void unfolded(Book& book) {
  const Expr going = substitute(lt(0, closing(j)), elastic);
  const Exprs assumptions = of_wedge({le(0, j), V_positive, lt(0, L), going});
  book.chapter("unfolded", "The unfolded wedge", assumptions);
  know(lossless(book, "wedge.signs"));
  // Where nothing is lost, kappa always is a cosine.
  const Theorem K_is = lossless(book, "collapse.def_K");
  const Expr K = left(K_is), rest = M_C * mass_of_all() / ((M_A + M_C) * (1 + w_B * M_C));
  know(tautology(lt(substitute(kappa(), elastic), 1),
                 {lossless(book, "collapse.threshold"),
                  linear(lt(K, 1), {equation(1 - K, rest, {K_is}), positive(rest)})}));
  know(lossless(book, "wedge.acute"));
  const Theorem cosine = turned(lossless(book, "wedge.cosine"));
  walls(book, cosine);
  const Expr h = right(cosine).arg(0);
  const auto here = [&](Expr t) { return substitute(t, elastic); };
  const Expr all = mass_of_all(), scale = sqrt((M_A + M_C) / all);
  const Theorem radius_is = book.define(
      "radius", {M_A, w_B, M_C, V, L, j}, scale * side(j) * here(apart(j)), assumptions,
      "At collision j the scaled places have, from where all three would meet, the distance");
  const auto radius = [&](Expr i) { return substitute(left(radius_is), {{j, i}}); };

  const Expr A = here(at_collision("x_A", j)), B = here(at_collision("x_B", j)),
             C = here(at_collision("x_C", j));
  book.show(
      "radius", "whose square, with the masses, is a sum over the pairs of bodies:",
      equation(all * power(radius(j), 2),
               M_A * power(A - B, 2) + w_B * M_A * M_C * power(A - C, 2) + M_C * power(B - C, 2),
               squared_shares(book) +
                   Theorems{radius_is, lossless(book, "places.ball"), book["cycle.turn_squared"]}));

  const Theorem takes_place =
      tautology(lt(0, here(U(j))), {lossless(book, "motion.takes_place"), assume(going)});
  const Expr sine = sin((j + 1) * h);
  know(takes_place);
  const Theorem L_is = book.define("scaled_L", {M_A, w_B, M_C, L}, scale * L, of_wedge({}),
                                   "With the distance at first");
  const Theorem V_is = book.define("scaled_V", {M_A, w_B, M_C, V}, scale * V * (r_A() / r_B()),
                                   of_wedge({}), "and the speed");
  const Expr first = left(L_is), speed = left(V_is);
  book.show("speed", "which is that of the energy without that of the centre of mass,",
            equation(power(speed, 2), M_A * power(V, 2) - w_B * power(M_A * V, 2) / all,
                     squared_shares(book) + Theorems{V_is}));
  const Theorems rules = without_losses(book, cosine) +
                         Theorems{radius_is, solved_for(B, lossless(book, "places.distance")), L_is,
                                  V_is, lossless(book, "places.time")};
  const Expr moved = speed * here(at_collision("time", j));
  const Theorem sum = equation(sine, sin(j * h) * cos(h) + cos(j * h) * sin(h), {}, {j * h, h});
  book.show("line",
            "the path from there, unfolded so that collision j is at the angle j h, is a straight "
            "line:",
            both({equation(radius(j) * cos(j * h), first - moved * cos(h), rules + Theorems{sum}),
                  equation(radius(j) * sin(j * h), moved * sin(h), rules)}));
}

void cradle(Book& book) {
  const Theorem magic = assume(eq(alpha, fun("alpha_", {k})));
  book.chapter("cradle", "A cradle of magic ratios",
               {alpha_positive, V_positive, lt(0, L), le(1, k), magic.conclusion()});
  last_collision(book);
  hand_on(book);
}
}  // namespace derivation
