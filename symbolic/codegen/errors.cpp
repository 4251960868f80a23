// The rules: how errors of operands become the error of a result.
#include "codegen/errors.hpp"

#include <algorithm>

#include "codegen/lower.hpp"

namespace codegen {
namespace {
/// Ranges and facts are of exact values; computed ones are within this, relatively: `and_more`.
constexpr double close = 0x1p-22;
/// What has no relative bound but is tested to be above this many times its error may divide: its
/// error is below `close` of it, then, with half of that to spare for the test's own roundings.
constexpr double clear = 2 / close;

/// Thirteen bits are enough of a bound: up.
Form shortened(Form f) {
  for (auto& [sizes, c] : f) {
    const int unit = c > 0 ? std::ilogb(c) - 12 : 0;
    c = std::ldexp(std::ceil(std::ldexp(c, -unit)), unit);
  }
  return f;
}

class Analyst {
public:
  Analyst(const Program& program, const NumberType& type, Plan& plan)
      : p(program), t(type), absorber(program, plan) {}

  /// A node's error, after those of its operands; a line for a reader, where it may have one.
  std::string node(int k) {
    const Node& n = p[k];
    for (int o : n.of)
      if (n.op != Op::cancelling_sum) check_no_spill(o);
    Computed here;
    rule(k, here, here.off);
    if (!(here.loose >= 0 && here.loose <= loosest))
      throw Refused("the low part of " + n.name + " is loose");
    here.off = absorber.absorbed(here.off);
    computed.push_back(here);
    check_close(k);
    for (const SizeFact& fact : p.facts)
      if (std::max(fact.small, fact.large) == k) use_fact(fact);
    if (n.is_exact || n.name.starts_with('-')) return "";
    const std::string low = t.is_pair() ? "; low part " + as_power_of_2(here.loose) : "";
    return n.name + ": off by " + in_words(p, here.off) + low;
  }
  Form result(const Result& r) {
    const int k = r.node;
    if (r.kind == Result::whole || r.kind == Result::guard) return {};
    check_no_spill(k);
    Form f = error(k);
    if (r.kind == Result::sign) {
      // The sign is that of the high part; of one part, a unit is allowed for the comparison.
      add_loss(f, t.is_pair() ? low(k) : t.u, k);
    } else if (r.kind == Result::real && f.empty() && t.is_pair() && low(k) <= t.u) {
      f[size_of(p, k, spread).first] = 0;  // other number types have a term there
    } else if (r.kind == Result::real) {
      add_loss(f, t.rounding_test(low(k)), k);
    }
    // Roundings of the bound at run time, and high parts for values: below 2^-38 for ten factors.
    for (auto& [sizes, c] : f) c *= (r.kind == Result::divisor ? clear : 1) * and_more;
    const auto least = f.find({});
    if (r.kind == Result::divisor && (least == f.end() || least->second < p[k].range.low))
      throw Refused(p[k].name + " may be below its range and pass the test of a divisor");
    return shortened(absorber.absorbed(f));
  }

private:
  /// What is known of a computed value.
  struct Computed {
    Form off;                // |computed - exact| is at most that
    double loose = 0;        // its low part is at most that much of its high part
    double spill = 0;        // and so much more; sums that cancel end it
    bool is_tested = false;  // close to the exact value by the test of a divisor, not by a bound
  };
  const Program& p;
  const NumberType& t;
  Absorber absorber;
  std::vector<Computed> computed;
  std::set<int> spread;  // products of two without a relative bound: sized as their factors are

  const Computed& operator[](int k) const { return computed[std::size_t(k)]; }
  const Form& error(int k) const { return (*this)[k].off; }
  double low(int k) const { return (*this)[k].loose; }
  void check_no_spill(int k) const {
    if ((*this)[k].spill > 0) throw Refused("the low part of " + p[k].name + " may be large");
  }

  void add_sized(Form& f, const Form& x, int node, double k = 1) const {
    const auto [sizes, by] = size_of(p, node, spread);
    add(f, x, k * by, sizes);
  }
  void add_loss(Form& f, double loss, int node) const { add_sized(f, {{{}, loss}}, node); }

