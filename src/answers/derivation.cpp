// SPDX-License-Identifier: GPL-2.0-or-later
#include "answers/derivation.hpp"

#include <set>

#include "answers/errors.hpp"
#include "answers/shown_text.hpp"
#include "coq/files.hpp"
#include "derivation/book.hpp"
#include "kernel/print.hpp"
#include "render/pages.hpp"

namespace answers {
namespace {

using derivation::Chapter;
using derivation::Statement;
using kernel::Op;
using kernel::Theorem;

/// The shown theorems by number, in the book's order, and which of them each was made from.
using Numbers = std::set<std::size_t>;
class Index {
public:
  explicit Index(const derivation::Book& book) {
    kernel::Theorems shown;
    for (const Chapter& chapter : book.chapters()) {
      chapters.push_back(chapter.name);
      for (const Statement& s : chapter.statements) {
        const kernel::Expr conclusion = s.theorem.conclusion();
        numbers.emplace(conclusion, all.size());
        if (conclusion.op() == Op::And)
          for (const kernel::Expr& part : conclusion.args()) numbers.emplace(part, all.size());
        all.push_back({chapter, s});
        shown.push_back(s.theorem);
      }
    }
    proofs = coq::proofs_of(shown);
  }
  Numbers premises(std::size_t of) const {
    Numbers found;
    std::set<coq::Sequent> seen;
    const auto premises_of = [&](const Theorem& t) {
      return proofs.at(coq::sequent_of(t)).step().premises;
    };
    kernel::Theorems open = premises_of(all[of].statement.theorem);
    while (!open.empty()) {
      const Theorem t = open.back();
      open.pop_back();
      if (t.step().rule == "assume" || !seen.insert(coq::sequent_of(t)).second) continue;
      const auto shown = numbers.find(t.conclusion());
      if (shown != numbers.end() && shown->second < of)  // what is shown later is another one
        found.insert(shown->second);
      else
        for (const Theorem& p : premises_of(t)) open.push_back(p);
    }
    return found;
  }
  std::vector<std::string> ids(const Numbers& which) const {
    std::vector<std::string> texts;
    for (const std::size_t k : which) texts.push_back(all[k].statement.id);
    return texts;
  }
  struct Shown {
    const Chapter& chapter;
    const Statement& statement;
  };
  std::vector<Shown> all;
  std::vector<std::string> chapters;

private:
  coq::Proofs proofs;                           // none rests on itself
  std::map<kernel::Expr, std::size_t> numbers;  // a definition may be shown under more hypotheses
};

/// The chapters, steps and labels that are named.
std::vector<std::string> words_of(const Request& request) {
  std::vector<std::string> words = request.words;
  if (request.has("from")) words.push_back(request.text("from"));
  return words;
}
/// Proved as far as they need.
const derivation::Book& book_for(const Request& request) {
  const std::vector<std::string> words = words_of(request);
  bool is_all = words.empty();
  for (const std::string& word : words) {
    const bool is_chapter = word.find_first_of(".:") == word.npos;  // labels have a colon
    const bool is_there = derivation::is_shown(is_chapter ? word + "." : word);  // or its end
    is_all = is_all || (!is_chapter && !is_there);
  }
  return is_all ? derivation::the_book() : derivation::proved_so_far();
}
/// What is asked for; all where no word is given.
Numbers asked_for(const Request& request, const Index& index) {
  Numbers wanted;
  const std::vector<std::string> words = words_of(request);
  for (const std::string& word : words) {
    Numbers named;
    for (std::size_t k = 0; k < index.all.size(); ++k) {
      const auto& [chapter, s] = index.all[k];
      const bool is_label =
          !word.empty() && (" " + s.label + " ").find(" " + word + " ") != word.npos;
      if (s.id == word || chapter.name == word || is_label) named.insert(k);
    }
    if (named.empty()) {
      throw InvalidInput("derive: no chapter, step or label " + shown_text(word) +
                         "; chapters: " + joined(index.chapters) + "; steps: derive --list");
    }
    wanted.merge(named);
  }
  const bool takes_all = words.empty();
  for (std::size_t k = index.all.size(); k-- > 0;) {  // from the last to the first
    if (takes_all) wanted.insert(k);
    if (request.has("from") && wanted.count(k) != 0) wanted.merge(index.premises(k));
  }
  return wanted;
}

std::vector<render::Section> sections_of(const Numbers& wanted, const Index& index) {
  std::vector<render::Section> out;
  const Chapter* last = nullptr;
  for (const std::size_t k : wanted) {
    const auto& [chapter, s] = index.all[k];
    if (last != &chapter) out.push_back({chapter.title, chapter.assumptions, {}});
    last = &chapter;
    kernel::Exprs conditions = s.theorem.hypotheses();
    for (const kernel::Expr& assumption : chapter.assumptions) std::erase(conditions, assumption);
    out.back().steps.push_back({s.id, s.label, s.words, s.theorem.conclusion(), conditions,
                                s.theorem.step().rule, index.ids(index.premises(k))});
  }
  return out;
}

}  // namespace

std::vector<render::Section> derivation_sections() {
  const Index index(derivation::the_book());
  return sections_of(asked_for({}, index), index);
}

Answer derive(const Request& request) {
  const Index index(book_for(request));
  const Numbers wanted = asked_for(request, index);
  const std::map<std::string, std::string (*)(const std::vector<render::Section>&)> pages{
      {"text", render::text_page},
      {"markdown", render::markdown_page},
      {"latex", render::latex_page},
      {"html", render::html_page}};
  const auto page = pages.find(request.format);
  const bool is_list = request.format == "text" && request.has("list");
  if (page != pages.end() && !is_list) return {{}, page->second(sections_of(wanted, index))};
  Table table{{"id", "formula", "hypotheses", "label", "rule", "premises", "verdict"}, {}};
  std::string list;
  for (const std::size_t k : wanted) {
    const Statement& s = index.all[k].statement;
    std::vector<std::string> hypotheses;
    for (const kernel::Expr& h : s.theorem.hypotheses()) hypotheses.push_back(kernel::text(h));
    const std::string formula = kernel::text(s.theorem.conclusion());
    list += s.id + (s.label.empty() ? "" : " (" + s.label + ")") + "\n    " + formula + "\n";
    table.rows.push_back({text_cell(s.id), text_cell(formula), list_cell(hypotheses),
                          text_cell(s.label), text_cell(s.theorem.step().rule),
                          list_cell(index.ids(index.premises(k))), text_cell("proved")});
  }
  return {table, is_list ? list : ""};
}

Answer verify(const Request&) {
  std::string problem;
  try {
    derivation::the_book();
  } catch (const kernel::Refused& refused) {
    problem = refused.what();
  }
  kernel::Theorems shown;
  for (const Chapter& chapter : derivation::proved_so_far().chapters())
    for (const Statement& s : chapter.statements) shown.push_back(s.theorem);
  return verified(shown, problem);
}

Answer verified(const kernel::Theorems& shown, const std::string& problem) {
  const bool has_failed = !problem.empty();
  Answer answer{one_row({{"proved", whole_cell(shown.size())},
                         {"failed", whole_cell(has_failed ? 1 : 0)},
                         {"steps", whole_cell(coq::proofs_of(shown).size())}})};
  answer.check_failed = has_failed;
  if (has_failed) answer.note = "verify: not proved: " + problem;
  return answer;
}

}  // namespace answers
