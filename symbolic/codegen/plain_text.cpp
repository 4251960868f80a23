// SPDX-License-Identifier: GPL-2.0-or-later
// Operations as they are typed, with no more brackets than it takes.
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
}  // namespace

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
  for (int k = 0; k < p.size(); ++k) {
    if (!has_line(k)) continue;
    if (!p[k].formula.empty()) text += "    // " + p[k].formula + "\n";
    text += "    const Number " + p[k].name + " = " + right_side(k) + ";\n";
  }
  return text;
}
}  // namespace codegen
