// Derivations, a line after the other: each must be true, and a small step from what stands before.
#include <span>

#include "equality/normal_form.hpp"
#include "learn/terms.hpp"

namespace learn {
namespace {

std::string line_name(std::size_t i) { return "line " + std::to_string(i + 1); }

/// A line or a side of it, or what is wrong with it by the line's number.
notation::Typed typed(const Terms& terms, const std::string& text, std::size_t line, Texts& notes) {
  return answers::with_place<kernel::Refused>(line_name(line) + ": ", [&] {
    const notation::Typed read = terms.typed(text, notes);
    for (Expr side : {read.term, read.right ? read.right : read.term}) {
      if (kernel::is_matrix(side)) kernel::refuse("a matrix");
      if (const std::string why = terms.foreign(side, text); !why.empty()) kernel::refuse(why);
    }
    return read;
  });
}

std::pair<Expr, Expr> both_sides(const Terms& terms, const std::string& equation) {
  const Texts sides = split(equation, '=');
  if (sides.size() != 2) throw InvalidInput(equation + ": an equation is expected");
  return {terms.content(sides[0]), terms.content(sides[1])};
}

/// An equation as left - right, in which the unknowns are symbols.
class Equations {
public:
  explicit Equations(const Terms& terms) : terms_(terms) {
    for (const auto& [name, step] : terms.exercise.unknowns) {
      unknowns_.push_back(notation::symbol(name));
      truth_.emplace(unknowns_.back(), terms.stated(step));
    }
    for (const std::string& law : terms.exercise.laws) laws_.push_back(content(law));
    for (const auto& term : terms.exercise.not_zero) not_zero_.push_back(terms.content(term));
  }
  Expr content(const std::string& equation) const {
    const auto [left, right] = both_sides(terms_, equation);
    return left - right;
  }
  bool is_zero(Expr e) const { return terms_.are_equal(e, 0); }
  /// Of an equation, with a counterexample. Also notes where it has no value.
  Judgement truth(const notation::Typed& e, std::size_t line, Texts& notes) const {
    const Expr left = kernel::substitute(e.term, truth_);
    const Expr right = kernel::substitute(e.right, truth_);
    Judgement said = terms_.compare(left - right, 0);
    for (const std::string& gap : said.notes) notes.push_back(line_name(line) + ": " + gap);
    if (said.mark == Mark::wrong) said = terms_.compare(left, right);
    replace_all(said.feedback, " yours is ", " its left side is ");
    replace_all(said.feedback, "; it should be ", ", its right side ");
    return said;
  }
  bool has_unknowns(Expr e) const { return kernel::substitute(e, truth_) != e; }
  /// One is the other times something without unknowns: e(v) f(w) = e(w) f(v) for all v and w.
  bool are_proportional(Expr e, Expr f) const {
    kernel::Substitution others;
    for (Expr unknown : unknowns_)
      others.emplace(unknown, notation::symbol(notation::name_of(unknown) + "_0"));
    return terms_.are_equal(e * kernel::substitute(f, others), kernel::substitute(e, others) * f);
  }
  std::string missing_law(std::span<const Expr> lines) const {
    for (std::size_t i = 0; i < laws_.size(); ++i) {
      const auto is_law = [&](Expr e) { return !is_zero(e) && are_proportional(e, laws_[i]); };
      if (std::ranges::none_of(lines, is_law)) return terms_.exercise.laws[i];
    }
    return {};
  }
  /// From a law, or one line before, or two: an unknown eliminated or one divided by the other.
  bool follows(Expr e, std::span<const Expr> before) const {
    const auto is_same = [&](Expr f) { return are_proportional(e, f); };
    if (std::ranges::any_of(laws_, is_same) || std::ranges::any_of(before, is_same)) return true;
    for (Expr f : before)
      for (Expr factor : not_zero_) {  // is left out, as it was typed in each term
        const auto has_factor = [&] { return is_zero(kernel::replace(f, factor, 0)); };
        if (equality::is_proved(has_factor) && are_proportional(e * factor, f)) return true;
      }
    for (Expr f : before)
      for (Expr by : before)
        for (Expr unknown : unknowns_)
          if (f != by && (eliminates(e, f, by, unknown) || divides(e, f, by, unknown))) return true;
    return false;
  }

private:
  const Terms& terms_;
  kernel::Exprs unknowns_, laws_, not_zero_;
  kernel::Substitution truth_;

