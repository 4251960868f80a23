#include <cctype>

#include "equality/normal_form.hpp"
#include "learn/terms.hpp"

namespace learn {
namespace {

const std::string happens = "Right: this is what happens.";

/// Without a byte order mark, lines that begin with #, outer space and LaTeX's, a first =, a stop.
std::string plain(std::string text) {
  if (text.starts_with("\xEF\xBB\xBF")) text.erase(0, 3);
  const auto blanks = [](const Texts& part) { return part[0] == "\\\\" ? part[0] : "  "; };
  text = replaced(text, R"(\\\\|\\[,;:! ])", blanks);
  replace_all(text, "\r", "\n");
  Texts lines = split(text, '\n');
  std::erase_if(lines, [](const std::string& line) { return line[0] == '#'; });
  text = answers::joined(lines, "\n");
  for (const std::string sign : {"=", "≈"})
    if (text.starts_with(sign)) text.replace(0, sign.size(), " ");  // columns stay as they are
  text.erase(text.find_last_not_of(".,; ") + 1);
  return text;
}

/// 28/33 of t = 28/33 ≈ 0.85, but not the a_2 of a_2 ≈ 0.2.
std::string before_decimals(const std::string& text, Texts& notes) {
  const Texts part = matched(text, R"((.*\S) *(?:≈|\\approx\b) *(?:-|−)?[0-9.]+)");
  const auto is_name = [&] { return !matched(part[1], R"([\w'\\{}\x80-\xff]+)").empty(); };
  if (part.empty() || (is_name() && part[1].find_first_not_of("0123456789.") != part[1].npos))
    return text;
  notes.push_back("what follows ≈ is not read");
  return part[1];
}

bool has_counts(Expr e) { return kernel::text(e).find("ceil(") != std::string::npos; }

/// As a student would type it, where the exercise has names of what was run.
std::string with_numbers(const Exercise& e, const std::string& text) {
  if (e.run.empty() || !e.choices.empty() || e.kind == "code") return text;
  const Terms terms(e);
  const Expr number = terms.in_full(terms.content(text));
  const auto q = notation::rational_value(number);
  if (q && cln::integer_length(cln::denominator(*q)) > 40)  // a rounded one
    return answers::real_cell(cln::double_approx(*q)).text;
  return notation::typed_text(number);
}

Judgement judge_expression(const Exercise& e, const std::string& text, Texts& notes) {
  const Terms terms(e);
  const Texts sides = split(text, '=');
  const auto equation = [&](const std::string& side) {  // columns stay
    return sides[0] + "=" + std::string(text.rfind(side) - sides[0].size() - 1, ' ') + side;
  };
  for (std::size_t i = 1; i + 1 < sides.size(); ++i) {  // name = one = another: each is the answer
    const Judgement one = judge_expression(e, equation(sides[i]), notes);
    if (one.mark != Mark::right && one.mark != Mark::other_form) return one;
  }
  const bool is_prediction = e.kind == "predict";
  const std::string last = sides.size() > 2 ? equation(sides.back()) : text;
  const Expr typed = terms.typed_for_name(last, notes);
  if (is_prediction && kernel::is_matrix(typed)) kernel::refuse("a number is asked for");
  const Expr given = terms.in_full(typed);
  if (const std::string foreign = terms.foreign(typed, text); !foreign.empty()) {
    Judgement said = terms.mistake(given, "");
    if (said.feedback.empty()) kernel::refuse(foreign);
    notes.push_back(foreign);
    return said;
  }
  const Expr expected = terms.in_full(terms.answer());
  Judgement said = terms.compare(given, expected, typed);
  notes.insert(notes.end(), said.notes.begin(), said.notes.end());
  if (said.mark == Mark::right) {
    const std::string lack = terms.lacking(typed, last);
    if (is_prediction || lack.empty()) return {Mark::right, is_prediction ? happens : "Right."};
    return {Mark::other_form,
            "Equal to the answer, but not in the form asked for (" + e.form + "): " + lack + "."};
  }
  if (said.mark != Mark::wrong) return said;
  if (is_prediction && !e.within.empty()) {
    const Expr gap = notation::call("abs", given - expected);
    const auto is_near = equality::holds({gap, "<=", terms.in_full(terms.content(e.within))});
    if (!is_near) return {Mark::undecided, "It could not be decided whether yours is near enough."};
    if (*is_near) return {Mark::right, "Right: near enough."};
  }
  const bool are_numbers = !kernel::is_matrix(given) && !kernel::is_matrix(expected);
  if (!is_prediction && are_numbers && terms.are_equal(given, -expected))
    said.feedback = "Only the sign is wrong: yours is minus the answer.";
  const Texts decimal = matched(text, R"(.*\.([0-9]+)[^.]*)");
  if (are_numbers && e.symbols.empty() && e.within.empty() && !decimal.empty()) {
    const int digits = int(decimal[1].size());  // less than one of the last, or half of the first
    const Expr unit = cln::expt(cln::cl_RA(10), -digits) / (digits == 1 ? 2 : 1);
    if (equality::holds({notation::call("abs", given - expected), "<", unit}) == true)
      said.feedback = "Yours is near, but rounded: an exact value is asked for.";
  }
  const std::string closed =  // 1/(1+alpha) for 1/1+alpha
      replaced(text, R"(/ *([\w.\x80-\xff]+ *([-+]|−) *[\w.\x80-\xff]+))",
               [](const Texts& part) { return "/(" + part[1] + ")"; });
  const auto is_right = [&] {
    Texts ignored;
    return terms.are_equal(terms.in_full(terms.typed_for_name(closed, ignored)), expected);
  };
  if (closed != text && equality::is_proved(is_right))
    said.feedback = "Parentheses are missing: it would be right as " + closed + ".";
  return terms.mistake(given, said.feedback);
}

bool are_true(const Terms& terms, const std::string& conditions) {
  for (const std::string& part : split(conditions, ','))
    for (const auto& [left, relation, right] : notation::read_comparisons(part)) {
      const auto is_true = equality::holds({terms.in_full(left), relation, terms.in_full(right)});
      if (!is_true) throw InvalidInput("when: " + part + ": not decided");
      if (!*is_true) return false;
    }
  return true;
}

char right_choice(const Exercise& e) {
  if (e.when.empty()) return e.answer.empty() ? '?' : e.answer[0];
  const Terms terms(e);
  std::string letters;
  for (std::size_t i = 0; i < e.when.size(); ++i)
    if (are_true(terms, e.when[i])) letters += char('a' + i);
  if (letters.size() != 1)
    throw InvalidInput("when: " + std::to_string(letters.size()) + " choices are right, not one");
  return letters[0];
}

/// In small letters, with a blank before each and one at the end.
std::string words_of(std::string text) {
  for (char& c : text) c = char(std::tolower(static_cast<unsigned char>(c)));
  return replaced(" " + text + " ", R"([^\w\x80-\xff]+)", [](const Texts&) { return " "; });
}

Judgement judge_choice(const Exercise& e, const std::string& text) {
  const Texts part =  // (a), b., c) words, a – words
      matched(text, R"([(["']? *([A-Za-z]) *(?:(?:[).,:;\]"'-]|–|—) *(.*))?)");
  const std::string words = words_of(part.empty() ? text : part[2]);
  std::string letters, listed, fits;  // all; those whose choices have these words
  Texts meant;
  for (const std::string& choice : e.choices) {
    const char own = char('a' + letters.size());
    letters += own;
    listed += (own == 'a' ? "" : letters.size() == e.choices.size() ? " or " : ", ");
    listed += own;
    if (words == " " || words_of(choice).find(words) == words.npos) continue;
    fits += own;
    meant.push_back(std::string(1, own) + ") \"" + choice + "\"");
  }
  char letter = part.empty() ? '?' : char(part[1][0] | 0x20);
  if (const std::size_t at = letters.find(letter); at != letters.npos) {
    const bool are_two = !matched(words, " (or )?[a-z] ").empty();  // a, or b
    const bool is_reason = fits.empty() && letter == part[1][0];    // a, because...
    if (words != " " && (are_two || (fits.find(letter) == fits.npos && !is_reason)))
      kernel::refuse(std::string(1, letter) + ") is \"" + e.choices[at] +
                     "\"; which is meant, the letter or the words?");
  } else if (!fits.empty()) {
    letter = fits[0];
    const std::string& choice = e.choices[std::size_t(letter - 'a')];
    const bool is_half = words_of(choice) != words && words.size() > 5 &&  // but not of yes or no
                         words_of(choice.substr(0, choice.find(','))) == words;
    if (fits.size() > 1 || !words_of(choice).starts_with(words) ||
        (is_half && letter != right_choice(e)))  // that much may be true
      kernel::refuse("is " + answers::joined(meant, " or ") + " meant?");
  } else {
    return {Mark::unread,
            "Answer with " + listed + " (you typed \"" + answers::shown_text(text) + "\")."};
  }
  if (letter == right_choice(e)) return {Mark::right, happens};
  const auto was_given = [&](const std::string& one) { return one == std::string(1, letter); };
  return mistake(e, was_given, "This is not what happens.");
}

}  // namespace

