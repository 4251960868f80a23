// The axioms of real analysis, one a line: each is true for ALL values of its variables, x, y real
// and i, j integer. This one place could say what 1/0 is; it does not, and nothing needs it.
#include <algorithm>

#include "kernel/theorem.hpp"

namespace kernel {
namespace {
using Axioms = std::vector<std::pair<std::string, Expr>>;

const Axioms& table() {
  const Expr x = real("x"), y = real("y"), i = integer("i"), j = integer("j");
  static const Axioms known = {
      // order
      {"equal or less or greater", logic_or({lt(x, y), eq(x, y), lt(y, x)})},
      {"less is not equal", imp(lt(x, y), neq(x, y))},
      {"discrete", iff(lt(i, j), le(i + 1, j))},
      // root
      {"root squared", imp(le(0, x), eq(power(sqrt(x), 2), x))},
      {"root not negative", imp(le(0, x), le(0, sqrt(x)))},
      // ceiling, an integer by its sort
      {"ceiling", logic_and({le(x, ceil(x)), lt(ceil(x), x + 1)})},
      // sine and cosine
      {"sin 0", eq(sin(0), 0)},
      {"cos 0", eq(cos(0), 1)},
      {"sin sum", eq(sin(x + y), sin(x) * cos(y) + cos(x) * sin(y))},
      {"cos sum", eq(cos(x + y), cos(x) * cos(y) - sin(x) * sin(y))},
      {"sin minus", eq(sin(-x), -sin(x))},
      {"cos minus", eq(cos(-x), cos(x))},
      {"circle", eq(power(sin(x), 2) + power(cos(x), 2), 1)},
      {"sin pi", eq(sin(pi()), 0)},
      {"cos pi", eq(cos(pi()), -1)},
      {"sin pi/2", eq(sin(pi() / 2), 1)},
      {"cos pi/2", eq(cos(pi() / 2), 0)},
      {"sin positive", imp(logic_and({lt(0, x), lt(x, pi())}), lt(0, sin(x)))},
      {"cos falls", imp(logic_and({le(0, x), lt(x, y), le(y, pi())}), lt(cos(y), cos(x)))},
      {"pi positive", lt(0, pi())},
      // arctangent
      {"atan range", logic_and({lt(-pi() / 2, atan(x)), lt(atan(x), pi() / 2)})},
      {"atan positive", imp(lt(0, x), lt(0, atan(x)))},
      {"cos atan", eq(cos(atan(x)), 1 / sqrt(1 + power(x, 2)))},
      {"sin atan", eq(sin(atan(x)), x / sqrt(1 + power(x, 2)))},
      {"atan bounds", imp(le(0, x), logic_and({le(x - power(x, 3) / 3, atan(x)), le(atan(x), x)}))},
  };
  return known;
}
}  // namespace

// AXIOM. True for all real numbers, by real analysis.
Theorem axiom(const std::string& name) {
  const auto it = std::ranges::find_if(table(), [&name](const auto& a) { return a.first == name; });
  if (it == table().end()) refuse("no axiom " + name);
  return Theorem({}, it->second, {"axiom " + name});
}
std::vector<std::string> axiom_names() {
  std::vector<std::string> out;
  for (const auto& [name, f] : table()) out.push_back(name);
  return out;
}
}  // namespace kernel
