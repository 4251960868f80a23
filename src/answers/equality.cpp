#include <algorithm>

#include "answers/commands.hpp"
#include "answers/derivation.hpp"
#include "equality/decide.hpp"

namespace answers {
namespace {

Cell counterexample_cell(const equality::Verdict& verdict) {
  if (!verdict.counterexample) return missing_cell();
  const auto& [at, point, left, right, difference] = *verdict.counterexample;
  const Cell all = object_cell({{"at", text_cell(point)},
                                {"left", text_cell(left)},
                                {"right", text_cell(right)},
                                {"difference", text_cell(difference)}});
  return {(point.empty() ? "" : "at " + point + ": ") + left + " and " + right + ", apart by " +
              difference.substr(difference.starts_with('-') ? 1 : 0),
          all.json};
}

}  // namespace

Answer equal(const Request& request) {
  if (request.words.size() != 2)
    throw InvalidInput(
        "equal: two expressions are needed; example: magicmass equal \"sqrt(8)\" "
        "\"2*sqrt(2)\"");
  std::vector<std::string> notes;
  kernel::Exprs sides;
  std::set<std::string> symbols;
  std::string place = "left side, ";
  try {
    for (const std::string& word : request.words) {
      notation::Typed read = notation::read_typed(word);
      if (kernel::is_matrix(read.term)) kernel::refuse("a matrix; equal compares numbers");
      notes.insert(notes.end(), read.notes.begin(), read.notes.end());
      sides.push_back(with_meanings(read.term, notes));
      symbols.merge(notation::symbols_of(sides.back()));
      place = sides.size() == 1 ? "right side, " : "";
    }
    const equality::Domain domain = equality::read_domain(request.text("domain"), symbols, notes);
    const equality::Verdict verdict = equality::decide(sides[0], sides[1], domain);
    notes.insert(notes.end(), verdict.notes.begin(), verdict.notes.end());
    for (auto note = notes.begin(); note != notes.end(); ++note)  // of both sides: said once
      notes.erase(std::remove(note + 1, notes.end(), *note), notes.end());
    const std::string& theorem = verdict.theorem;
    return {.table = one_row({{"verdict", text_cell(equality::word(verdict.answer))},
                              {"proof", text_cell(verdict.proof)},
                              {"counterexample", counterexample_cell(verdict)},
                              {"domain", list_cell(verdict.domain)},
                              {"conditions", list_cell(verdict.conditions)},
                              {"theorem", theorem.empty() ? missing_cell() : text_cell(theorem)},
                              {"notes", list_cell(notes)}}),
            .check_failed = verdict.answer == equality::Answer::Different,
            .is_undecided = verdict.answer == equality::Answer::Undecided};
  } catch (const kernel::Refused& r) {
    throw InvalidInput("equal: " + place + shown_text(r.what(), 300));
  }
}

}  // namespace answers