const char* word(Mark mark) {
  constexpr const char* words[]{"right", "other form", "incomplete",
                                "wrong", "unread",     "undecided"};
  return words[static_cast<std::size_t>(mark)];
}

Judgement judge(const Exercise& e, const std::string& typed, const Run& run) try {
  const std::string text = e.kind == "code" ? typed : plain(typed);
  if (text.empty()) return {Mark::unread, "The answer is empty."};
  Texts notes;
  Judgement said = e.kind == "code"         ? judge_code(e, text, run)
                   : e.kind == "derivation" ? judge_derivation(e, text, notes)
                   : e.choices.empty() ? judge_expression(e, before_decimals(text, notes), notes)
                                       : judge_choice(e, text);
  said.notes = notes;
  return said;
} catch (const kernel::Refused& r) {
  const std::string why = answers::shown_text(r.what(), 300);
  return {Mark::unread,
          "Not understood: " + why + (why.ends_with('?') || why.ends_with('.') ? "" : ".")};
}

Judgement mistake(const Exercise& e,
                  const std::function<bool(const std::string& answer)>& was_given,
                  const std::string& otherwise) {
  for (const Misconception& m : e.misconceptions)
    if (std::ranges::any_of(m.answers, was_given)) return {Mark::wrong, m.feedback, {}, m.name};
  return {Mark::wrong, otherwise};
}

