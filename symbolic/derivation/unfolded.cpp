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
}  // namespace derivation
