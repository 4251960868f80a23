// Forms: algebra, absorption, printing.
#include <algorithm>

#include "codegen/errors.hpp"

namespace codegen {
namespace {
constexpr double no_worse = 32;  // a term may be that much larger than the one that takes it:
                                 // fewer operations at run time against a wider bound
}  // namespace

Sizes joined(Sizes x, const Sizes& y) {
  x.insert(x.end(), y.begin(), y.end());
  std::sort(x.begin(), x.end());
  return x;
}
void add(Form& f, const Form& x, double k, const Sizes& sizes) {
  for (const auto& [s, c] : x) {
    if (!(c * k >= 0)) throw Refused("an error bound that is negative or not a number");
    if (c * k > 0) f[joined(s, sizes)] += c * k;
  }
}

bool Absorber::is_below(int part, int whole) const {
  if (part == whole) return true;
  for (const auto& [small, large] : facts)
    if (small == part && (large == whole || is_below(large, whole))) return true;
  const Node& n = p[whole];
  return n.op == Op::sum && (is_below(part, n.of[0]) || is_below(part, n.of[1]) ||
                             is_difference(part, n.of[0], n.of[1]));
}
/// Whether a node is x - y or y - x.
bool Absorber::is_difference(int node, int x, int y) const {
  const Node& n = p[node];
  if (n.op != Op::cancelling_sum) return false;
  const auto is_minus = [&](int k, int of) {
    return p[k].op == Op::scale && p[k].factor == -1 && p[k].of[0] == of;
  };
  const auto is_it = [&](int a, int b) {
    return (n.of[0] == a && is_minus(n.of[1], b)) || (n.of[1] == a && is_minus(n.of[0], b));
  };
  return is_it(x, y) || is_it(y, x);
}
/// What |x| is at most in |y|: sizes that y alone has need one of x's that is below them.
std::optional<double> Absorber::share(const Sizes& x, const Sizes& y) const {
  Sizes mine, yours;
  std::set_difference(x.begin(), x.end(), y.begin(), y.end(), std::back_inserter(mine));
  std::set_difference(y.begin(), y.end(), x.begin(), x.end(), std::back_inserter(yours));
  for (int v : yours) {
    const auto m = std::find_if(mine.begin(), mine.end(), [&](int w) { return is_below(w, v); });
    if (m == mine.end()) return {};
    mine.erase(m);
  }
  double by = 1;
  for (int w : mine) by *= most(w);
  return by > small_size ? std::nullopt : std::optional(by);
}
const Sizes* Absorber::taker(const Form& f, const Sizes& x, double k, const Sizes& but) const {
  for (const auto& [y, of_y] : f) {
    if (y == but) continue;
    const std::optional<double> by = share(x, y);
    if (by && *by * k <= no_worse * of_y) return &y;
  }
  return nullptr;
}
void Absorber::take(Form& f, const Taking& t) const {
  const auto taken = f.extract(t.term);
  if (taken.empty()) return;
  for (const auto& [part, by, into] : t.parts) {
    const std::optional<double> of_part = share(part, into);
    if (!of_part) throw Refused("a term that is taken into a smaller one");
    f[into] += *of_part * by * taken.mapped() * and_more;
  }
}
std::optional<Taking> Absorber::next(const Form& f) const {
  for (const auto& [x, k] : f) {
    if (const Sizes* y = taker(f, x, k, x)) return Taking{x, {{x, 1, *y}}};
    for (int v : x) {
      const Node& n = p[v];
      if (n.op != Op::sum && n.op != Op::cancelling_sum) continue;
      Sizes rest = x;
      rest.erase(std::find(rest.begin(), rest.end(), v));
      Taking t{x, {}};
      for (int o : n.of) {
        const auto [part, by] = size_of(p, o, {});
        const Sizes all = joined(rest, part);
        if (const Sizes* y = taker(f, all, k * by, x)) t.parts.push_back({all, by, *y});
      }
      if (t.parts.size() == 2) return t;
    }
  }
  return {};
}
Form Absorber::absorbed(Form f) {
  if (at == plan_.size()) {
    plan_.emplace_back();
    while (const std::optional<Taking> t = next(f)) {
      plan_.back().push_back(*t);
      take(f, *t);
    }
  } else {
    for (const Taking& t : plan_[at]) take(f, t);
  }
  ++at;
  return f;
}
Form Absorber::constant(const Form& f, double largest) const {
  Form r;
  for (const auto& [sizes, k] : f) {
    double by = k;
    Sizes left;
    for (int v : sizes)
      if (most(v) > largest)
        left.push_back(v);
      else
        by *= most(v);
    r[left] += by * and_more;
  }
  return r;
}

std::pair<Sizes, double> size_of(const Program& p, int node, const std::set<int>& spread) {
  const Node& n = p[node];
  if (n.op == Op::constant) return {{}, n.range.size()};
  const bool is_spread = spread.count(node) > 0;
  if (n.op != Op::scale && n.op != Op::size && !is_spread) return {{node}, 1};
  const auto [s, by] = size_of(p, n.of[0], spread);
  if (!is_spread) return {s, by * std::fabs(n.factor)};
  const auto [t, more] = size_of(p, n.of[1], spread);
  return {joined(s, t), by * more * and_more};
}

std::string in_words(const Program& p, const Form& f) {
  std::string text;
  for (const auto& [sizes, k] : f) {
    text += (text.empty() ? "" : " + ") + as_power_of_2(k);
    for (int v : sizes) text += " |" + p[v].name + "|";
  }
  return text.empty() ? "0" : text;
}
std::string in_code(const Program& p, const Form& f, std::vector<double>& constants) {
  if (f.empty()) return "";
  if (f.size() == 1 && f.begin()->first.empty()) {
    constants.push_back(f.begin()->second);
    return "E[" + std::to_string(constants.size() - 1) + "]";
  }
  std::map<int, int> uses;
  for (const auto& [sizes, k] : f)
    for (int v : std::set(sizes.begin(), sizes.end())) ++uses[v];
  const int best = std::ranges::max_element(uses, {}, &std::pair<const int, int>::second)->first;
  Form with, without;
  for (const auto& [sizes, k] : f) {
    Sizes s = sizes;
    const auto found = std::find(s.begin(), s.end(), best);
    const bool has_it = found != s.end();
    if (has_it) s.erase(found);
    (has_it ? with : without)[s] = k;
  }
  const std::string inner = in_code(p, with, constants);
  const std::string size = p[best].is_exact ? "N::magnitude_of(" : "size_of(";
  const std::string product =
      size + p[best].name + ") * " + (with.size() > 1 ? "(" + inner + ")" : inner);
  return without.empty() ? product : product + " + " + in_code(p, without, constants);
}
}  // namespace codegen