  /// What the unknown is by a line that is linear in it.
  std::optional<Expr> solved(Expr line, Expr unknown) const {
    const Expr at_0 = kernel::substitute(line, {{unknown, 0}});
    const Expr slope = kernel::substitute(line, {{unknown, 1}}) - at_0;
    if (is_zero(slope) || !terms_.are_equal(line, slope * unknown + at_0)) return {};
    return -at_0 / slope;
  }
  bool eliminates(Expr e, Expr f, Expr by, Expr unknown) const {
    const std::optional<Expr> value = solved(by, unknown);
    if (!value) return false;
    const Expr left = kernel::substitute(f, {{unknown, *value}});
    const Expr e_left = kernel::substitute(e, {{unknown, *value}});
    return !is_zero(left) && !is_zero(e_left) && are_proportional(e_left, left);
  }
  /// f / by, each with what is 0 with the factor on one side: M_1 (u_1 - v_1) = M_2 (v_2 - u_2).
  bool divides(Expr e, Expr f, Expr by, Expr unknown) const {
    return std::ranges::any_of(not_zero_, [&](Expr factor) {
      const std::optional<Expr> zero = solved(factor, unknown);
      if (!zero) return false;
      const Expr f_right = kernel::substitute(f, {{unknown, *zero}});
      const Expr by_right = kernel::substitute(by, {{unknown, *zero}});
      const Expr crossed = by_right * f - f_right * by;
      return has_unknowns(f_right) && has_unknowns(by_right) && !is_zero(crossed) &&
             (are_proportional(e * factor * by_right, crossed) || are_proportional(e, crossed));
    });
  }
};

Judgement judge_equations(const Terms& terms, const Texts& lines, Texts& notes) {
  const Equations equations(terms);
  std::vector<notation::Typed> all;
  kernel::Exprs differences;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const notation::Typed& e = all.emplace_back(typed(terms, lines[i], i, notes));
    if (!e.right) kernel::refuse(line_name(i) + " is no equation; each line should have one =");
    differences.push_back(e.term - e.right);
  }
  const auto missing = [&](const std::string& otherwise) {
    const std::string law = equations.missing_law(differences);
    return law.empty() ? otherwise : " This law is missing: " + law + ".";
  };
  for (std::size_t i = 0; i < differences.size(); ++i) {
    const Expr e = differences[i];
    const std::span<const Expr> before(differences.data(), i);
    const std::string line = "Line " + std::to_string(i + 1);
    if (equations.is_zero(e))
      return {Mark::incomplete, line + " says nothing: it holds for all velocities." + missing("")};
    const Judgement said = equations.truth(all[i], i, notes);
    if (said.mark == Mark::undecided)
      return {said.mark, "It could not be decided whether " + line_name(i) + " is true."};
    if (said.mark == Mark::wrong) {
      const auto was_given = [&](const std::string& answer) {
        return equations.are_proportional(e, equations.content(answer));
      };
      return mistake(terms.exercise, was_given,
                     line + " is not true of this motion. " + said.feedback);
    }
    if (!equations.follows(e, before)) {
      const std::string later = equations.missing_law(before);
      return {Mark::incomplete,
              line +
                  (i == 0 ? " is true, but a derivation begins with a law."
                          : " is true, but how does it follow from the lines before it?") +
                  missing(!later.empty() ? " This law must stand before it: " + later + "."
                                         : " A step is missing between " + line_name(i - 1) +
                                               " and " + line_name(i) + ".")};
    }
  }
  const Expr left = all.back().term, right = all.back().right,
             name = terms.content(terms.exercise.name);
  if ((left != name || equations.has_unknowns(right)) &&
      (right != name || equations.has_unknowns(left)))
    return {Mark::incomplete, "Each line is right, but the end is missing: " + terms.exercise.name +
                                  " = an expression without unknowns." + missing("")};
  return {Mark::right, "Right: each line follows, and the last one is the answer."};
}

/// Lines that are equal to what stands before, each by an identity or by putting in the laws. An
/// equation that begins with something else stands for itself, and is a law if it is a small step.
Judgement judge_chain(const Terms& terms, const Texts& lines, Texts& notes) {
  const Exercise& e = terms.exercise;
  const Expr start = terms.content(e.start);
  Expr before = start;
  std::string shown_before = e.start;
  std::vector<std::pair<Expr, Expr>> laws, asides;
  for (const std::string& law : e.laws) laws.push_back(both_sides(terms, law));
  const auto with = [](const auto& equations, Expr term) {
    for (const auto& [left, right] : equations) term = kernel::replace(term, left, right);
    return term;
  };
  kernel::Substitution others;
  for (const std::string& name : notation::symbols_of(start))
    others.emplace(notation::symbol(name), notation::symbol(name + "_0"));
  const auto is_step = [&](Expr from, Expr to) {
    const auto is_moved = [&](const auto& aside) {  // what is on both sides of it, or a factor
      const Expr by_law = with(laws, aside.first - aside.second);
      return std::ranges::any_of(std::array{aside.first - aside.second, by_law}, [&](Expr is) {
        return !terms.are_equal(is, 0) &&
               terms.are_equal((from - to) * kernel::substitute(is, others),
                               kernel::substitute(from - to, others) * is);
      });
    };
    return terms.are_equal(from, to) || terms.are_equal(with(laws, from), to) ||
           terms.are_equal(with(laws, with(asides, from)), to) ||
           std::ranges::any_of(asides, is_moved);
  };
  const auto is_finished = [&] { return terms.lacking(before, shown_before).empty(); };
  const auto goes_on = [&](std::size_t i) { return i < lines.size() && lines[i].starts_with("="); };
  const auto missing = [&](const std::string& how) {  // where no step was more than an identity
    const auto is_law = [&](const auto& both) { return !terms.are_equal(both.first, both.second); };
    const bool is_used = !terms.are_equal(start, before) || std::ranges::any_of(asides, is_law);
    return is_used ? "" : how + e.laws[0] + ".";
  };
  std::pair reached{before, shown_before};
  bool is_aside = false;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (is_aside && !goes_on(i)) std::tie(before, shown_before) = reached;
    is_aside = is_aside && goes_on(i);
    if (!is_aside) reached = {before, shown_before};
    Texts parts = split(lines[i], '=');
    if (parts.empty()) kernel::refuse(line_name(i) + " is empty");
    if (parts.size() == 2 && !goes_on(i) && typed(terms, parts[1], i, notes).term == start)
      std::swap(parts[0], parts[1]);
    for (const std::string& part : parts) {
      const bool is_one = parts.size() == 1 && !goes_on(i + 1);
      const bool is_left = &part == &parts[0] && !goes_on(i) && !is_one;
      const Expr now = typed(terms, part, i, notes).term, given = terms.in_full(now);
      if (is_left && now == start) continue;  // goes on from what was reached
      const std::string what =
          before == start ? e.start + ", with which the chain begins" : "what comes before it";
      const std::string shown = terms.quoted(part, now);
      const Judgement compared = terms.compare(given, terms.in_full(before), now);
      for (const std::string& gap : compared.notes) notes.push_back(line_name(i) + ": " + gap);
      if (compared.mark == Mark::undecided)
        return {Mark::undecided, "It could not be decided whether " + shown + " in " +
                                     line_name(i) + " is equal to " + what + "."};
      if (compared.mark == Mark::wrong) {
        const std::string differs = "In " + line_name(i) + ", " + shown + " is not equal to " +
                                    what + ". " + compared.feedback;
        const Judgement said = is_aside || is_finished() ? Judgement{Mark::wrong, differs}
                                                         : terms.mistake(given, differs);
        if (!is_left || !said.misconception.empty()) return said;
        is_aside = true;  // an equation of its own, such as a law
      } else if (!is_step(before, now) && !(is_aside && is_step(now, before))) {
        Expr other = before;
        for (Expr sine : equality::parts_of(before))
          if (kernel::is_call(sine, "sin"))
            other = kernel::replace(other, kernel::power(sine, 2),
                                    1 - kernel::power(cos(sine.arg(0)), 2));
        const bool is_circle = other != before && is_step(other, now);
        return {Mark::incomplete, "In " + line_name(i) + " a step is missing between " +
                                      shown_before + " and " + shown + ", though they are equal" +
                                      (is_circle ? ": sin^2 = 1 - cos^2."
                                                 : "." + missing(" Show how it follows from "))};
      } else if (is_aside) {
        asides.emplace_back(before, now);
      }
      before = now;
      shown_before = shown;
    }
  }
  if (is_aside) std::tie(before, shown_before) = reached;
  if (before == start || !is_finished())
    return {Mark::incomplete, "Every line is right, but what " + e.start +
                                  " is equal to is not yet in the form asked for: " + e.form + "." +
                                  missing(" This law is missing: ")};
  return {Mark::right, "Right: each line is equal to the one before, and the last is the answer."};
}

