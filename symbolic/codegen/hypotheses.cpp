// Hypotheses and parameters against intervals.
#include <algorithm>

#include "codegen/emit.hpp"
#include "kernel/names.hpp"

namespace codegen {
namespace {

bool has_power(Expr e) { return e.name() == "pow" || std::ranges::any_of(e.args(), has_power); }
/// Whether a formula follows from the ranges; what has no range is not known, nor is a power, for
/// its base may be a little above 1.
bool holds(const Domain& d, Expr f) {
  const Exprs parts = f.args();
  if (has_power(f)) return false;
  if (f.op() == kernel::Op::And)
    return std::all_of(parts.begin(), parts.end(), [&](Expr g) { return holds(d, g); });
  if (f.op() != kernel::Op::Lt && f.op() != kernel::Op::Le && f.op() != kernel::Op::Eq)
    return false;
  try {
    const Interval l = d.range(f.arg(0)), r = d.range(f.arg(1));
    if (f.op() == kernel::Op::Lt) return l.high < r.low;
    if (f.op() == kernel::Op::Le) return l.high <= r.low;
    return l.is_point() && r.is_point() && l.low == r.low;
  } catch (const Refused&) {
    return false;
  }
}
std::string in_words(const Input& i) {
  Words others;
  for (Expr a : i.variable.args())
    if (a.op() != kernel::Op::Num) others.push_back(kernel::text(a));
  return i.name() + (others.empty() ? "" : "(" + joined(others, ", ") + ")");
}
bool is_at_unit(const kernel::Substitution& units, Expr parameter, Expr argument) {
  const auto unit = units.find(parameter);
  return unit != units.end() && unit->second == argument;
}
/// Each name at its own parameters, where it stands at their units.
Expr at_parameters(const kernel::Substitution& units, Expr e) {
  Exprs arguments = e.args();
  if (arguments.empty()) return e;
  for (Expr& a : arguments) a = at_parameters(units, a);
  const bool is_name = e.op() == kernel::Op::Fun && kernel::signature(e.name()) != nullptr;
  const Exprs parameters = is_name ? kernel::signature(e.name())->params : Exprs{};
  for (std::size_t k = 0; k < parameters.size(); ++k)
    if (is_at_unit(units, parameters[k], arguments[k])) arguments[k] = parameters[k];
  return kernel::with_args(e, arguments);
}
}  // namespace

std::string shown(const Quantity& q, Expr formula) {
  return kernel::text(at_parameters(q.units, formula));
}
Interval range_of(const Input& input, const Case& which, bool is_wide) {
  Interval r = is_wide ? input.wide_range : input.range;
  for (const Condition& w : which.where)
    if (w.name == input.variable.name()) r = meet(r, w.of(is_wide));
  return r;
}
std::string domain_in_words(const Quantity& q, const Case& c, bool is_exact) {
  Words parts;
  for (const Input& i : q.inputs) {
    const Interval r = range_of(i, c, false);
    const auto end = [&](double x) { return i.is_whole() ? kernel::digits(exact(x)) : hex(x); };
    const bool is_any = is_exact && !i.is_whole();
    const std::string any = r.low > 0 ? " > 0" : r.low < 0 ? " any" : " >= 0";
    const std::string from = i.may_be_zero ? " 0 or from " : " from ";
    parts.push_back(in_words(i) + (is_any ? any : from + end(r.low) + " to " + end(r.high)));
  }
  for (const Condition& g : c.guards)
    parts.push_back(g.name + " between " + hex(g.range.low) + " and " + hex(g.range.high));
  for (const std::string& d : c.divisors) parts.push_back(d + " above 2^23 times its error");
  return joined(parts, ", ");
}
std::vector<Output> outputs_of(const Case& c) {
  std::vector<Output> r;
  for (const Theorem& t : c.outputs) {
    const Expr left = t.conclusion().arg(0);
    r.push_back({identifier(left.name()), left.sort() == kernel::Sort::Int});
  }
  std::stable_partition(r.begin(), r.end(), [](const Output& x) { return x.is_whole; });
  return r;
}
void check_outputs(const Quantity& q) {
  if (q.cases.empty()) throw Refused(q.name + " has no case");
  for (const Case& c : q.cases)
    if (outputs_of(c) != outputs_of(q.cases[0]))
      throw Refused("the cases of " + q.name + " do not have the same outputs");
}
void check_hypotheses(const Domain& d, const Exprs& hypotheses, Expr conclusion) {
  for (Expr h : hypotheses)
    if (!holds(d, h))
      throw Refused("the intervals do not give " + kernel::text(h) + ", which is needed for " +
                    kernel::text(conclusion));
}
Expr head(const Domain& d, const Theorem& t) {
  const Expr f = t.conclusion();
  if (f.op() != kernel::Op::Eq || f.arg(0).op() != kernel::Op::Fun)
    throw Refused("not of the form name(params) = term: " + kernel::text(f));
  check_hypotheses(d, t.hypotheses(), f);
  return f.arg(0);
}
Expr checked_head(const Domain& d, const Theorem& t) {
  const Expr name = head(d, t);
  const Exprs parameters = kernel::signature(name.name())->params,
              own = kernel::signature(name.name())->variables;
  std::set<Expr> taken;  // no input stands in two places, or in that of another one
  for (std::size_t k = 0; k < name.size(); ++k) {
    const Expr a = name.arg(k);
    const bool has_own =
        k < own.size() && std::ranges::count(d.quantity.inputs, own[k], &Input::variable) > 0;
    const auto is_it = [&](const Input& input) {
      if (taken.contains(input.variable) || (has_own && input.variable != own[k])) return false;
      const Interval r = range_of(input, d.which, d.is_wide);
      const bool is_number = a.op() == kernel::Op::Num && r.is_point();
      return a == input.variable || (is_number && exact(r.low) == a.value());
    };
    const bool is_unit = k < parameters.size() && is_at_unit(d.quantity.units, parameters[k], a);
    const auto input = std::ranges::find_if(d.quantity.inputs, is_it);
    if (!is_unit && input != d.quantity.inputs.end()) taken.insert(input->variable);
    if (!is_unit && input == d.quantity.inputs.end())
      throw Refused(kernel::text(a) + " is no input here: " + kernel::text(t.conclusion()));
  }
  return name;
}
std::string name_of_recursion(const Theorem& t) {
  static const std::map<std::string, std::string> names{
      {"|- turn_0 = 1 and (0 <= j implies turn_(j + 1) = -turn_j)", "turn"},
      {"|- pow_0 = 1 and (0 <= j implies pow_(j + 1) = y*pow_j)", "pow"}};
  const auto found = names.find(kernel::text(t));  // no two theorems have one text
  if (found == names.end()) throw Refused("no recursion of pow or turn: " + kernel::text(t));
  return found->second;
}
}  // namespace codegen