  /// The error of k against the size of a value that is known to be as large as all its terms'.
  std::optional<double> of_parts(int k, int whole) const {
    double sum = 0;
    for (const auto& [sizes, c] : error(k)) {
      if (sizes.size() != 1 || !absorber.is_below(sizes[0], whole)) return {};
      sum += c;
    }
    return sum;
  }
  /// |computed - exact| / |computed|, where that is bounded.
  std::optional<double> relative(int k) const {
    const Form& f = error(k);
    if (f.empty()) return 0.0;
    const auto [sizes, by] = size_of(p, k, spread);
    if (f.size() == 1 && f.begin()->first == sizes && by > 0) return f.begin()->second / by;
    if (const std::optional<double> r = of_parts(k, k)) return *r * and_more;
    const Form c = absorber.constant(f);
    if (c.size() != 1 || !c.begin()->first.empty()) return {};
    const double from_least = c.begin()->second / p[k].range.least() * and_more;
    return from_least <= close ? std::optional(from_least) : std::nullopt;
  }
  double needed(int k) const {
    const std::optional<double> r = relative(k);
    if (!r) throw Refused("no relative error bound of " + p[k].name + ", which is needed");
    return *r;
  }
  void check_close(int k) const {
    const Form& f = error(k);
    if (f.empty() || (*this)[k].is_tested) return;
    const double off = relative(k).value_or(absorber.bounded(f) / p[k].range.size());
    if (!(off <= close)) throw Refused(p[k].name + " is too far off for its range to be used");
  }
  /// |small| <= |large| holds of computed values, nearly, if both are close in terms of |large|.
  void use_fact(const SizeFact& fact) {
    for (int k : {fact.small, fact.large}) {
      if (fact.is_of_computed) break;
      std::optional<double> off = relative(k);
      if (!off) off = of_parts(k, fact.large);
      if (!off || !(*off <= close))
        throw Refused("a fact is not known of computed values of " + p[k].name);
    }
    absorber.know(fact.small, fact.large);
  }