Texts rules(const Exercise& e) {
  Texts lines;
  for (const std::string& choice : e.choices)
    lines.push_back(std::string(1, char('a' + int(lines.size()))) + ") " + choice);
  if (!e.choices.empty() || e.kind == "code") return lines;
  lines = {"An answer is a number"};
  if (!e.symbols.empty()) lines[0] = "An answer may use: " + answers::joined(Terms(e).allowed());
  for (const auto& [name, value] : e.values)
    if (e.symbols.empty()) lines[0] += "; " + name + " = " + value;
  const bool has_name = !e.name.empty() && e.kind != "derivation";
  if (has_name) lines.push_back("It may begin with: " + e.name + " =");
  if (!e.form.empty()) lines.push_back("Form: " + e.form);
  return lines;
}

std::string how_to_write(const Exercise& e, const std::string& said) {
  if (e.kind == "code" || !e.choices.empty())
    return "See again: magicmass learn show " + e.id + e.options;
  const bool is_said = !matched(said, ".*(a number is asked for|an answer may use).*").empty();
  const std::string rule = is_said ? "" : rules(e)[0] + ". ";
  if (e.kind == "derivation") return rule + "A line looks like this: " + e.laws[0];
  Texts examples;
  for (const Misconception& m : e.misconceptions)
    examples.insert(examples.end(), m.answers.begin(), m.answers.end());
  examples.insert(examples.end(), {"sqrt(7)/9", "22 + 1/13"});
  const auto is_fit = [terms = Terms(e), own = own_answer(e)](const std::string& one) {
    const Expr term = terms.content(one);
    return one.find(own) == one.npos && (terms.foreign(term) + terms.lacking(term, one)).empty();
  };
  return rule +
         "This can be read, but is not the answer: " + *std::ranges::find_if(examples, is_fit);
}

