// SPDX-License-Identifier: GPL-2.0-or-later
#include "course/formulas.hpp"

#include <algorithm>
#include <cctype>
#include <regex>
#include <set>

#include <fmt/format.h>

#include "course/refusal.hpp"
#include "render/formula.hpp"
#include "render/formula_latex.hpp"
#include "render/formula_mathml.hpp"
#include "render/html_frame.hpp"
#include "render/notation.hpp"

namespace magicmass::course {
namespace {

using render::html_escaped;

/// An equation that is wider, in em, scrolls on a phone; the keyboard must reach what scrolls.
constexpr double phone_width = 19;

render::Formula equation(const proof::Step& step) {
  return render::equation(step.from, step.relation, step.to);
}

/// What holds throughout the course; the first page says so, and no formula repeats it.
bool is_standing(const std::string& condition) {
  static const std::set<std::string> standing{
      "a(n) != a(n - 1) for every n from 1 up to there",
      "b(n) != b(n - 1) for every n from 1 up to there",
      "the objects do not pass through each other", "mu_A = M_A/(M_A + m)",
      "mu_B = M_B/(M_B + m) or mu_B = 1"};
  static const std::set<std::string> positive{
      "M", "m", "M_1", "M_2", "M_A", "M_B", "mu_A", "mu_B", "V", "L", "alpha", "e"};
  const auto sign = condition.find(" > 0");
  return standing.contains(condition) ||
         (sign + 4 == condition.size() &&
          positive.contains(condition.substr(0, sign)));
}

/// Every letter of it is a symbol: v_2 - v_1, but no word.
bool is_of_symbols(const render::Formula& formula) {
  using Kind = render::Formula::Kind;
  const bool is_name = formula.kind == Kind::name || formula.kind == Kind::call;
  if (formula.kind == Kind::verbatim || formula.kind == Kind::adjacent)
    return false;
  if (is_name && !render::looks_like_symbol(formula.text) &&
      !render::is_function_name(formula.text))
    return false;
  return std::all_of(formula.parts.begin(), formula.parts.end(), is_of_symbols);
}

bool is_verbatim(const render::Formula& formula) {
  return formula.kind == render::Formula::Kind::verbatim ||
         std::any_of(formula.parts.begin(), formula.parts.end(), is_verbatim);
}

bool holds_relation(const render::Formula& formula) {
  return formula.kind == render::Formula::Kind::relation ||
         std::any_of(formula.parts.begin(), formula.parts.end(), holds_relation);
}

std::string display(const render::Formula& formula) {
  const bool wide = render::latex_width(formula) > phone_width;
  return fmt::format(
      "<div class=\"equation\"{}>{}</div>",
      wide ? " tabindex=\"0\" role=\"group\" aria-label=\"equation\"" : "",
      render::mathml_display(formula));
}

}  // namespace

Steps by_id(const std::vector<proof::Step>& steps) {
  Steps result;
  for (const proof::Step& step : steps) result.emplace(step.id, step);
  return result;
}

std::string theorem_display(const proof::Step& step) {
  const render::Formula formula = equation(step);
  if (is_verbatim(formula))
    throw Refusal(step.id + " cannot be shown as a formula: " + step.from + " " +
                  step.relation + " " + step.to);
  std::string conditions;
  for (const std::string& condition : step.conditions)
    if (!is_standing(condition) &&
        step.verdict != "hypothesis")  // that is its own condition
      conditions += (!conditions.empty()            ? "; "
                     : condition.starts_with("as ") ? ", "
                                                    : " if ") +
                    render::html_prose(condition);
  return fmt::format(
      "<div class=\"theorem\">{0}\n<p class=\"source\"><a "
      "href=\"derivation.html#{1}\">{1}</a> "
      "<span class=\"verdict\">{2}{3}</span></p></div>",
      display(formula), html_escaped(step.id), html_escaped(step.verdict),
      conditions);
}

std::string side_display(const std::string& side) {
  return display(render::formula(side));
}

std::string theorem_inline(const proof::Step& step) {
  return fmt::format("<a class=\"formula\" href=\"derivation.html#{}\">{}</a>",
                     html_escaped(step.id), render::mathml(equation(step)));
}

std::string side_inline(const std::string& side) {
  return render::mathml(render::formula(side));
}

std::string term(const std::string& text) {
  const auto formula = render::read_formula(text);
  if (formula && !holds_relation(*formula)) return render::mathml(*formula);
  if (formula || render::read_relation(text))
    throw Refusal(
        "$" + text +
        "$ claims something; a claim comes from the derivation: {{theorem:id}}");
  throw Refusal(
      "$" + text +
      "$ is not in the derivation's notation, such as $a(n)$ or $n*psi/2$");
}

std::string heading(const std::string& text) {
  const auto formula = render::read_formula(text);
  return formula && is_of_symbols(*formula) ? render::mathml(*formula)
                                            : render::html_prose(text);
}

std::string value(const std::string& text) {
  const bool is_negative = text.size() > 1 && text[0] == '-' &&
                           std::isdigit(static_cast<unsigned char>(text[1])) != 0;
  if (is_negative) return "−" + value(text.substr(1));
  static const std::regex scientific("([0-9.]+)e([+-])0*([0-9]+)");
  std::smatch part;
  if (!std::regex_match(text, part, scientific)) return html_escaped(text);
  const std::string factor = part[1] == "1" ? "" : part[1].str() + "·";
  return factor + "10<sup>" + (part[2] == "-" ? "−" : "") + part[3].str() +
         "</sup>";
}

}  // namespace magicmass::course
