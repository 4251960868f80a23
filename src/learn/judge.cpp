#include <cctype>

#include "equality/normal_form.hpp"
#include "learn/terms.hpp"

namespace learn {
namespace {

const std::string rounded = "Yours is near, but rounded: an exact value is asked for.";
const std::string happens = "Right: this is what happens.";

/// Without a byte order mark, lines that begin with #, outer space and LaTeX's, a first =, a stop.
std::string plain(std::string text) {
  if (text.size() > 20000) kernel::refuse("longer than 20000 characters");
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
  text = replaced(text, R"(^ *(\\?Delta|Δ) *(?=[A-Za-z]\w* *=))", [](auto&) { return "Delta_"; });
  return replaced(text, "([0-9]) collisions$", [](const Texts& part) { return part[1]; });
}

/// 28/33 of t = 28/33 ≈ 0.85, but not the a_2 of a_2 ≈ 0.2.
std::string before_decimals(const std::string& text, Texts& notes) {
  const Texts part = matched(text, R"((.*\S) *(?:≈|\\approx\b) *(?:-|−)?[0-9.]+(?: *V)?)");
  const std::string name = R"((?![0-9]|\\?[a-z]?frac|\\?sqrt|√)[\w'\\{}\x80-\xff]+)";
  if (part.empty() || !matched(part[1], name).empty()) return text;
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
  if (!matched(text, R"((.*= *)?(∞|\\infty|[Ii]nf(inity|inite|initely many.*)?))").empty())
    return {Mark::wrong, "Yours is infinite; a finite value is asked for."};
  const Terms terms(e);
  const bool is_prediction = e.kind == "predict";
  const Expr typed = terms.typed_for_name(text, notes);
  if (is_prediction && kernel::is_matrix(typed)) kernel::refuse("a number is asked for");
  Expr given = terms.in_full(typed);
  if (const std::string foreign = terms.foreign(typed, text); !foreign.empty()) {
    Judgement said = terms.mistake(given, "");
    if (said.feedback.empty()) kernel::refuse(foreign);
    notes.push_back(foreign);
    return said;
  }
  const Expr expected = terms.in_full(terms.answer());
  const bool is_row = given.rows() == 1 && expected.cols() == 1 && given.cols() == expected.rows();
  if (is_row) given = kernel::matrix(1, kernel::entries(given));
  Judgement said = terms.compare(given, expected, typed);
  notes.insert(notes.end(), said.notes.begin(), said.notes.end());
  if (said.mark == Mark::right) {
    if (is_row) return {Mark::other_form, "Right, but a column is asked for: write [a; b; c]."};
    const std::string lack = terms.lacking(typed, text);
    if (is_prediction || lack.empty()) return {Mark::right, is_prediction ? happens : "Right."};
    return {Mark::other_form,
            "Equal to the answer, but not in the form asked for (" + e.form + "): " + lack + "."};
  }
  if (said.mark != Mark::wrong) return said;
  const bool are_numbers = !kernel::is_matrix(given) && !kernel::is_matrix(expected);
  const Expr gap = are_numbers ? notation::call("abs", given - expected) : given;
  if (is_prediction && !e.within.empty()) {
    const auto is_near = equality::holds({gap, "<=", terms.in_full(terms.content(e.within))});
    if (!is_near) return {Mark::undecided, "It could not be decided whether yours is near enough."};
    if (*is_near) return {Mark::right, "Right: near enough."};
  }
  if (!is_prediction && are_numbers && terms.are_equal(given, -expected))
    said.feedback = "Only the sign is wrong: yours is minus the answer.";
  const Texts decimal = matched(text, R"(.*\.([0-9]+)[^.]*)");
  if (are_numbers && e.symbols.empty() && e.within.empty() && !decimal.empty()) {
    const Expr unit = cln::expt(cln::cl_RA(10), -int(decimal[1].size()));
    if (equality::holds({gap, "<=", unit / 2}) == true)
      said.feedback = rounded;
    else if (decimal[1].size() > 1 && equality::holds({gap, "<", unit}) == true)
      said.feedback = "Yours is near, but rounded or cut off: an exact value is asked for.";
  }
  if (are_numbers && terms.are_equal(given * kernel::pi() / 180, expected))
    said.feedback = "Yours is in degrees; radians are asked for.";
  const auto bracketed = [](const Texts& part) { return "/(" + part[1] + ")"; };  // 1/1+alpha
  const auto closed =
      replaced(text, R"(/ *([\w.\x80-\xff]+ *([-+]|−) *[\w.\x80-\xff]+))", bracketed);
  const auto is_right = [&](const std::string& other) {
    Texts ignored;
    return terms.are_equal(terms.in_full(terms.typed_for_name(other, ignored)), expected);
  };
  if (closed != text && equality::is_proved([&] { return is_right(closed); }))
    said.feedback = "Parentheses are missing: it would be right as " + closed + ".";
  const Texts pi = matched(text, R"((.*[^0-9.]|)(3\.14[0-9]*)(.*))");
  if (!pi.empty() && equality::is_proved([&] { return is_right(pi[1] + "(pi)" + pi[3]); }))
    said.feedback = pi[2] + " is rounded: write pi.";
  return terms.mistake(given, said.feedback);
}

/// name = one = another: each is the answer; the last one may be rounded.
Judgement judge_chain(const Exercise& e, const std::string& text, Texts& notes) {
  const Texts sides = split(text, '=');
  if (sides.size() < 3 || sides.size() > 40) return judge_expression(e, text, notes);
  const std::size_t first = text.find('=') + 1, last = text.rfind('=') + 1;
  const Judgement before = judge_chain(e, text.substr(0, last - 1), notes);
  if (before.mark != Mark::right && before.mark != Mark::other_form) return before;
  const std::string gap(last - first, ' ');  // columns stay
  Judgement said = judge_expression(e, text.substr(0, first) + gap + text.substr(last), notes);
  const bool is_rounded = said.feedback == rounded;
  const std::string one = *(sides.end() - 2), other = sides.back();
  if (is_rounded) notes.push_back(other + " is rounded: write ≈ " + other);
  if (said.mark == Mark::wrong && said.misconception.empty())
    said.feedback = one + " is right, but " + other + " is not equal to it. " + said.feedback;
  return is_rounded ? before : said;
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
  const Texts part = matched(text, R"([(["']? *([A-Za-z]) *(?:(?:[).,:;\]"'-]|–|—) *(.*))?)");
  const std::string words = words_of(part.empty() ? text : part[2]);  // also of c) words
  std::string all, fits, meant;  // letters; those of choices with these words
  for (std::size_t i = 0; i < e.choices.size(); ++i) {
    const std::string own(1, char('a' + i));
    all += (i == 0 ? "" : i + 1 == e.choices.size() ? " or " : ", ") + own;
    if (words == " " || words_of(e.choices[i]).find(words) == words.npos) continue;
    meant += (fits.empty() ? "" : " or ") + own + ") \"" + e.choices[i] + "\"";
    fits += own;
  }
  char letter = part.empty() ? '?' : char(part[1][0] | 0x20);
  if (const auto at = std::size_t(letter - 'a'); at < e.choices.size()) {
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
      kernel::refuse("is " + meant + " meant?");
  } else {
    return {Mark::unread,
            "Answer with " + all + " (you typed \"" + answers::shown_text(text) + "\")."};
  }
  if (letter == right_choice(e)) return {Mark::right, happens};
  const auto was_given = [&](const std::string& one) { return one == std::string(1, letter); };
  return mistake(e, was_given, "This is not what happens.");
}

}  // namespace

