#include "equality/normal_form.hpp"

namespace equality {
using kernel::refuse;
using notation::typed_text;
namespace {
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
  if (notation::name_of(symbol).empty() || !value || c.relation == "!=") return false;
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
std::string shown(Expr symbol, const Range& range) {
  const std::string name = typed_text(symbol);
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
      if (name == "integer" || name == "real") refuse("is a comma missing?");
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
    const std::vector<notation::Comparison> chain = notation::read_comparisons(condition, &unused);
    const auto goes = [&](char way) {
      return std::ranges::any_of(chain, [&](const auto& c) { return c.relation[0] == way; });
    };
    if (goes('<') && goes('>')) refuse("a chain goes one way, as 0 < x < 5; is a comma missing?");
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
      refuse("no value of " + typed_text(symbol) + " satisfies " + shown(symbol, range));
  return domain;
}
std::vector<std::string> texts(const Domain& domain) {
  std::vector<std::string> out;
  for (const auto& [symbol, range] : domain.ranges) out.push_back(shown(symbol, range));
  std::ranges::sort(out);
  for (const notation::Comparison& c : domain.further)
    out.push_back(typed_text(c.left) + " " + c.relation + " " + typed_text(c.right));
  return out;
}

}  // namespace equality
