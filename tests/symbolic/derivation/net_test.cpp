// Each theorem of the book at random points; false statements are seen; the paper's labels.
#include <algorithm>
#include <random>

#include "derivation/book.hpp"
#include "motion.hpp"
#include "notation/typed.hpp"
#include "rows.hpp"

namespace {
using namespace net;
using derivation::the_book;
using kernel::Expr;
using kernel::Exprs;
using kernel::Op;
using Point = std::map<Expr, cl_R>;  ///< values of variables
cl_R value(Expr term, const Point& point);

/// A name that the book makes for evaluation alone, such as plus_n, is what its definition says.
Expr defined(Expr e) {
  static std::map<std::string, Expr> definitions;
  if (definitions.empty())
    for (const auto& chapter : the_book().chapters())
      for (const auto& s : chapter.statements)
        if (const std::size_t at = s.id.find(".def_"); at != std::string::npos)
          definitions.emplace(s.id.substr(at + 5), s.theorem.conclusion());
  const Expr is = definitions[e.name()];
  return is ? substitute(is.arg(1), is.arg(0).args(), e.args()) : is;
}
cl_R of_function(Expr e, const std::vector<cl_R>& x) {
  const std::string f = e.name();
  const auto rounded_up = [](const cl_R& y) {
    const cl_R r = cln::round1(y);
    return cln::abs(y - r) < tiny() ? r : cl_R(cln::ceiling1(y));
  };
  const auto over = [](const cl_R& above, const cl_R& below) -> cl_R {
    if (cln::abs(below) < tiny()) throw Undefined();
    return above / below;
  };
  if (f == "inv") return over(1, x[0]);
  if (f == "sqrt") {
    if (x[0] < -tiny()) throw Undefined();
    return x[0] < tiny() ? exact(0) : cln::realpart(cln::sqrt(exact(x[0])));
  }
  if (f == "sin") return cln::sin(exact(x[0]));
  if (f == "cos") return cln::cos(exact(x[0]));
  if (f == "atan") return cln::atan(exact(x[0]));
  if (f == "pi") return circle();
  if (f == "ceil") return rounded_up(x[0]);
  if (f == "floor") return -rounded_up(-x[0]);
  if (f == "sawtooth") return x[0] + rounded_up(-x[0]);
  if (f == "pow") return cln::expt(exact(x[0]), whole(x[1]));
  if (f == "choose") return binomial(x[0], whole(x[1]));
  if (f == "cos_sum" || f == "sin_sum") {
    cl_R sum = exact(0);
    for (int j = 0; j <= x[2]; ++j) {
      const int s = f == "cos_sum" ? 2 * j : 2 * j + 1;
      const int rest = whole(x[1]) - s;
      if (rest < 0) throw Undefined();
      const cl_R powers =
          cln::expt(cln::sin(exact(x[0])), s) * cln::expt(cln::cos(exact(x[0])), rest);
      sum = sum + (j % 2 == 0 ? 1 : -1) * binomial(x[1], s) * powers;
    }
    return sum;
  }
  if (f == "tan") return over(cln::sin(exact(x[0])), cln::cos(exact(x[0])));
  return function(f, x);
}
std::vector<cl_R> values(Expr e, const Point& point) {
  std::vector<cl_R> out;
  for (const Expr& a : e.args()) out.push_back(value(a, point));
  return out;
}
Matrix matrix_value(Expr e, const Point& point) {
  const auto part = [&](std::size_t i) { return matrix_value(e.arg(i), point); };
  if (e.op() == Op::Matrix) {
    const std::vector<cl_R> entries = values(e, point);
    return Eigen::Map<const Matrix>(entries.data(), e.rows(), e.cols());
  }
  if (e.op() == Op::Transpose) return part(0).transpose();
  if (e.op() == Op::Times) {
    Matrix out = part(0);
    for (std::size_t i = 1; i < e.size(); ++i) out = out * part(i);
    return out;
  }
  if (e.op() != Op::MatrixPower) {
    const Matrix known = matrix_function(e.name(), values(e, point));
    return known.size() == 0 ? matrix_value(defined(e), point) : known;
  }
  const cl_R n = value(e.arg(1), point);
  if (n < 0) throw Undefined();
  const Matrix m = part(0);
  Matrix out = Matrix::Identity(e.rows(), e.cols());
  for (int i = 0; i < n; ++i) out = m * out;
  return out;
}
int sign(const cl_R& l, const cl_R& r) {
  const cl_R d = l - r;
  if (cln::abs(d) < tiny() * (1 + cln::abs(l) + cln::abs(r))) return 0;
  return d < 0 ? -1 : 1;
}
bool same(Expr l, Expr r, const Point& point) {
  if (!kernel::is_matrix(l)) return sign(value(l, point), value(r, point)) == 0;
  const Matrix a = matrix_value(l, point), b = matrix_value(r, point);
  for (int i = 0; i < a.size(); ++i)
    if (sign(a.data()[i], b.data()[i]) != 0) return false;
  return true;
}

std::mt19937_64 engine(12345);
int any_of(int count) { return int(engine() % std::uint64_t(count)); }
cl_R between(double lo, double hi) {
  const cl_R share = exact(cl_R(any_of(1 << 30))) / exact(cl_R(1 << 30));
  return exact(cl_R(lo)) + share * exact(cl_R(hi - lo));
}
/// Of an impact with restitution: e, masses, velocities before and after. A contact loses nothing;
/// what rebounds from a wall has no mass beside it.
std::vector<cl_R> of_impact(Expr law, const Point& point) {
  std::vector<cl_R> x = values(law, point);
  if (law.name() == "contact") x.insert(x.begin(), 1);
  if (law.name() == "rebound") x.insert(x.begin() + 1, {0, 1});
  return x;
}

cl_R value(Expr e, const Point& point) {
  const Op op = e.op();
  if (op == Op::Num) return e.value();
  if (op == Op::Var) return point.at(e);
  if (op == Op::Pow) return cln::expt(value(e.arg(0), point), e.exponent());
  if (op == Op::Det) {
    const Matrix m = matrix_value(e.arg(0), point);
    return m.rows() == 3 ? m.topLeftCorner<3, 3>().determinant()
                         : m.topLeftCorner<2, 2>().determinant();
  }
  if (op == Op::Entry) return matrix_value(e.arg(0), point).data()[e.index()];
  if (op == Op::Add || op == Op::Mul) {
    cl_R out = exact(op == Op::Mul ? 1 : 0);
    for (const cl_R& x : values(e, point)) out = op == Op::Mul ? out * x : out + x;
    return out;
  }
  const Expr definition = defined(e);
  return definition ? value(definition, point) : of_function(e, values(e, point));
}
bool truth(Expr f, const Point& point) {
  const Op op = f.op();
  const Exprs parts = f.args();
  const auto holds = [&](Expr g) { return truth(g, point); };
  const auto order = [&] { return sign(value(parts[0], point), value(parts[1], point)); };
  if (op == Op::Eq) return same(parts[0], parts[1], point);
  if (op == Op::Lt) return order() < 0;
  if (op == Op::Le) return order() <= 0;
  if (op == Op::Not) return !holds(parts[0]);
  if (op == Op::And) return std::all_of(parts.begin(), parts.end(), holds);
  if (op == Op::Or) return std::any_of(parts.begin(), parts.end(), holds);
  if (op == Op::Imp) return !holds(parts[0]) || holds(parts[1]);
  if (op == Op::Iff) return holds(parts[0]) == holds(parts[1]);
  if (op == Op::All) {  // at a value that the point has, or some; so many of an index that
    // collisions have ended by then
    for (const auto& [v, x] : point)
      if (v.name() == f.name() && v.sort() == f.bound_sort()) return holds(kernel::open(f, v));
    const int last = f.bound_sort() == kernel::Sort::Int ? 60 : 12;
    for (int x = -2; x <= last; ++x)
      if (!holds(kernel::open(f, x))) return false;
    return true;
  }
  if (f.name() == "takes_place") {
    for (int i = 0; i <= value(parts[2], point); ++i)
      if (!holds(kernel::lt(0, kernel::fun("approach", {parts[0], parts[1], i})))) return false;
    return true;
  }
  const std::vector<cl_R> x = of_impact(f, point);
  const cl_R before = x[1] * x[3] + x[2] * x[4], after = x[1] * x[5] + x[2] * x[6];
  return sign(before, after) == 0 && sign(x[6] - x[5], x[0] * (x[3] - x[4])) == 0 &&
         (f.name() != "contact" || sign(x[3], x[5]) != 0);
}

/// The hypotheses are asked for there: variables at random, equations solved.
Point random_point(const Exprs& hypotheses, Expr conclusion) {
  std::set<Expr> variables = free_variables(conclusion);
  for (const Expr& h : hypotheses) variables.merge(free_variables(h));
  Point point;
  // A rotation by an angle in a frame, perhaps after a reflection; that of the plane in its own.
  const auto has = [&](const char* name) { return variables.count(kernel::real(name)) != 0; };
  const bool in_plane = has("o_22") && !has("o_33");
  Matrix r = matrix_function(any_of(2) ? "P_3" : "lambda_3", {exact(0)});
  for (const char* axis : {"lambda_1", "lambda_2"})
    r = r * matrix_function(axis, {in_plane ? exact(0) : between(-3, 3)});
  const cl_R angle = cl_R(any_of(4)) * (any_of(4) ? between(-1, 1) : circle());
  Matrix o = r * matrix_function("lambda_3", {angle}) * r.transpose();
  if (!has("r_33") && any_of(2))
    o = o * (in_plane ? matrix_function("lambda_1", {circle()}) : matrix_function("P_3", {}));
  for (int i = 0; i < 9 && has("o_33"); ++i)  // that there are a frame and an angle
    point[kernel::real("r_" + std::to_string(i / 3 + 1) + std::to_string(i % 3 + 1))] =
        r(i / 3, i % 3);
  if (has("o_33")) point[kernel::real("phi")] = angle;
  const std::map<char, Matrix> of{{'o', o}, {'r', r}, {'m', r.transpose() * o * r}};
  cl_R last = exact(1);
  const auto drawn = [&](Expr v) -> cl_R {
    const std::string name = v.name();
    const int kind = any_of(8);
    if (v.sort() == kernel::Sort::Int) return any_of(12) - (name == "k" ? 0 : 1);
    if (name.size() == 4 && of.count(name[0])) return of.at(name[0])(name[2] - '1', name[3] - '1');
    if (name == "alpha" && kind < 2)
      return function(kind == 0 ? "alpha_" : "beta_", {1 + any_of(8)});
    if (name == "alpha") return cln::exp(between(-4, 2.5));
    if (name == "w_B" && kind < 2) return 0;
    if (name[0] == 'M' || name == "w_B") return between(0.1, 4);
    if (name[0] == 'e') return kind < 4 ? between(0.01, 0.1) : between(0.1, 1.2);
    if (kind == 0) return circle() * (any_of(9) - 2) / 2;
    if (kind == 1) return cl_R(any_of(8) - 1) / (1 + any_of(3));
    return kind == 2 ? last : between(-2.5, 5.5);
  };
  for (const Expr& v : variables) last = point[v] = drawn(v);
  if (has("d_A") && point[kernel::real("V")] == 0) throw Undefined();
  for (const Expr& h : hypotheses) {
    if (h.op() == Op::Fun) {
      const std::vector<cl_R> x = of_impact(h, point);
      const cl_R centre = (x[1] * x[3] + x[2] * x[4]) / (x[1] + x[2]);
      point[h.arg(h.size() - 2)] = (1 + x[0]) * centre - x[0] * x[3];
      point[h.arg(h.size() - 1)] = (1 + x[0]) * centre - x[0] * x[4];
    }
    if (h.op() == Op::Eq && h.arg(0).op() == Op::Fun && h.arg(0).name() == "q_e") {
      const std::vector<cl_R> x = values(h.arg(0), point);
      const cl_R of_B = 4 * x[3] * (1 + x[1] * x[2]);
      point[h.arg(0).arg(0)] = of_B * x[2] / ((1 + x[3]) * (1 + x[3]) - of_B);
    }
    if (h.op() == Op::Eq && h.arg(0).op() == Op::Fun && h.arg(0).name() == "room_e") {
      const std::vector<cl_R> x = values(h.arg(0), point);
      point[h.arg(0).arg(1)] = (cln::square(1 - x[2]) / (4 * x[2] * x[0]) - 1) / (1 + x[0]);
    }
    if (h.op() == Op::Eq && h.arg(0).op() == Op::Var && !free_variables(h.arg(1)).count(h.arg(0)))
      point[h.arg(0)] =
          h.arg(0).name().starts_with("o_") ? point[h.arg(0)] : value(h.arg(1), point);
  }
  return point;
}
struct Tried {
  int points = 0;        // that satisfy the hypotheses
  std::string false_at;  // the first at which the conclusion is false or has no value; or empty
};
Tried tried(const Exprs& hypotheses, Expr conclusion, int wanted) {
  Tried out;
  constexpr int most_tries = 8000;
  for (int i = 0; i < most_tries && out.points < wanted; ++i) {
    Point point;
    try {
      point = random_point(hypotheses, conclusion);
      if (!std::ranges::all_of(hypotheses, [&](Expr h) { return truth(h, point); })) continue;
    } catch (const Undefined&) {
      continue;
    }
    ++out.points;
    try {
      if (truth(conclusion, point)) {
        if (point.empty()) break;
        continue;
      }
    } catch (const Unseen&) {
      --out.points;
      continue;
    } catch (const Undefined&) {
      out.false_at = "no value ";
    }
    std::ostringstream words;
    for (const auto& [v, x] : point) words << v.name() << " = " << cln::double_approx(x) << " ";
    out.false_at += "at " + words.str();
    break;
  }
  return out;
}
}  // namespace

