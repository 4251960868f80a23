// One normal form for all that people type: sums of products of powers, where the exponents are
// polynomials. exp(u) is e^u; cos(u) and sin(u) are sums of z^u and z^-u, z^u = cos(u) + i sin(u);
// roots are fractional powers; log(u) is a sum of logarithms of atoms; |u| is a product of moduli.
// So e^(3x) e^-x, (xy)^n, log(27)/log(3) and cos(u)^2 + sin(u)^2 need no rule of their own.
#pragma once

#include <algorithm>
#include <array>
#include <utility>

#include "algebra/tactics.hpp"
#include "equality/decide.hpp"

namespace equality {
using kernel::Op;
using Exponent = kernel::Polynomial;
using Product = std::map<Expr, Exponent>;   ///< atom -> exponent, which is not 0
using Sum = std::map<Product, cln::cl_RA>;  ///< no coefficient is 0

Expr circle();  ///< z, the point of the unit circle: z^u = cos(u) + i sin(u)
inline Expr euler() { return notation::call("exp", 1); }
inline Expr absolute(Expr e) { return notation::call("abs", e); }
inline Sum number(const cln::cl_RA& q) { return q == 0 ? Sum() : Sum{{Product(), q}}; }
inline Sum atom(Expr e, const Exponent& power = {{{}, 1}}) { return {{Product{{e, power}}, 1}}; }
Sum imaginary();  ///< i = z^(pi/2)
Sum operator+(const Sum& a, const Sum& b);
Sum scaled(const Sum& a, const cln::cl_RA& q);
inline Sum operator-(const Sum& a, const Sum& b) { return a + scaled(b, -1); }
Exponent exponent(const cln::cl_RA& q);
Exponent times_pi(const cln::cl_RA& q);
/// What a sum, a product or an exponent has of one part: 0 where it is absent.
template <class Parts>
typename Parts::mapped_type of_part(const Parts& parts, const typename Parts::key_type& part) {
  const auto it = parts.find(part);
  return it == parts.end() ? typename Parts::mapped_type() : it->second;
}
inline Exponent exponent_in(const Product& product, Expr atom) { return of_part(product, atom); }
inline cln::cl_RA constant_part(const Exponent& e) { return of_part(e, {}); }
std::optional<cln::cl_RA> number_of(const Exponent& e);
std::optional<int> whole_number(const Exponent& e);
inline bool is_whole(const cln::cl_RA& q) { return cln::denominator(q) == 1; }
inline bool is_even(const cln::cl_RA& whole) { return cln::evenp(cln::numerator(whole)); }
inline bool is_sine(Expr e) { return is_call(e, "sin") || is_call(e, "cos"); }
bool is_arcus(Expr e);
void multiply(Product& into, Expr atom, const Exponent& exponent);
/// What cannot be computed is not proved.
bool is_proved(const auto& question) {
  try {
    return question();
  } catch (const std::runtime_error&) {
    return false;
  }
}

/// The form would be too long, or GiNaC would take too long to factor it.
struct TooLarge : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The numerator. Throws TooLarge above 100,000.
int whole(const cln::cl_RA& q);

/// The rational e of a root or a power x^e, and the n of e = k/n.
std::optional<cln::cl_RA> root_exponent(Expr root);
int order_of(Expr root);

/// All parts of a term, each once: inner ones first, itself the last.
Exprs parts_of(Expr term);
/// Arguments of moduli, symbols under roots and bases of powers there.
std::set<Expr> turns(Expr term);
enum class Need { NotZero, NotNegative, Positive };
struct Requirement {
  Need kind;
  Expr term;
  bool operator==(const Requirement&) const = default;
};
std::vector<Requirement> requirements(Expr term, const Domain& domain);
std::string text(const Requirement& r);  ///< "x - 1 != 0"
/// "x >= 0 |- sqrt(x)^2 = x", which the kernel proves from what the terms need, what the domain
/// says, what is `given` (x = 2, put in one after the other) and what other roots are. Refused
/// (kernel::Refused): not found, or not all of +, *, quotients, roots and sines of parts of pi.
std::string certified(Expr goal, const Exprs& given, std::vector<Requirement> needs,
                      const Domain& domain);
/// Where a term is 0 that is linear in x, with a number as its coefficient.
std::optional<Expr> zero_of(Expr term, Expr x);
/// a, b and c, if it is a x^2 + b x + c.
std::array<Expr, 3> quadratic_in(Expr term, Expr x);
/// And where it may be 0: quadratic in x, or with x in one function that has an inverse.
Exprs zeros_of(Expr term, Expr x);
/// "has no value at a zero of x^3 - x - 1, near x = 1.32472", to six digits, where a divisor of x
/// that has values all over the domain changes its sign; "needs ... != 0" where that was not found.
std::string said_of_zero(Expr divisor, const Domain& domain);
/// Of +, *, powers, moduli and constants: where its symbols are whole it may be meant to be.
bool is_whole_form(Expr e);
/// What holds where it says so of several symbols, or of one and an irrational number.
std::vector<Requirement> conditions(const Domain& domain);

/// Normal forms on a domain: what is said of a term holds where it is defined, as was assumed.
class Forms {
public:
  explicit Forms(Domain domain) : where(std::move(domain)) {}
  void assume(const Requirement& requirement);

