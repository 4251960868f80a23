// SPDX-License-Identifier: GPL-2.0-or-later
#include "render/formula.hpp"

#include <algorithm>
#include <array>
#include <cctype>

#include "render/notation.hpp"

namespace magicmass::render {
namespace {

using Kind = Formula::Kind;

constexpr int deepest = 200;  // the kernel's own formulas stay below 20

/// What cannot be read; caught where reading began.
struct Unreadable {};

class Reader {
public:
  explicit Reader(std::string_view text) : text_(text) {}

  Formula whole(bool with_relations) {
    Formula result = with_relations ? relation() : sum();
    if (at_ != text_.size()) throw Unreadable();
    return result;
  }

private:
  std::string_view text_;
  std::size_t at_ = 0;
  int depth_ = 0;

  char peek(std::size_t ahead = 0) const {
    return at_ + ahead < text_.size() ? text_[at_ + ahead] : '\0';
  }
  bool take(std::string_view expected) {
    if (text_.substr(at_, expected.size()) != expected) return false;
    at_ += expected.size();
    return true;
  }
  void require(std::string_view expected) {
    if (!take(expected)) throw Unreadable();
  }
  static bool is_letter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; }
  static bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }

  Formula relation() {
    static constexpr std::array<std::string_view, 7> signs{"=", "!=", "<=", ">=", "<", ">", "~"};
    Formula result{.kind = Kind::relation, .parts = {sum()}};
    for (bool more = true; more;) {
      more = false;
      for (const std::string_view sign : signs)
        if (take(" " + std::string(sign) + " ")) {
          result.signs.emplace_back(sign);
          result.parts.push_back(sum());
          more = true;
          break;
        }
    }
    if (result.signs.empty()) throw Unreadable();
    return result;
  }

  Formula sum() {
    if (++depth_ > deepest) throw Unreadable();
    std::vector<Formula> terms;
    terms.push_back(take("-") ? negative(product()) : product());
    for (;;) {
      if (take(" + "))
        terms.push_back(product());
      else if (take(" - "))
        terms.push_back(negative(product()));
      else
        break;
    }
    --depth_;
    if (terms.size() == 1) return terms.front();
    return {.kind = Kind::sum, .parts = std::move(terms)};
  }

  static Formula negative(Formula inside) {
    return {.kind = Kind::negative, .parts = {std::move(inside)}};
  }

  Formula product() {
    std::vector<Formula> factors{dotted()};
    const auto gathered = [&]() -> Formula {
      if (factors.size() == 1) return factors.front();
      return {.kind = Kind::product, .parts = factors};
    };
    for (;;) {
      if (take("*"))
        factors.push_back(dotted());
      else if (take("/"))
        factors = {Formula{.kind = Kind::quotient, .parts = {gathered(), dotted()}}};
      else
        return gathered();
    }
  }

  /// A word of prose is no name: only what looks like a symbol stands beside another.
  static void require_symbol(const Formula& part) {
    if (part.kind == Kind::name && !looks_like_symbol(part.text)) throw Unreadable();
  }

  Formula dotted() {
    Formula result = adjacent();
    for (;;) {
      const bool tight = peek() == '.' && is_letter(peek(1));
      if (!tight && !take(" . ")) return result;
      if (tight) ++at_;
      result = {
          .kind = Kind::dot, .text = tight ? "." : " . ", .parts = {std::move(result), adjacent()}};
    }
  }

  Formula adjacent() {
    std::vector<Formula> parts{power()};
    while (peek() == ' ' &&
           (is_letter(peek(1)) || peek(1) == '[' || peek(1) == '(' || peek(1) == '|')) {
      ++at_;
      parts.push_back(power());
    }
    if (parts.size() == 1) return parts.front();
    for (const Formula& part : parts) require_symbol(part);
    return {.kind = Kind::adjacent, .parts = std::move(parts)};
  }

  Formula power() {
    Formula base = primary();
    while (take("!")) base = {.kind = Kind::call, .text = "factorial", .parts = {base}};
    if (!take("^")) return base;
    return {.kind = Kind::power, .parts = {std::move(base), primary()}};
  }

  Formula primary() {
    if (is_digit(peek())) return number();
    if (is_letter(peek())) return named();
    if (take("[")) return matrix();
    if (take("|")) {
      Formula inside = sum();
      require("|");
      return {.kind = Kind::absolute, .parts = {std::move(inside)}};
    }
    require("(");
    std::vector<Formula> parts = arguments(")");
    if (parts.size() != 1) return {.kind = Kind::list, .parts = std::move(parts)};
    const std::size_t begin = at_ + 1;
    if (peek() != '_') return parts.front();
    for (++at_; is_digit(peek()) || is_letter(peek());) ++at_;
    return {.kind = Kind::entry,
            .text = std::string(text_.substr(begin, at_ - begin)),
            .parts = std::move(parts)};
  }

