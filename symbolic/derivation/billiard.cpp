// Redner's billiard: with each place times the root of the mass a collision is a mirror.
#include "derivation/wedge.hpp"

namespace derivation {
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
}  // namespace derivation
