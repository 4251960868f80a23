// SPDX-License-Identifier: GPL-2.0-or-later
#include "answers/derivation.hpp"

#include <algorithm>
#include <set>

#include "answers/errors.hpp"
#include "answers/shown_text.hpp"
#include "derivation/book.hpp"
#include "kernel/print.hpp"
#include "render/pages.hpp"

namespace answers {
namespace {

using derivation::Chapter;
using derivation::Statement;
using kernel::Theorem;

/// What a theorem says; two of one content are one theorem to a reader.
using Content = std::pair<kernel::Exprs, kernel::Expr>;
Content content_of(const Theorem& theorem) { return {theorem.hypotheses(), theorem.conclusion()}; }

/// All theorems that a step was made from, those in its certificate too.
kernel::Theorems premises_of(const kernel::Step& step) {
  kernel::Theorems all = step.premises;
  if (!step.certificate) return all;
  for (const auto& [cofactor, equation] : step.certificate->equations) all.push_back(equation);
  for (const auto& product : step.certificate->products)
    all.insert(all.end(), product.factors.begin(), product.factors.end());
  for (const auto* more : {&step.certificate->multipliers, &step.certificate->nonzero})
    all.insert(all.end(), more->begin(), more->end());
  return all;
}

/// The shown theorems of the book, and which of them each was made from.
class Index {
public:
  explicit Index(const derivation::Book& the_book) : book(the_book) {
    for (const Chapter& chapter : book.chapters())
      for (const Statement& s : chapter.statements) ids.emplace(s.theorem.conclusion(), s.id);
  }
  std::vector<std::string> premises(const Statement& s) const {
    std::set<std::string> found;
    std::set<Content> seen;
    std::vector<Theorem> open = premises_of(s.theorem.step());
    while (!open.empty()) {
      const Theorem t = open.back();
      open.pop_back();
      const Content content = content_of(t);
      if (!seen.insert(content).second) continue;
      const auto shown = ids.find(t.conclusion());
      if (shown != ids.end() && shown->second != s.id) {
        found.insert(shown->second);
        continue;
      }
      for (const Theorem& p : premises_of(t.step())) open.push_back(p);
    }
    std::vector<std::string> in_order;
    for (const Chapter& chapter : book.chapters()) {
      for (const Statement& other : chapter.statements)
        if (found.count(other.id) != 0) in_order.push_back(other.id);
    }
    return in_order;
  }
  const derivation::Book& book;

private:
  std::map<kernel::Expr, std::string> ids;  // a definition may be shown under more hypotheses
};

/// The ids that are asked for; all where no word is given.
std::set<std::string> asked_for(const Request& request, const Index& index) {
  std::set<std::string> wanted;
  const auto add = [&](const std::string& word) {
    const std::size_t before = wanted.size();
    for (const Chapter& chapter : index.book.chapters()) {
      for (const Statement& s : chapter.statements)
        if (s.id == word || chapter.name == word) wanted.insert(s.id);
    }
    if (wanted.size() == before) {
      std::vector<std::string> names;
      for (const Chapter& chapter : index.book.chapters()) names.push_back(chapter.name);
      throw InvalidInput("derive: no chapter or step " + shown_text(word) +
                         "; chapters: " + joined(names) + "; steps: derive --list");
    }
  };
  for (const std::string& word : request.words) add(word);
  if (request.has("from")) add(request.text("from"));
  if (wanted.empty())
    for (const Chapter& chapter : index.book.chapters()) add(chapter.name);
  if (!request.has("from")) return wanted;
  // What they rest on, from the last statement to the first.
  const auto& chapters = index.book.chapters();
  for (auto chapter = chapters.rbegin(); chapter != chapters.rend(); ++chapter) {
    for (auto s = chapter->statements.rbegin(); s != chapter->statements.rend(); ++s) {
      if (wanted.count(s->id) != 0)
        for (const std::string& id : index.premises(*s)) wanted.insert(id);
    }
  }
  return wanted;
}

kernel::Exprs beyond(const kernel::Exprs& hypotheses, const kernel::Exprs& assumptions) {
  kernel::Exprs out;
  for (const kernel::Expr& h : hypotheses)
    if (std::find(assumptions.begin(), assumptions.end(), h) == assumptions.end()) out.push_back(h);
  return out;
}

std::vector<render::Section> sections(const std::set<std::string>& wanted, const Index& index) {
  std::vector<render::Section> out;
  for (const Chapter& chapter : index.book.chapters()) {
    render::Section section{chapter.title, chapter.assumptions, {}};
    for (const Statement& s : chapter.statements) {
      if (wanted.count(s.id) != 0) {
        section.steps.push_back({s.id, s.label, s.words, s.theorem.conclusion(),
                                 beyond(s.theorem.hypotheses(), chapter.assumptions),
                                 s.theorem.step().rule, index.premises(s)});
      }
    }
    if (!section.steps.empty()) out.push_back(section);
  }
  return out;
}

}  // namespace

std::vector<Column> derive_columns() {
  return {{"id", Type::text, "", "chapter and name"},
          {"formula", Type::text, "", "what is proved"},
          {"hypotheses", Type::list, "", "under which conditions"},
          {"label", Type::text, "", "the paper's equations"},
          {"rule", Type::text, "", "the kernel's rule of the last step"},
          {"premises", Type::list, "", "the steps that it was made from"},
          {"verdict", Type::text, "", "proved"}};
}

Answer derive(const Request& request) {
  const Index index(derivation::the_book());
  const std::set<std::string> wanted = asked_for(request, index);
  if (request.format == "markdown") return {{}, render::markdown_page(sections(wanted, index))};
  if (request.format == "text" && !request.has("list"))
    return {{}, render::text_page(sections(wanted, index))};
  Table table{derive_columns(), {}};
  std::string list;
  for (const Chapter& chapter : index.book.chapters()) {
    for (const Statement& s : chapter.statements) {
      if (wanted.count(s.id) == 0) continue;
      std::vector<std::string> hypotheses;
      for (const kernel::Expr& h : s.theorem.hypotheses()) hypotheses.push_back(kernel::text(h));
      const std::string formula = kernel::text(s.theorem.conclusion());
      list += s.id + (s.label.empty() ? "" : " (" + s.label + ")") + "\n    " + formula + "\n";
      table.rows.push_back({text_cell(s.id), text_cell(formula), list_cell(hypotheses),
                            text_cell(s.label), text_cell(s.theorem.step().rule),
                            list_cell(index.premises(s)), text_cell("proved")});
    }
  }
  return {table, request.format == "text" ? list : ""};
}

std::vector<Column> verify_columns() {
  return {{"proved", Type::whole, "1", "theorems that are shown"},
          {"failed", Type::whole, "1", "theorems whose proof was refused"},
          {"steps", Type::whole, "1", "different steps of the kernel"}};
}

Answer verify(const Request&) {
  const derivation::Book* book = nullptr;
  try {
    book = &derivation::the_book();
  } catch (const kernel::Refused& refused) {
    Table failed{verify_columns(), {{whole_cell(0), whole_cell(1), whole_cell(0)}}, false};
    return {failed, "not proved: " + std::string(refused.what()) + "\n", true};
  }
  std::int64_t shown = 0;
  std::set<Content> steps;
  std::vector<Theorem> open;
  for (const Chapter& chapter : book->chapters()) {
    for (const Statement& s : chapter.statements) {
      ++shown;
      open.push_back(s.theorem);
    }
  }
  while (!open.empty()) {
    const Theorem t = open.back();
    open.pop_back();
    if (!steps.insert(content_of(t)).second) continue;
    for (const Theorem& p : premises_of(t.step())) open.push_back(p);
  }
  const auto step_count = static_cast<std::int64_t>(steps.size());
  return {{verify_columns(), {{whole_cell(shown), whole_cell(0), whole_cell(step_count)}}, false},
          ""};
}

}  // namespace answers