  Formula number() {
    const std::size_t begin = at_;
    while (is_digit(peek())) ++at_;
    if (peek() == '.' && is_digit(peek(1))) {
      ++at_;
      while (is_digit(peek())) ++at_;
    }
    return {.kind = Kind::number, .text = std::string(text_.substr(begin, at_ - begin))};
  }

  Formula named() {
    const std::size_t begin = at_;
    while (is_letter(peek()) || is_digit(peek()) || (peek() == '_' && peek(1) != '(')) ++at_;
    while (peek() == '\'') ++at_;
    if (peek(0) == '_' && text_[at_ - 1] == '\'' && peek(1) != '(')  // e'_3
      for (++at_; is_letter(peek()) || is_digit(peek());) ++at_;
    std::string name(text_.substr(begin, at_ - begin));
    if (take("_(")) return {.kind = Kind::call, .text = name, .parts = arguments(")")};
    if (take("(")) return family(std::move(name));
    return {.kind = Kind::name, .text = std::move(name)};
  }

  /// v_A(n; 1/2, 1, e): behind the semicolon the parameters of a family of sequences; `signs` tells where they begin.
  Formula family(std::string name) {
    Formula call{.kind = Kind::call, .text = std::move(name)};
    bool more = true;
    while (more) {
      call.parts.push_back(sum());
      if (take("; "))
        call.signs = {std::to_string(call.parts.size())};
      else
        more = take(", ");
    }
    require(")");
    return call;
  }

  std::vector<Formula> arguments(std::string_view end) {
    std::vector<Formula> parts;
    do parts.push_back(sum());
    while (take(", "));
    require(end);
    return parts;
  }

  Formula matrix() {
    Formula result{.kind = Kind::matrix};
    if (peek() != '[') {
      result.parts = arguments("]");
      result.columns = result.parts.size();
      return result;
    }
    do {
      require("[");
      std::vector<Formula> row = arguments("]");
      if (result.columns != 0 && row.size() != result.columns) throw Unreadable();
      result.columns = row.size();
      std::move(row.begin(), row.end(), std::back_inserter(result.parts));
    } while (take(", "));
    require("]");
    return result;
  }
};

std::optional<Formula> read(std::string_view text, bool with_relations) {
  try {
    return Reader(text).whole(with_relations);
  } catch (const Unreadable&) {
    return std::nullopt;
  }
}

/// Built from integers, indices and counts alone.
bool is_index(const Formula& part) {
  static constexpr std::array<std::string_view, 10> indices{"k'", "i", "j", "k",   "m",
                                                            "n",  "r", "N", "N_A", "N_B"};
  switch (part.kind) {
    case Kind::number:
      return true;
    case Kind::name:
      return std::find(indices.begin(), indices.end(), part.text) != indices.end();
    case Kind::call:
      if (part.text != "ceil" && part.text != "floor") return false;
      [[fallthrough]];
    case Kind::sum:
    case Kind::negative:
    case Kind::quotient:
    case Kind::product:
      return std::all_of(part.parts.begin(), part.parts.end(), is_index);
    default:
      return false;
  }
}

}  // namespace

std::optional<Formula> read_formula(std::string_view text) { return read(text, false); }

std::optional<Formula> read_relation(std::string_view text) { return read(text, true); }

Formula formula(std::string_view text) {
  return read_formula(text).value_or(Formula{.kind = Kind::verbatim, .text = std::string(text)});
}

Formula equation(std::string_view from, const std::string& relation, std::string_view to) {
  return {.kind = Kind::relation, .parts = {formula(from), formula(to)}, .signs = {relation}};
}

SumParts sum_parts(const Formula& call) {
  if (call.parts.size() == 4) return {call.parts[0], call.parts[1], call.parts[2], call.parts[3]};
  const Formula index{.kind = Kind::name, .text = "k"};
  const auto renamed = [&](const auto& self, Formula part) -> Formula {
    if (part == Formula{.kind = Kind::name, .text = "k'"}) return index;
    for (Formula& inner : part.parts) inner = self(self, inner);
    return part;
  };
  return {index, call.parts[1], call.parts[2], renamed(renamed, call.parts[0])};
}

bool is_cross(const Formula& adjacent, const Formula& part) {
  return adjacent.parts.size() == 3 && &part == &adjacent.parts[1] && part.kind == Kind::name &&
         part.text == "x";
}

bool is_sum_over_index(const Formula& part) {
  return part.kind == Kind::call && part.text == "sum" &&
         (part.parts.size() == 3 || part.parts.size() == 4);
}

bool is_element(const Formula& part) {
  return part.kind == Kind::call && part.parts.size() == 1 && !is_function_name(part.text) &&
         is_index(part.parts.front());
}

}  // namespace magicmass::render