  void rule(int k, Computed& here, Form& f) {
    const Node& n = p[k];
    const int x = n.of.empty() ? -1 : n.of[0], y = n.of.size() < 2 ? -1 : n.of[1];
    const auto take = [&](Loss l) {
      add_loss(f, l.loss, k);
      here.loose = l.loose;
    };
    switch (n.op) {
      case Op::input:
      case Op::nearest:  // what is counted is what its sign tests
      case Op::step:
      case Op::whole_sum:
      case Op::turn:
        break;
      case Op::power:
        take(t.power(needed(x), p[y].range.high));
        add(f, {{{}, least_power(!t.is_pair()) * 2}});
        break;
      case Op::constant:
        if (!n.is_exact) take(t.constant(lost(n)));
        break;
      case Op::root:
      case Op::ceiling:
        throw Refused("no error bound of an operation of plain forms");
      case Op::exact_sum:
        take(t.exact_sum());
        break;
      case Op::scale:
      case Op::size:
        add(f, error(x), std::fabs(n.factor));
        here.loose = low(x);
        break;
      case Op::sum:
        sum(f, k, x, y);
        take(t.sum(low(x), low(y)));
        break;
      case Op::cancelling_sum: {
        const NumberType::Cancelling c = t.cancelling_sum(low(x), low(y));
        for (int o : {x, y}) {
          const double of_operand =
              (o == x ? c.of_x : c.of_y) + c.of_result;  // |x + y| <= |x| + |y|
          add(f, error(o));
          if (p[o].op == Op::cosine) {  // its high part is no size
            add(f, {{{}, of_operand * absorber.most(o) + 3 * t.u * (*this)[o].spill}}, and_more);
          } else {
            add_loss(f, of_operand, o);
          }
        }
        if (p[x].op == Op::constant || p[y].op == Op::constant) f = absorber.constant(f);
        here.loose = c.loose;
        break;
      }
      case Op::product:
      case Op::exact_product:
        here.is_tested = product(f, k, x, y);
        take(n.op == Op::product ? t.product(low(x), low(y)) : t.product(low(x)));
        break;
      case Op::quotient:
        here.is_tested = quotient(f, k, x, y);
        take(t.quotient(low(x), low(y)));
        break;
      case Op::reciprocal_root:
        add_loss(f, needed(x) * 0.5 * and_more, k);
        take(t.reciprocal_root(low(x)));
        break;
      case Op::arc_tangent:  // |t atan'(t)/atan(t)| <= 1
        add_loss(f, needed(x) * and_more, k);
        take(t.arc_tangent(low(x), low(y), needed(y)));
        break;
      case Op::sine:
      case Op::cosine: {
        const bool is_small = p[x].range.size() <= small_angle;
        const NumberType::SineCosine of =
            is_small ? t.small_sine_cosine(low(x)) : t.sine_cosine(low(x));
        Form angle = error(x);
        add_loss(angle, of.angle, x);
        sine_or_cosine(f, k, x, angle, of.angle);
        take(n.op == Op::sine ? of.sine : of.cosine);
        if (n.op == Op::cosine && of.spill > 0) {
          add(f, {{{}, of.absolute}});
          here.spill = of.spill;
        }
        break;
      }
    }
  }
  /// What high and low part of a constant lack.
  static double lost(const Node& n) {
    const cln::cl_RA value = n.number(), rest = value - exact(nearest(value));
    const cln::cl_RA off = cln::abs((rest - exact(nearest(rest))) / value);
    return upper(off) + (n.of_pi ? 0x1p-400 : 0);
  }
  /// Of one sign: the larger relative bound.
  void sum(Form& f, int k, int x, int y) const {
    const std::optional<double> of_x = relative(x), of_y = relative(y);
    if (of_x && of_y) {
      add_loss(f, std::max(*of_x, *of_y), k);
    } else {
      add(f, error(x));
      add(f, error(y));
    }
  }
  /// Whether it is close to the exact product because a factor is, which is tested.
  bool product(Form& f, int k, int x, int y) {
    const std::optional<double> of_x = relative(x), of_y = relative(y);
    if (of_x && of_y) {
      add_loss(f, *of_x + *of_y + *of_x * *of_y, k);
      return false;
    }
    if (!p[y].is_exact) spread.insert(k);
    add_sized(f, error(x), y);
    add_sized(f, error(y), x);
    for (const auto& [sizes, c] : error(x)) add(f, error(y), c, sizes);
    return (*this)[x].is_tested || (*this)[y].is_tested;
  }
  /// Whether it is close to the exact quotient because the divisor is, which is tested. Then
  /// q = c/y, c a constant, y off by E < |y| 2^-23: |c/(y + E) - c/y| is |q| E/|y|, y exact, so at
  /// most E |q|^2/|c| and a bit, q computed.
  bool quotient(Form& f, int k, int x, int y) const {
    if (p.has(Result::divisor, y)) {
      if (p[x].op != Op::constant || !p[x].is_exact)
        throw Refused("a quotient of no constant by " + p[y].name + ", which is tested");
      add(f, error(y), and_more / p[x].range.size(), {k, k});
      return true;
    }
    const double of_y = needed(y) * and_more;
    if (const std::optional<double> r = relative(x)) {
      add_loss(f, (*r + of_y) * and_more, k);
    } else {
      add(f, error(x), and_more / p[y].range.least());
      add_loss(f, of_y, k);
    }
    return false;
  }
  void sine_or_cosine(Form& f, int k, int x, const Form& angle, double of_turn) {
    const double top = absorber.most(x);
    const std::optional<double> r = relative(x);
    if (p[k].op == Op::sine && r && top < 2.2) {  // |x cos x / sin x| <= max(1, -top/tan top)
      add_loss(f, (*r + of_turn) * std::max(1.0, -top / std::tan(top)) * and_more, k);
      return;
    }
    const Form plain = absorber.absorbed(absorber.constant(angle));
    if (p[k].op == Op::sine || top > 1.5707)
      add(f, plain, and_more);
    else  // |cos x - cos y| <= |x - y| (sin top + |x - y|); `close` keeps the last in and_more
      add(f, plain, std::sin(top) * (1 + 0x1p-40) * and_more);
  }
};
}  // namespace

Analysis analyse(const Program& p, const NumberType& type, Plan& plan) {
  Analyst analyst(p, type, plan);
  Analysis a;
  for (int k = 0; k < p.size(); ++k) a.steps.push_back(analyst.node(k));
  std::erase(a.steps, "");
  for (const Result& r : p.results) a.outputs.push_back(analyst.result(r));
  return a;
}
}  // namespace codegen
