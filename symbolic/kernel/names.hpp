// Names: variables with their sorts, functions with their signatures. A name is one thing for ever,
// and no two things print alike. A name is a letter, then letters, digits, underscores, at most one
// prime at the end, and no word of the notation.
#pragma once

#include "kernel/expr.hpp"

namespace kernel {
struct Signature {
  std::vector<Sort> args = {};
  Sort result = Sort::Real;
  Exprs params = {};  ///< the first ones: not printed where all of them stand as they are
  int rows = 0;
  int cols = 0;
  Exprs variables = {};
  Expr body = {};  ///< what it is defined as, of `variables`

  bool indexed() const;  ///< an integer is printed as an index: a_n
  /// Before argument i: "; " where the variables of a predicate change their letter, else ", ".
  std::string separator(std::size_t i) const;
};
const Signature* signature(const std::string& name);
/// A function of which nothing is known. Refused: a name in use, or that could be read as another.
void declare(const std::string& name, const Signature& s);
/// Why the name cannot be a variable of that sort, or "".
std::string why_no_variable(const std::string& name, Sort sort);
/// Makes a variable known; Refused for the reason above.
void declare_variable(const std::string& name, Sort sort);
/// The variable of that name if there is one, else no Expr.
Expr known_variable(const std::string& name);
bool is_known(const std::string& name);
/// What an index is written behind: "a_" for a, "alpha_" for alpha_.
std::string stem(const std::string& name);
}  // namespace kernel