  /// Throws TooLarge, NotDefined (a quotient by what is identically 0).
  Sum of(Expr term);
  bool is_zero(const Sum& sum);
  bool is_not_negative(const Sum& sum) { return has_sign(sum, 1, false); }
  bool is_positive(const Sum& sum) { return has_sign(sum, 1, true); }
  bool holds(const Requirement& requirement);
  /// z^u - 1 for u = the sum: 0 where it is a multiple of 2 pi.
  bool is_whole_turns(const Sum& sum) { return is_zero(turned(sum) - number(1)); }
  bool is_integer(Expr term);
  Expr expression(const Sum& sum);
  /// The same where the sum is real, with cos(u) for z^u; else nothing. This alone is a term of
  /// real numbers: in the other one z is just a name.
  std::optional<Expr> real_expression(const Sum& sum);

private:
  struct Factors {
    cln::cl_RA number = 1;
    Product powers = {};  // of atoms; sums that cannot be factored have become atoms
  };
  Domain where;
  std::map<Expr, Sum> forms;       // of terms
  std::map<Expr, Sum> composites;  // what an atom stands for
  std::map<Sum, Factors> factored;
  std::map<Sum, Expr> products;              // sums that were typed as a product or a power
  std::map<Sum, std::pair<int, int>> signs;  // of composites, and the depth where that was asked
  std::map<Expr, int> assumed_signs;         // 1: not negative, 2: positive, -1, -2 likewise
  std::set<Expr> assumed_not_zero;
  std::vector<std::pair<Sum, int>> assumed;  // signs, likewise
  struct SignedProduct {  // a b c is not negative (1) or positive (-1), or others are 0
    Exprs atoms = {};
    Product others = {};
    int sign = 1;
  };
  std::vector<SignedProduct> signed_products;
  int depth = 0;          // of questions for signs
  std::size_t asked = 0;  // terms in them

  Sum computed(Expr term);
  Sum function(Expr term);
  Sum times(const Sum& a, const Sum& b);
  void reduce(Product& product, cln::cl_RA& number);
  void reduce_modulus(Product& product, cln::cl_RA& number, Expr atom, const Exponent& exponent);
  void reduce_turns(Product& product, cln::cl_RA& number, const Exponent& exponent) const;
  Sum integer_power(const Sum& base, int exponent);
  std::optional<Sum> rationalized(const Sum& constant);
  Exponent multiplied(const Exponent& a, const Exponent& b);
  Sum symbolic_power(const Sum& base, const Exponent& exponent);
  Sum real_power(const Sum& base, const Exponent& exponent);
  Product power_of_modulus(const Sum& base, const Exponent& exponent);
  Sum odd_root(const Sum& base, const Exponent& exponent);
  Sum logarithm(const Sum& sum);
  Sum exponential(const Sum& sum);
  Sum divided(Sum sum);
  Sum multiplied_out(const Product& powers);
  Sum cancelled(const Sum& sum);
  Sum turned(const Sum& angle);  // z^angle
  Sum turned_by_inverse(Expr inverse, const cln::cl_RA& multiple);
  Sum inverse_angle(const std::string& name, const Sum& sum);
  const Factors& factors(const Sum& sum);
  Factors factors_of(const Sum& sum);
  Expr composite(const Sum& sum) { return composites.emplace(expression(sum), sum).first->first; }
  void take_factor(Factors& into, Sum part, int times_taken);
  std::pair<Expr, cln::cl_RA> as_power(const Sum& part);
  void take_real(Factors& into, Sum part, int times_taken);
  Sum reduced(Product product, cln::cl_RA number = 1);

