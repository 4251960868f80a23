// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>

#include "equality/normal_form.hpp"

namespace equality {
using kernel::Op;
using kernel::refuse;
namespace {
constexpr std::size_t most_tried = 60;    // for one point that satisfies the further conditions
constexpr std::size_t most_special = 24;  // values that the numbers of the terms suggest

Range usual_range(const std::string& name) {
  static const std::set<std::string> positive{"alpha", "V", "L", "M", "m", "M_A", "M_B"};
  if (positive.contains(name)) return {.low = End{0}};
  if (name == "e") return {.low = End{0}, .high = End{1, true}};
  if (name == "n" || name == "k") return {.is_integer = true, .low = End{1, true}};
  if (name == "j") return {.is_integer = true, .low = End{0, true}};
  return {};
}
std::string trimmed(std::string text) {
  text.erase(text.find_last_not_of(" \t\r\n") + 1);
  return text.erase(0, text.find_first_not_of(" \t\r\n"));
}
// At commas outside of brackets, or what stands for one.
std::vector<std::string> separated(std::string text) {
  for (std::size_t at = 0; (at = text.find(" and ", at)) != text.npos;) text.replace(at, 5, ",");
  std::vector<std::string> parts{""};
  int depth = 0;
  for (const char c : text) {
    depth += c == '(' ? 1 : c == ')' ? -1 : 0;
    if ((c == ',' || c == ';') && depth == 0)
      parts.emplace_back();
    else
      parts.back() += c;
  }
  return parts;
}
// A bound of one symbol, the strictest one counts; false where the comparison is none.
bool bound(const notation::Comparison& c, std::map<Expr, Range>& given) {
  const bool is_turned = !notation::name_of(c.right).empty();
  const Expr symbol = is_turned ? c.right : c.left;
  const auto value = notation::rational_value(is_turned ? c.left : c.right);
  if (notation::name_of(symbol).empty() || !value) return false;
  if (c.relation == "!=") return false;
  const End end{*value, c.relation.ends_with('=')};
  if (c.relation == "=" || (c.relation[0] == '<') != is_turned) given[symbol].cut_above(end);
  if (c.relation == "=" || (c.relation[0] == '<') == is_turned) given[symbol].cut_below(end);
  return true;
}
// abs(x) < 1: -1 < x and x < 1.
std::vector<notation::Comparison> without_modulus(const notation::Comparison& c) {
  if (!is_call(c.left, "abs") || c.relation[0] != '<') return {c};
  const Expr inner = c.left.arg(0);
  return {{Expr(-1) * c.right, c.relation, inner}, {inner, c.relation, c.right}};
}
// 0 < x and x < y: 0 < y.
void bound_by_others(Domain& domain) {
  for (std::size_t pass = 0; pass < domain.further.size(); ++pass)
    for (const auto& [left, relation, right] : domain.further) {
      const bool is_turned = relation[0] == '>', is_weak = relation.ends_with('=');
      const auto below = domain.ranges.find(is_turned ? right : left);
      const auto above = domain.ranges.find(is_turned ? left : right);
      const bool is_order = relation[0] == '<' || is_turned;
      if (!is_order || below == domain.ranges.end() || above == domain.ranges.end()) continue;
      if (const auto end = below->second.low)
        above->second.cut_below({end->value, end->is_inside && is_weak});
      if (const auto end = above->second.high)
        below->second.cut_above({end->value, end->is_inside && is_weak});
    }
}
bool is_in(const Domain& domain, const Point& point) {
  return std::ranges::all_of(domain.further, [&](const notation::Comparison& c) {
    return holds({at(point, c.left), c.relation, at(point, c.right)}) == true;
  });
}
std::string shown(Expr symbol, const Range& range) {
  const std::string name = notation::typed_text(symbol);
  const auto number = [](const std::optional<End>& end) { return kernel::digits(end->value); };
  const auto sign = [](const std::string& strict, const std::optional<End>& end) {
    return " " + strict + (end->is_inside ? "= " : " ");
  };
  if (range.is_point()) return name + " = " + number(range.low);
  std::string bounds = name;
  if (range.low)
    bounds = range.high ? number(range.low) + sign("<", range.low) + name
                        : name + sign(">", range.low) + number(range.low);
  if (range.high) bounds += sign("<", range.high) + number(range.high);
  if (range.is_integer) return name + " integer" + (bounds == name ? "" : ", " + bounds);
  return bounds == name ? name + " real" : bounds;
}

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
    for (int value : {1, -1, 2, -2, 0, 3, -3}) add(value);
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
  cln::cl_RA inward = cln::cl_RA(1) / 1000;
  if (range.is_integer) inward = 1;
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
      values = {*start / (*start - *next)};
  }
  if (is_call(e, "log"))
    for (const cln::cl_RA& value : std::set(found))  // about exp(20), where log(x) is 20
      if (value > 0 && value < 60) values.push_back(cln::expt(cln::cl_RA(3), cln::ceiling1(value)));
  for (const cln::cl_RA& value : values) {
    if (cln::integer_length(cln::numerator(value)) > 200) continue;
    found.insert(value);
  }
}
// x^y is taken at negative x where the symbols of y are whole numbers; elsewhere it is what a real
// power is, though (-1/2)^y has a value by accident at some fractions.
bool has_accident(const Point& point, Expr e, int bits) {
  if (is_call(e, "raised") && enclosure(at(point, e.arg(0)), bits).high() < 0)
    for (Expr symbol : kernel::free_variables(e.arg(1)))
      if (cln::denominator(point.at(symbol)) != 1) return true;
  return std::ranges::any_of(e.args(), [&](Expr part) { return has_accident(point, part, bits); });
}
}  // namespace