std::string own_answer(const Exercise& e) {
  if (e.kind == "code") return e.solution_code;
  if (!e.when.empty()) return std::string(1, right_choice(e));
  return e.answer.empty() ? notation::typed_text(Terms(e).answer()) : with_numbers(e, e.answer);
}

Texts faults(const Exercise& e, const Run& run) {
  Texts wrong;
  try {
    const auto need = [&](bool is_fine, const std::string& what, const Judgement& said) {
      if (!is_fine) wrong.push_back(what + " is judged " + word(said.mark) + ": " + said.feedback);
    };
    if (e.kind != "code") {
      const Terms terms(e);
      Texts unused;
      equality::read_domain(e.domain, {e.symbols.begin(), e.symbols.end()}, unused);
      for (const std::string& condition : unused) wrong.push_back("domain: " + condition);
      for (const std::string& name : e.symbols)
        if (notation::symbols_of(terms.content(name)).size() != 1)
          wrong.push_back("symbols: " + name + " is none");
      if (!e.within.empty() &&
          equality::holds({terms.in_full(terms.content(e.within)), ">=", 0}) != true)
        wrong.push_back("within: " + e.within + " is no number from 0 on");
    }
    const Judgement own = judge(e, own_answer(e), run);
    need(own.mark == Mark::right, "its own answer", own);
    if (!e.answer.empty() && !e.answer_from.empty()) {
      const Terms terms(e);
      const Expr step = terms.in_full(terms.from_step(e.answer_from));
      const Judgement said = terms.compare(terms.in_full(terms.answer()), step);
      need(said.mark == Mark::right, "its own answer", said);
    }
    if (e.kind == "symbolic" && e.answer_from.empty() && !e.name.empty()) {
      Exercise in_alpha = e;  // where psi and all other names have their meaning
      in_alpha.symbols.push_back("alpha");
      for (const std::string& used :
           notation::symbols_of(Terms(in_alpha).in_book(Terms(e).answer())))
        in_alpha.symbols.push_back(used);
      const Terms terms(in_alpha);
      const Expr name = terms.content(e.name), stated = terms.in_book(name);
      const Expr answer = terms.in_book(terms.answer());
      // 2*V/(2 + alpha) of b_t is true where the counts are what the prompt says.
      const bool is_stated = stated != name && terms.foreign(stated).empty() &&
                             (has_counts(answer) || !has_counts(stated));
      const Judgement said = terms.compare(answer, is_stated ? stated : answer);
      need(said.mark != Mark::wrong, "its own answer, held against the book,", said);
    }
    for (const Misconception& one : e.misconceptions)
      for (const std::string& text : one.answers) {
        const Judgement said = judge(e, with_numbers(e, text), run);
        need(said.mark == Mark::wrong && said.feedback == one.feedback,
             "the misconception " + (e.kind == "code" ? one.name : text), said);
      }
    if (e.kind == "code") {
      const Judgement said = judge(e, e.starter, run);
      need(said.mark == Mark::wrong, "the starter", said);
    }
    const bool is_number = e.kind == "predict" && e.choices.empty() && !e.run.empty();
    if (is_number && with_numbers(e, e.answer) == e.answer)
      wrong.push_back("run: nothing of it is used by answer; rounded numbers need within");
    if (e.hints.empty()) wrong.push_back("hints are missing");
  } catch (const std::exception& error) {
    wrong.push_back(error.what());
  }
  return wrong;
}

}  // namespace learn
