// The paper's symbols as terms, and what every chapter includes.
#pragma once
#include "algebra/tactics.hpp"
#include "derivation/book.hpp"

namespace derivation {
using namespace algebra;

inline const Expr alpha = real("alpha"), V = real("V"), x = real("x"), y = real("y");
inline const Expr n = integer("n"), j = integer("j"), k = integer("k");
/// Masses of two bodies, of a block, and velocities before and after a collision.
inline const Expr M_1 = real("M_1"), M_2 = real("M_2"), M = real("M");
inline const Expr u_1 = real("u_1"), u_2 = real("u_2"), v_1 = real("v_1"), v_2 = real("v_2");
inline const Expr momentum_kept = eq(M_1 * u_1 + M_2 * u_2, M_1* v_1 + M_2 * v_2);
inline const Expr alpha_positive = lt(0, alpha);
inline const Expr V_positive = lt(0, V);
inline const Expr n_from_0 = le(0, n), n_from_1 = le(1, n), j_from_0 = le(0, j);

inline Expr rational(int p, int q) { return Expr(cln::cl_RA(p) / q); }
/// After j collisions: the velocities of A, B and C; whose turn it is, 1 for P and -1 for Q.
inline Expr A(Expr i) { return fun("A", {alpha, V, i}); }
inline Expr B(Expr i) { return fun("B", {alpha, V, i}); }
inline Expr C(Expr i) { return fun("C", {alpha, V, i}); }
inline Expr turn(Expr i) { return fun("turn", {i}); }
/// 1 where collision i is one of A and C, else 0; and 1 where it is one of C and B.
inline Expr is_P(Expr i) { return (1 + turn(i)) / 2; }
inline Expr is_Q(Expr i) { return (1 - turn(i)) / 2; }
/// The paper's velocities, just after P_n and Q_n.
inline Expr a(Expr i) { return fun("a", {alpha, V, i}); }
inline Expr b(Expr i) { return fun("b", {alpha, V, i}); }
inline Expr c(Expr i) { return fun("c", {alpha, V, i}); }
inline Expr c_prime(Expr i) { return fun("c'", {alpha, V, i}); }
inline Expr V_vector(Expr i) { return fun("V_", {alpha, V, i}); }  ///< (a_n, b_n, sqrt(alpha) c'_n)
inline Expr theta() { return fun("theta", {alpha}); }
inline Expr psi() { return fun("psi", {alpha}); }
inline Expr half() { return psi() / 2; }
inline Expr quarter() { return psi() / 4; }
inline Expr V_CM() { return fun("V_CM", {alpha, V}); }
inline Expr Gamma() { return fun("Gamma", {alpha}); }
inline Expr Gamma_A() { return fun("Gamma_A", {alpha}); }
inline Expr Gamma_B() { return fun("Gamma_B", {alpha}); }
inline Expr Lambda() { return fun("Lambda", {alpha}); }
inline Expr R() { return fun("R", {alpha}); }
inline Expr lambda_3(Expr angle) { return fun("lambda_3", {angle}); }
/// The speed with which the two bodies of collision j approach before it.
inline Expr approach(Expr i) { return fun("approach", {alpha, V, i}); }
inline Expr a_t() { return fun("a_t", {alpha, V}); }
inline Expr b_t() { return fun("b_t", {alpha, V}); }
inline Expr c_t() { return fun("c_t", {alpha, V}); }
inline Expr N() { return fun("N", {alpha, V}); }
inline Expr N_A() { return fun("N_A", {alpha, V}); }
inline Expr N_B() { return fun("N_B", {alpha, V}); }
inline Expr identity(int size) {
  Exprs entries;
  for (int i = 0; i < size * size; ++i) entries.push_back(i % (size + 1) == 0 ? 1 : 0);
  return matrix(size, entries);
}
inline Expr column(const Exprs& entries) { return matrix(1, entries); }

/// The same with each equation's left side replaced by its right one, in their order.
inline Theorem rewritten(const Theorems& equations, Theorem t) {
  for (const Theorem& e : equations) t = rewrite(e, t);
  return t;
}
/// The same statement with arguments such as n - 1 + 1 computed.
inline Theorem canonical_form(const Theorem& t) {
  return restate(kernel::canonical(t.conclusion()), t);
}
/// What is so from 0 on at n - 1, from 1 on.
inline Theorem one_before(const Theorem& t) { return at(t, {{n, n - 1}}, {assume(n_from_1)}); }
/// Shows cosine and sine of half of an angle and of it, from |- angle = 2 atan(t), sqrt(1 + t^2).
void show_angle(Book& book, const Theorem& is, const Theorems& hypotenuse, Expr cosine, Expr sine);
/// |- sqrt(alpha (2 + alpha)) = sqrt(alpha) sqrt(2 + alpha)
Theorem root_split(Book& book);
/// Names with the same parameters and domain.
struct Names {
  Book& book;
  Exprs params, domain;
  Expr operator()(const std::string& symbol) const { return fun(symbol, params); }
  Theorem name(const std::string& symbol, Expr value, const std::string& words = "and") const {
    return book.define(symbol, params, value, domain, words);
  }
  /// The name of a positive term, known to be one from here on.
  Theorem positive(const std::string& symbol, Expr value, const std::string& words = "and") const {
    const Theorem is = name(symbol, value, words);
    know(algebra::positive(is));
    return is;
  }
};
/// Collisions with the approach speeds `speed`, as long as these are positive: 0 < speed(j) if and
/// only if 0 < sin(angle(j + 1)) is `sign`; angle(i) is i steps (or half steps) of a positive term,
/// angle(turns) = pi, angle(1) < pi. Shows that name(params), the least j with speed(j) <= 0, is
/// ceil(turns) - 1: statements N_least, N and happens.
struct Count {
  std::string name;
  Exprs params, domain;
  std::function<Expr(Expr)> speed, angle;
  Expr step, turns;
  Theorem sign;
};
void count(Book& book, const Count& c);
/// A velocity of the chapter "power" at a threshold, where its angle is pi less `rest`.
struct Velocity {
  Expr left, right;
  std::string id;
  Expr index, angle, rest, base;
};
struct Kind {
  std::string chapter, title, ratio, count_label, count_words, velocity_label, velocity_words;
  Expr d;  // psi/2 = pi/d
  Expr N_A_is, unrounded;
};
void at_threshold(Book& book, const Kind& kind, const std::vector<Velocity>& velocities);
/// 0 < pi/d and pi/d < pi/2 for a denominator d that `facts` say to be above 2.
Theorems range_of(Expr d, const Theorems& facts = {});

// The chapters.
using WriteChapter = void(Book& book);
WriteChapter contact, cycle, cycle_matrix, rotation, powers, counting, multiples, table,
    constraints, ratios, magic, deficient, terminal, orthogonal, minima, small_alpha, evaluators,
    end_forms, ratio_forms, heavy, collision_forms, radicals, exact_forms;

// What the chapters of evaluated forms share: names for parts of a form, the angle.
inline Expr of_alpha(const std::string& name) { return fun(name, {alpha}); }

/// half_h = psi/4, t = sin(psi/4)/cos(psi/4), t <= w, and rules for forms in t and w = t/alpha.
struct Angle {
  Theorem quarter, tangent, t_small;
  Theorems rules;
};
/// From the chapter "evaluators".
Angle evaluated_angle(const Book& book);
}  // namespace derivation