bool Range::contains(const cln::cl_RA& value) const {
  if (is_integer && cln::denominator(value) != 1) return false;
  if (low && (value < low->value || (value == low->value && !low->is_inside))) return false;
  return !(high && (value > high->value || (value == high->value && !high->is_inside)));
}
bool Range::is_empty() const {
  if (!low || !high) return false;
  if (!is_integer) return low->value > high->value || (low->value == high->value && !is_point());
  const cln::cl_I first = cln::ceiling1(low->value);
  return !contains(first) && !contains(first + 1);
}
void Range::cut_below(const End& end) {
  if (!low || low->value < end.value || (low->value == end.value && !end.is_inside)) low = end;
}
void Range::cut_above(const End& end) {
  if (!high || high->value > end.value || (high->value == end.value && !end.is_inside)) high = end;
}

Domain read_domain(const std::string& text, const std::set<std::string>& symbols,
                   std::vector<std::string>& unused) {
  Domain domain;
  for (const std::string& name : symbols) domain.ranges[notation::symbol(name)] = usual_range(name);
  std::map<Expr, Range> given;
  // Absent symbols may bound others: x < y < z.
  const auto note = [&](Expr e, const std::string& condition) {
    for (const std::string& name : notation::symbols_of(e)) {
      if (symbols.contains(name)) continue;
      domain.ranges.try_emplace(notation::symbol(name), usual_range(name));
      unused.push_back("\"" + condition + "\": " + name + " is in neither expression");
    }
  };
  const auto read = [&](const std::string& condition) {
    for (const std::string kind : {"integer", "real"})
      if (condition.ends_with(" " + kind)) {
        const std::string name = condition.substr(0, condition.size() - kind.size() - 1);
        const Expr e = notation::read_typed(name).term;
        if (notation::name_of(e).empty()) refuse("a symbol is expected before " + kind);
        note(e, condition);
        domain.ranges[e] = {.is_integer = kind == "integer"};
        return;
      }
    if (condition.starts_with("not ")) refuse("not: write the opposite, as in x >= 0");
    const std::vector<notation::Comparison> chain = notation::read_comparisons(condition);
    const auto goes = [&](char way) {
      return std::ranges::any_of(chain, [&](const auto& c) { return c.relation[0] == way; });
    };
    if (goes('<') && goes('>'))
      refuse("a chain goes one way, as in 0 < x < 5; is a comma missing?");
    for (const notation::Comparison& one : chain)
      for (const notation::Comparison& c : without_modulus(one)) {
        note(c.left + c.right, condition);
        if (!bound(c, given)) domain.further.push_back(c);
      }
  };
  if (text.find(" or ") != text.npos) refuse("or: the conditions must hold together, with commas");
  const std::vector<std::string> parts = separated(text);
  if (parts.size() > 50) refuse("more than 50 conditions");
  for (const std::string& part : trimmed(text).empty() ? std::vector<std::string>() : parts) {
    const std::string condition = trimmed(part);
    if (condition.empty()) refuse("an empty condition; write for example 0 < alpha");
    try {
      read(condition);
    } catch (const kernel::Refused& r) {
      refuse("\"" + condition.substr(0, 60) + "\": " + r.what());
    }
  }
  for (const auto& [symbol, range] : given) {
    Range& known = domain.ranges[symbol];
    if (range.low) known.low = range.low;
    if (range.high) known.high = range.high;
    if (known.is_empty() && !range.is_empty())
      known = {.is_integer = known.is_integer, .low = range.low, .high = range.high};
  }
  bound_by_others(domain);
  const auto is_asked = [&](Expr symbol) {
    const std::string name = notation::name_of(symbol);
    return symbols.contains(name) || std::ranges::any_of(domain.further, [&](const auto& c) {
             return notation::symbols_of(kernel::eq(c.left, c.right)).contains(name);
           });
  };
  std::erase_if(domain.ranges, [&](const auto& range) { return !is_asked(range.first); });
  for (const auto& [symbol, range] : domain.ranges)
    if (range.is_empty())
      refuse("no value of " + notation::typed_text(symbol) + " satisfies " + shown(symbol, range));
  return domain;
}
std::vector<std::string> texts(const Domain& domain) {
  std::vector<std::string> out;
  for (const auto& [symbol, range] : domain.ranges) out.push_back(shown(symbol, range));
  std::ranges::sort(out);
  for (const notation::Comparison& c : domain.further)
    out.push_back(notation::typed_text(c.left) + " " + c.relation + " " +
                  notation::typed_text(c.right));
  return out;
}

