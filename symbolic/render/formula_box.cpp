// SPDX-License-Identifier: GPL-2.0-or-later
// Formulas over several lines.
#include <algorithm>

#include "render/breaking.hpp"
#include "render/formula_text.hpp"
#include "render/notation.hpp"
#include "render/wrapping.hpp"

namespace magicmass::render {
namespace {

using Kind = Formula::Kind;

class Display {
public:
  explicit Display(const TextStyle& style) : style_(style) {}

  TextBox box(const Formula& formula) const {
    switch (formula.kind) {
      case Kind::sum:
        return sum(formula);
      case Kind::negative:
        return negative(factor(formula.parts[0]));
      case Kind::product:
        return product(formula.parts);
      case Kind::adjacent:
        return adjacent(formula.parts);
      case Kind::quotient:
        return is_small(formula) ? line(formula)
                                 : fraction(line(formula.parts[0]), line(formula.parts[1]), bar());
      case Kind::power:
        return power(formula);
      case Kind::matrix:
        return matrix(formula);
      case Kind::relation:
        return relation(formula);
      default:
        return line(formula);
    }
  }

  /// A piece with what stands before and behind it.
  TextBox box(const Piece& piece, bool first) const {
    std::vector<TextBox> boxes;
    if (!piece.sign.empty())
      boxes.push_back(line_box(first ? lead(piece.sign) : " " + lead(piece.sign)));
    if (piece.sign.empty() && piece.factor && !first)
      boxes.push_back(line_box(style_.unicode ? " " : "*"));
    boxes.push_back(piece.factor || piece.sign.ends_with('-') ? factor(piece.formula)
                                                              : box(piece.formula));
    return beside(boxes);
  }

private:
  const TextStyle& style_;

  std::string minus() const { return style_.unicode ? "−" : "-"; }
  std::string bar() const { return style_.unicode ? "─" : "-"; }
  TextBox line(const Formula& formula) const { return line_box(inline_text(formula, style_)); }

  /// "=" as "= ", "= -" as "= −".
  std::string lead(const std::string& sign) const {
    if (!style_.unicode)
      return sign == "-" || sign.ends_with(" -") ? sign + (sign == "-" ? " " : "") : sign + " ";
    if (sign == "-") return "− ";
    if (sign.ends_with(" -")) return unicode_sign(sign.substr(0, sign.size() - 2)) + " −";
    return unicode_sign(sign) + " ";
  }

  /// Apart from a fraction's bar.
  TextBox negative(const TextBox& inside) const {
    return beside({line_box(inside.height() > 1 ? minus() + " " : minus()), inside});
  }

  /// Numbers, and a letter over a number: one line is enough for these.
  static bool is_small(const Formula& quotient) {
    const auto simple = [](const Formula& part) {
      return part.kind == Kind::number || part.kind == Kind::name;
    };
    return simple(quotient.parts[0]) && quotient.parts[1].kind == Kind::number;
  }

  TextBox round(const TextBox& inside) const {
    return surrounded(inside, Bracket::round, style_.unicode);
  }

  TextBox factor(const Formula& part) const {
    const bool open =
        part.kind == Kind::sum || part.kind == Kind::negative || part.kind == Kind::relation;
    if (open) return round(box(part));
    const TextBox inside = box(part);
    return part.kind == Kind::quotient && inside.height() == 1 ? round(inside) : inside;
  }

  TextBox sum(const Formula& formula) const {
    std::vector<TextBox> boxes;
    for (const Formula& term : formula.parts) {
      const bool negative = term.kind == Kind::negative && !boxes.empty();
      if (!boxes.empty()) boxes.push_back(line_box(negative ? " " + minus() + " " : " + "));
      boxes.push_back(negative ? factor_of_term(term.parts[0]) : box(term));
    }
    return beside(boxes);
  }

  TextBox factor_of_term(const Formula& part) const {
    return part.kind == Kind::sum ? round(box(part)) : box(part);
  }

  /// Neighbours that are one line each stay as inline text has them.
  TextBox product(const std::vector<Formula>& parts) const {
    std::vector<TextBox> boxes;
    Formula flat{.kind = Kind::product};
    const auto close = [&] {
      if (flat.parts.empty()) return;
      boxes.push_back(line(flat.parts.size() == 1 ? as_factor(flat.parts[0]) : flat));
      flat.parts.clear();
    };
    for (const Formula& part : parts) {
      if (box(part).height() == 1) {
        flat.parts.push_back(part);
        continue;
      }
      close();
      boxes.push_back(factor(part));
    }
    close();
    for (std::size_t i = 1; i < boxes.size(); i += 2)
      boxes.insert(boxes.begin() + static_cast<std::ptrdiff_t>(i),
                   line_box(style_.unicode ? " " : "*"));
    return beside(boxes);
  }

  /// A single factor, in its parentheses if it needs them: as a product of one.
  static Formula as_factor(const Formula& part) {
    return part.kind == Kind::sum ? Formula{.kind = Kind::product, .parts = {part}} : part;
  }