/// Without what each line begins with: "1. ", "(b) ", "iii) " or a bullet. Columns stay.
Texts without_marks(const Texts& lines) {
  Texts plain;
  for (const std::string& line : lines) {
    const std::string mark = "^(\\(?(" + std::to_string(plain.size() + 1) + "|[ivx]+|[IVX]+|" +
                             char('a' + plain.size() % 26) + ")(\\.(?![0-9])|[):] )" +
                             (lines.size() > 1 ? "|([-*]|•|–) )" : ")");
    const auto blanks = [](const Texts& part) { return std::string(part[0].size(), ' '); };
    plain.push_back(replaced(line, mark, blanks));
    if (plain.back() == line) return lines;
  }
  return plain;
}

}  // namespace

Judgement judge_derivation(const Exercise& e, const std::string& text, Texts& notes) {
  const Terms terms(e);
  const std::string environment =  // of LaTeX, as {align}
      R"(\\(begin|end|tag|label)\*?\{[^{}]{1,40}\}|\\no(tag|number)|&)";
  std::string plain = replaced(text, environment, [](const Texts&) { return ""; });
  for (const char* between : {"\\\\", "->", "=>", "⇒", "⇔", "∴", "\\Rightarrow", "\\Leftrightarrow",
                              "\\implies", "\\iff", "\\therefore"})
    replace_all(plain, between, "\n");
  Texts lines = split(plain, '\n');
  if (lines.size() == 1) lines = split(plain, ';');  // on a command line
  if (lines.size() > 40) kernel::refuse("more than 40 lines");
  if (lines.empty()) kernel::refuse("there is no line");
  if (lines[0].starts_with("- ") && without_marks(lines) != lines)
    notes.push_back("the - before each line is read as a bullet");
  lines = without_marks(lines);
  for (std::string& line : lines) {
    line.erase(line.find_last_not_of(".,; ") + 1);
    const std::string number = R"(([^-+*/^=(,; ])[.,;]?(?:[ \t]|\\q?quad){1,20}\(([0-9]{1,2})\)$)";
    line = replaced(line, number, [&](const Texts& part) {
      notes.push_back("(" + part[2] + ") at the end is read as the line's number");
      return part[1];
    });
  }
  return e.start.empty() ? judge_equations(terms, lines, notes) : judge_chain(terms, lines, notes);
}

}  // namespace learn
