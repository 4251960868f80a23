// The spelling of each operation in the runtime; and as it is typed, with no bracket too many.
#include <algorithm>

#include "codegen/emit.hpp"

namespace codegen {
namespace {
const std::map<Op, std::string> functions_of_cmath{{Op::root, "sqrt"},    {Op::sine, "sin"},
                                                   {Op::cosine, "cos"},   {Op::arc_tangent, "atan"},
                                                   {Op::ceiling, "ceil"}, {Op::size, "abs"}};
std::string number(const cln::cl_RA& q) {
  const auto whole = [](const cln::cl_I& n) { return "Number(" + kernel::digits(n) + ")"; };
  const cln::cl_I below = cln::denominator(q);
  return whole(cln::numerator(q)) + (below == 1 ? "" : " / " + whole(below));
}
bool is_near(Interval x, Interval y) {  // -y is from x/2 to 2 x, with room for errors
  constexpr double room = 1 + 1e-6;
  const bool opposite = (x.low > 0 && y.high < 0) || (x.high < 0 && y.low > 0);
  return opposite && 2 * y.least() >= x.size() * room && 2 * x.least() >= y.size() * room;
}
std::string constant(const Node& n) {
  const double high = nearest(n.number()), low = nearest(n.number() - exact(high));
  const cln::cl_I above = cln::numerator(n.value), below = cln::denominator(n.value);
  if (!is_double(above) || !is_double(below)) throw Refused("a constant of too many digits");
  return std::string(n.of_pi ? "N::pi_times(" : "N::rational(") + hex(nearest(above)) + ", " +
         hex(nearest(below)) + ", " + hex(high) + ", " + hex(low) + ")";
}
struct Spelling {
  const char* pattern;
  const char* word;  ///< what is counted
};
/// #0: the first operand as an N, $0: as a T, @0: its name. The factor is %.
const std::map<Op, Spelling> spellings{
    {Op::exact_sum, {"N::two_sum($0, $1)", "sums of doubles"}},
    {Op::whole_sum, {"$0 + $1", ""}},
    {Op::scale, {"scaled(#0, %)", ""}},
    {Op::sum, {"#0 + #1", "sums"}},
    {Op::cancelling_sum, {"cancelling_sum(#0, #1)", "sums"}},
    {Op::product, {"#0 * #1", "products"}},
    {Op::exact_product, {"times(#0, $1)", "products by doubles"}},
    {Op::quotient, {"quotient(#0, #1)", "quotients"}},
    {Op::reciprocal_root, {"reciprocal_root(#0)", "reciprocal roots"}},
    {Op::root, {"", "roots"}},        // plain forms' alone, as errors.cpp says
    {Op::ceiling, {"", "ceilings"}},  // and these
    {Op::arc_tangent, {"arc_tangent<Tier>(#0, #1)", "arctangents"}},
    {Op::sine, {"of_@0.sine", "sines"}},
    {Op::cosine, {"of_@0.cosine", "cosines"}},
    {Op::size, {"magnitude(#0)", ""}},
    {Op::nearest, {"N::nearest(leading(#0) / leading(#1))", "roundings to whole numbers"}},
    {Op::power, {"power(#0, $1)", "powers"}},
    {Op::turn, {"N::turn($0)", ""}},
    {Op::step, {"$0 + (N::times_sign_of(N::all(0.5), leading(#1)) - 0.5)", ""}}};
/// Faster ones, where ranges allow them.
std::string pattern(const Program& p, const Node& n) {
  const auto of = [&](std::size_t i) { return p[n.of[i]].range; };
  if (n.op == Op::exact_sum && of(0).least() >= of(1).size()) return "N::fast_two_sum($0, $1)";
  if (n.op == Op::exact_sum && of(1).least() >= of(0).size()) return "N::fast_two_sum($1, $0)";
  if (n.op == Op::scale && n.is_exact) return "$0 * %";
  if (n.op == Op::scale && n.factor == -1) return "-#0";
  if (n.op == Op::cancelling_sum && is_near(of(0), of(1))) return "near_sum(#0, #1)";
  if (n.op == Op::quotient && p[n.of[0]].is_exact) return "quotient($0, #1)";
  return spellings.at(n.op).pattern;
}
}  // namespace

std::string as_plain(const Program& p, int k) {
  if (p[k].op == Op::constant) return "N::all(" + hex(nearest(p[k].value)) + ")";
  return p[k].name;
}
std::string as_number(const Program& p, int k) {
  if (p[k].op == Op::constant && !p[k].is_exact) return constant(p[k]);
  return p[k].is_exact ? "N::exact(" + as_plain(p, k) + ")" : p[k].name;
}
std::string right_side(const Program& p, const Node& n) {
  const std::string from = pattern(p, n);
  std::string r;
  for (std::size_t i = 0; i < from.size(); ++i) {
    const char c = from[i];
    if (c == '%') {
      r += hex(n.factor);
    } else if (c == '#' || c == '$' || c == '@') {
      const int x = n.of[std::size_t(from[++i] - '0')];
      r += c == '#' ? as_number(p, x) : c == '$' ? as_plain(p, x) : p[x].name;
    } else {
      r += c;
    }
  }
  return r;
}
std::string sine_and_cosine(const Program& p, const Node& n) {
  const int x = n.of[0];
  const bool is_small = p[x].range.size() <= small_angle;
  return "const auto of_" + p[x].name + " = sine_cosine" +
         (is_small ? "_small<Tier>(" : "<Tier>(") + as_number(p, x) + ");";
}

std::string purpose(const Program& p, int k) {
  if (!p[k].formula.empty()) return p[k].formula;
  std::set<int> parts{k};
  Words whose;
  const auto is_part = [&](int x) { return parts.contains(x); };
  for (int whole = k + 1; whole < p.size(); ++whole) {
    if (std::ranges::none_of(p[whole].of, is_part)) continue;
    if (p[whole].formula.empty())
      parts.insert(whole);
    else
      whose.push_back(p[whole].name);
  }
  for (const Result& r : p.results) {
    if (r.node == k) return "";
    if (is_part(r.node) && std::ranges::count(whose, r.name) == 0) whose.push_back(r.name);
  }
  return "for " + joined(whose, ", ");
}

std::string operation_counts(const Program& p) {
  std::map<std::string, int> counts;
  for (const Node& n : p.nodes) {
    const auto found = spellings.find(n.op);
    if (found != spellings.end() && *found->second.word != 0) ++counts[found->second.word];
  }
  Words r;
  for (const auto& [word, count] : counts) r.push_back(word + ": " + std::to_string(count));
  return r.empty() ? "none" : joined(r, ", ");
}

PlainText::PlainText(const Program& program) : p(program), uses(program.nodes.size(), 0) {
  for (const Node& n : p.nodes)
    for (int o : n.of) ++uses[std::size_t(o)];
  for (const Result& r : p.results) ++uses[std::size_t(r.node)];
}
bool PlainText::has_line(int k) const {
  const Node& n = p[k];
  if (n.op == Op::input || (n.op == Op::constant && !n.of_pi)) return false;
  return !n.formula.empty() || (!n.name.empty() && uses[std::size_t(k)] > 1 && n.op != Op::scale);
}
std::string PlainText::call(const std::string& function, const std::string& x) {
  functions.insert(function);
  return function + "(" + x + ")";
}
std::string PlainText::use(int k, int binding) {
  return has_line(k) ? p[k].name : right_side(k, binding);
}
std::string PlainText::right_side(int k, int binding) {
  const Node& n = p[k];
  const auto bound = [&](int own, const std::string& text) {
    return own < binding ? "(" + text + ")" : text;
  };
  const auto of = [&](std::size_t i, int in) { return use(n.of[i], in); };
  switch (n.op) {
    case Op::input:
      return n.is_whole ? "Number(" + n.name + ")" : n.name;
    case Op::constant:
      if (n.of_pi) return bound(2, number(4 * n.value) + " * " + call("atan", "Number(1)"));
      return bound(cln::denominator(n.value) == 1 ? 3 : 2, number(n.value));
    case Op::sum:
    case Op::cancelling_sum: {
      const Node& y = p[n.of[1]];
      const bool is_taken_off = y.op == Op::scale && !has_line(n.of[1]);
      if (y.op == Op::constant && y.value < 0) return bound(1, of(0, 1) + " - " + number(-y.value));
      return bound(1, of(0, 1) + (is_taken_off ? " - " + use(y.of[0], 2) : " + " + of(1, 2)));
    }
    case Op::scale:
      return bound(1, "-" + of(0, 2));
    case Op::product:
      return bound(2, of(0, 2) + " * " + of(1, 3));
    case Op::quotient:
      return bound(2, of(0, 2) + " / " + of(1, 3));
    default:
      return call(functions_of_cmath.at(n.op), of(0, 1));
  }
}
std::string PlainText::lines() {
  std::string text;
  for (int k = 0; k < p.size(); ++k)
    if (has_line(k))
      text += commented("  const Number " + p[k].name + " = " + right_side(k) + ";", purpose(p, k));
  return text;
}
}  // namespace codegen
