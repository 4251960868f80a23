// SPDX-License-Identifier: GPL-2.0-or-later
#include "answers/derivation.hpp"

#include <algorithm>

#include "answers/errors.hpp"
#include "coq/files.hpp"
#include "derivation/book.hpp"

namespace answers {
namespace {

using derivation::Chapter;
using derivation::Statement;
using kernel::Op;
using kernel::Theorem;

/// A theorem where it is shown; which others it was made from, by their places in the book's order.
using Places = std::set<std::size_t>;
struct Shown {
  const Chapter& chapter;
  const Statement& statement;
  Places premises = {};
};

std::vector<Shown> all_shown(const derivation::Book& book) {
  std::vector<Shown> all;
  std::map<kernel::Expr, std::size_t> places;  // a definition may be shown under more hypotheses
  kernel::Theorems theorems;
  for (const Chapter& chapter : book.chapters())
    for (const Statement& s : chapter.statements) {
      const kernel::Expr conclusion = s.theorem.conclusion();
      places.emplace(conclusion, all.size());
      if (conclusion.op() == Op::And)
        for (const kernel::Expr& part : conclusion.args()) places.emplace(part, all.size());
      all.push_back({chapter, s});
      theorems.push_back(s.theorem);
    }
  const coq::Proofs proofs = coq::proofs_of(theorems);  // none rests on itself
  for (std::size_t k = 0; k < all.size(); ++k) {
    std::set<coq::Sequent> seen;
    kernel::Theorems open{theorems[k]};
    while (!open.empty()) {
      const coq::Sequent next = coq::sequent_of(open.back());
      open.pop_back();
      for (const Theorem& t : proofs.at(next).step().premises) {
        if (t.step().rule == "assume" || !seen.insert(coq::sequent_of(t)).second) continue;
        const auto shown = places.find(t.conclusion());
        if (shown != places.end() && shown->second < k)  // what is shown later is another one
          all[k].premises.insert(shown->second);
        else
          open.push_back(t);
      }
    }
  }
  return all;
}
std::vector<std::string> ids(const Places& which, const std::vector<Shown>& all) {
  std::vector<std::string> texts;
  for (const std::size_t k : which) texts.push_back(all[k].statement.id);
  return texts;
}

/// The chapters, steps and labels that are named.
std::vector<std::string> words_of(const Request& request) {
  std::vector<std::string> words = request.words;
  if (request.has("from")) words.push_back(request.text("from"));
  return words;
}
/// Proved as far as they need.
const derivation::Book& book_for(const Request& request) {
  const std::vector<std::string> words = words_of(request);
  const auto is_proved = [](const std::string& word) {
    const bool is_chapter = word.find_first_of(".:") == word.npos;  // labels have a colon
    return derivation::is_shown(is_chapter ? word + "." : word) || is_chapter;  // or its end
  };
  const bool is_all = words.empty() || !std::ranges::all_of(words, is_proved);
  return is_all ? derivation::the_book() : derivation::proved_so_far();
}
/// What is asked for; all where no word is given.
Places asked_for(const Request& request, const std::vector<Shown>& all) {
  Places wanted;
  const std::vector<std::string> words = words_of(request);
  for (const std::string& word : words) {
    Places named;
    for (std::size_t k = 0; k < all.size(); ++k) {
      const auto& [chapter, s, premises] = all[k];
      const bool is_label =
          !word.empty() && (" " + s.label + " ").find(" " + word + " ") != word.npos;
      if (s.id == word || chapter.name == word || is_label) named.insert(k);
    }
    if (named.empty()) {
      std::vector<std::string> chapters;
      for (const Chapter& chapter : derivation::the_book().chapters())
        chapters.push_back(chapter.name);
      throw InvalidInput("derive: no chapter, step or label " + shown_text(word) +
                         "; chapters: " + joined(chapters) + "; steps: derive --list");
    }
    wanted.merge(named);
  }
  for (std::size_t k = all.size(); k-- > 0;) {  // from the last to the first
    if (words.empty()) wanted.insert(k);
    if (request.has("from") && wanted.contains(k))
      wanted.insert(all[k].premises.begin(), all[k].premises.end());
  }
  return wanted;
}

std::vector<render::Section> sections_of(const Places& wanted, const std::vector<Shown>& all) {
  std::vector<render::Section> out;
  const Chapter* last = nullptr;
  for (const std::size_t k : wanted) {
    const auto& [chapter, s, premises] = all[k];
    if (last != &chapter) out.push_back({chapter.title, chapter.assumptions, {}});
    last = &chapter;
    kernel::Exprs conditions = s.theorem.hypotheses();
    for (const kernel::Expr& assumption : chapter.assumptions) std::erase(conditions, assumption);
    out.back().steps.push_back({s.id, s.label, s.words, s.theorem.conclusion(), conditions,
                                s.theorem.step().rule, ids(premises, all)});
  }
  return out;
}

}  // namespace

std::vector<render::Section> derivation_sections() {
  const std::vector<Shown> all = all_shown(derivation::the_book());
  return sections_of(asked_for({}, all), all);
}

Answer derive(const Request& request) {
  const std::vector<Shown> all = all_shown(book_for(request));
  const Places wanted = asked_for(request, all);
  const std::map<std::string, std::string (*)(const std::vector<render::Section>&)> pages{
      {"text", render::text_page},
      {"markdown", render::markdown_page},
      {"latex", render::latex_page},
      {"html", render::html_page}};
  const auto page = pages.find(request.format);
  const bool is_list = request.format == "text" && request.has("list");
  if (page != pages.end() && !is_list) return {{}, page->second(sections_of(wanted, all))};
  Table table{{"id", "formula", "hypotheses", "label", "rule", "premises", "verdict"}, {}};
  std::string list;
  for (const std::size_t k : wanted) {
    const auto& [chapter, s, premises] = all[k];
    std::vector<std::string> hypotheses;
    for (const kernel::Expr& h : s.theorem.hypotheses()) hypotheses.push_back(kernel::text(h));
    const std::string formula = kernel::text(s.theorem.conclusion());
    list += s.id + (s.label.empty() ? "" : " (" + s.label + ")") + "\n    " + formula + "\n";
    table.rows.push_back({text_cell(s.id), text_cell(formula), list_cell(hypotheses),
                          text_cell(s.label), text_cell(s.theorem.step().rule),
                          list_cell(ids(premises, all)), text_cell("proved")});
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
