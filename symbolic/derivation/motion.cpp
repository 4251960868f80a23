// The motion from rest, in which only A moves at the start.
#include "derivation/wedge.hpp"

namespace derivation {
namespace {
/// Where kappa is the cosine of an angle h: pi/h collisions, rounded up, less one.
void number(Book& book) {
  const Known here;
  const Exprs domain = of_wedge({lt(0, e), lt(kappa(), 1), V_positive});
  know(book["wedge.acute"]);
  const Theorem cosine = turned(book["wedge.cosine"]);
  const Expr h = right(cosine).arg(0), slope = kappa() / sin(h);
  const Theorem quotient = quotients_of_sines(book, cosine)[0];
  book.show("speed_sine", "Where kappa is below 1 the approach speeds are sines, too,",
            equation(closing(j), V * root_power(j) * side(j) * right(quotient),
                     {book["motion.speed"], quotient}));
  const Theorem length =
      root_is(1 + power(slope, 2), 1 / sin(h), angles({}, {h}) + Theorems{cosine});
  const Theorem tilt =
      same_angle(equation(cos(atan(slope)), cos(pi() / 2 - h),
                          {rewrite(length, at("cos atan", {{x, slope}}))}, {pi() / 2, h}),
                 {positive(atan(slope))});
  const Theorem phase = at(book["any_start.def_phase_e"], {{W, 0}});
  const Theorem many = at(book["any_start.N"], {{W, 0}});
  const Theorem is = book.define("N_e", at_rest(), left(many), domain, "and the number of all is");
  const Theorem turns = rewrite(linear(eq(left(phase), h), {phase, tilt}), chain(is, many));
  book.show("N", "that is,", rewrite(equation(right(turns).arg(0).arg(0), pi() / h), turns));
}
/// One statement for both: that all collisions take place, and that K is 1 or more.
void endless(Book& book) {
  const Expr i = integer("i"), from_1 = le(1, kappa());
  const Theorem every = generalize(i, given(le(0, i), [&](const Theorem& from_0) {
                                     return at(book["motion.never_ends"], {{j, i}}, {from_0});
                                   }));
  const Theorem number = book["motion.N"], is = book["motion.def_N_e"];
  const Expr N = left(number), always = every.conclusion();
  const Theorem turns = positive(right(number).arg(0).arg(0), {book["wedge.acute"]});
  const Known index({linear(le(0, N), {number, turns})});
  const Theorem last = part(at(book["any_start.happens"], {{W, 0}}), 1);
  const Theorem ended = from_rest(book, rewrite(turned(is), last), {}, {N});
  const Theorem another =
      tautology(lt(0, closing(N)), {specialize(assume(always), N), linear(le(0, N))});
  const Theorem ends = refute(always, linear(lt(0, 0), {another, ended}));
  book.show("endless", "The collisions never end if and only if K is 1 or more:",
            tautology(iff(always, le(1, left(book["collapse.def_K"]))),
                      {book["collapse.threshold"], discharge(from_1, every),
                       discharge(lt(kappa(), 1), ends)}));
}
}  // namespace

Theorem from_rest(const Book& book, const Theorem& t, Substitution terms, const Exprs& indices) {
  terms.insert({W, 0});
  Theorem out = at(t, terms);
  for (const Theorem& is : parts({book["motion.names"]}))
    for (Expr i : indices) out = rewrite(turned(at(is, {{j, i}}, {assume(le(0, j))})), out);
  return out;
}

void motion(Book& book) {
  book.chapter("motion", "Two bodies at rest", of_wedge({le(0, j), lt(0, e), V_positive}));
  Theorems names;
  const auto named = [&](const std::string& symbol, Expr of_any) {
    names.push_back(
        defined(symbol, at_rest() + Exprs{j}, substitute(of_any, {{W, 0}}), of_wedge({le(0, j)})));
  };
  for (const std::string body : {"A", "B", "C"}) named("v_" + body, any_velocity(body, j));
  named("closing", nearing(j));
  book.show("names", "With the ball and B at rest at the start all is named anew:", both(names));
  const auto show = [&](const std::string& id, const char* words, const Exprs& indices) {
    book.show(id, words, from_rest(book, book["any_start." + id], {}, indices));
  };
  book.show("start", "At the start",
            canonical_form(from_rest(book, book["any_start.start"], {}, {0})));
  show("next", "Collision j is one of A and C, or of C and B, by turns:", {j, j + 1});
  show("closing", "Before collision j its two bodies approach with the speed", {j});
  show("recurrence", "and each one follows from two before:", {j, j + 1, j + 2});
  for (Expr i : {Expr(0), j}) know(at(book["wedge.signs"], {{j, i}}));
  know(positive(book["wedge.kappa"]));
  const Expr U_j = U(j), closes = closing(j), factor = V * root_power(j) * side(j);
  const Theorem speed =
      book.show("speed", "So collision j has the approach speed",
                equation(closes, factor * U_j, {from_rest(book, book["any_start.speed"])}));
  book.show("takes_place", "and takes place if and only if U_j is positive:",
            same_sign(iff(lt(0, closes), lt(0, U_j)), factor, {speed}));
  number(book);
  const Known from_1({assume(le(1, kappa()))});
  book.show(
      "never_ends", "Where kappa is 1 or more, the collisions never end:",
      tautology(lt(0, closes), {book["motion.takes_place"],
                                linear(lt(0, U_j), {at(book["chebyshev.rise"], {{x, kappa()}})})}));
  endless(book);
}
}  // namespace derivation
