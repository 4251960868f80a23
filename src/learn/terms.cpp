// SPDX-License-Identifier: GPL-2.0-or-later
#include "learn/terms.hpp"

#include <algorithm>
#include <sstream>

#include "answers/equality.hpp"
#include "answers/errors.hpp"
#include "answers/shown_text.hpp"
#include "answers/velocities.hpp"
#include "magicmass/scenes/keys.hpp"

namespace learn {
namespace {

using answers::InvalidInput;

std::set<std::string> as_set(const Texts& texts) { return {texts.begin(), texts.end()}; }

/// "a, b; c, d" in brackets.
std::string bracketed(const std::string& text) {
  if (text.find_first_of("[{") != text.npos || text.find(';') == text.npos) return text;
  std::istringstream rows(text);
  std::string all;
  for (std::string row; std::getline(rows, row, ';');)
    all += (all.empty() ? "[" : ", [") + row + "]";
  return "[" + all + "]";
}

/// The names of which a word is made, with spaces: "M_2u_2" is "M_2 u_2"; "" where it is not.
std::string parted(const std::string& word, const std::set<std::string>& names) {
  if (names.contains(word)) return word;
  for (const std::string& name : names) {
    if (!word.starts_with(name)) continue;
    const std::string rest = parted(word.substr(name.size()), names);
    if (!rest.empty()) return name + " " + rest;
  }
  return {};
}

/// M_2u_2, as LaTeX has it, in two words where both are names: a power belongs to the last one.
std::string with_spaces(const std::string& text, const std::set<std::string>& names, Texts& notes) {
  std::string all, word, plain;
  for (const char c : text + " ") {
    const bool is_letter = (c | 0x20) >= 'a' && (c | 0x20) <= 'z';
    const bool is_brace =
        (c == '{' && word.ends_with('_')) || (c == '}' && plain.size() < word.size());
    if (is_letter || is_brace || (!word.empty() && (c == '_' || (c >= '0' && c <= '9')))) {
      word += c;
      if (!is_brace) plain += c;
      continue;
    }
    const std::string apart = plain.find('_') == plain.npos ? "" : parted(plain, names);
    if (apart.find(' ') != apart.npos) {
      notes.push_back(word + " is read as " + apart);
      word = apart;
    }
    all += word + c;
    word = plain = "";
  }
  all.pop_back();
  return all;
}

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

/// A counterexample in words. Of constants the right value is not given away.
std::string difference(const equality::Counterexample& c) {
  if (c.point.empty())
    return std::string("Yours is too ") + (c.difference.starts_with('-') ? "small." : "large.");
  const std::string right = c.right.starts_with("too close") ? "0, or very nearly" : c.right;
  const bool is_close = c.difference.find("e-") != c.difference.npos;
  return "At " + c.point + " yours is " + c.left + "; it should be " + right +
         (is_close ? ", apart by " + c.difference + "." : ".");
}

}  // namespace

Terms::Terms(const Exercise& e) : exercise(e) {
  for (const auto& [name, text] : e.values) values.emplace(notation::symbol(name), content(text));
  for (const auto& [name, text] : ran(e.run)) values.emplace(notation::symbol(name), content(text));
}

Expr Terms::typed(std::string text, Texts& notes) const {
  const std::set<std::string> names = as_set(exercise.symbols);
  constexpr std::size_t longest = 20000;  // more is refused by the reader
  if (text.size() <= longest) text = with_spaces(bracketed(text), names, notes);
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
  const std::string meant = magicmass::scenes::nearest_name(names[0], exercise.symbols);
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
  return domain;
}

Judgement Terms::compare_numbers(Expr given, Expr expected) const {
  std::set<std::string> symbols = notation::symbols_of(given);
  symbols.merge(notation::symbols_of(expected));
  equality::Verdict verdict;
  try {
    verdict = equality::decide(given, expected, domain(symbols));
  } catch (const kernel::Refused& r) {
    const std::string why = r.what();
    if (symbols.empty())
      return {Mark::wrong,
              "Yours has no value" + why.substr(std::min(why.rfind(": "), why.size())) + "."};
    return {Mark::undecided, "It could not be compared: " + why + "."};
  }
  if (verdict.answer == equality::Answer::Undecided)
    return {Mark::undecided, "It could not be decided whether yours is equal to the answer."};
  if (verdict.answer == equality::Answer::Different)
    return {Mark::wrong, difference(*verdict.counterexample)};
  for (std::string note : verdict.notes) {
    const std::string left = "the left side alone has no value";
    if (!note.starts_with(left)) continue;
    note = "yours has no value" + note.substr(left.size());
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

std::string misconception_of(const Terms& terms, Expr given) {
  for (const Misconception& one : terms.exercise.misconceptions)
    for (const std::string& text : one.answers)
      if (terms.are_equal(given, terms.in_full(terms.content(text)))) return one.feedback;
  return {};
}

}  // namespace learn
