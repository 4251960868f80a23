// Newton's cradle of the paper: equal blocks with balls of magic ratios between them, and how much
// room each ball must leave for the one before it.
#include "derivation/wedge.hpp"

namespace derivation {
namespace {
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

void cradle(Book& book) {
  const Theorem magic = assume(eq(alpha, fun("alpha_", {k})));
  book.chapter("cradle", "A cradle of magic ratios",
               {alpha_positive, V_positive, lt(0, L), le(1, k), magic.conclusion()});
  last_collision(book);
  hand_on(book);
}
}  // namespace derivation
