// Symbols of the motion of three bodies of any masses with restitution.
#pragma once
#include "derivation/symbols.hpp"

namespace derivation {
/// w_B is 1/M_B, 0 for a wall.
inline const Expr M_A = real("M_A"), w_B = real("w_B"), M_C = real("M_C"), e = real("e");
inline const Expr L = real("L"), W = real("W"), d_A = real("d_A"), d_B = real("d_B");
inline const Expr tau = real("tau"), unit = real("unit");
/// Positive masses, B perhaps a wall, and more.
inline Exprs of_wedge(const Exprs& more) {
  return Exprs{lt(0, M_A), le(0, w_B), lt(0, M_C)} + more;
}
/// The mass of all three over that of B, 1 for a wall.
inline Expr mass_of_all() { return 1 + w_B * (M_A + M_C); }
/// C approaches B with W and A approaches C with V; B is at rest.
inline Exprs any_start() { return {M_A, w_B, M_C, e, V, W}; }
inline Substitution start_with(Expr of_A, Expr of_B) { return {{V, of_A}, {W, of_B}}; }
/// The velocity of "A", "B" or "C" after i collisions, and the approach speed before collision i.
inline Expr any_velocity(const std::string& body, Expr i) {
  return fun("any_" + body, any_start() + Exprs{i});
}
inline Expr nearing(Expr i) { return fun("nearing", any_start() + Exprs{i}); }
/// The momentum, times w_B.
inline Expr any_momentum() { return w_B * (M_A * (V + W) + M_C * W); }
/// The same where the ball and B are at rest at the start.
inline Exprs at_rest() { return {M_A, w_B, M_C, e, V}; }
inline Expr velocity(const std::string& body, Expr i) {
  return fun("v_" + body, at_rest() + Exprs{i});
}
inline Expr closing(Expr i) { return fun("closing", at_rest() + Exprs{i}); }
/// A theorem of the motion from any start about that from rest, in its names, at `indices`.
Theorem from_rest(const Book& book, const Theorem& t, Substitution terms = {},
                  const Exprs& indices = {j, j + 1});
/// sqrt(e)^i
inline Expr root_power(Expr i) { return fun("pow", {sqrt(e), i}); }
/// Shows the motion from any start, collision by collision, and what its approach speeds keep.
void sequences(Book& book);
inline const Substitution elastic{{e, 1}};
inline Exprs masses_and_e() { return {M_A, w_B, M_C, e}; }
inline Expr kappa() { return fun("kappa", masses_and_e()); }
inline Expr U(Expr i, Expr at = kappa()) { return fun("U", {at, i}); }
inline Expr U_last(Expr i) { return fun("U_last", {kappa(), i}); }
inline Expr r_A() { return fun("r_A", {M_A, M_C}); }
inline Expr r_B() { return fun("r_B", {w_B, M_C}); }
inline Expr r_e() { return fun("r_e", masses_and_e()); }
/// The approach speed before collision i, but for positive factors.
inline Expr swing(Expr i) { return V * U(i) + W * r_e() * U_last(i); }
/// 1 for P, r_A/r_B for Q.
inline Expr side(Expr i) { return is_P(i) + is_Q(i) * (r_A() / r_B()); }
/// time, x_A, x_B, x_C at collision i.
inline Expr at_collision(const char* name, Expr i) {
  return fun(name, {M_A, w_B, M_C, e, V, L, i});
}
inline Expr apart(Expr i) { return at_collision("x_B", i) - at_collision("x_A", i); }
/// l = r/by from l by = r for a positive term `by`.
Theorem divided(Expr l, Expr by, const Theorem& times_by);
/// Blocks of mass 1, a ball of mass alpha.
inline const Substitution blocks_of_paper{{M_A, 1}, {w_B, 1}, {M_C, alpha}};
/// The paper's case, and theorems for these blocks, or where nothing is lost.
inline Expr in_paper(Expr t) { return substitute(substitute(t, blocks_of_paper), elastic); }
inline Theorem lossless(const Book& book, const char* id) { return at(book[id], elastic); }
Theorem for_blocks(const Theorem& t, Substitution terms = {}, const Theorems& facts = {});
inline Theorem in_paper(const Theorem& t) { return for_blocks(t, elastic); }
/// The start, and what the first collisions change.
Theorems first_collisions(const Book& book, int count,
                          const Substitution& bodies = blocks_of_paper);
/// The squares of r_A and r_B.
Theorems squared_shares(const Book& book);
/// |- 0 < pow_j(t) and pow_j(t) <= 1, from t <= 1 for a t that is known to be positive.
Theorem powers_of(const Book& book, const Theorem& at_most_1);
/// Where kappa is cos(h), U_j and U_last are sines of multiples of h over sin(h).
Theorems quotients_of_sines(const Book& book, const Theorem& kappa_is);
/// The same where nothing is lost and powers of e are 1, as the first two of four say.
Theorems without_losses(const Book& book, const Theorem& kappa_is);
WriteChapter restitution, from_any_start, motion, transmission, ends, chebyshev, wedge, places,
    collapse, encounters, wall, cradle, billiard, losses, unfolded, bodies, loss_forms;
}  // namespace derivation
