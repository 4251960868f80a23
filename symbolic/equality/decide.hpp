// Constants: balls and exact signs. Domains: a range for each symbol, and further conditions.
#pragma once

#include "balls/ball.hpp"
#include "notation/typed.hpp"

namespace equality {
using balls::Ball;
using balls::NotCertain;
using kernel::Expr;
using kernel::Exprs;

/// The term has no real value: "the square root of a negative number". One line.
struct NotDefined : std::runtime_error {
  using std::runtime_error::runtime_error;
};
/// The value of a term without variables, with so many bits behind the point. Throws NotDefined
/// where that is certain, balls::NotCertain where more bits may help.
Ball enclosure(Expr constant, int bits);
/// The same with the bits that balls have now, and values for symbols and for whole terms.
Ball enclosure(Expr term, const std::map<Expr, Ball>& values);
/// -1, 0 or 1, exactly; nothing where neither bits nor a bound of separation decide it, as they do
/// for what is_algebraic() and takes up to 60,000 bits. Throws NotDefined.
std::optional<int> exact_sign(Expr constant);
/// Built by +, *, quotients and roots from rationals and sines of rational multiples of pi.
bool is_algebraic(Expr constant);
/// The rational q with e = q pi, if e is written so.
std::optional<cln::cl_RA> multiple_of_pi(Expr e);
/// The fraction of such a denominator that is within 10^-9 of the value.
std::optional<cln::cl_RA> near_fraction(const cln::cl_RA& value, int largest_denominator);

struct End {
  cln::cl_RA value;
  bool is_inside = false;  ///< it belongs to the range
};
/// The values that one symbol may take: an interval, all of it or the integers in it.
struct Range {
  bool is_integer = false;
  std::optional<End> low = {};   ///< none: minus infinity
  std::optional<End> high = {};  ///< none: infinity

  void cut_below(const End& end);
  void cut_above(const End& end);
  bool contains(const cln::cl_RA& value) const;
  bool is_empty() const;
  bool is_point() const { return low && high && low->value == high->value && contains(low->value); }
};
/// Symbols by name: the order in which terms were made must not decide which point comes first.
struct ByName {
  bool operator()(Expr a, Expr b) const { return a.name() < b.name(); }
};
using Point = std::map<Expr, cln::cl_RA, ByName>;

struct Domain {
  std::map<Expr, Range, ByName> ranges;            ///< of every symbol
  std::vector<notation::Comparison> further = {};  ///< conditions that bound no one symbol
};

/// "0 < alpha <= 1, n integer, n >= 1, x real": with commas, each a comparison or a kind. What is
/// said of a symbol replaces what is usual: alpha, V, L, M, m, M_A, M_B > 0, 0 < e <= 1, n, k >= 1
/// and j >= 0 integers; other symbols are real. Refused (kernel::Refused): an empty condition.
/// `unused`: what it says of symbols that are not in `symbols`, and how conditions were read.
Domain read_domain(const std::string& text, const std::set<std::string>& symbols,
                   std::vector<std::string>& unused);
std::vector<std::string> texts(const Domain& domain);

/// Points of the domain, the simplest first; fewer than `count` where few are found. After the
/// simple values come those of `terms`: their numbers and what is beside them, where |x - 5000|
/// turns. `is_inside`: fractions first, which lie inside of short intervals, then values far apart.
std::vector<Point> points(const Domain& domain, std::size_t count, const Exprs& terms,
                          bool is_inside = false);
/// Whether it is true of constants; nothing where that is not decided, or where symbols are left.
std::optional<bool> holds(const notation::Comparison& comparison);
Expr at(const Point& point, Expr term);
std::string text(const Point& point);  ///< "alpha = 1/2, n = 3"

struct Value {
  std::optional<Ball> ball = {};  ///< nothing: no value, or not certain
  std::string why_none = {};      ///< where it is certain that there is none

  bool is_known() const;  ///< to fifty digits, or that there is none
};
Value value_at(const Point& point, Expr term, int bits = 192);

std::string shown_value(Expr constant);  ///< "1/2", "0.7071067811865475"

// Are two expressions equal over the reals, wherever both have a value? Never a guess.
enum class Answer { Equal, Different, Undecided };

struct Counterexample {
  Point at;           ///< but for values that the domain gives
  std::string point;  ///< "alpha = 1/2, n = 3"; "" for constants
  std::string left;   ///< "1/2", "0.7071067811865475"
  std::string right;
  std::string difference;  ///< left - right
};
struct Verdict {
  Answer answer = Answer::Undecided;
  std::string proof = {};                ///< how it is known, in a sentence; else what was tried
  std::vector<std::string> domain = {};  ///< "alpha > 0", "n integer, n >= 1"
  std::vector<std::string> conditions = {};  ///< where both sides have a value: "alpha - 1 != 0"
  std::vector<std::string> notes = {};       ///< where one side alone has a value
  std::optional<Counterexample> counterexample = {};
  std::string theorem = {};  ///< what the kernel certified, for rational functions
};
/// Explanation: also points of gaps, what powers need, and the kernel's theorem. Case: one of
/// those that a proof is split into, tried at few points and not split again.
enum class Wanted { Case, Verdict, Explanation };
/// Equal: proved wherever both sides have a value, but for isolated points. Different: at a point
/// both values are certain, and differ. Refused (kernel::Refused): no such point was found.
Verdict decide(Expr left, Expr right, const Domain& domain, Wanted wanted = Wanted::Explanation);
const char* word(Answer answer);  ///< "equal", "different", "undecided"
}  // namespace equality
