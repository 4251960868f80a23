// Reads theorems: definitions and outputs into nodes, facts and guards into ranges.
#include "codegen/lower.hpp"

#include <algorithm>

namespace codegen {
namespace {

class Reader : public Builder {
public:
  Reader(const Quantity& quantity, const Case& which, Numbers of)
      : Builder(of), q(quantity), c(which) {
    for (const Input& i : q.inputs) {
      const std::string name = i.variable.name();
      Interval range = codegen::range_of(i, c, domain.is_wide);
      if (numbers == Numbers::field && !i.is_whole())  // of which no more is said, and none tested
        range = {range.low > 0 ? 0x1p-1074 : range.low < 0 ? -infinity : 0, infinity};
      const bool is_variable = i.variable.op() == kernel::Op::Var;
      if (!is_plain() && !(range.low >= 0)) throw Refused(name + " may be negative");
      if (!is_plain() && !is_variable) throw Refused(name + " is no variable");
      if (i.may_be_zero && (is_plain() || q.has_arrays))
        throw Refused(name + " may be 0 in evaluators of single numbers alone");
      nodes[i.variable] = input(i.name(), i.is_whole(), range, i.may_be_zero);
    }
    for (const Theorem& t : q.recursions) recursions.insert(name_of_recursion(t));
    if (is_plain() && !c.divisors.empty()) throw Refused("divisors are tested in evaluators alone");
    for (const Condition& w : c.where) {
      const auto is_it = [&](const Input& i) { return i.variable.name() == w.name; };
      if (std::ranges::none_of(q.inputs, is_it))
        throw Refused("a condition on " + w.name + ", which is no input");
    }
  }
  void define(const Theorem& t) {
    const Expr name = checked_head(domain, t);
    if (kernel::is_matrix(name)) return define_entries(t);
    const std::string formula = shown(q, t.conclusion());
    const int k = named_node(name, t.conclusion().arg(1), identifier(name.name()), formula);
    named.insert(name.name());
    // Guards first: a fact's hypotheses may rest on them.
    for (const Condition& g : c.guards) {
      if (g.name != name.name()) continue;
      narrow(k, g.of(domain.is_wide));
      program.results.push_back({Result::guard, g.name, k});
    }
    for (const std::string& d : c.divisors) {
      if (d != name.name()) continue;
      // What is above 2^23 times the errors of pairs is above that: the analysis sees to it.
      narrow(k, {domain.is_wide ? 0x1p-500 : 0x1p-100, program[k].range.high});
      program.results.push_back({Result::divisor, d, k});
    }
    for (const Fact& f : c.facts) use_fact(f);
  }
  void output(const Theorem& t) {
    const Expr left = checked_head(domain, t);
    const bool is_whole = left.sort() == kernel::Sort::Int;
    if (is_plain()) {
      if (named.count(left.name()) == 0) define(t);
    } else {
      nodes[left] = build(t.conclusion().arg(1));
      const Node& n = program[nodes[left]];
      if (is_whole && !n.is_whole) throw Refused(left.name() + " is not known to be whole");
      if (is_whole && !domain.is_wide && n.range.size() > 0x1p51)
        throw Refused(left.name() + " may be above 2^51");
    }
    for (Expr e : kernel::is_matrix(left) ? kernel::entries(left) : Exprs{left})
      program.results.push_back(
          {is_whole ? Result::whole : Result::real, identifier(left.name()), nodes.at(e)});
  }
  void check_all_used() const {
    const auto check_named = [&](const std::string& what, const std::string& name) {
      if (named.count(name) == 0) throw Refused(what + name + ", which has no definition");
    };
    for (const Condition& g : c.guards) check_named("a guard on ", g.name);
    for (const std::string& d : c.divisors) check_named("a divisor ", d);
    for (const Fact& f : c.facts)
      if (used.count(f.formula) == 0)
        throw Refused("a fact that no definition is about: " + kernel::text(f.formula));
  }

private:
  const Quantity& q;
  const Case& c;
  Domain domain{q, c, numbers == Numbers::wide, [this](Expr e) { return range(e); }};
  std::set<std::string> named;
  std::set<Expr> used;

  int named_node(Expr left, Expr right, const std::string& name, const std::string& formula) {
    const std::string calls = q.doubling ? call_doubling(*q.doubling, right, *this) : "";
    if (!calls.empty()) program.doubling = emit_doubling(*q.doubling, domain);
    program.calls += calls;
    const int k = build(right);
    nodes[left] = k;
    Node& n = program[k];
    if (n.name.empty() && n.op != Op::constant) {
      n.name = name;
      n.formula = formula;
    }
    return k;
  }
  /// The formula stands at the first entry.
  void define_entries(const Theorem& t) {
    const Expr name = t.conclusion().arg(0);
    const Exprs left = kernel::entries(name);
    const Exprs right = kernel::entries(t.conclusion().arg(1));
    const std::size_t columns = std::size_t(name.cols());
    for (std::size_t k = 0; k < left.size(); ++k) {
      const std::string place = std::to_string(k / columns + 1) + std::to_string(k % columns + 1);
      named_node(left[k], right[k], name.name() + "_" + place,
                 k == 0 ? shown(q, t.conclusion()) : "");
    }
  }
  bool is_known(Expr e) const { return e.op() == kernel::Op::Num || nodes.count(e) > 0; }
  /// p <= q or p^2 = q, once both are known: a range's end, the larger value, a square for atan.
  void use_fact(const Fact& t) {
    const Expr f = t.formula;
    const bool is_square =
        f.op() == kernel::Op::Eq && f.arg(0).op() == kernel::Op::Pow && f.arg(0).exponent() == 2;
    if (!is_square && f.op() != kernel::Op::Le && f.op() != kernel::Op::Lt)
      throw Refused("not of the form p <= q or p^2 = q: " + kernel::text(f));
    const Expr p = is_square ? f.arg(0).arg(0) : f.arg(0);
    if (used.count(f) > 0 || !is_known(p) || !is_known(f.arg(1))) return;
    check_hypotheses(domain, t.hypotheses, f);
    used.insert(f);
    const int small = build(p), large = build(f.arg(1));
    const Interval low = program[small].range, high = program[large].range;
    if (is_square) {
      squares[small] = large;
      const Interval size = root(high);
      return narrow(small, low.low >= 0 ? size : Interval{-size.high, size.high});
    }
    narrow(large, {low.low, high.high});
    narrow(small, {low.low, high.high});
    if (program[small].op == Op::constant || program[large].op == Op::constant) return;
    if (!(low.low >= 0)) throw Refused("of unknown sign: " + kernel::text(p));
    program.facts.push_back({small, large, !t.of_computed.empty()});
  }
};
}  // namespace

std::string identifier(const std::string& name) {
  return name.ends_with("'") ? name.substr(0, name.size() - 1) + "_prime" : name;
}
std::string Input::name() const { return identifier(variable.name()); }

Program lower(const Quantity& quantity, const Case& which, Numbers numbers) try {
  Reader reader(quantity, which, numbers);
  for (const Theorem& t : which.definitions) reader.define(t);
  for (const Theorem& t : which.outputs) reader.output(t);
  reader.check_all_used();
  std::ranges::stable_sort(reader.program.results, {}, &Result::kind);
  return named(in_stages(without_dead_code(reader.program)));
} catch (const Refused& why) {
  throw Refused(quantity.name + ", " + which.name + ": " + why.what());
}
}  // namespace codegen
