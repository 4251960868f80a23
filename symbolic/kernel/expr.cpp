// The table of all trees, and make(), which checks each before it enters.
#include "kernel/expr.hpp"

#include <algorithm>
#include <deque>
#include <unordered_map>

#include "kernel/names.hpp"

namespace kernel {
void refuse(const std::string& why) { throw Refused(why); }

namespace {
constexpr int max_depth = 1000;
constexpr int max_rows = 8;
constexpr std::uint64_t max_weight = std::uint64_t(1) << 62;

struct Node {
  Parts parts;
  Sort sort = Sort::Bool;
  int rows = 0;
  int cols = 0;
  std::map<int, Sort> loose = {};  // bound indices that lead out of the tree, with their sorts
  int depth = 0;
  std::uint64_t weight = 1;
};
std::deque<Node>& nodes() {
  static std::deque<Node> table(1);  // place 0 is no tree
  return table;
}
const Node& at(std::size_t place) {
  if (place == 0) refuse("an Expr that was never given a value");
  return nodes()[place];
}
std::size_t hash(const Parts& p) {
  std::size_t h = cln::equal_hashcode(p.value);
  const auto mix = [&h](std::size_t x) { h = (h ^ x) * 0x9E3779B97F4A7C15u + (h >> 29); };
  mix(std::size_t(p.op));
  mix(std::size_t(p.variable));
  mix(std::size_t(p.exponent));
  mix(std::size_t(p.index));
  mix(std::size_t(p.cols));
  if (p.op != Op::All) mix(std::hash<std::string>()(p.name));
  for (Expr a : p.args) mix(a.id());
  return h;
}
// What an All calls its variable is not part of its identity.
bool equal(const Parts& a, const Parts& b) {
  return a.op == b.op && a.variable == b.variable && a.exponent == b.exponent &&
         a.index == b.index && a.cols == b.cols && a.args == b.args && a.value == b.value &&
         (a.op == Op::All || a.name == b.name);
}

// How many arguments of which kind (Real: numbers) an operation takes, and what it gives.
struct Form {
  std::size_t least, most;
  Sort takes, gives;
};
const Form& form(Op op) {
  using enum Sort;
  static constexpr Form forms[] = {
      {0, 0, Real, Real},           // Num
      {0, 0, Real, Real},           // Var
      {0, 0, Real, Real},           // Bound
      {0, SIZE_MAX, Real, Real},    // Fun
      {1, SIZE_MAX, Real, Int},     // Add
      {1, SIZE_MAX, Real, Int},     // Mul
      {1, 1, Real, Int},            // Pow
      {2, 2, Real, Bool},           // Eq
      {2, 2, Real, Bool},           // Lt
      {2, 2, Real, Bool},           // Le
      {1, 1, Bool, Bool},           // Not
      {1, SIZE_MAX, Bool, Bool},    // And
      {1, SIZE_MAX, Bool, Bool},    // Or
      {2, 2, Bool, Bool},           // Imp
      {2, 2, Bool, Bool},           // Iff
      {1, 1, Bool, Bool},           // All
      {1, SIZE_MAX, Real, Matrix},  // Matrix
      {2, 2, Matrix, Matrix},       // Times
      {1, 1, Matrix, Matrix},       // Transpose
      {2, 2, Matrix, Matrix},       // MatrixPower
      {1, 1, Matrix, Real},         // Entry
      {1, 1, Matrix, Real},         // Det
  };
  if (std::size_t(op) >= std::size(forms)) refuse("no such operation");
  return forms[std::size_t(op)];
}
Sort kind(Expr e) { return e.sort() == Sort::Int ? Sort::Real : e.sort(); }
Sort needed(const Parts& p, std::size_t i) {
  if (p.op == Op::MatrixPower && i == 1) return Sort::Real;
  return p.op == Op::Eq && kind(p.args[0]) == Sort::Matrix ? Sort::Matrix : form(p.op).takes;
}
void check_arguments(const Parts& p) {
  static const std::map<Sort, std::string> words = {
      {Sort::Real, "number"}, {Sort::Bool, "formula"}, {Sort::Matrix, "matrix"}};
  const std::size_t count = p.args.size();
  if (count < form(p.op).least || count > form(p.op).most)
    refuse("an operation with " + std::to_string(count) + " arguments");
  for (std::size_t i = 0; i < count; ++i)
    if (kind(p.args[i]) != needed(p, i))
      refuse("a " + words.at(kind(p.args[i])) + " stands where a " + words.at(needed(p, i)) +
             " is needed: " + brief(p.args[i]));
}
Node function(const Parts& p) {
  const Signature* s = signature(p.name);
  if (!s) refuse("no function " + p.name);
  if (s->args.size() != p.args.size()) refuse(p.name + " has another number of arguments");
  for (std::size_t i = 0; i < p.args.size(); ++i)
    if (s->args[i] == Sort::Int && p.args[i].sort() != Sort::Int)
      refuse(p.name + " needs an integer, not " + brief(p.args[i]));
  return Node{p, s->result, s->rows, s->cols};
}
Node shaped(const Parts& p, int rows, int cols) {
  if (rows > max_rows || cols > max_rows) refuse("a matrix of more than 8 rows or columns");
  return Node{p, Sort::Matrix, rows, cols};
}
Node matrix_node(const Parts& p) {
  const Expr a = p.args[0];
  const int count = int(std::min<std::size_t>(p.args.size(), 1000));
  switch (p.op) {
    case Op::Matrix:
      if (p.cols < 1 || count % p.cols != 0) refuse("a matrix has whole rows");
      return shaped(p, count / p.cols, p.cols);
    case Op::Times:
      if (a.cols() != p.args[1].rows()) refuse("matrices that do not fit");
      return shaped(p, a.rows(), p.args[1].cols());
    case Op::Transpose:
      return shaped(p, a.cols(), a.rows());
    case Op::MatrixPower:
      if (p.args[1].sort() != Sort::Int) refuse("a power of a matrix needs an integer");
      if (a.rows() != a.cols()) refuse("only a square matrix has powers");
      return shaped(p, a.rows(), a.cols());
    case Op::Entry:
      if (a.op() != Op::Fun && a.op() != Op::MatrixPower) refuse("an entry that entry() computes");
      if (p.index < 0 || p.index >= a.rows() * a.cols()) refuse("no such entry");
      return Node{p, Sort::Real};
    default:
      if (a.rows() != a.cols()) refuse("only a square matrix has a determinant");
      return Node{p, Sort::Real};
  }
}
// Sort and shape, for every operation.
Node checked(const Parts& p) {
  check_arguments(p);
  const bool real = std::ranges::any_of(p.args, [](Expr a) { return a.sort() == Sort::Real; });
  switch (p.op) {
    case Op::Num:
      return Node{p, cln::denominator(p.value) == 1 ? Sort::Int : Sort::Real};
    case Op::Var:
      declare_variable(p.name, p.variable);
      return Node{p, p.variable};
    case Op::Bound:
    case Op::All:
      if (p.index < 0 || p.index > max_depth) refuse("no such bound index");
      if (p.variable != Sort::Real && p.variable != Sort::Int) refuse("a bound number is needed");
      return Node{p, p.op == Op::All ? Sort::Bool : p.variable};
    case Op::Fun:
      return function(p);
    case Op::Pow:
      if (p.exponent < 1) refuse("an exponent below 1");
      if (p.exponent > max_exponent) refuse("an exponent above 1000000");
      break;
    case Op::Eq:
      if (p.args[0].rows() != p.args[1].rows() || p.args[0].cols() != p.args[1].cols())
        refuse("matrices of two shapes are not equal");
      break;
    default:
      break;
  }
  if (form(p.op).takes == Sort::Matrix || p.op == Op::Matrix) return matrix_node(p);
  return Node{p, real && form(p.op).gives == Sort::Int ? Sort::Real : form(p.op).gives};
}
// Loose indices, depth and weight, from the arguments'.
void measure(Node& n) {
  const Parts& p = n.parts;
  const int binds = p.op == Op::All ? 1 : 0;
  if (p.op == Op::Bound) n.loose = {{p.index, p.variable}};
  for (Expr a : p.args) {
    const Node& node = at(a.id());
    for (const auto& [i, sort] : node.loose) {
      const Sort is = i < binds ? p.variable : n.loose.emplace(i - binds, sort).first->second;
      if (is != sort) refuse("a bound number of two sorts");
    }
    n.depth = std::max(n.depth, node.depth + 1);
    n.weight = std::min(max_weight, n.weight + node.weight);
  }
  if (n.depth > max_depth) refuse("nested more than 1000 deep");
}
// Only the fields that the operation uses, so that equal trees are the same.
Parts used(const Parts& p) {
  Parts out{.op = p.op, .args = p.args};
  const auto is = [&p](std::initializer_list<Op> ops) {
    return std::find(ops.begin(), ops.end(), p.op) != ops.end();
  };
  if (is({Op::Var, Op::Fun, Op::All})) out.name = p.name;
  if (is({Op::Num})) out.value = p.value;
  if (is({Op::Pow})) out.exponent = p.exponent;
  if (is({Op::Bound, Op::Entry})) out.index = p.index;
  if (is({Op::Matrix})) out.cols = p.cols;
  if (is({Op::Var, Op::Bound, Op::All})) out.variable = p.variable;
  return out;
}
// (a + b) + c is a + b + c; a sum, product, conjunction or disjunction of one is that one.
Parts flat(const Parts& p) {
  Parts out = p;
  if (p.args.empty() || p.args[0].op() != p.op) return out;
  out.args = p.args[0].args();
  out.args.insert(out.args.end(), p.args.begin() + 1, p.args.end());
  return out;
}
}  // namespace

Expr make(const Parts& wanted) {
  const bool flattens = wanted.op == Op::Add || wanted.op == Op::Mul;
  const bool joins = flattens || wanted.op == Op::And || wanted.op == Op::Or;
  const Parts p = flattens ? flat(used(wanted)) : used(wanted);
  static std::unordered_multimap<std::size_t, std::uint32_t> places;
  const std::size_t key = hash(p);
  Expr e;
  for (auto [it, end] = places.equal_range(key); it != end; ++it) {
    e.place = it->second;
    if (equal(at(it->second).parts, p)) return e;  // it was checked when it entered
  }
  Node node = checked(p);
  if ((joins && p.args.size() == 1) || (p.op == Op::Pow && p.exponent == 1)) return p.args[0];
  measure(node);
  if (nodes().size() >= UINT32_MAX) refuse("more than 2^32 terms");
  e.place = std::uint32_t(nodes().size());
  nodes().push_back(std::move(node));
  places.emplace(key, e.place);
  return e;
}
Expr with_args(Expr e, const Exprs& args) {
  const Node& n = at(e.id());
  if (n.parts.op == Op::Entry && args.size() == 1) {
    const int cols = n.parts.args[0].cols();
    return entry(args[0], n.parts.index / cols, n.parts.index % cols);
  }
  Parts parts = n.parts;
  parts.args = args;
  return make(parts);
}

Expr::Expr(int number) : Expr(from_rational(number)) {}
Expr Expr::from_rational(const cln::cl_RA& number) {
  return make({.op = Op::Num, .value = number});
}
Op Expr::op() const { return at(place).parts.op; }
Sort Expr::sort() const { return at(place).sort; }
std::string Expr::name() const { return at(place).parts.name; }
cln::cl_RA Expr::value() const { return at(place).parts.value; }
int Expr::exponent() const { return at(place).parts.exponent; }
int Expr::index() const { return at(place).parts.index; }
Sort Expr::bound_sort() const { return at(place).parts.variable; }
int Expr::rows() const { return at(place).rows; }
int Expr::cols() const { return at(place).cols; }
int Expr::loose() const {
  const std::map<int, Sort>& indices = at(place).loose;
  return indices.empty() ? 0 : indices.rbegin()->first + 1;
}
std::uint64_t Expr::weight() const { return at(place).weight; }
std::size_t Expr::size() const { return at(place).parts.args.size(); }
Exprs Expr::args() const { return at(place).parts.args; }
Expr Expr::arg(std::size_t i) const {
  const Exprs& args = at(place).parts.args;
  if (i >= args.size()) refuse("no argument " + std::to_string(i) + " in " + brief(*this));
  return args[i];
}

bool is_call(Expr e, std::string_view f) { return e.op() == Op::Fun && at(e.id()).parts.name == f; }
bool is_term(Expr e) { return (e.sort() == Sort::Real || e.sort() == Sort::Int) && !e.loose(); }
bool is_matrix(Expr e) { return e.sort() == Sort::Matrix && !e.loose(); }
bool is_formula(Expr e) { return e.sort() == Sort::Bool && !e.loose(); }
}  // namespace kernel
