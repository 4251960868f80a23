// SPDX-License-Identifier: GPL-2.0-or-later
#include "equality/bounded.hpp"
#include "equality/paper_names.hpp"

namespace magicmass::equality {
namespace {

Tree parsed(const std::string& text, const char* side) {
  try {
    return parse(text);
  } catch (const NotAnExpression& error) {
    throw Refused(std::string("the ") + side + " side: " + error.what());
  }
}

std::vector<std::string> notes_on(const std::set<std::string>& names) {
  std::vector<std::string> notes;
  for (const std::string& name : names) {
    if (meaning(name)) {
      notes.push_back(name + " = " + meaning_as_printed(name));
    } else if (!is_paper_name(name)) {
      const std::string nearest = nearest_paper_name(name);
      if (!nearest.empty())
        notes.push_back(name + " is taken as a symbol of its own, a real number; did you mean " +
                        nearest + "?");
    }
  }
  return notes;
}

}  // namespace

Verdict answer(const Question& question, const std::function<void(const Verdict&)>& provisional) {
  const Tree left_as_typed = parsed(question.lhs, "left");
  const Tree right_as_typed = parsed(question.rhs, "right");
  std::set<std::string> names = symbols_of(left_as_typed);
  collect_symbols(right_as_typed, names);
  const Tree lhs = with_meanings(left_as_typed);
  const Tree rhs = with_meanings(right_as_typed);
  const std::vector<std::string> notes = notes_on(names);
  const auto with_notes = [&](Verdict verdict) {
    verdict.notes.insert(verdict.notes.end(), notes.begin(), notes.end());
    return verdict;
  };
  try {
    std::set<std::string> symbols = symbols_of(lhs);
    collect_symbols(rhs, symbols);
    const Domain domain = parse_domain(question.domain, symbols);
    return with_notes(decide(lhs, rhs, domain, [&](const Verdict& verdict) {
      if (provisional) provisional(with_notes(verdict));
    }));
  } catch (const NotAnExpression& error) {
    throw Refused(std::string("the domain: ") + error.what());
  } catch (const NoQuestion& error) {
    throw Refused(error.what());
  }
}

}  // namespace magicmass::equality
