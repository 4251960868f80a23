// SPDX-License-Identifier: GPL-2.0-or-later
#include "learn/judge.hpp"

#include <sstream>

#include "answers/shown_text.hpp"
#include "learn/form.hpp"
#include "learn/terms.hpp"

namespace learn {
namespace {

/// Without a byte order mark, lines that begin with #, and space around it.
std::string plain(std::string text) {
  if (text.starts_with("\xEF\xBB\xBF")) text.erase(0, 3);
  std::istringstream lines(text);
  std::string all, line;
  while (std::getline(lines, line)) {
    const std::size_t begin = line.find_first_not_of(" \t\r");
    if (begin == line.npos || line[begin] == '#') continue;
    all +=
        (all.empty() ? "" : "\n") + line.substr(begin, line.find_last_not_of(" \t\r") + 1 - begin);
  }
  return all;
}

/// As a student would type it, where the exercise has names of what was run.
std::string with_numbers(const Exercise& e, const std::string& text) {
  if (e.run.empty() || !e.choices.empty() || e.kind == "code") return text;
  const Terms terms(e);
  return notation::typed_text(terms.in_full(terms.content(text)));
}

}  // namespace

const char* word(Mark mark) {
  constexpr const char* words[]{"right", "other form", "incomplete",
                                "wrong", "unread",     "undecided"};
  return words[static_cast<std::size_t>(mark)];
}

Judgement judge(const Exercise& e, const std::string& typed, const Run& run) {
  const std::string text = e.kind == "code" ? typed : plain(typed);
  if (text.empty()) return {Mark::unread, "The answer is empty."};
  try {
    Judgement said = e.kind == "code"       ? judge_code(e, text, run)
                     : e.kind == "symbolic" ? judge_symbolic(e, text)
                     : e.kind == "predict"  ? judge_prediction(e, text)
                                            : judge_derivation(e, text);
    for (const Misconception& one : e.misconceptions)
      if (said.feedback == one.feedback) said.misconception = one.name;
    return said;
  } catch (const kernel::Refused& r) {
    const std::string why = answers::shown_text(r.what(), 300);
    return {Mark::unread,
            "Not understood: " + why + (why.ends_with('?') || why.ends_with('.') ? "" : ".")};
  }
}

std::string own_answer(const Exercise& e) {
  if (e.kind == "code") return e.solution_code;
  if (!e.when.empty()) return std::string(1, right_choice(e));
  return e.answer.empty() ? notation::typed_text(Terms(e).answer()) : with_numbers(e, e.answer);
}

Texts faults(const Exercise& e, const Run& run) {
  Texts wrong;
  try {
    const Judgement own = judge(e, own_answer(e), run);
    if (own.mark != Mark::right)
      wrong.push_back("its own answer is judged " + std::string(word(own.mark)) + ": " +
                      own.feedback);
    for (const Misconception& one : e.misconceptions)
      for (const std::string& text : one.answers) {
        const Judgement said = judge(e, with_numbers(e, text), run);
        const std::string& name = e.kind == "code" ? one.name : text;
        if (said.mark != Mark::wrong || said.feedback != one.feedback)
          wrong.push_back("the misconception " + name + " is judged " + word(said.mark) + ": " +
                          said.feedback);
      }
    if (e.kind == "code")
      if (const Judgement said = judge(e, e.starter, run); said.mark != Mark::wrong)
        wrong.push_back("the starter is judged " + std::string(word(said.mark)) + ": " +
                        said.feedback);
    if (e.hints.empty()) wrong.push_back("hints are missing");
  } catch (const std::exception& error) {
    wrong.push_back(error.what());
  }
  return wrong;
}

Judgement judge_symbolic(const Exercise& e, const std::string& text) {
  const Terms terms(e);
  Judgement said;
  const Expr typed = terms.typed_for_name(text, said.notes);
  const Expr given = terms.in_full(typed);
  if (const std::string foreign = terms.foreign(typed); !foreign.empty()) {
    said.feedback = misconception_of(terms, given);
    if (said.feedback.empty()) kernel::refuse(foreign);
    said.mark = Mark::wrong;
    return said;
  }
  const Expr expected = terms.in_full(terms.answer());
  const Judgement compared = terms.compare(given, expected);
  said.mark = compared.mark;
  said.feedback = compared.feedback;
  said.notes.insert(said.notes.end(), compared.notes.begin(), compared.notes.end());
  if (said.mark == Mark::right) {
    std::string lack = lacking(e.form, typed, terms.domain(notation::symbols_of(typed)));
    if (lack.empty()) return {Mark::right, "Right.", said.notes};
    // All of it is quoted as it was typed: + (-1) would be shown as - 1.
    const std::string all = notation::typed_text(typed) + " ";
    if (lack.starts_with(all) && text.find('=') == text.npos)
      lack.replace(0, all.size() - 1, quoted(text, typed));
    return {Mark::other_form,
            "Equal to the answer, but not in the form asked for (" + e.form + "): " + lack + ".",
            said.notes};
  }
  if (said.mark != Mark::wrong) return said;
  if (const std::string known = misconception_of(terms, given); !known.empty())
    said.feedback = known;
  else if (!kernel::is_matrix(given) && !kernel::is_matrix(expected) &&
           terms.are_equal(given, -expected))
    said.feedback = "Only the sign is wrong: yours is minus the answer.";
  return said;
}

}  // namespace learn
