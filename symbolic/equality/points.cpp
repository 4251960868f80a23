// Points of a domain to try, and what terms are there.
#include "equality/normal_form.hpp"

namespace equality {
namespace {
constexpr int digits_shown = 16, largest_denominator = 1000, most_halves = 60;
constexpr std::size_t longest_shown = 40;
constexpr std::size_t most_tried = 60;     // for one point that satisfies the further conditions
constexpr std::size_t points_around = 40;  // of a zero
constexpr std::size_t most_special = 24;   // values that the numbers of the terms suggest

// The values of a range to try: the simplest first, or fractions first, and the special ones last.
std::vector<cln::cl_RA> values_of(const Range& range, std::size_t count, bool is_inside,
                                  const std::set<cln::cl_RA>& special, std::size_t most) {
  std::vector<cln::cl_RA> values;
  std::size_t room = count;
  const auto add = [&](const cln::cl_RA& value) {
    if (values.size() < room && range.contains(value) &&
        std::ranges::find(values, value) == values.end())
      values.push_back(value);
  };
  const auto add_around = [&](const cln::cl_RA& q) {  // 0 and the ends
    add(q);
    add(-q);
    if (range.low) add(range.low->value + q);
    if (range.high) add(range.high->value - q);
  };
  if (!is_inside)
    for (int value : {0, 1, -1, 2, -2, 3, -3}) add(value);
  if (!is_inside) add_around(0);
  for (int below = 2; below <= 4 && !range.is_integer; ++below)
    for (int above = 1; above < 2 * below; ++above) {
      const cln::cl_RA fraction = cln::cl_RA(above) / below;
      if (range.low && range.high)
        add(range.low->value + (range.high->value - range.low->value) * fraction);
      add_around(fraction);
    }
  const cln::cl_RA start = range.low    ? cln::cl_RA(cln::ceiling1(range.low->value))
                           : range.high ? cln::cl_RA(cln::floor1(range.high->value))
                                        : cln::cl_RA(0);
  for (int step : {0, 1, 2, 3, 4, 5, 6, 7, 9, 11, 15, 29, 99, 100, 1000}) {
    add(start + cln::cl_RA(step));
    add(start - cln::cl_RA(step));
  }
  for (int below : {10, 100, 1000}) add_around(cln::cl_RA(1) / below);
  room = most;
  std::set<cln::cl_RA> turns = special;
  turns.insert({0, cln::cl_RA(1) / 7});
  for (const std::optional<End>& end : {range.low, range.high})
    if (end) turns.insert(end->value);
  const cln::cl_RA below = 4 * cln::min(cln::cl_RA(-1), *turns.begin());
  const cln::cl_RA above = 4 * cln::max(cln::cl_RA(1), *turns.rbegin());
  turns.insert({below, above});
  for (auto turn = turns.begin(), next = turn; turn != turns.end(); turn = next) {
    add(*turn);
    if (++next == turns.end()) break;
    const cln::cl_RA middle = (*turn + *next) / 2;
    add(range.is_integer ? cln::cl_RA(cln::floor1(middle)) : middle);
  }
  cln::cl_RA inward = cln::cl_RA(1) / (range.is_integer ? 1 : 1000);
  if (range.low && range.high) inward = inward * (range.high->value - range.low->value);
  for (const cln::cl_RA& value : {range.low ? range.low->value + inward : below,
                                  range.high ? range.high->value - inward : above})
    if (range.contains(value)) values.push_back(value);
  return values;
}
void collect_turns(Expr e, std::set<cln::cl_RA>& found) {
  for (Expr arg : e.args()) collect_turns(arg, found);
  std::vector<cln::cl_RA> values;
  const std::set<Expr> symbols = kernel::free_variables(e);
  if (symbols.empty()) {
    const auto value = notation::rational_value(e);
    if (!value || *value == 0) return;
    values = {*value, cln::abs(*value) < 1 ? 1 / *value : -*value};
  } else if (e.op() == Op::Add && symbols.size() == 1) {
    const auto at = [&](int value) {
      return notation::rational_value(kernel::substitute(e, {{*symbols.begin(), Expr(value)}}));
    };
    const auto start = at(0), next = at(1), last = at(2);
    if (start && next && last && *next != *start && *last - *next == *next - *start)
      for (int beside : {0, 1, -1}) values.push_back(*start / (*start - *next) + beside);
  }
  if (is_call(e, "log"))
    for (const cln::cl_RA& value : std::set(found))  // about exp(20), where log(x) is 20
      if (value > 0 && value < 60) values.push_back(cln::expt(cln::cl_RA(3), cln::ceiling1(value)));
  for (const cln::cl_RA& value : values)
    if (cln::integer_length(cln::numerator(value)) <= 200) found.insert(value);
}
// x^y is taken at negative x where the symbols of y are whole numbers, and y no quotient of them;
// elsewhere it is what a real power is, though it has a value by accident at some fractions.
bool has_accident(const Point& point, Expr term, int bits) {
  for (Expr e : parts_of(term))
    if (is_call(e, "raised") && enclosure(at(point, e.arg(0)), bits).high() < 0)
      for (Expr symbol : kernel::free_variables(e.arg(1)))
        if (cln::denominator(point.at(symbol)) != 1 || !is_whole_form(e.arg(1))) return true;
  return false;
}
}  // namespace

bool is_whole_form(Expr e) {
  const bool is_other = e.op() == Op::Fun && !is_call(e, "raised") && !is_call(e, "abs");
  if (kernel::free_variables(e).empty()) return true;
  return !is_other && std::ranges::all_of(e.args(), is_whole_form);
}
std::vector<Point> points(const Domain& domain, std::size_t count, const Exprs& of, bool inside) {
  std::set<cln::cl_RA> special;
  for (Expr e : of) collect_turns(e, special);
  std::vector<Expr> symbols;
  std::vector<std::vector<cln::cl_RA>> values;
  const std::size_t most = count + (inside ? 0 : most_special);
  const std::size_t usual = inside ? 60 : domain.ranges.size() == 1 ? count : 24;
  for (const auto& [symbol, range] : domain.ranges) {
    symbols.push_back(symbol);
    values.push_back(values_of(range, usual, inside, special, most));
    if (values.back().empty()) return {};
  }
  std::vector<Point> out;
  const auto add = [&](const auto& place) {
    Point point;
    for (std::size_t j = 0; j < symbols.size(); ++j) point[symbols[j]] = values[j][place(j)];
    if (std::ranges::all_of(domain.further, [&](const notation::Comparison& c) {
          return holds({at(point, c.left), c.relation, at(point, c.right)}) == true;
        }))
      out.push_back(point);
  };
  // By the sum of the places in the lists, so that simple points come first.
  using Places = std::vector<std::size_t>;
  std::set<std::pair<std::size_t, Places>> next{{0, Places(symbols.size())}};
  for (std::size_t tried = 0; !next.empty() && out.size() < most && tried < most_tried * count;
       ++tried) {
    auto [sum, places] = next.extract(next.begin()).value();
    add([&places = places](std::size_t j) { return places[j]; });  // clang 14 takes no binding
    for (std::size_t j = 0; j < symbols.size(); ++j) {
      if (++places[j] < values[j].size()) next.emplace(sum + 1, places);
      --places[j];
    }
  }
  const std::size_t corners =
      inside || symbols.size() == 1 ? 0 : 1U << std::min<std::size_t>(symbols.size(), 4);
  // Then both of the last values of each symbol, which are near its ends.
  for (std::size_t corner = 0; corner < corners; ++corner)
    add([&](std::size_t j) {
      const std::size_t last = values[j].size() - 1;
      return last - std::min(last, (corner >> j) % 2);
    });
  // And values far down in the lists of several symbols at once, each list in steps of its own.
  for (std::size_t i = 0; inside && i < 2 * count; ++i)
    add([&](std::size_t j) { return (i * (2 * j + 3) + 5 * j) % values[j].size(); });
  return out;
}
std::string said_of_zero(Expr term, const Domain& domain) {
  const std::string name = notation::typed_text(term);
  if (domain.ranges.size() != 1 || !domain.further.empty() || !requirements(term, domain).empty())
    return "needs " + name + " != 0";
  const Expr x = domain.ranges.begin()->first;
  const auto sign = [&](const cln::cl_RA& q) { return exact_sign(at({{x, q}}, term)).value_or(0); };
  std::map<cln::cl_RA, int> signs;
  for (const Point& one : points(domain, points_around, {})) signs[one.at(x)] = sign(one.at(x));
  for (auto next = signs.begin(), last = next++; next != signs.end(); last = next++) {
    if (domain.ranges.at(x).is_integer || last->second * next->second >= 0) continue;
    cln::cl_RA low = last->first, high = next->first;
    for (int halves = 0; halves < most_halves; ++halves)
      (sign((low + high) / 2) == last->second ? low : high) = (low + high) / 2;
    if (const auto digits = balls::decimal(low, high, 6))
      return "has no value at a zero of " + name + ", near " + notation::typed_text(x) + " = " +
             *digits;
  }
  return "needs " + name + " != 0";
}
std::optional<bool> holds(const notation::Comparison& c) try {
  const Expr difference = c.left - c.right;
  if (!notation::symbols_of(difference).empty()) return {};
  const auto sign = exact_sign(difference);
  if (!sign) return {};
  if (*sign == 0) return c.relation.ends_with('=') && c.relation != "!=";
  return c.relation == "!=" || c.relation[0] == (*sign < 0 ? '<' : '>');
} catch (const NotDefined&) {
  return false;
}
Expr at(const Point& point, Expr term) {
  return kernel::substitute(term, {point.begin(), point.end()});
}
std::string shown_value(Expr constant) {
  auto exact = notation::rational_value(constant);
  const Value value = value_at({}, constant);
  if (!exact && value.ball) exact = near_fraction(value.ball->low(), largest_denominator);
  const std::string digits = exact ? kernel::digits(*exact) : "";
  if (exact && digits.size() <= longest_shown && exact_sign(constant - Expr(*exact)) == 0)
    return digits;
  for (int bits = 128; bits <= 8192; bits *= 2) {
    const auto ball = value_at({}, constant, bits).ball;
    if (!ball) continue;
    if (const auto text = balls::decimal(ball->low(), ball->high(), digits_shown)) return *text;
  }
  return "too close to 0 to be shown";
}
std::string text(const Point& point) {
  std::string out;
  for (const auto& [symbol, value] : point)
    out += (out.empty() ? "" : ", ") + notation::typed_text(symbol) + " = " + kernel::digits(value);
  return out;
}

bool Value::is_known() const {
  if (!ball) return !why_none.empty();
  const cln::cl_RA size = cln::max(cln::cl_RA(1), cln::abs(ball->low()));
  return ball->high() - ball->low() < size / cln::ash(cln::cl_I(1), 166);
}
Value value_at(const Point& point, Expr side, int bits) try {
  const Ball ball = enclosure(at(point, side), bits);
  if (has_accident(point, side, bits)) return {.why_none = "a real power of a negative number"};
  return {.ball = ball};
} catch (const NotDefined& none) {
  return {.why_none = none.what()};
} catch (const NotCertain&) {
  return {};
}
}  // namespace equality