const char* word(Mark mark) {
  constexpr const char* all[]{"right", "other form", "incomplete", "wrong", "unread", "undecided"};
  return all[static_cast<std::size_t>(mark)];
}

Judgement judge(const Exercise& e, const std::string& typed, const Run& run) try {
  const std::string text = e.kind == "code" ? typed : plain(typed);
  if (text.empty()) return {Mark::unread, "The answer is empty."};
  Texts notes;
  Judgement said = e.kind == "code"         ? judge_code(e, text, run)
                   : e.kind == "derivation" ? judge_derivation(e, text, notes)
                   : e.choices.empty()      ? judge_chain(e, before_decimals(text, notes), notes)
                                            : judge_choice(e, text);
  said.notes = notes;
  return said;
} catch (const kernel::Refused& r) {
  const std::string why = answers::shown_text(r.what(), 300);
  return {Mark::unread,
          "Not understood: " + why + (why.ends_with('?') || why.ends_with('.') ? "" : ".")};
}

Judgement mistake(const Exercise& e, const IsAnswer& was_given, const std::string& otherwise) {
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
  Texts all;
  for (const Misconception& m : e.misconceptions)
    all.insert(all.end(), m.answers.begin(), m.answers.end());
  all.insert(all.end(), {"sqrt(7)/9", "22 + 1/13"});
  const auto is_fit = [terms = Terms(e), own = own_answer(e)](const std::string& one) {
    const Expr term = terms.content(one);
    return one.find(own) == one.npos && (terms.foreign(term) + terms.lacking(term, one)).empty();
  };
  return rule + "This can be read, but is not the answer: " + *std::ranges::find_if(all, is_fit);
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
      if (said.mark != Mark::right)
        wrong.push_back("answer and answer_from disagree: " + said.feedback);
    }
    if (e.kind == "symbolic" && e.answer_from.empty() && !e.name.empty()) {
      Exercise in_alpha = e;  // where psi and all other names have their meaning
      in_alpha.symbols.push_back("alpha");
      for (const auto& used : notation::symbols_of(Terms(in_alpha).in_book(Terms(e).answer())))
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
        need(said.misconception == one.name || (e.kind == "code" && said.feedback == one.feedback),
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
