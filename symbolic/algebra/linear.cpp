#include <algorithm>

#include "algebra/tactics.hpp"

namespace algebra {
namespace {
using cln::cl_RA;

/// p > 0 or p >= 0 with the combination of rows that it is: 0 is the negated goal, i fact i - 1.
struct Row {
  Polynomial p;
  std::vector<cl_RA> of;
  bool strict;

  cl_RA coefficient(const Monomial& m) const {
    const auto it = p.find(m);
    return it == p.end() ? cl_RA(0) : it->second;
  }
  bool is_constant() const {
    return std::all_of(p.begin(), p.end(), [](const auto& term) { return term.first.empty(); });
  }
};
Row combined(const Row& a, const cl_RA& x, const Row& b, const cl_RA& y) {
  Row sum{scaled(a.p, x) + scaled(b.p, y), a.of, a.strict || b.strict};
  for (std::size_t i = 0; i < sum.of.size(); ++i) sum.of[i] = x * a.of[i] + y * b.of[i];
  return sum;
}

/// Takes the unknown that each equation leads with out of all other rows.
void eliminate_equations(std::vector<Row>& equations, std::vector<Row>& inequalities) {
  for (std::size_t i = 0; i < equations.size(); ++i) {
    const Row e = equations[i];
    const auto lead = std::ranges::find_if(e.p, [](const auto& t) { return !t.first.empty(); });
    if (lead == e.p.end()) continue;
    const auto take_out = [&](Row& row) {
      const cl_RA q = row.coefficient(lead->first);
      if (q == 0) return;
      const bool strict = row.strict;
      row = combined(row, 1, e, -q / lead->second);
      row.strict = strict;
    };
    for (Row& row : inequalities) take_out(row);
    for (std::size_t j = 0; j < equations.size(); ++j)
      if (j != i) take_out(equations[j]);
  }
}
/// One unknown less, the one that makes the fewest new rows; false where there is none left.
bool eliminate_unknown(std::vector<Row>& rows) {
  std::map<Monomial, std::pair<std::size_t, std::size_t>> signs;
  for (const Row& row : rows)
    for (const auto& [m, q] : row.p)
      if (!m.empty()) ++(q > 0 ? signs[m].first : signs[m].second);
  if (signs.empty()) return false;
  const auto product = [](const auto& entry) { return entry.second.first * entry.second.second; };
  const auto best = std::ranges::min_element(signs, {}, product);
  const Monomial unknown = best->first;
  std::vector<Row> rest, above, below;
  for (Row& row : rows) {
    const cl_RA q = row.coefficient(unknown);
    (q > 0 ? above : q < 0 ? below : rest).push_back(std::move(row));
  }
  for (const Row& a : above)
    for (const Row& b : below)
      rest.push_back(combined(a, 1 / a.coefficient(unknown), b, -1 / b.coefficient(unknown)));
  rows = std::move(rest);
  return true;
}
/// A constant row that is false: of[0] (-D) + sum of facts = c, so D = (sum - c)/of[0]; with of[0]
/// = 0 the facts contradict each other.
Theorem from_contradiction(const Row& row, Expr goal, const Theorems& facts) {
  const bool absurd = row.of[0] == 0;
  const cl_RA scale = absurd ? cl_RA(1) : row.of[0];
  Certificate certificate;
  for (std::size_t i = 1; i < row.of.size(); ++i) {
    if (row.of[i] == 0) continue;
    const cl_RA q = row.of[i] / scale;
    if (facts[i - 1].conclusion().op() == Op::Eq)
      certificate.equations.emplace_back(Expr(q), facts[i - 1]);
    else
      certificate.products.push_back({q, {facts[i - 1]}, {}});
  }
  const cl_RA c = row.coefficient({});
  if (c != 0) certificate.products.push_back({-c / scale, {}, {}});
  if (!absurd) return arithmetic(goal, certificate);
  return tautology(goal, {arithmetic(lt(0, 0), certificate), never()});
}
using Proof = std::optional<Theorem>;

Proof contradicted(Expr goal, const Theorems& facts) {
  const std::size_t count = facts.size() + 1;
  std::vector<Row> rows, equations;
  const auto unit = [&](std::size_t i) {
    std::vector<cl_RA> v(count, 0);
    v[i] = 1;
    return v;
  };
  rows.push_back({polynomial(goal.arg(0) - goal.arg(1)), unit(0), goal.op() == Op::Le});
  for (std::size_t i = 1; i < count; ++i) {
    const Theorem& fact = facts[i - 1];
    const Op op = fact.conclusion().op();
    (op == Op::Eq ? equations : rows).push_back({polynomial(gap(fact)), unit(i), op == Op::Lt});
  }
  eliminate_equations(equations, rows);
  constexpr std::size_t most_rows = 3000;
  do {
    for (const Row& row : rows) {
      if (!row.is_constant()) continue;
      const cl_RA c = row.coefficient({});
      if (c < 0 || (c == 0 && row.strict)) return from_contradiction(row, goal, facts);
    }
  } while (rows.size() < most_rows && eliminate_unknown(rows));
  return {};
}
bool of_integers(Expr relation) {
  return relation.arg(0).sort() == Sort::Int && relation.arg(1).sort() == Sort::Int;
}
/// Integers i <= j also from i - 1 < j.
Proof inequality(Expr goal, const Theorems& facts) {
  if (const Proof p = contradicted(goal, facts)) return p;
  if (goal.op() != Op::Le || !of_integers(goal)) return {};
  const Proof less = contradicted(lt(goal.arg(0) - 1, goal.arg(1)), facts);
  if (!less) return {};
  return restate(goal, next_integer(*less));
}
Proof equality(Expr goal, const Theorems& facts) {
  const Expr l = goal.arg(0), r = goal.arg(1);
  const Proof above = inequality(le(l, r), facts);
  if (!above) return {};
  const auto certificate = above->step().certificate;
  if (certificate && certificate->products.empty() && above->step().rule == "arithmetic")
    return arithmetic(goal, *certificate);
  const Proof below = inequality(le(r, l), facts);
  if (!below) return {};
  return follows(goal, {*above, *below});
}
Proof relation(Expr goal, const Theorems& facts) {
  if (goal.op() == Op::Eq) return equality(goal, facts);
  if (goal.op() != Op::Not) return inequality(goal, facts);
  const Expr equal = goal.arg(0);
  for (const Expr& less : {lt(equal.arg(0), equal.arg(1)), lt(equal.arg(1), equal.arg(0))})
    if (const Proof p = inequality(less, facts))
      if (const Proof absurd = contradicted(lt(0, 0), {*p, assume(equal)}))
        return refute(equal, *absurd);
  return {};
}

/// What is true of the monomials that occur: d/d = 1, squares of roots, axioms.
class Occurring {
public:
  Occurring(Expr goal, const Theorems& given) : facts(given) {
    look_at(goal);
    for (const Theorem& t : given) add(t, false);
  }
  void add(const Theorem& fact, bool is_new = true) {
    if (is_new) facts.push_back(fact);
    if (fact.conclusion().op() == Op::Lt && of_integers(fact.conclusion()))
      facts.push_back(next_integer(fact));
    look_at(gap(fact));
  }
  void look_at(Expr term) {
    for (const auto& [monomial, q] : polynomial(term)) {
      if (!seen.insert(monomial).second) continue;
      for (const auto& [a, k] : monomial) of_atom(monomial, a, k);
    }
  }
  bool shares_an_atom(Expr term) const {
    for (const auto& [monomial, q] : polynomial(term))
      for (const auto& [a, k] : monomial)
        if (atoms.count(a)) return true;
    return false;
  }
  Theorems facts;

private:
  void of_atom(const Monomial& monomial, Expr a, int k) {
    const std::string f = a.op() == Op::Fun ? a.name() : "";
    if (f == "inv") quotient(monomial, a);
    if (f == "sqrt" && k > 1) square(monomial, a);
    if (!atoms.insert(a).second) return;
    if (f == "pi") facts.push_back(axiom("pi positive"));
    if (f == "ceil" || f == "atan")
      for (const Theorem& t :
           parts({at(f == "ceil" ? "ceiling" : "atan range", {{real("x"), a.arg(0)}})}))
        add(t);
    for (const auto& [name, angle] : {std::pair{" 0", Expr(0)}, {" pi", pi()}, {" pi/2", pi() / 2}})
      if ((f == "cos" || f == "sin") && canonical(a.arg(0)) == canonical(angle))
        facts.push_back(axiom(f + name));
  }
  /// d/d = 1, times what is left of the monomial
  void quotient(const Monomial& monomial, Expr inverse) {
    const Polynomial& divisor = polynomial(inverse.arg(0));
    for (auto lead = divisor.rbegin(); lead != divisor.rend(); ++lead) {
      const auto rest = divided(monomial, polynomial(expression({*lead}) * inverse).begin()->first);
      if (lead->first.empty() || !rest) continue;
      const Expr cofactor = expression({{*rest, 1}});
      if (const Proof d = sign_of(inverse.arg(0), facts))
        add(equation(cofactor * inverse.arg(0) * inverse, cofactor, {*d}));
      return;
    }
  }
  void square(const Monomial& monomial, Expr root) {
    const Expr cofactor = expression({{*divided(monomial, {{root, 2}}), 1}});
    if (const Proof p = sign_of(root.arg(0), facts, false))
      add(equation(cofactor * power(root, 2), cofactor * root.arg(0), {root_squared(*p)}));
  }
  std::set<Monomial> seen;
  std::set<Expr> atoms;
};

/// How deep `linear` has called itself by way of signs.
struct Deeper {
  static inline int depth = 0;
  Deeper() { ++depth; }
  ~Deeper() { --depth; }
};
}  // namespace

Proof combination(Expr equation, const Theorems& equations) {
  return equality(equation, equations);
}
Proof linear_if(Expr goal, const Theorems& given_facts) {
  Theorems facts;
  for (const Theorem& t : parts(given_facts))
    if (is_relation(t.conclusion())) facts.push_back(t);
  if (const Proof p = relation(goal, facts)) return p;
  constexpr int deepest = 3;
  if (Deeper::depth >= deepest) return {};
  const Deeper deeper;
  Occurring occurring(gap(goal), facts);
  if (const Proof p = relation(goal, occurring.facts)) return p;
  const Theorems all_known = known();
  std::vector<bool> taken(all_known.size(), false);
  for (int round = 0; round < 2; ++round) {
    for (std::size_t i = 0; i < taken.size(); ++i) {
      const Theorem& t = all_known[i];
      if (taken[i] || !is_relation(t.conclusion()) || !occurring.shares_an_atom(gap(t))) continue;
      taken[i] = true;
      occurring.add(t);
    }
    if (const Proof p = relation(goal, occurring.facts)) return p;
  }
  return {};
}
Theorem linear(Expr goal, const Theorems& facts) {
  if (const Proof all = by_parts(goal, [&](Expr g) { return linear(g, facts); })) return *all;
  if (goal.op() == Op::Imp)
    return discharge(goal.arg(0), linear(goal.arg(1), facts + Theorems{assume(goal.arg(0))}));
  if (goal.op() == Op::Iff) {
    const Expr f = goal.arg(0), g = goal.arg(1);
    return tautology(goal, {linear(imp(f, g), facts), linear(imp(g, f), facts)});
  }
  if (const Proof p = linear_if(goal, facts)) return *p;
  if (goal.op() == Op::Lt || goal.op() == Op::Le)
    if (const Proof sign = sign_of(gap(goal), facts, goal.op() == Op::Lt))
      return arithmetic(goal, {.products = {{1, {*sign}}}});
  refuse("no linear combination of the facts gives " + text(goal));
}
Theorem scaled(Expr goal, Expr relation, Expr factor, const Theorems& facts) {
  return linear(goal, facts + Theorems{times(linear(relation, facts), positive(factor, facts))});
}
Theorem same_sign(Expr equivalence, Expr factor, const Theorems& facts) {
  const Expr l = equivalence.arg(0), r = equivalence.arg(1);
  const auto negated = [](Expr f) {
    return f.op() == Op::Lt ? le(f.arg(1), f.arg(0)) : lt(f.arg(1), f.arg(0));
  };
  const auto carried = [&](Expr from, Expr to) {
    return given(from,
                 [&](const Theorem& t) { return scaled(to, from, factor, facts + Theorems{t}); });
  };
  return tautology(equivalence, {carried(r, l), carried(negated(r), negated(l))});
}
}  // namespace algebra
