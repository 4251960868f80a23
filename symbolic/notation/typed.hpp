// Reads terms, matrices and formulas as the kernel prints them, and what people type: plain text,
// Unicode, LaTeX. What has two usual readings is refused with both, or a note says how it was read.
#pragma once

#include <optional>

#include "kernel/expr.hpp"

namespace notation {
/// The very tree that is printed so: read(kernel::text(e)) is e. Variables and functions are those
/// that the kernel knows; parameters that the printer hides are put back.
/// Refused (kernel::Refused, one line with the place): what is not of this form, a name that nobody
/// has declared, more than 200,000 characters, brackets more than 200 deep.
kernel::Expr read(std::string_view text);

struct Typed {
  kernel::Expr term;               ///< a number or a matrix
  std::vector<std::string> notes;  ///< how it was read: "1/2 M_1 is read as (1/2)*M_1"
  kernel::Expr right = {};         ///< of an equation, whose left side is the term
};
/// Numbers (decimals exactly: 0.1 is 1/10), + - * / ^, names, |x|, sqrt cbrt root abs sin cos tan
/// sec csc cot asin acos atan exp log sinh cosh tanh, matrices [[a, b], [c, d]] or (a, b; c, d) or
/// \begin{pmatrix}; M₁, c'_n, usual spellings of signs; a product's sign may be left out where it
/// is clear, as in M_2u_2 where both are in `factors`. A name before a bracket is a function unless
/// it is in `factors`, is Greek or has an index, or is one of the usual letters: x, V, n, ...
/// Refused (kernel::Refused, "column 7: ..."): anything else, more than 20,000 characters, brackets
/// more than 200 deep, numbers of more than 70,000 bits, exponents above 10,000.
Typed read_typed(std::string_view text, const std::set<std::string>& factors = {});
/// The same, or an equation; where a column is asked for it may be (a, b).
Typed read_equation(std::string_view text, const std::set<std::string>& factors, bool is_column);

/// One sign of an equation or a chain: 0 < alpha <= 1 are two.
struct Comparison {
  kernel::Expr left;
  std::string relation;  ///< "<", "<=", ">", ">=", "=" or "!="
  kernel::Expr right;
};
/// At least one; `notes`: how they were read.
std::vector<Comparison> read_comparisons(std::string_view, std::vector<std::string>* notes = {});

/// The variable that stands for a typed name: whatever the name means elsewhere, here it is a real
/// number of which nothing is known. c'_n is called c_prime_n.
kernel::Expr symbol(const std::string& name);
/// Of these names the one that differs in _ and in small and capital letters alone; "" of none.
std::string alike(const std::string& name, const std::set<std::string>& names);
/// The names of which a word is made, with spaces: "M_2u_2" is "M_2 u_2"; "" where it is not.
std::string parted(const std::string& word, const std::set<std::string>& names);
/// The typed name, or "" of what is no such variable.
std::string name_of(kernel::Expr symbol);
std::set<std::string> symbols_of(kernel::Expr e);
/// x^y for real y; root of a whole order, of negative numbers too where that is odd; the logarithm,
/// and so on: functions of the reader; `call` also makes those that the kernel knows.
kernel::Expr raised(kernel::Expr base, kernel::Expr exponent);
kernel::Expr root(int order, kernel::Expr x);
kernel::Expr call(const std::string& name, kernel::Expr x);
/// The value of a term of numbers, +, *, quotients and whole powers, while it is short.
std::optional<cln::cl_RA> rational_value(kernel::Expr e);
/// As one would type it; reads back as a term of the same value.
std::string typed_text(kernel::Expr e);
}  // namespace notation
