// SPDX-License-Identifier: GPL-2.0-or-later
// Numbers from the law of one collision alone: a body is reflected at the velocity of the common
// centre of mass. Nothing here is read from the book.
#include <cln/complex.h>
#include <cln/float.h>

#include "net.hpp"

namespace net {
namespace {
const cln::float_format_t digits = cln::float_format(80);

cl_R after(const cl_R& u, const cl_R& other, const cl_R& m, const cl_R& m_other,
           const cl_R& e = 1) {
  return (1 + e) * (m * u + m_other * other) / (m + m_other) - e * u;
}

/// A, B, C after some collisions, those with A and B by turns.
struct State {
  cl_R a, b, c;
  bool A_next = true;
  cl_R approach() const { return A_next ? a - c : c - b; }
  void collide(const cl_R& alpha) {
    cl_R& block = A_next ? a : b;
    const cl_R before = block;
    block = after(block, c, 1, alpha);
    c = after(c, before, alpha, 1);
    A_next = !A_next;
  }
};
State after_collisions(const cl_R& alpha, const cl_R& V, int j) {
  if (j < 0 || alpha <= 0) throw Undefined();
  State s{exact(V), exact(0), exact(0)};
  for (int i = 0; i < j; ++i) s.collide(alpha);
  return s;
}
struct End {
  State last;
  int N = 0, N_A = 0;
};
End end_of(const cl_R& alpha, const cl_R& V, const cl_R& still) {
  if (alpha <= 0 || V <= 0) throw Undefined();
  End e{after_collisions(alpha, V, 0)};
  while (e.last.approach() > still) {
    ++e.N;
    if (e.last.A_next) ++e.N_A;
    e.last.collide(alpha);
  }
  return e;
}
/// The least alpha with a count of at most k, by halving.
cl_R threshold(bool of_A, int k) {
  if (k < 1) throw Undefined();
  static std::map<std::pair<bool, int>, cl_R> known;
  if (const auto it = known.find({of_A, k}); it != known.end()) return it->second;
  cl_R lo = exact(0), hi = exact(1) + exact(1) / 1000;
  for (int i = 0; i < 230; ++i) {
    const cl_R middle = (lo + hi) / 2;
    const End e = end_of(middle, 1, 0);
    ((of_A ? e.N_A : e.N - e.N_A) <= k ? hi : lo) = middle;
  }
  return known[{of_A, k}] = hi;
}
/// Three bodies of any masses that lose energy, with their places: x holds M_A, 1/M_B or 0 for a
/// wall, M_C, e, V, and perhaps L.
struct Trio {
  explicit Trio(const std::vector<cl_R>& x)
      : A_mass(x[0]),
        per_B(x[1]),
        ball(x[2]),
        e(x[3]),
        v{exact(x[4]), exact(0), exact(0)},
        place{0, x.size() > 5 ? x[5] : 1, 0} {
    if (A_mass <= 0 || per_B < 0 || ball <= 0) throw Undefined();
  }
  std::size_t block() const { return A_next ? 0 : 1; }
  cl_R approach() const { return A_next ? v[0] - v[2] : v[2] - v[1]; }
  void collide() {
    const cl_R centre = A_next ? (A_mass * v[0] + ball * v[2]) / (A_mass + ball)
                               : (per_B * ball * v[2] + v[1]) / (per_B * ball + 1);
    for (std::size_t i : {block(), std::size_t(2)}) v[i] = (1 + e) * centre - e * v[i];
    A_next = !A_next;
  }
  void wait() {
    if (cln::abs(approach()) < tiny()) throw Undefined();
    const cl_R gap = A_next ? place[2] - place[0] : place[1] - place[2];
    const cl_R t = gap / approach();
    time = time + t;
    for (std::size_t i = 0; i < 3; ++i) place[i] = place[i] + t * v[i];
  }
  cl_R A_mass, per_B, ball, e;
  std::vector<cl_R> v, place;
  cl_R time = 0;
  bool A_next = true;
};
/// At collision j, before it.
Trio trio_at(std::vector<cl_R> x, bool with_places) {
  const int j = whole(x.back());
  x.pop_back();
  Trio t(x);
  if (j < 0) throw Undefined();
  for (int i = 0; i < j; ++i) {
    t.collide();
    if (with_places) t.wait();
  }
  return t;
}
/// How many collisions there are, where they end soon.
int trio_count(const std::vector<cl_R>& x) {
  Trio t(x);
  for (int n = 0; n < 300; ++n) {
    if (t.approach() <= tiny()) return n;
    t.collide();
    // Seen from the ball, unless there is a wall, and by a unit that shrinks as speeds do.
    const cl_R centre = t.per_B == 0 ? cl_R(0) : t.v[2];
    const cl_R unit = cln::realpart(cln::sqrt(exact(t.e)));
    for (cl_R& v : t.v) v = (v - centre) / unit;
  }
  throw Undefined();
}
/// Chebyshev's U_j by its sum of powers.
cl_R chebyshev(const cl_R& x, int j) {
  cl_R sum = 0;
  for (int k = 0; 2 * k <= j; ++k) {
    cl_R term = cln::expt(exact(2 * x), j - 2 * k) * (k % 2 == 0 ? 1 : -1);
    for (int i = 0; i < k; ++i) term = term * (j - k - i) / (i + 1);
    sum = sum + term;
  }
  return sum;
}
/// The columns of a collision or of a whole cycle, of (A, B, sqrt(alpha) C).
Matrix collisions(const cl_R& alpha, bool with_A, bool with_B) {
  if (alpha <= 0) throw Undefined();
  const cl_R s = cln::realpart(cln::sqrt(exact(alpha)));
  Matrix m(3, std::vector<cl_R>(3));
  for (std::size_t col = 0; col < 3; ++col) {
    State t{exact(col == 0 ? 1 : 0), exact(col == 1 ? 1 : 0), exact(col == 2 ? 1 : 0) / s};
    if (with_A) t.collide(alpha);
    t.A_next = false;
    if (with_B) t.collide(alpha);
    const cl_R out[]{t.a, t.b, t.c * s};
    for (std::size_t row = 0; row < 3; ++row) m[row][col] = out[row];
  }
  return m;
}
Matrix rotation(const cl_R& angle, std::size_t i, std::size_t j, std::size_t size) {
  Matrix m(size, std::vector<cl_R>(size, exact(0)));
  for (std::size_t k = 0; k < size; ++k) m[k][k] = exact(1);
  m[i][i] = m[j][j] = cln::cos(exact(angle));
  m[j][i] = cln::sin(exact(angle));
  m[i][j] = -m[j][i];
  return m;
}
using Vector = std::vector<cl_R>;
Vector cross(const Vector& p, const Vector& q) {
  return {p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]};
}
Vector unit(const Vector& v) {
  const cl_R l = cln::realpart(cln::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]));
  return {v[0] / l, v[1] / l, v[2] / l};
}
/// The axis of a cycle, and the two directions that complete it, as columns.
Matrix frame(const cl_R& alpha) {
  Matrix m = collisions(alpha, true, true);
  for (std::size_t i = 0; i < 3; ++i) m[i][i] = m[i][i] - 1;
  Vector axis = unit(cross(m[0], m[1]));
  if (axis[0] < 0) axis = {-axis[0], -axis[1], -axis[2]};
  const Vector first = unit(cross({exact(0), exact(0), exact(1)}, axis));
  const Vector second = cross(axis, first);
  Matrix out;
  for (std::size_t i = 0; i < 3; ++i) out.push_back({first[i], second[i], axis[i]});
  return out;
}
}  // namespace

