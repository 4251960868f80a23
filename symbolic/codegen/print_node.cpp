// SPDX-License-Identifier: GPL-2.0-or-later
// The spelling of each operation in the runtime.
#include "codegen/print_node.hpp"

#include <map>

#include <cln/integer.h>

#include "codegen/builder.hpp"
#include "codegen/exact.hpp"
#include "codegen/quantity.hpp"

namespace codegen {
namespace {
bool is_near(Interval x, Interval y) {  // -y is from x/2 to 2 x, with room for errors
  constexpr double room = 1 + 1e-6;
  const bool opposite = (x.low > 0 && y.high < 0) || (x.high < 0 && y.low > 0);
  return opposite && 2 * y.least() >= x.size() * room && 2 * x.least() >= y.size() * room;
}
std::string constant(const Node& n) {
  const cln::cl_RA value = n.of_pi ? n.value * pi() : n.value;
  const double high = nearest(value);
  const double low = nearest(value - exact(high));
  const double above = nearest(cln::numerator(n.value));
  const double below = nearest(cln::denominator(n.value));
  if (exact(above) * cln::denominator(n.value) != n.value * exact(below) * exact(below)) {
    throw Refused("a constant of too many digits");
  }
  return std::string(n.of_pi ? "N::pi_times(" : "N::rational(") + hex(above) + ", " + hex(below) +
         ", " + hex(high) + ", " + hex(low) + ")";
}
std::string call(const std::string& function, const std::string& x, const std::string& y) {
  return function + "(" + x + ", " + y + ")";
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
  const auto number = [&](std::size_t i) { return as_number(p, n.of[i]); };
  const auto plain = [&](std::size_t i) { return as_plain(p, n.of[i]); };
  const auto range = [&](std::size_t i) { return p[n.of[i]].range; };
  switch (n.op) {
    case Op::exact_sum:
      if (range(0).least() >= range(1).size()) return call("N::fast_two_sum", plain(0), plain(1));
      if (range(1).least() >= range(0).size()) return call("N::fast_two_sum", plain(1), plain(0));
      return call("N::two_sum", plain(0), plain(1));
    case Op::whole_sum:
      return plain(0) + " + " + plain(1);
    case Op::exact_scale:
      return plain(0) + " * " + hex(n.factor);
    case Op::scale:
      return n.factor == -1 ? "-" + number(0) : call("scaled", number(0), hex(n.factor));
    case Op::sum:
      return number(0) + " + " + number(1);
    case Op::cancelling_sum:
      return call(is_near(range(0), range(1)) ? "near_sum" : "cancelling_sum", number(0),
                  number(1));
    case Op::product:
      return number(0) + " * " + number(1);
    case Op::exact_product:
      return call("times", number(0), plain(1));
    case Op::quotient:
      return call("quotient", p[n.of[0]].is_exact ? plain(0) : number(0), number(1));
    case Op::reciprocal_root:
      return "reciprocal_root(" + number(0) + ")";
    case Op::arc_tangent:
      return call("arc_tangent<Tier>", number(0), number(1));
    case Op::sine:
      return "of_" + p[n.of[0]].name + ".sine";
    case Op::cosine:
      return "of_" + p[n.of[0]].name + ".cosine";
    case Op::size:
      return "magnitude(" + number(0) + ")";
    case Op::nearest:
      return "N::nearest(leading(" + number(0) + ") / leading(" + number(1) + "))";
    case Op::step:
      return plain(0) + " + (N::times_sign_of(N::all(0.5), leading(" + number(1) + ")) - 0.5)";
    case Op::root:
    case Op::ceiling:
    case Op::input:
    case Op::constant:
      break;
  }
  throw Refused("nothing to print for " + n.name);
}
std::string sine_and_cosine(const Program& p, const Node& n) {
  const int x = n.of[0];
  const bool is_small = p[x].range.size() <= small_angle;
  return "const auto of_" + p[x].name + " = sine_cosine" +
         (is_small ? "_small<Tier>(" : "<Tier>(") + as_number(p, x) + ");";
}

std::string operation_counts(const Program& p) {
  static const std::map<Op, std::string> words{{Op::exact_sum, "sums of doubles"},
                                               {Op::sum, "sums"},
                                               {Op::cancelling_sum, "sums"},
                                               {Op::product, "products"},
                                               {Op::exact_product, "products by doubles"},
                                               {Op::quotient, "quotients"},
                                               {Op::reciprocal_root, "reciprocal roots"},
                                               {Op::arc_tangent, "arctangents"},
                                               {Op::sine, "sines"},
                                               {Op::cosine, "cosines"},
                                               {Op::nearest, "roundings to whole numbers"}};
  std::map<std::string, int> counts;
  for (const Node& n : p.nodes) {
    if (const auto found = words.find(n.op); found != words.end()) ++counts[found->second];
  }
  std::string r;
  for (const auto& [word, count] : counts) {
    r += (r.empty() ? "" : ", ") + word + ": " + std::to_string(count);
  }
  return r.empty() ? "none" : r;
}
}  // namespace codegen
