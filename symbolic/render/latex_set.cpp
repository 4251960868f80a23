// SPDX-License-Identifier: GPL-2.0-or-later
#include "render/latex_set.hpp"

#include <algorithm>

#include "render/formula_latex.hpp"
#include "render/notation.hpp"

namespace magicmass::render::tex {
namespace {

using Kind = Formula::Kind;

const Set thin_space{"\\,", 0.17};

Set braced(const Set& inside) { return {"{" + inside.code + "}", inside.width, inside.tall}; }

bool is_compound(const Formula& part) {
  return part.kind == Kind::sum || part.kind == Kind::negative || part.kind == Kind::relation;
}

bool of_numbers(const Formula& quotient) {
  return quotient.parts[0].kind == Kind::number && quotient.parts[1].kind == Kind::number;
}

bool is_applied(const Formula& part) {
  const Formula& base = part.kind == Kind::power ? part.parts[0] : part;
  return base.kind == Kind::call && !upright_function(base.text).empty();
}

Set product(const Formula& formula, bool small) {
  Set result;
  for (std::size_t i = 0; i < formula.parts.size(); ++i) {
    const Formula& part = formula.parts[i];
    const Formula& head = part.kind == Kind::power ? part.parts[0] : part;
    if (i > 0 && head.kind == Kind::number) result += {"\\cdot", 0.7};
    if (i > 0 && head.kind != Kind::number &&
        (is_applied(formula.parts[i - 1]) || is_applied(part) || is_root(formula.parts[i - 1])))
      result += thin_space;
    result += is_cross(formula, part)       ? Set{"\\times", 1.2}
              : part.kind == Kind::adjacent ? fenced(set(part, small), "(", ")")
                                            : factor(part, small);
  }
  return result;
}

Set quotient(const Formula& formula, bool small) {
  const Formula& above = formula.parts[0];
  const Formula& below = formula.parts[1];
  if (small && of_numbers(formula)) return {"\\tfrac{" + above.text + "}{" + below.text + "}", 0.5};
  if (small) {
    const bool open = below.kind == Kind::product || below.kind == Kind::quotient;
    Set result = factor(above, true);
    result += {"/", 0.5};
    result += open ? fenced(set(below, true), "(", ")") : factor(below, true);
    return result;
  }
  const Set up = set(above, true);
  const Set down = set(below, true);
  return {"\\frac{" + up.code + "}{" + down.code + "}", std::max(up.width, down.width) + 0.25,
          true};
}

Set power(const Formula& formula, bool small) {
  const Formula& base = formula.parts[0];
  const Set high = set(formula.parts[1], true);
  if (is_applied(base))  // cos^n x, for cos x^n would be the cosine of x^n
    return call(base, small, "^{" + high.code + "}");
  if (is_root(base) && formula.parts[1].kind == Kind::number) {  // sqrt(x)^3
    const Set inside = factor(base.parts[0], true);
    return {inside.code + "^{" + high.code + "/2}", inside.width + 0.8, inside.tall};
  }
  const bool open = base.kind == Kind::product || base.kind == Kind::power ||
                    base.kind == Kind::adjacent || (base.kind == Kind::quotient) ||
                    (base.kind == Kind::call && base.text == "factorial");
  Set result = open ? fenced(set(base, small), "(", ")") : factor(base, small);
  if (result.code.ends_with('}') && is_element(base)) result = braced(result);
  result.code += "^{" + high.code + "}";
  result.width += 0.75 * high.width;
  return result;
}

/// In a matrix fractions keep their full size.
std::string with_large_fractions(std::string code) {
  for (std::size_t at = 0; (at = code.find("\\frac", at)) != std::string::npos; at += 6)
    code.replace(at, 5, "\\dfrac");
  return code;
}

Set matrix(const Formula& formula) {
  std::vector<Set> cells;
  for (const Formula& part : formula.parts) cells.push_back(set(part, false));
  const bool tall =
      std::any_of(cells.begin(), cells.end(), [](const Set& cell) { return cell.tall; });
  std::vector<double> widths(formula.columns, 0);
  std::string code = "\\begin{pmatrix}";
  for (std::size_t i = 0; i < cells.size(); ++i) {
    double& width = widths[i % formula.columns];
    width = std::max(width, cells[i].width);
    if (i > 0) code += i % formula.columns != 0 ? " &" : tall ? " \\\\[4ex]" : " \\\\";
    code += " " + with_large_fractions(cells[i].code);
  }
  double width = 1;
  for (const double column : widths) width += column + 1;
  return {code + " \\end{pmatrix}", width, true};
}

Set sum(const Formula& formula, bool small) {
  Set result;
  for (const Formula& term : formula.parts) {
    const bool negative = term.kind == Kind::negative && !result.code.empty();
    if (!result.code.empty()) result += {negative ? "-" : "+", 1.2};
    result += negative ? (term.parts[0].kind == Kind::sum ? factor(term.parts[0], small)
                                                          : set(term.parts[0], small))
                       : set(term, small);
  }
  return result;
}

Set relation(const Formula& formula, bool small) {
  Set result = set(formula.parts[0], small);
  for (std::size_t i = 0; i < formula.signs.size(); ++i) {
    result += {latex_sign(formula.signs[i]), 1.4};
    result += set(formula.parts[i + 1], small);
  }
  return result;
}

}  // namespace

Set factor(const Formula& part, bool small) {
  const bool open =
      is_compound(part) || (small && part.kind == Kind::quotient && !of_numbers(part));
  return open ? fenced(set(part, small), "(", ")") : set(part, small);
}

Set set(const Formula& formula, bool small) {
  switch (formula.kind) {
    case Kind::number:
      return {formula.text, 0.5 * static_cast<double>(formula.text.size())};
    case Kind::name: {
      const std::string upright = upright_function(formula.text);
      if (!upright.empty()) return {"\\operatorname{" + upright + "}", 1.5};
      return name(formula.text);
    }
    case Kind::sum:
      return sum(formula, small);
    case Kind::negative: {
      Set result{"-", 0.8};
      result += is_compound(formula.parts[0]) ? factor(formula.parts[0], small)
                                              : set(formula.parts[0], small);
      return result;
    }
    case Kind::product:
      return product(formula, small);
    case Kind::adjacent: {
      Set result;
      for (const Formula& part : formula.parts) {
        if (!result.code.empty()) result += thin_space;
        result += factor(part, small);
      }
      return result;
    }
    case Kind::quotient:
      return quotient(formula, small);
    case Kind::power:
      return power(formula, small);
    case Kind::call:
      return call(formula, small, "");
    case Kind::matrix:
      return matrix(formula);
    case Kind::list:
      return fenced(arguments(formula), "(", ")");
    case Kind::dot: {
      Set result = factor(formula.parts[0], small);
      result += {"\\cdot", 0.7};
      result += factor(formula.parts[1], small);
      return result;
    }
    case Kind::entry: {
      Set result = fenced(set(formula.parts[0], small), "(", ")");
      result.code += "_{" + formula.text + "}";
      return result;
    }
    case Kind::absolute:
      return fenced(set(formula.parts[0], small), "|", "|");
    case Kind::relation:
      return relation(formula, small);
    case Kind::verbatim:
      break;
  }
  return {"\\text{" + latex_escaped(formula.text) + "}",
          0.5 * static_cast<double>(formula.text.size())};
}

}  // namespace magicmass::render::tex