  TextBox adjacent(const std::vector<Formula>& parts) const {
    std::vector<TextBox> boxes;
    for (const Formula& part : parts) {
      if (!boxes.empty()) boxes.push_back(line_box(" "));
      boxes.push_back(part.kind == Kind::matrix ? matrix(part) : line(part));
    }
    return beside(boxes);
  }

  TextBox power(const Formula& formula) const {
    const Formula& base = formula.parts[0];
    if (base.kind != Kind::sum && base.kind != Kind::quotient) return line(formula);
    const TextBox below = box(base);
    if (below.height() == 1) return line(formula);
    const TextBox open = round(below);
    const Formula x{.kind = Kind::name, .text = "x"};  // for the raised digits alone
    std::string high =
        inline_text({.kind = Kind::power, .parts = {x, formula.parts[1]}}, style_).substr(1);
    TextBox raised{{high}, 0};
    while (raised.height() < open.height())
      raised.rows.push_back(std::string().append(columns(high), ' '));
    raised.baseline = open.baseline;
    return beside({open, raised});
  }

  TextBox matrix(const Formula& formula) const {
    std::vector<TextBox> cells;
    for (const Formula& part : formula.parts) cells.push_back(line(part));
    return surrounded(grid(cells, formula.columns), Bracket::square, style_.unicode);
  }

  TextBox relation(const Formula& formula) const {
    std::vector<TextBox> boxes{box(formula.parts[0])};
    for (std::size_t i = 0; i < formula.signs.size(); ++i) {
      const std::string sign = style_.unicode ? unicode_sign(formula.signs[i]) : formula.signs[i];
      boxes.push_back(line_box(" " + sign + " "));
      boxes.push_back(box(formula.parts[i + 1]));
    }
    return beside(boxes);
  }
};

std::string rows(const TextBox& box, std::size_t indent) {
  std::string text;
  for (const std::string& row : box.rows) {
    std::string line = std::string().append(indent, ' ') + row;
    line.erase(line.find_last_not_of(' ') + 1);
    text += line + "\n";
  }
  return text;
}

/// The last resort: inline text, each side wrapped.
std::string wrapped_equation(const Formula& equation, const TextStyle& style, std::size_t indent) {
  std::string text;
  for (std::size_t i = 0; i < equation.parts.size(); ++i) {
    const std::string side = inline_text(equation.parts[i], style);
    if (i == 0) {
      text = wrapped(side, std::string().append(indent, ' '));
      continue;
    }
    const std::string sign =
        style.unicode ? unicode_sign(equation.signs[i - 1]) : equation.signs[i - 1];
    const std::string head = " " + sign + " ";
    const bool behind = i == 1 && columns(text) + columns(head) <= indent + 24;
    if (behind) text.pop_back();
    const std::string front =
        behind ? text + head : std::string().append(indent + 2, ' ') + sign + " ";
    text = (behind ? "" : text) + wrapped(side, front);
  }
  return text;
}

/// Each entry of a matrix that is wider than the page, row by row.
std::string entries(const Formula& matrix, const TextStyle& style, std::size_t indent) {
  std::string text;
  for (std::size_t i = 0; i < matrix.parts.size(); ++i) {
    const std::string place = "[" + std::to_string(i / matrix.columns + 1) + "," +
                              std::to_string(i % matrix.columns + 1) + "]  ";
    text += wrapped(inline_text(matrix.parts[i], style), std::string().append(indent, ' ') + place);
  }
  return text;
}

}  // namespace

std::string display_text(const Formula& equation, const TextStyle& style, std::size_t indent) {
  const Display display(style);
  const TextBox whole = display.box(equation);
  if (indent + whole.width() <= page_width) return rows(whole, indent);
  const std::size_t inner = indent + 2;
  const double room = static_cast<double>(page_width - inner - 6);
  const WidthOf width = [&](const Formula& part) {
    return static_cast<double>(display.box(part).width());
  };
  const std::vector<Piece> parts = pieces(equation, width, room);
  const bool fits = std::all_of(parts.begin(), parts.end(), [&](const Piece& piece) {
    return piece.opens == 0 && piece.closes == 0 &&
           (width(piece.formula) <= room || piece.formula.kind == Kind::matrix);
  });
  if (!fits) return wrapped_equation(equation, style, indent);
  std::string text;
  std::vector<TextBox> line;
  std::size_t used = 0;
  const auto close = [&] {
    if (!line.empty()) text += rows(beside(line), text.empty() ? indent : inner);
    line.clear();
    used = 0;
  };
  for (const Piece& piece : parts) {
    if (piece.formula.kind == Kind::matrix && width(piece.formula) > room) {
      if (!piece.sign.empty()) line.push_back(line_box(" " + piece.sign + " "));
      line.push_back(line_box("the matrix with"));
      close();
      text += entries(piece.formula, style, inner);
      continue;
    }
    const bool relates = piece.sign.find_first_of("=<>!") != std::string::npos;
    if (relates && used > 24) close();
    TextBox box = display.box(piece, line.empty());
    if (used + box.width() + inner > page_width && !line.empty()) {
      close();
      box = display.box(piece, true);
    }
    used += box.width();
    line.push_back(std::move(box));
  }
  close();
  return text;
}

}  // namespace magicmass::render