std::vector<Point> points(const Domain& domain, std::size_t count, const Exprs& terms,
                          bool is_inside) {
  std::set<cln::cl_RA> special;
  for (Expr e : terms) collect_turns(e, special);
  std::vector<Expr> symbols;
  std::vector<std::vector<cln::cl_RA>> values;
  const std::size_t most = count + (is_inside ? 0 : most_special);
  const std::size_t usual = is_inside ? 60 : domain.ranges.size() == 1 ? count : 24;
  for (const auto& [symbol, range] : domain.ranges) {
    symbols.push_back(symbol);
    values.push_back(values_of(range, usual, is_inside, special, most));
    if (values.back().empty()) return {};
  }
  std::vector<Point> out;
  const auto add = [&](const auto& place) {
    Point point;
    for (std::size_t j = 0; j < symbols.size(); ++j) point[symbols[j]] = values[j][place(j)];
    if (is_in(domain, point)) out.push_back(point);
  };
  // By the sum of the places in the lists, so that simple points come first.
  using Places = std::vector<std::size_t>;
  std::set<std::pair<std::size_t, Places>> next{{0, Places(symbols.size())}};
  for (std::size_t tried = 0; !next.empty() && out.size() < most && tried < most_tried * count;
       ++tried) {
    auto [sum, places] = next.extract(next.begin()).value();
    add([&](std::size_t j) { return places[j]; });
    for (std::size_t j = 0; j < symbols.size(); ++j) {
      if (++places[j] < values[j].size()) next.emplace(sum + 1, places);
      --places[j];
    }
  }
  const std::size_t corners =
      is_inside || symbols.size() == 1 ? 0 : 1U << std::min<std::size_t>(symbols.size(), 4);
  // Then both of the last values of each symbol, which are near its ends.
  for (std::size_t corner = 0; corner < corners; ++corner)
    add([&](std::size_t j) {
      const std::size_t last = values[j].size() - 1;
      return last - std::min(last, (corner >> j) % 2);
    });
  // And values far down in the lists of several symbols at once, each list in steps of its own.
  for (std::size_t i = 0; is_inside && i < 2 * count; ++i)
    add([&](std::size_t j) { return (i * (2 * j + 3) + 5 * j) % values[j].size(); });
  return out;
}
std::optional<bool> holds(const notation::Comparison& c) {
  const Expr difference = c.left - c.right;
  if (!notation::symbols_of(difference).empty()) return {};
  try {
    const auto sign = exact_sign(difference);
    if (!sign) return {};
    if (*sign == 0) return c.relation.ends_with('=') && c.relation != "!=";
    return c.relation == "!=" || c.relation[0] == (*sign < 0 ? '<' : '>');
  } catch (const NotDefined&) {
    return false;
  }
}
Expr at(const Point& point, Expr term) {
  kernel::Substitution s;
  for (const auto& [symbol, value] : point) s.emplace(symbol, Expr(value));
  return kernel::substitute(term, s);
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
Value value_at(const Point& point, Expr side, int bits) {
  try {
    const Ball ball = enclosure(at(point, side), bits);
    if (has_accident(point, side, bits)) return {.why_none = "a real power of a negative number"};
    return {.ball = ball};
  } catch (const NotDefined& none) {
    return {.why_none = none.what()};
  } catch (const NotCertain&) {
    return {};
  }
}
}  // namespace equality