  Exponent exponent_of(const Sum& sum);
  Sum sum_of(const Exponent& exponent) { return of(kernel::expression(exponent)); }
  bool is_integer(const Exponent& exponent) const;
  bool is_complex(Expr atom);
  Sum conjugated(const Sum& sum);
  Exponent constant(Expr atom, const Exponent& e);

  Sum expanded(Sum sum, Product* divisor = nullptr);
  bool is_nothing(const Sum& sum) { return sum.size() != 1 && expanded(sum).empty(); }
  /// The sign (1 or -1) is proved; strictly: without 0.
  bool has_sign(const Sum& sum, int sign, bool strictly);
  // 2: positive, 1: not negative, 0: not known, -1 and -2 likewise
  int sign_of_atom(Expr atom);
  int sign_of_powers(const Product& powers);
  using Rule = int(const Sum& sum);
  Rule sign_of, sign_of_composite, sign_of_number, sign_of_two, sign_by_bounds;
  Rule sign_of_cosine, sign_of_quadratic, sign_of_root, sign_by_terms, sign_by_shift;
};

/// Proved on the domain, where what is known holds; false where that is not found out.
bool is_certain(const Requirement& requirement, const Domain& domain,
                std::vector<Requirement> known = {});
/// The box made smaller by those requirements that bound one symbol: x >= 1 for sqrt(x - 1).
Domain narrowed(Domain domain, const std::vector<Requirement>& needs);
bool is_zero_constant(Expr constant);
/// Of a polynomial in its atoms, found by GiNaC, multiplied out again for a check. Throws TooLarge.
std::vector<std::pair<kernel::Polynomial, int>> factorized(const kernel::Polynomial& p);

/// left - right, a sum of multiples of inverse angles and of pi, is 0: a multiple of it is a whole
/// number of turns in normal form, both sides are continuous all over the domain, which is
/// connected, and the difference is small at a point of `common`.
bool is_same_angle(Expr left, Expr right, const Domain& domain, const std::vector<Point>& common);
/// `right` with its inverse angles as multiples of those of `left`, where that is proved.
Expr with_one_angle(Expr left, Expr right, const Domain& domain, const std::vector<Point>& common);

/// Bounds of constants by rational numbers, each proved by the kernel.
class Enclosures {
public:
  /// low <= e and e <= high
  struct Bounds {
    cln::cl_RA low, high;
    algebra::Theorem above, below;
  };
  /// Refused: what is not +, *, quotients, powers and what has been added or is known by facts.
  Bounds of(Expr constant);
  /// 0 < e or e < 0. Refused: 0 is between its bounds.
  algebra::Theorem sign(Expr constant);
  /// From root^n = base; where n is even, also 0 <= root.
  void add_root(const algebra::Theorem& is, const algebra::Theorems& sign);
  /// The cosine c of pi/d, 6 < d < 36, from c^n = a polynomial in c whose greatest zero it is.
  void add_cosine(int d, const algebra::Theorem& is);

  explicit Enclosures(const algebra::Theorems& equations) : facts(equations) {}

private:
  const algebra::Theorems& facts;
  std::map<Expr, Bounds> known;
  Bounds found(Expr constant);
  static Bounds shown(Expr e, const cln::cl_RA& low, const cln::cl_RA& high,
                      const algebra::Theorems& above, const algebra::Theorems& below);
  static Bounds product(Expr e, const Bounds& x, const Bounds& y);
  static Bounds inverse(Expr e, const Bounds& x);
};

/// |- sum = 0: times another sum it is 0 by `facts` (monomial = term), and that one's bounds are of
/// one sign. Refused: not found.
algebra::Theorem vanishes(Expr sum, const algebra::Theorems& facts, Enclosures& of);
}  // namespace equality
