// SPDX-License-Identifier: GPL-2.0-or-later
#include "learn/terms.hpp"

#include <algorithm>
#include <sstream>

#include "answers/equality.hpp"
#include "answers/errors.hpp"
#include "answers/shown_text.hpp"
#include "answers/velocities.hpp"
#include "equality/constant.hpp"
#include "learn/spelling.hpp"
#include "magicmass/scenes/keys.hpp"

namespace learn {
namespace {

using answers::InvalidInput;

std::set<std::string> as_set(const Texts& texts) { return {texts.begin(), texts.end()}; }

/// "count --alpha 3/25": the numbers of its one row by their columns' names.
std::map<std::string, std::string> ran(const std::string& line) {
  static const std::map<std::string, answers::Answer (*)(const answers::Request&)> commands{
      {"eval", answers::eval}, {"count", answers::count}, {"terminal", answers::terminal}};
  std::map<std::string, std::string> numbers;
  if (line.empty()) return numbers;
  std::istringstream words(line);
  std::string command, option, value;
  words >> command;
  answers::Request request;
  while (words >> option >> value) request.options.emplace(option.erase(0, 2), value);
  const auto found = commands.find(command);
  if (found == commands.end()) throw InvalidInput("run: allowed: eval, count, terminal");
  const answers::Table table = found->second(request).table;
  for (std::size_t i = 0; i < table.columns.size(); ++i) {
    std::string text = table.rows.at(0).at(i).text;
    if (text.find_first_of("0123456789") != text.npos &&
        text.find_first_not_of("-+./e0123456789") == text.npos) {
      std::replace(text.begin(), text.end(), 'e', 'E');  // 1e-12 has two readings
      numbers.emplace(table.columns[i], text);
    }
  }
  return numbers;
}

/// "V = 1, alpha = 2": by name, whatever was named first.
std::string by_name(const std::string& point) {
  Texts each = parts(point, ',');
  for (std::string& one : each) one.erase(0, one.find_first_not_of(' '));
  std::sort(each.begin(), each.end());
  return answers::joined(each);
}

/// A counterexample in words. Of constants the right value is not given away.
std::string difference(const equality::Counterexample& c) {
  if (c.point.empty())
    return std::string("Yours is too ") + (c.difference.starts_with('-') ? "small." : "large.");
  const auto shown = [](const std::string& value) {
    return value.starts_with("too close") ? "0, or very nearly" : value;
  };
  const bool is_close = c.difference.find("e-") != c.difference.npos;
  return "At " + by_name(c.point) + " yours is " + shown(c.left) + "; it should be " +
         shown(c.right) + (is_close ? ", apart by " + c.difference + "." : ".");
}

/// ", for instance at alpha = 1: why" where yours certainly has no value at most of the points
/// where the right answer has one; else nothing.
std::string without_value(Expr given, Expr expected, const equality::Domain& domain) {
  constexpr std::size_t tried = 60;
  const auto why_none = [](Expr constant) -> std::optional<std::string> {
    try {
      equality::enclosure(constant, 192);
      return "";
    } catch (const equality::NotDefined& none) {
      return none.what();
    } catch (const equality::NotCertain&) {
      return {};
    }
  };
  std::string first;
  int all = 0, gaps = 0;
  for (const equality::Point& point : equality::points(domain, tried, {given, expected})) {
    if (why_none(equality::at(point, expected)) != "") continue;
    ++all;
    const std::string why = why_none(equality::at(point, given)).value_or("");
    if (why.empty()) continue;
    if (++gaps > 1) continue;
    first =
        (point.empty() ? "" : ", for instance at " + by_name(equality::text(point))) + ": " + why;
  }
  return 2 * gaps > all ? first : "";
}

}  // namespace

Terms::Terms(const Exercise& e) : exercise(e) {
  for (const auto& [name, text] : e.values) values.emplace(notation::symbol(name), content(text));
  for (const auto& [name, text] : ran(e.run)) values.emplace(notation::symbol(name), content(text));
}

int Terms::columns() const {
  if (exercise.kind != "symbolic") return 0;
  const Expr expected = answer();
  return kernel::is_matrix(expected) ? expected.cols() : 0;
}

Expr Terms::typed(std::string text, Texts& notes) const {
  const std::set<std::string> names = as_set(exercise.symbols);
  constexpr std::size_t longest = 20000;  // more is refused by the reader
  if (text.size() <= longest) text = with_spaces(bracketed(text, columns() == 1), names, notes);
  std::set<std::string> known = names;
  for (const auto& [name, value] : exercise.values) known.insert(name);
  if (const std::string the_unit = unit(text, known); !the_unit.empty())
    kernel::refuse(
        "an answer is written without a unit such as " + the_unit + ": " +
        (names.empty() ? "it is a number, in units of V and L" : "its symbols have their own"));
  const notation::Typed read = notation::read_typed(text, names);
  notes.insert(notes.end(), read.notes.begin(), read.notes.end());
  return read.term;
}

Expr Terms::typed_for_name(const std::string& text, Texts& notes) const {
  const std::size_t sign = text.find('=');
  if (sign == text.npos) return typed(text, notes);
  const Texts sides{text.substr(0, sign), text.substr(sign + 1)};
  if (sides[1].find('=') != sides[1].npos) kernel::refuse("one equation is expected, with one =");
  if (exercise.name.empty())
    kernel::refuse("what is asked for has no name; write the expression alone, without =");
  const Expr name = content(exercise.name);
  for (const int side : {0, 1}) {
    Texts ignored;
    if (typed(sides[std::size_t(side)], ignored) == name)
      return typed(sides[std::size_t(1 - side)], notes);
  }
  kernel::refuse("neither side of this equation is " + exercise.name + ", which is asked for");
}

Expr Terms::content(const std::string& text) const {
  try {
    return notation::read_typed(text, as_set(exercise.symbols)).term;
  } catch (const kernel::Refused& r) {
    throw InvalidInput(text + ": " + r.what());
  }
}

Expr Terms::from_step(const std::string& id) const {
  try {
    return answers::stated_value(id);
  } catch (const kernel::Refused& r) {
    throw InvalidInput(r.what());
  }
}

Expr Terms::answer() const {
  return exercise.answer_from.empty() ? content(exercise.answer) : from_step(exercise.answer_from);
}

std::string Terms::foreign(Expr term) const {
  Texts names;
  const std::set<std::string> symbols = as_set(exercise.symbols);
  for (const std::string& name : notation::symbols_of(term))
    if (!symbols.contains(name) && !exercise.values.contains(name)) names.push_back(name);
  if (names.empty()) return {};
  std::string meant = notation::alike(names[0], symbols);
  if (meant.empty()) meant = parted(names[0], symbols);
  if (meant.empty()) meant = magicmass::scenes::nearest_name(names[0], exercise.symbols);
  std::replace(meant.begin(), meant.end(), ' ', '*');
  return answers::joined(names) + (names.size() == 1 ? " has" : " have") + " no place here: " +
         (symbols.empty() ? "a number is asked for"
                          : "an answer may use " + answers::joined(exercise.symbols)) +
         (meant.empty() ? "" : "; is " + meant + " meant?");
}

Expr Terms::in_full(Expr term) const {
  // An angle stays an angle where nothing is said of the mass ratio.
  const bool has_alpha = as_set(exercise.symbols).contains("alpha");
  Texts ignored;
  if (has_alpha || !foreign(term).empty()) term = answers::with_meanings(term, ignored);
  return kernel::substitute(term, values);
}

equality::Domain Terms::domain(const std::set<std::string>& symbols) const {
  std::set<std::string> all = symbols;
  all.insert(exercise.symbols.begin(), exercise.symbols.end());
  Texts ignored;
  equality::Domain domain = equality::read_domain(exercise.domain, all, ignored);
  std::erase_if(domain.ranges, [&](const auto& range) {
    return !symbols.contains(notation::name_of(range.first));
  });
  for (notation::Comparison& c : domain.further) {
    c.left = in_full(c.left);
    c.right = in_full(c.right);
  }
  std::erase_if(domain.further, [&](const notation::Comparison& c) {
    const std::set<std::string> needed = notation::symbols_of(c.left - c.right);
    return !std::includes(symbols.begin(), symbols.end(), needed.begin(), needed.end());
  });
  return domain;
}

Judgement Terms::compare_numbers(Expr given, Expr expected) const {
  std::set<std::string> symbols = notation::symbols_of(given);
  symbols.merge(notation::symbols_of(expected));
  equality::Verdict verdict;
  equality::Domain where;
  std::string why = "It could not be decided whether yours is equal to the answer.";
  try {
    where = domain(symbols);
    verdict = equality::decide(given, expected, where);
  } catch (const kernel::Refused& r) {
    why = "It could not be compared: " + std::string(r.what()) + ".";
  }
  if (verdict.answer == equality::Answer::Undecided) {
    const std::string none = without_value(given, expected, where);
    if (none.empty()) return {Mark::undecided, why};
    return {Mark::wrong, "Yours has no real value" + none + "."};
  }
  if (verdict.answer == equality::Answer::Different)
    return {Mark::wrong, difference(*verdict.counterexample)};
  for (std::string note : verdict.notes) {
    const std::string left = "the left side alone has no value";
    if (!note.starts_with(left)) continue;
    const std::size_t begin = left.size() + 4, end = note.find(": ");  // " at "
    note = "yours has no value at " + by_name(note.substr(begin, end - begin)) + note.substr(end);
    const bool is_gap = std::none_of(verdict.conditions.begin(), verdict.conditions.end(),
                                     [](const std::string& c) { return c.find('>') != c.npos; });
    if (is_gap) return {Mark::right, "", {note}};
    return {Mark::wrong, "It is equal where it has a value, but " + note + "."};
  }
  return {Mark::right, ""};
}

Judgement Terms::compare(Expr given, Expr expected) const {
  const bool is_matrix = kernel::is_matrix(expected);
  if (is_matrix != kernel::is_matrix(given))
    return {Mark::wrong, is_matrix ? "A matrix is asked for." : "A matrix is not asked for."};
  if (!is_matrix) return compare_numbers(given, expected);
  const auto shape = [](Expr m) {
    return std::to_string(m.rows()) + " by " + std::to_string(m.cols());
  };
  if (shape(given) != shape(expected))
    return {Mark::wrong, "Yours is " + shape(given) + " (rows by columns); " + shape(expected) +
                             " is asked for."};
  Judgement all{Mark::right, ""};
  for (int row = 0; row < given.rows(); ++row)
    for (int column = 0; column < given.cols(); ++column) {
      Judgement one =
          compare_numbers(kernel::entry(given, row, column), kernel::entry(expected, row, column));
      if (one.mark == Mark::right) continue;
      one.feedback = "Row " + std::to_string(row + 1) + ", column " + std::to_string(column + 1) +
                     ": " + one.feedback;
      if (one.mark == Mark::wrong) return one;
      all = one;
    }
  return all;
}

std::string quoted(const std::string& typed, Expr read) {
  constexpr std::size_t longest = 80;
  const std::size_t begin = typed.find_first_not_of(" \t"), end = typed.find_last_not_of(" \t");
  const std::string text = typed.substr(begin, end + 1 - begin);
  return answers::shown_text(text, longest) == text ? text : notation::typed_text(read);
}

std::string misconception_of(const Terms& terms, Expr given) {
  for (const Misconception& one : terms.exercise.misconceptions)
    for (const std::string& text : one.answers)
      if (terms.are_equal(given, terms.in_full(terms.content(text)))) return one.feedback;
  return {};
}

}  // namespace learn