TEST_CASE("each theorem is true at random points that satisfy its hypotheses") {
  for (const auto& chapter : the_book().chapters())
    for (const auto& s : chapter.statements) {
      INFO(s.id << ": " << kernel::text(s.theorem));
      const Tried t = tried(s.theorem.hypotheses(), s.theorem.conclusion(), 100);
      CHECK(t.false_at == "");
      CHECK(t.points >= (kernel::free_variables(s.theorem.conclusion()).empty() ? 1 : 100));
    }
}

TEST_CASE("each axiom is true at random points, and none of these is") {
  for (const std::string& name : kernel::axiom_names()) {
    INFO(name);
    CHECK(tried({}, kernel::axiom(name).conclusion(), 1000).false_at == "");
  }
  for (const auto& row : rows_of("symbolic/derivation/no_axioms.tsv", 1)) {
    INFO(row[0]);
    CHECK_FALSE(tried({}, notation::read(row[0]), 4000).false_at.empty());
  }
}

TEST_CASE("false statements are seen") {
  for (const auto& row : rows_of("symbolic/derivation/false.tsv", 3, 81)) {
    const kernel::Theorem theorem = the_book()[row[0]];
    std::string words = kernel::text(theorem.conclusion());
    const std::size_t at = words.find(row[1]);
    INFO(row[0] << ": " << row[2] << " in " << words);
    REQUIRE(at != std::string::npos);
    words.replace(at, row[1].size(), row[2]);
    CHECK_FALSE(tried(theorem.hypotheses(), notation::read(words), 400).false_at.empty());
  }
}

TEST_CASE("hypotheses that nothing satisfies are seen") {
  const kernel::Expr alpha = kernel::real("alpha");
  CHECK(tried({kernel::lt(alpha, 0), kernel::lt(0, alpha)}, kernel::eq(alpha, 1), 20).points == 0);
}

TEST_CASE("each label of the paper has a statement, and no statement has another") {
  std::set<std::string> paper, claimed;
  for (const auto& row : rows_of("symbolic/derivation/labels.tsv", 1)) paper.insert(row[0]);
  for (const auto& chapter : the_book().chapters())
    for (const auto& s : chapter.statements) {
      std::istringstream labels(s.label);
      for (std::string label; labels >> label;) claimed.insert(label);
    }
  CHECK(claimed == paper);
  CHECK(paper.size() == 68);
}
