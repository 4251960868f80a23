// Terms, matrices and formulas: one immutable, interned tree. Equal trees are the same Expr.
// Nothing is simplified here: what is written is what is kept (only (a + b) + c and (a * b) * c are
// written flat). Every function is TOTAL, as in Coq and HOL Light: inv(0) and sqrt(-1) are some
// real numbers of which nothing is known, so no rule asks for definedness. needs() of
// kernel/theorem.hpp says what a formula that is shown needs to make sense. One thread at a time.
#pragma once

#include <concepts>
#include <cstdint>
#include <map>
#include <set>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include <cln/integer.h>
#include <cln/rational.h>

namespace kernel {
/// What the kernel throws for whatever it does not accept; the message is one line.
struct Refused : std::runtime_error {
  using std::runtime_error::runtime_error;
};
[[noreturn]] void refuse(const std::string& why);

enum class Sort { Real, Int, Bool, Matrix };
enum class Op {
  Num,
  Var,
  Bound,
  Fun,
  Add,
  Mul,
  Pow,
  Eq,
  Lt,
  Le,
  Not,
  And,
  Or,
  Imp,
  Iff,
  All,
  Matrix,
  Times,
  Transpose,
  MatrixPower,
  Entry,
  Det
};

class Expr;
using Exprs = std::vector<Expr>;
using Substitution = std::map<Expr, Expr>;
struct Parts;

/// The place of a tree in the kernel's table: no pointer leads into it, and each place holds a tree
/// that make() has checked. An Expr made by default is no tree; asking it anything is Refused.
class Expr {
public:
  Expr() = default;
  Expr(int number);
  template <std::same_as<cln::cl_RA> T>
  Expr(const T& number) : Expr(from_rational(number)) {}
  template <class T>
  requires(std::is_arithmetic_v<T> || std::is_enum_v<T>) Expr(T)
  = delete;  // 0.5, 4294967296, true: none of them is silently another number

  Op op() const;
  Sort sort() const;
  std::string name() const;      ///< of Var and Fun; of All: what its variable is called
  cln::cl_RA value() const;      ///< of Num
  int exponent() const;          ///< of Pow, at least 2
  int index() const;             ///< of Bound: de Bruijn; of Entry: row-major place from 0
  Sort bound_sort() const;       ///< of All: the sort of its variable
  int rows() const;              ///< of a matrix
  int cols() const;              ///< of a matrix
  int loose() const;             ///< 1 + the largest Bound index that leads out of the tree, else 0
  std::uint64_t weight() const;  ///< nodes of the tree, written out
  std::size_t size() const;
  Expr arg(std::size_t i) const;
  Exprs args() const;
  std::size_t id() const { return place; }
  explicit operator bool() const { return place != 0; }
  friend bool operator==(Expr a, Expr b) { return a.place == b.place; }
  /// Order of creation: arguments before what holds them.
  friend bool operator<(Expr a, Expr b) { return a.place < b.place; }

private:
  friend Expr make(const Parts& parts);
  static Expr from_rational(const cln::cl_RA& number);
  std::uint32_t place = 0;
};

/// What a tree is made of. A field that the operation does not use keeps its default.
struct Parts {
  Op op = Op::Num;
  Exprs args = {};
  std::string name = {};
  cln::cl_RA value = 0;
  int exponent = 0;
  int index = 0;
  int cols = 0;                ///< of Matrix
  Sort variable = Sort::Real;  ///< of Var and Bound: their sort; of All: its variable's sort
};
/// The only maker: checks names, sorts, shapes and arity, whoever calls it.
Expr make(const Parts& parts);
/// The same operation on other arguments.
Expr with_args(Expr e, const Exprs& args);

// Makers. An integer term may stand where a real one is asked for.
Expr real(const std::string& name);  ///< a free variable; a name has one sort for ever
Expr integer(const std::string& name);
Expr fun(const std::string& name, const Exprs& args);
Expr sum(const Exprs& terms);
Expr product(const Exprs& factors);
constexpr int max_exponent = 1000000;
Expr power(Expr base, int exponent);  ///< exponent from 1 to max_exponent
template <class T>
requires(std::is_arithmetic_v<T> && !std::same_as<T, int>) Expr power(Expr base, T exponent)
= delete;
Expr eq(Expr l, Expr r);  ///< of numbers, or of matrices of one shape
Expr lt(Expr l, Expr r);
Expr le(Expr l, Expr r);
Expr neq(Expr l, Expr r);
Expr logic_not(Expr f);
Expr logic_and(const Exprs& fs);
Expr logic_or(const Exprs& fs);
Expr imp(Expr f, Expr g);
Expr iff(Expr f, Expr g);
Expr all(Expr variable, Expr f);

Expr operator+(Expr a, Expr b);
Expr operator*(Expr a, Expr b);
Expr operator-(Expr a);          ///< a number's sign goes into it, -(2*x) is (-2)*x
Expr operator-(Expr a, Expr b);  ///< a + (-b)
Expr operator/(Expr a, Expr b);  ///< a*inv(b); a/(b*c) is a*inv(b)*inv(c), a/b^2 is a*inv(b)^2
Expr sin(Expr x);
Expr cos(Expr x);
Expr atan(Expr x);
Expr sqrt(Expr x);
Expr ceil(Expr x);
Expr pi();

/// Free variables by terms of their sort. Nothing is captured: bound variables are indices.
Expr substitute(Expr e, const Substitution& s);
/// The same for these variables, in their order.
Expr substitute(Expr e, const Exprs& variables, const Exprs& terms);
/// Every occurrence of a closed term or matrix by another.
Expr replace(Expr e, Expr from, Expr to);
/// The body of a closed All with the term for its variable.
Expr open(Expr quantified, Expr term);
std::set<Expr> free_variables(Expr e);

/// Matrices of a fixed shape. entry() computes: (A B)_ij is a sum, A^T_ij is A_ji, so that only the
/// entry of a name or of a power stays an Entry. Rows and columns are counted from 0 here.
Expr matrix(int cols, const Exprs& entries);
Expr times(Expr a, Expr b);
Expr transpose(Expr a);
Expr power(Expr a, Expr n);
Expr det(Expr a);
Expr entry(Expr a, int i, int j);
Exprs entries(Expr a);  ///< row by row
/// The equations of the entries of an equation of matrices, row by row.
Exprs entry_equations(Expr matrix_equation);

/// Whether it is that function of something.
bool is_call(Expr e, std::string_view function);
bool is_term(Expr e);     ///< a number without loose index
bool is_matrix(Expr e);   ///< a matrix without loose index
bool is_formula(Expr e);  ///< a formula without loose index

/// Printed, from the tree and nothing else; read back it is the same tree. Refused: a tree of more
/// than 200,000 nodes, or with a loose index.
std::string text(Expr e);
/// For messages: cut after some 200 characters, never Refused.
std::string brief(Expr e);
std::string digits(const cln::cl_RA& q);  ///< "-2/3"
}  // namespace kernel
