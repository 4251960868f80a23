#include "answers/derivation.hpp"

#include <algorithm>

#include "coq/files.hpp"
#include "derivation/book.hpp"

namespace answers {
namespace {

using namespace derivation;
using namespace render;

/// Whether one holds wherever the other does: a definition may be shown under more hypotheses.
bool is_same_case(const kernel::Exprs& one, const kernel::Exprs& other) {
  const auto is_within = [](const kernel::Exprs& some, const kernel::Exprs& all) {
    return std::ranges::all_of(some, [&](auto h) { return std::ranges::count(all, h) > 0; });
  };
  return is_within(one, other) || is_within(other, one);
}

/// A step's premises are other steps before it, in the book's order.
std::vector<Section> sections_of(const Book& book) {
  std::multimap<kernel::Expr, std::size_t> places;
  kernel::Theorems theorems;
  std::vector<std::string> ids;
  for (const Chapter& chapter : book.chapters())
    for (const Statement& s : chapter.statements) {
      const kernel::Expr conclusion = s.theorem.conclusion();
      places.emplace(conclusion, ids.size());
      if (conclusion.op() == kernel::Op::And)
        for (const kernel::Expr& part : conclusion.args()) places.emplace(part, ids.size());
      theorems.push_back(s.theorem);
      ids.push_back(s.id);
    }
  const coq::Proofs proofs = coq::proofs_of(theorems);  // none rests on itself
  std::vector<Section> sections;
  std::size_t k = 0;  // the step's place
  for (const Chapter& chapter : book.chapters()) {
    sections.push_back({chapter.title, chapter.assumptions, {}});
    for (const Statement& s : chapter.statements) {
      std::set<std::size_t> premises;
      std::set<coq::Sequent> seen;
      kernel::Theorems open{s.theorem};
      while (!open.empty()) {
        const coq::Sequent next = coq::sequent_of(open.back());
        open.pop_back();
        for (const kernel::Theorem& t : proofs.at(next).step().premises) {
          if (t.step().rule == "assume" || !seen.insert(coq::sequent_of(t)).second) continue;
          const auto [first, last] = places.equal_range(t.conclusion());
          const auto shown = std::find_if(first, last, [&](const auto& place) {
            return place.second < k &&  // what is shown later is another one
                   is_same_case(theorems[place.second].hypotheses(), t.hypotheses());
          });
          if (shown != last)
            premises.insert(shown->second);
          else
            open.push_back(t);
        }
      }
      kernel::Exprs conditions = s.theorem.hypotheses();
      for (const kernel::Expr& assumed : chapter.assumptions) std::erase(conditions, assumed);
      Step step{s.id, s.label, s.words, s.theorem.conclusion(), conditions, s.theorem.step().rule,
                {}};
      for (const std::size_t place : premises) step.premises.push_back(ids[place]);
      sections.back().steps.push_back(step);
      ++k;
    }
  }
  return sections;
}

/// The book, proved as far as these chapters, steps and labels need.
const Book& book_for(const std::vector<std::string>& words) {
  const auto is_proved = [](const std::string& word) {
    const bool is_chapter = word.find_first_of(".:") == word.npos;  // labels have a colon
    return derivation::is_shown(is_chapter ? word + "." : word) || is_chapter;  // or its end
  };
  const bool is_all = words.empty() || !std::ranges::all_of(words, is_proved);
  return is_all ? derivation::the_book() : derivation::proved_so_far();
}

/// What is asked for; all where no word is given.
std::vector<Section> asked_for(const Request& request) {
  std::vector<std::string> words = request.words;
  if (request.has("from")) words.push_back(request.text("from"));
  std::vector<Section> sections = sections_of(book_for(words));
  if (words.empty()) return sections;
  std::set<std::string> wanted;
  for (const std::string& word : words) {
    bool is_known = false;
    for (const Section& section : sections)
      for (const Step& step : section.steps) {
        const bool is_label =
            !word.empty() && (" " + step.label + " ").find(" " + word + " ") != word.npos;
        if (step.id != word && !step.id.starts_with(word + ".") && !is_label) continue;
        wanted.insert(step.id);
        is_known = true;
      }
    if (is_known) continue;
    const auto chapters = texts_of(derivation::the_book().chapters(), &Chapter::name);
    throw InvalidInput("derive: no chapter, step or label " + shown_text(word) +
                       "; chapters: " + joined(chapters) + "; steps: derive --list");
  }
  for (auto section = sections.rbegin(); section != sections.rend(); ++section) {
    for (auto step = section->steps.rbegin(); step != section->steps.rend(); ++step)
      if (request.has("from") && wanted.contains(step->id))
        wanted.insert(step->premises.begin(), step->premises.end());
    std::erase_if(section->steps, [&](const Step& step) { return !wanted.contains(step.id); });
  }
  std::erase_if(sections, [](const Section& section) { return section.steps.empty(); });
  return sections;
}

}  // namespace

std::vector<Section> derivation_sections() { return sections_of(derivation::the_book()); }

Answer derive(const Request& request) {
  const std::vector<Section> sections = asked_for(request);
  const std::map<std::string, std::string (*)(const std::vector<Section>&)> pages{
      {"text", text_page}, {"markdown", markdown_page}, {"latex", latex_page}, {"html", html_page}};
  const auto page = pages.find(request.format);
  const bool is_list = request.format == "text" && request.has("list");
  if (page != pages.end() && !is_list) return {{}, page->second(sections)};
  Table table{{"id", "formula", "hypotheses", "label", "rule", "premises", "verdict"}, {}};
  std::string list;
  for (const Section& section : sections)
    for (const Step& step : section.steps) {
      const auto hypotheses =
          texts_of(derivation::shown(step.id).hypotheses(), [](auto h) { return kernel::text(h); });
      const std::string formula = kernel::text(step.formula);
      list += wrapped(step.id + (step.label.empty() ? "" : " (" + step.label + ")"), "") +
              wrapped(formula, "    ");
      table.rows.push_back({text_cell(step.id), text_cell(formula), list_cell(hypotheses),
                            text_cell(step.label), text_cell(step.rule), list_cell(step.premises),
                            text_cell("proved")});
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
  return {.table = one_row({{"proved", whole_cell(shown.size())},
                            {"failed", whole_cell(has_failed ? 1 : 0)},
                            {"steps", whole_cell(coq::proofs_of(shown).size())}}),
          .check_failed = has_failed,
          .note = has_failed ? "verify: not proved: " + problem : ""};
}

}  // namespace answers
