// SPDX-License-Identifier: GPL-2.0-or-later
#include "render/formula_latex.hpp"

#include <map>

#include "render/breaking.hpp"
#include "render/latex_set.hpp"
#include "render/notation.hpp"

namespace magicmass::render {
namespace {

using tex::Set;

constexpr double relation_width = 1.4;

/// "= -" as two signs; a line that begins with one needs {} for its spacing.
std::string signs(const std::string& sign) {
  if (sign.ends_with(" -")) return latex_sign(sign.substr(0, sign.size() - 2)) + " -";
  return sign.empty() ? "" : latex_sign(sign);
}

Set set(const Piece& piece) {
  const Set content = piece.factor || piece.sign.ends_with('-') ? tex::factor(piece.formula, false)
                                                                : tex::set(piece.formula, false);
  const std::string size = content.tall ? "\\bigg" : "\\big";
  Set result;
  if (!piece.sign.empty()) result = {signs(piece.sign), relation_width};
  for (int i = 0; i < piece.opens; ++i) result += {size + "l(", 0.5};
  result += content;
  for (int i = 0; i < piece.closes; ++i) result += {size + "r)", 0.5};
  return result;
}

}  // namespace

std::string latex(const Formula& formula) { return tex::set(formula, false).code; }

double latex_width(const Formula& formula) { return tex::set(formula, false).width; }

std::string latex_display(const Formula& equation, double room) {
  const Set whole = tex::set(equation, false);
  if (whole.width <= room) return whole.code;
  std::string code = "\\begin{aligned}\n& ";
  double used = 0;
  for (const Piece& piece : pieces(equation, latex_width, room - 6)) {
    const Set next = set(piece);
    const bool relates = piece.sign.find_first_of("=<>!") != std::string::npos;
    if (used > 0 && (used + next.width > room || (relates && used > room / 3))) {
      code += " \\\\\n& \\quad {}";
      used = 1;
    }
    code += " " + next.code;
    used += next.width;
  }
  return code + "\n\\end{aligned}";
}

std::string latex_escaped(std::string_view text) {
  static const std::map<char, std::string> escapes{{'\\', "\\textbackslash{}"},
                                                   {'{', "\\{"},
                                                   {'}', "\\}"},
                                                   {'$', "\\$"},
                                                   {'&', "\\&"},
                                                   {'#', "\\#"},
                                                   {'%', "\\%"},
                                                   {'_', "\\_"},
                                                   {'^', "\\textasciicircum{}"},
                                                   {'~', "\\textasciitilde{}"},
                                                   {'<', "\\textless{}"},
                                                   {'>', "\\textgreater{}"},
                                                   {'|', "\\textbar{}"},
                                                   {'"', "\\textquotedbl{}"},
                                                   {'\'', "\\textquotesingle{}"}};
  std::string result;
  for (const char character : text) {
    const auto escape = escapes.find(character);
    result += escape == escapes.end() ? std::string(1, character) : escape->second;
  }
  return result;
}

}  // namespace magicmass::render