cl_R exact(const cl_R& x) { return cln::cl_float(x, digits); }
cl_R circle() { return cln::pi(digits); }
const cl_R& tiny() {
  static const cl_R result = cln::expt(cl_R(10), -50);
  return result;
}
int whole(const cl_R& x) {
  const cl_R r = cln::round1(x);
  if (cln::abs(x - r) > tiny()) throw Undefined();
  return cln::cl_I_to_int(cln::round1(x));
}
cl_R acos(const cl_R& x) { return cln::realpart(cln::acos(x)); }

Matrix matrix_function(const std::string& f, const Vector& x) {
  if (f == "Gamma_A") return collisions(x[0], true, false);
  if (f == "Gamma_B") return collisions(x[0], false, true);
  if (f == "Lambda") return collisions(x[0], true, true);
  if (f == "R") return frame(x[0]);
  if (f == "lambda") return rotation(x[0], 0, 1, 2);
  if (f == "lambda_1") return rotation(x[0], 1, 2, 3);
  if (f == "lambda_2") return rotation(x[0], 2, 0, 3);
  if (f == "lambda_3") return rotation(x[0], 0, 1, 3);
  if (f == "P_2") return {{1, 0}, {0, -1}};
  if (f == "P_3") return {{1, 0, 0}, {0, 1, 0}, {0, 0, -1}};
  if (f == "mirror") {  // columns: a body of unit scaled speed and one at rest
    const cl_R s_1 = cln::realpart(cln::sqrt(exact(x[0]))),
               s_2 = cln::realpart(cln::sqrt(exact(x[1])));
    return {{after(1, 0, x[0], x[1]), s_1 * after(0, 1 / s_2, x[0], x[1])},
            {s_2 * after(0, 1 / s_1, x[1], x[0]), after(1, 0, x[1], x[0])}};
  }
  if (f == "Gamma") {
    const Matrix m = collisions(x[0], true, false);
    return {{m[0][0], m[0][2]}, {m[2][0], m[2][2]}};
  }
  if (f != "V_") throw std::runtime_error("no numbers for the matrix " + f);
  const cl_R root = cln::realpart(cln::sqrt(exact(x[0])));
  return {{function("a", x)}, {function("b", x)}, {root * function("c'", x)}};
}
cl_R function(const std::string& f, const Vector& x) {
  if (f == "theta") return acos(matrix_function("Gamma", x)[0][0]);
  if (f == "psi") {
    const Matrix m = matrix_function("Lambda", x);
    return acos((m[0][0] + m[1][1] + m[2][2] - 1) / 2);
  }
  const auto root = [](const cl_R& of) { return cln::realpart(cln::sqrt(exact(of))); };
  if (f == "U") return chebyshev(x[0], whole(x[1]));
  if (f == "U_last") return x[1] == 0 ? cl_R(0) : chebyshev(x[0], whole(x[1]) - 1);
  if (f == "r_A") return root(x[0] / (x[0] + x[1]));
  if (f == "r_B") return root(1 / (1 + x[0] * x[1]));
  if (f == "kappa" || f == "h_e" || f == "y_e") {
    // The second speed of a motion with V = 1 tells it.
    Trio t({x[0], x[1], x[2], x[3], 1});
    t.collide();
    const cl_R share_A = x[0] / (x[0] + x[2]), share_B = 1 / (1 + x[1] * x[2]);
    const cl_R kappa = t.approach() * root(share_B / share_A) / (2 * root(x[3]));
    if (f == "kappa") return kappa;
    if (f == "h_e" ? kappa >= 1 : kappa < 1) throw Undefined();
    return f == "h_e" ? acos(kappa) : kappa - root(kappa * kappa - 1);
  }
  if (f == "N_e") return trio_count(x);
  if (f == "v_A" || f == "v_B" || f == "v_C") return trio_at(x, false).v[std::size_t(f[2] - 'A')];
  if (f == "x_A" || f == "x_B" || f == "x_C")
    return trio_at(x, true).place[std::size_t(f[2] - 'A')];
  if (f == "time") return trio_at(x, true).time;
  if (f == "when" || f == "apart") {
    const Trio t = trio_at({1, 1, x[0], 1, x[1], x[2], x[3]}, true);
    return f == "when" ? t.time : t.place[1] - t.place[0];
  }
  if (f == "a_e" || f == "b_e" || f == "c_e" || f == "c_e'") {
    const cl_R collisions = 2 * x[3] - (f == "c_e" ? 1 : 0);
    const std::size_t body = std::size_t(f[0] - 'a');
    return trio_at({1, 1, x[0], x[2], x[1], collisions}, false).v[body];
  }
  if (f == "cradle_speed" || f == "cradle_count") {
    cl_R speed = x[0], count = 0;
    for (int i = 1; i <= x[1]; ++i) {
      const End end = end_of(threshold(true, i), speed, tiny());
      speed = end.last.b;
      count = count + end.N;
    }
    return f == "cradle_speed" ? speed : count;
  }
  if (f == "squares") {
    const cl_R kappa = function("kappa", {x[0], x[1], x[2], x[3]});
    cl_R sum = 0;
    for (int i = 0; i < x[4]; ++i) {
      const cl_R u = chebyshev(kappa, i);
      sum = sum + cln::expt(exact(x[3]), i) * u * u;
    }
    return sum;
  }
  if (f == "closing") return trio_at(x, false).approach();
  if (f == "before" || f == "after" || f.ends_with("_next")) {
    Trio t = trio_at({x[0], x[1], x[2], x[3], x[4], x[6]}, false);
    if (f == "before") return t.approach();
    t.collide();
    return f == "after" ? t.approach() : t.v[std::size_t(f[0] - 'A')];
  }
  if (f == "moment" || f == "place" || f == "blocks") {
    const Trio t = trio_at(x, true);
    return f == "moment" ? t.time : f == "place" ? t.place[2] : t.place[1] - t.place[0];
  }
  if (f == "turn") return whole(x[0]) % 2 == 0 ? 1 : -1;
  if (f == "alpha_") return threshold(true, whole(x[0]));
  if (f == "beta_") return threshold(false, whole(x[0]));
  if (f == "V_CM") return x[1] / (2 + x[0]);
  if (f == "A" || f == "B" || f == "C" || f == "approach") {
    const State s = after_collisions(x[0], x[1], whole(x[2]));
    return f == "A" ? s.a : f == "B" ? s.b : f == "C" ? s.c : s.approach();
  }
  if (f == "a") return function("A", {x[0], x[1], 2 * x[2]});
  if (f == "b") return function("B", {x[0], x[1], 2 * x[2]});
  if (f == "c'") return function("C", {x[0], x[1], 2 * x[2]});
  if (f == "c") return x[2] == 0 ? exact(0) : function("C", {x[0], x[1], 2 * x[2] - 1});
  const End e = end_of(x[0], x[1], tiny());
  if (f == "N") return e.N;
  if (f == "N_A") return e.N_A;
  if (f == "N_B") return e.N - e.N_A;
  if (f == "a_t") return e.last.a;
  if (f == "b_t") return e.last.b;
  if (f == "c_t") return e.last.c;
  throw std::runtime_error("no number for " + f);
}
}  // namespace net
