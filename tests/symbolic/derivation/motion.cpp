// Numbers from the law of one collision alone: a body is reflected at the velocity of the common
// centre of mass. Nothing here is read from the book.
#include "motion.hpp"

#include <map>

#include <cln/integer.h>

#include "law_of_collision.hpp"

namespace net {
namespace {
const cln::float_format_t digits = cln::float_format(80);

using Vector = std::vector<cl_R>;
using Trio = law::ThreeBodies<cl_R>;

cl_R acos(const cl_R& x) { return cln::realpart(cln::acos(x)); }
cl_R root(const cl_R& x) { return cln::realpart(cln::sqrt(exact(x))); }
/// x holds M_A, 1/M_B or 0 for a wall, M_C, e, V, and perhaps W, d_A and d_B: B is at 0, at rest.
bool has_places(const Vector& x) { return x.size() > 7; }
Trio start(const Vector& x) {
  if (x[0] <= 0 || x[1] < 0 || x[2] <= 0) throw Undefined();
  const cl_R W = x.size() > 5 ? x[5] : 0;
  Trio t{x[0], x[1], x[2], x[3], {exact(x[4] + W), exact(0), exact(W)}, {}};
  if (has_places(x)) t.place = {-x[6] - x[7], exact(0), -x[7]};
  return t;
}
void wait(Trio& t) {
  if (cln::abs(t.approach()) < tiny()) throw Undefined();
  t.wait();
}
const Trio& seen(const Trio& t) {
  if (cln::expt(exact(t.e), t.N) < tiny()) throw Unseen();
  return t;
}
Trio after(const Vector& x, int collisions) {
  if (collisions < 0) throw Undefined();
  Trio t = start(x);
  while (t.N < collisions) {
    if (has_places(x)) wait(t);
    t.collide();
  }
  return seen(t);
}
/// At collision j, before it: x holds V, perhaps L, and j; A comes to C at 0, at time 0.
Trio trio_at(const Vector& x) {
  Vector from(x.begin(), x.begin() + 5);
  if (x.size() == 6) return after(from, whole(x[5]));
  from.insert(from.end(), {0, 0, x[5]});
  Trio t = after(from, whole(x[6]));
  wait(t);
  for (cl_R& place : t.place) place = place + x[5];
  return t;
}
/// How many collisions there are, where they end soon.
int count_of(const Vector& x, const cl_R& still) {
  Trio t = start(x);
  while (t.approach() > still) {
    if (t.N == 10000) throw Undefined();
    t.collide();
    // Seen from the ball, unless there is a wall, and by a unit that shrinks as speeds do.
    const cl_R centre = t.per_B == 0 ? cl_R(0) : t.v[2], unit = root(t.e);
    for (cl_R& v : t.v) v = (v - centre) / unit;
  }
  return seen(t).N;
}
/// Two equal blocks that lose nothing, after their last collision.
Trio end_of(const cl_R& alpha, const cl_R& V) {
  const Vector x{1, 1, alpha, 1, V};
  return after(x, count_of(x, tiny()));
}
/// The least alpha with a count of at most k, by halving.
cl_R threshold(bool of_A, int k) {
  if (k < 1) throw Undefined();
  static std::map<std::pair<bool, int>, cl_R> known;
  if (const auto it = known.find({of_A, k}); it != known.end()) return it->second;
  cl_R lo = exact(0), hi = exact(1) + exact(1) / 1000;
  for (int i = 0; i < 230; ++i) {
    const cl_R middle = (lo + hi) / 2;
    const int N = count_of({1, 1, middle, 1, 1}, 0);
    ((of_A ? N + 1 : N) / 2 <= k ? hi : lo) = middle;
  }
  return known[{of_A, k}] = hi;
}
/// Chebyshev's U_j by its sum of powers.
cl_R chebyshev(const cl_R& x, int j) {
  cl_R sum = 0;
  for (int k = 0; 2 * k <= j; ++k)
    sum = sum + (k % 2 == 0 ? 1 : -1) * binomial(j - k, k) * cln::expt(exact(2 * x), j - 2 * k);
  return sum;
}
/// The columns of a collision or of a whole cycle, of velocities by the roots of the masses.
Matrix collisions(const cl_R& M_A, const cl_R& ball, bool with_A, bool with_B) {
  const cl_R scale[]{root(M_A), 1, root(ball)};
  Matrix m(3, 3);
  for (int col = 0; col < 3; ++col) {
    Trio t = start({M_A, 1, ball, 1, 0});
    t.v[std::size_t(col)] = 1 / scale[col];
    if (with_A) t.collide();
    t.N = 1;
    if (with_B) t.collide();
    for (int row = 0; row < 3; ++row) m(row, col) = t.v[std::size_t(row)] * scale[row];
  }
  return m;
}
Matrix rotation(const cl_R& angle, int i, int j, int size) {
  Matrix m = Matrix::Identity(size, size);
  m(i, i) = m(j, j) = cln::cos(exact(angle));
  m(j, i) = cln::sin(exact(angle));
  m(i, j) = -m(j, i);
  return m;
}
using Direction = Eigen::Matrix<cl_R, 3, 1>;
Direction unit(const Direction& v) { return v / root(v.dot(v)); }
/// The axis of a cycle, and the two directions that complete it, as columns.
Matrix frame(const cl_R& alpha) {
  const Matrix m = collisions(1, alpha, true, true) - Matrix::Identity(3, 3);
  const Direction p = m.row(0), q = m.row(1);
  Direction axis = unit(p.cross(q));
  if (axis[0] < 0) axis = -axis;
  const Direction first = unit(Direction(0, 0, 1).cross(axis));
  Matrix out(3, 3);
  out << first, axis.cross(first), axis;
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
  if (cln::abs(x - cln::round1(x)) > tiny()) throw Undefined();
  return cln::cl_I_to_int(cln::round1(x));
}

cl_R binomial(const cl_R& n, int k) {
  cl_R out = exact(1);
  for (int i = 0; i < k; ++i) out = out * (n - i) / (i + 1);
  return out;
}
Matrix matrix_function(const std::string& f, const Vector& x) {
  if (f == "Gamma_A") return collisions(1, x[0], true, false);
  if (f == "Gamma_B") return collisions(1, x[0], false, true);
  if (f == "Lambda") return collisions(1, x[0], true, true);
  if (f == "R") return frame(x[0]);
  if (f == "lambda") return rotation(x[0], 0, 1, 2);
  if (f == "lambda_1") return rotation(x[0], 1, 2, 3);
  if (f == "lambda_2") return rotation(x[0], 2, 0, 3);
  if (f == "lambda_3") return rotation(x[0], 0, 1, 3);
  if (f == "X") {  // the cofactors of O - 1: normals of its rows
    const Direction a(x[0] - 1, x[1], x[2]), b(x[3], x[4] - 1, x[5]), c(x[6], x[7], x[8] - 1);
    Matrix out(3, 3);
    out << b.cross(c), c.cross(a), a.cross(b);
    return out;
  }
  if (f == "P_2") return Matrix{{1, 0}, {0, -1}};
  if (f == "P_3") return Matrix{{1, 0, 0}, {0, 1, 0}, {0, 0, -1}};
  if (f == "Gamma") return matrix_function("mirror", {1, x[0]});
  if (f == "mirror") {
    const Matrix m = collisions(x[0], x[1], true, false);
    return Matrix{{m(0, 0), m(0, 2)}, {m(2, 0), m(2, 2)}};
  }
  if (f != "V_") return {};
  return Direction(function("a", x), function("b", x), root(x[0]) * function("c'", x));
}
cl_R function(const std::string& f, const Vector& x) {
  if (f == "theta") return acos(matrix_function("Gamma", x)(0, 0));
  if (f == "psi") return acos((matrix_function("Lambda", x).trace() - 1) / 2);
  if (f == "U" || f == "U_last") return chebyshev(x[0], whole(x[1]) - (f == "U" ? 0 : 1));
  if (f == "r_A") return root(x[0] / (x[0] + x[1]));
  if (f == "r_B") return root(1 / (1 + x[0] * x[1]));
  if (f == "kappa") {  // the second speed of a motion with V = 1 tells it
    const cl_R speed = after({x[0], x[1], x[2], x[3], 1}, 1).approach();
    const cl_R r_A = function("r_A", {x[0], x[2]}), r_B = function("r_B", {x[1], x[2]});
    return speed * r_B / (2 * r_A * root(x[3]));
  }
  if (f == "h_e" || f == "y_e") {
    const cl_R kappa = function("kappa", x);
    if (f == "y_e" && cln::abs(kappa - 1) < tiny()) return exact(1);
    if (f == "h_e" ? kappa >= 1 : kappa < 1) throw Undefined();
    return f == "h_e" ? acos(kappa) : kappa - root(kappa * kappa - 1);
  }
  if (f == "N_e" || f == "N_any") return count_of(x, tiny());
  if (f.starts_with("place_")) {
    const Trio t = after(x, whole(x[9]));
    const std::size_t body = std::size_t(f[6] - 'A');
    return t.place[body] + t.v[body] * (x[8] - t.time);
  }
  if (f == "nearing") return after(x, whole(x[6])).approach();
  if (f.starts_with("any_")) return after(x, whole(x[6])).v[std::size_t(f[4] - 'A')];
  if (f == "instant" || f == "moment") return after(x, whole(x[8]) + 1).time;
  if (f == "before" || f == "after") {
    const cl_R A = x[4] * x[8] - x[6], B = x[5] * x[8] - x[7], later = f == "before" ? 0 : 1;
    return function("nearing", {x[0], x[1], x[2], x[3], A, B, x[9] + later});
  }
  if (f.ends_with("_at")) {
    Vector next = x;
    next[9] = x[9] + 1;
    return function(std::string("place_") + f[0], next);
  }
  if (f.starts_with("v_")) return trio_at(x).v[std::size_t(f[2] - 'A')];
  if (f.starts_with("x_")) return trio_at(x).place[std::size_t(f[2] - 'A')];
  if (f == "time") return trio_at(x).time;
  if (f == "closing") return trio_at(x).approach();
  if (f == "when" || f == "apart") {
    const Trio t = trio_at({1, 1, x[0], 1, x[1], x[2], x[3]});
    return f == "when" ? t.time : t.place[1] - t.place[0];
  }
  if (f == "a_e" || f == "b_e" || f == "c_e" || f == "c_e'") {
    const cl_R collisions = 2 * x[3] - (f == "c_e" ? 1 : 0);
    return trio_at({1, 1, x[0], x[2], x[1], collisions}).v[std::size_t(f[0] - 'a')];
  }
  if (f == "cradle_speed" || f == "cradle_count") {
    cl_R speed = x[0], count = 0;
    for (int i = 1; i <= x[1]; ++i) {
      const Trio end = end_of(threshold(true, i), speed);
      speed = end.v[1];
      count = count + end.N;
    }
    return f == "cradle_speed" ? speed : count;
  }
  if (f == "squares") {
    const cl_R kappa = function("kappa", {x[0], x[1], x[2], x[3]});
    const cl_R r_A = function("r_A", {x[0], x[2]}), r_B = function("r_B", {x[1], x[2]});
    cl_R sum = 0;
    for (int i = 0; i < x[6]; ++i) {
      const cl_R of_B = r_B / (r_A * root(x[3])) * chebyshev(kappa, i - 1);
      const cl_R u = x[4] * chebyshev(kappa, i) + x[5] * of_B;
      sum = sum + cln::expt(exact(x[3]), i) * u * u;
    }
    return sum;
  }
  if (f == "turn") return whole(x[0]) % 2 == 0 ? 1 : -1;
  if (f == "alpha_") return threshold(true, whole(x[0]));
  if (f == "beta_") return threshold(false, whole(x[0]));
  if (f == "V_CM") return x[1] / (2 + x[0]);
  if (f == "A" || f == "B" || f == "C" || f == "approach")
    return function(f == "approach" ? "closing" : "v_" + f, {1, 1, x[0], 1, x[1], x[2]});
  if (f == "c" && x[2] == 0) return exact(0);
  if (f == "a" || f == "b" || f == "c" || f == "c'")
    return function(f.substr(0, 1) + "_e" + f.substr(1), {x[0], x[1], 1, x[2]});
  const Trio end = end_of(x[0], x[1]);
  if (f == "N") return end.N;
  if (f == "N_A") return (end.N + 1) / 2;
  if (f == "N_B") return end.N / 2;
  if (f.ends_with("_t")) return end.v[std::size_t(f[0] - 'a')];
  throw std::runtime_error("no number for " + f);
}
}  // namespace net
