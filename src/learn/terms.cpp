#include "learn/terms.hpp"

#include "answers/commands.hpp"
#include "answers/derivation.hpp"
#include "equality/normal_form.hpp"
#include "magicmass/scenes/run.hpp"
#include "notation/tokens.hpp"

namespace learn {
namespace {

constexpr int points_tried = 60;

/// The numbers that answer a question, by their columns' names, rounded ones where that is fine. Of
/// a scene: N, all its collisions, and the velocity of each body at the end, by its name.
kernel::Substitution numbers_of(const std::string& question, bool is_rounded_fine) {
  kernel::Substitution numbers;
  if (question.find('=') != question.npos) {
    using namespace magicmass::scenes;
    Scene scene = parse_scene(question, "run");
    Result end = run(scene);
    const bool is_cut = end.status == Status::limited;
    if (is_cut && (end.is_undecided || !(scene.has("until") || scene.has("max_events"))))
      throw InvalidInput("run: " + end.why + "; allowed: a scene that comes to its end");
    if (end.status != Status::collapse)  // else there are infinitely many
      numbers.emplace(notation::symbol("N"), cln::cl_RA(cln::cl_I(end.events)));
    scene.is_exact = true;
    constexpr int most_exactly = 1000;  // collisions
    if (end.events <= most_exactly) equality::is_proved([&] { return end = run(scene), true; });
    for (std::size_t i = 0; i < end.terminal.size(); ++i) {
      const Expr body = notation::symbol(body_name(scene, i));
      const auto* exact = std::get_if<Surd>(&end.terminal[i]);
      const auto near = double_of(end.terminal[i]);
      if (exact)
        numbers.emplace(body, notation::read_typed(exact->text()).term);
      else if (near && is_rounded_fine)
        numbers.emplace(body, balls::exact(*near));
    }
    return numbers;
  }
  for (auto [column, text] : answers::answer_to(question))
    if (text.find_first_of("0123456789") != text.npos &&
        text.find_first_not_of("-+./e0123456789") == text.npos &&
        (is_rounded_fine || text.find('.') == text.npos)) {
      std::ranges::replace(text, 'e', 'E');  // 1e-12 has two readings
      numbers.emplace(notation::symbol(column), notation::read_typed(text).term);
    }
  return numbers;
}

/// A counterexample in words. Of constants the right value is not given away.
std::string difference(const equality::Counterexample& c, const std::string& where) {
  const auto shown = [](const std::string& value) {
    const Texts fraction = matched(value, "-?[0-9]+/([0-9]{3,})");
    if (fraction.empty()) return value.starts_with("too close") ? "0, or very nearly" : value;
    const cln::cl_RA q = *notation::rational_value(notation::read_typed(value).term);
    const bool is_decimal = cln::denominator(q * cln::expt(cln::cl_I(10), 15)) == 1;
    return is_decimal ? answers::real_cell(cln::double_approx(q)).text : value;
  };
  const bool is_small = c.difference.find("e-") != c.difference.npos;
  if (c.point.empty() && c.right != "0" && c.left.starts_with('-') != c.right.starts_with('-'))
    return "Yours has the wrong sign.";
  if (c.point.empty())
    return std::string(is_small ? "Yours is near, but not equal: it" : "Yours") + " is too " +
           (c.difference.starts_with('-') ? "small." : "large.");
  const std::size_t slash = std::min(c.difference.find('/'), c.difference.size());
  const bool is_close = is_small || c.difference.size() > 2 * slash + 6;
  const std::string said =
      "At " + c.point + where + " yours is " + shown(c.left) + "; it should be " + shown(c.right);
  if (is_close) return said + ", apart by " + c.difference.substr(c.difference[0] == '-') + ".";
  const auto six = [](const Texts& part) { return answers::formatted("%.6g", std::stod(part[0])); };
  return replaced(said, R"([0-9]+\.[0-9]{6,})", six) + ".";
}

/// " at alpha = 1: why": yours has no value at more than one in `share` points, the answer has.
std::string without_value(Expr given, Expr expected, const equality::Domain& domain, int share,
                          const kernel::Exprs& terms) {
  std::string first;
  int all = 0, gaps = 0;
  for (const equality::Point& point : equality::points(domain, points_tried, terms)) {
    if (!equality::value_at(point, expected).ball) continue;
    ++all;
    const std::string why_none = equality::value_at(point, given).why_none;
    if (why_none.empty() || ++gaps > 1) continue;
    first = (point.empty() ? "" : " at " + equality::text(point)) + ": " + why_none;
  }
  return share * gaps > all ? first : "";
}

/// Of what is equal to the answer: wrong where it has no value on more than single points.
Judgement with_gaps(Expr given, Expr expected, const equality::Domain& domain) {
  using equality::Requirement;
  Judgement said{Mark::right, ""};
  const std::vector<Requirement> needed = equality::requirements(expected, domain);
  const auto is_sure = [&](const Requirement& need) { return equality::is_certain(need, domain); };
  for (const Requirement& need : equality::requirements(given, domain)) {
    const bool is_square = need.kind == equality::Need::NotNegative &&
                           need.term.op() == kernel::Op::Pow && need.term.exponent() % 2 == 0;
    if (is_square || is_sure(need) || std::ranges::count(needed, need) > 0) continue;
    const bool is_bound = need.kind != equality::Need::NotZero;
    const Requirement broken{equality::Need::NotNegative, is_bound ? -need.term : Expr(1)};
    const std::string why =
        without_value(given, expected, narrowed(domain, {broken}), points_tried + 1, {need.term});
    if (is_bound && !why.empty())
      return {Mark::wrong, "It is equal where it has a value, but yours has no value" + why + "."};
    if (!why.empty())
      said.notes = {"yours has no value" + why};
    else if (said.notes.empty() && std::ranges::all_of(needed, is_sure))
      said.notes = {"yours has a value only where " + notation::typed_text(need.term) +
                    (is_bound ? " is not negative" : " is not 0")};
  }
  return said;
}

}  // namespace

Terms::Terms(const Exercise& e) : exercise(e), symbols(e.symbols.begin(), e.symbols.end()) {
  known = symbols;
  for (const auto& [name, text] : e.values) {
    if (symbols.empty()) known.insert(name);
    values.emplace(notation::symbol(name), content(text));
  }
  const bool is_exact = e.within.empty() && e.choices.empty() && e.kind != "code";
  if (!e.run.empty()) values.merge(numbers_of(e.run, !is_exact));
}

notation::Typed Terms::typed(std::string text, Texts& notes) const {
  if (std::ranges::count(text, '=') > 1) kernel::refuse("one equation is expected, with one =");
  const auto has = [&](const std::string& pattern) {
    return replaced(text, pattern, [](const Texts&) { return ""; }) != text;
  };
  if (has("(^|[^\\w\\\\])(over|plus|minus|times|half|one|two|three)(?!\\w)"))
    kernel::refuse("words are not read; write numbers in digits, as -1/2");
  if (has("[0-9) ]sec$")) kernel::refuse("sec has no place here: an answer is without units");
  for (const auto& [name, value] : exercise.values)
    if (value == "1")  // both readings of 147/64V have one value, and the reader knows this one
      text = replaced(text, "(/ *[0-9.]+)(" + name + "\\b)",
                      [](const Texts& part) { return part[1] + " " + part[2]; });
  const bool is_column = exercise.kind == "symbolic" && answer().cols() == 1;
  const notation::Typed read = notation::read_equation(text, symbols, is_column);
  for (const std::string& note : read.notes)
    if (std::ranges::count(notes, note) == 0) notes.push_back(note);
  return read;
}

Expr Terms::typed_for_name(const std::string& text, Texts& notes) const {
  const notation::Typed read = typed(text, notes);
  if (!read.right) return read.term;
  const std::string said = notation::name_of(read.term);
  const bool is_new =
      !said.empty() && !known.contains(said) && !notation::symbols_of(read.right).contains(said);
  if (is_new && exercise.name.empty()) return read.right;
  if (exercise.name.empty())
    kernel::refuse("what is asked for has no name; write the expression alone, without =");
  const Expr name = content(exercise.name);
  std::string full = notation::name_of(name);  // alpha_k, alpha_2
  for (const auto& [index, value] : exercise.values)
    if (full.ends_with("_" + index)) full.replace(full.size() - index.size(), index.size(), value);
  for (const auto& [left, right] : {std::pair{read.term, read.right}, {read.right, read.term}})
    if (left == name || (!full.empty() && notation::name_of(left) == full)) return right;
  const std::string index = "_(?!prime)[a-z0-9]+";  // a for a_n, t_1 for t
  if (is_new && !matched(said + " " + full, "(.+)(" + index + " \\1| \\1" + index + ")").empty())
    return read.right;
  kernel::refuse("neither side of this equation is " + exercise.name +
                 ", which is asked for; write " + exercise.name +
                 " = ..., or the expression alone");
}

Expr Terms::content(const std::string& text) const {
  return answers::given_by_user(text + ": ",
                                [&] { return notation::read_typed(text, symbols).term; });
}

Expr Terms::from_step(const std::string& id) const {
  return answers::given_by_user("", [&] { return answers::stated_value(id); });
}

Expr Terms::stated(const std::string& text) const {
  const std::string step = "[^-+*/^() 0-9][^-+*/^() ]*\\.[^-+*/^() ]*";
  return matched(text, step).empty() ? content(text) : from_step(text);
}

Expr Terms::in_book(Expr term) const {
  static const std::vector<std::pair<std::string, std::string>> steps{
      {"c_t", "terminal.definitions: c_t"},
      {"rho", "evaluators_end.def_rho"},
      {"a_t", "terminal.a"},
      {"b_t", "terminal.b"},
      {"t_j", "encounters.when"},
      {"s_j", "encounters.apart"},
      {"h", "evaluators_end.def_h"},
      {"N_A", "counting.N_A"},
      {"N_B", "counting.N_B"},
      {"N", "counting.N"}};
  for (const auto& [name, step] : steps)
    if (notation::symbols_of(term).contains(name))
      term = kernel::replace(term, notation::symbol(name), from_step(step));
  const Expr psi = from_step("evaluators.psi");  // 4 half_h
  return in_full(kernel::replace(term, psi.arg(1), notation::symbol("psi") / psi.arg(0)));
}

Expr Terms::answer() const {
  return exercise.answer.empty() ? from_step(exercise.answer_from) : content(exercise.answer);
}

std::string Terms::foreign(Expr term, const std::string& typed) const {
  Texts names;
  for (const std::string& name : notation::symbols_of(term))
    if (!known.contains(name)) names.push_back(name);
  if (names.empty()) return {};
  const std::string wanted =
      symbols.empty() ? "a number is asked for" : "an answer may use " + answers::joined(allowed());
  static const Texts units =
      split("J N cm degrees g h kg km m meters min minutes ms rad s seconds", ' ');
  const auto is_word = [](auto& one) { return one.size() > 3 && !notation::is_greek_name(one); };
  if (names.size() > 1 && std::ranges::any_of(names, is_word) &&
      !matched(typed, R"([^-+*/^=()_0-9\\]+)").empty())
    return "words are not read; " + wanted;
  Texts others;
  for (const std::string& name : names) {
    const std::string other_case(1, char(name[0] ^ 0x20));
    const bool is_letter = name.size() == 1 && symbols.contains(other_case) &&
                           !notation::symbols_of(term).contains(other_case);
    std::string other = is_letter ? other_case : notation::alike(name, symbols);
    if (other.empty()) other = notation::parted(name, symbols);
    replace_all(other, " ", "*");
    if (!other.empty()) others.push_back(other);
  }
  const std::string name = names[0];
  const bool is_near = name.size() > 3 && name != exercise.name;  // v_1 is not meant for M_1
  const bool has_unit =  // (1 + alpha) m/s, but not 1/(1 + m)
      symbols.empty() || !matched(typed, ".*[0-9A-Za-z)] [A-Za-z]+(/[A-Za-z]+)?").empty();
  const auto shown = [&](const std::string& one) { return quoted(typed, notation::symbol(one)); };
  if (symbols.empty() && name == exercise.name)
    return shown(name) + " is what is asked for: give its value";
  return answers::joined(answers::texts_of(names, shown)) + (names.size() == 1 ? " has" : " have") +
         " no place here: " + wanted +
         (has_unit && std::ranges::includes(units, names) ? ", without units" : "") +
         (others.empty()
              ? meant(name, is_near ? exercise.symbols : Texts{})
              : (others.size() == 1 ? "; is " : "; are ") + answers::joined(others) + " meant?");
}

std::string Terms::names_at(const equality::Point& point, Expr typed) const {
  Texts parts;
  for (const std::string& name : notation::symbols_of(typed)) {
    const Expr symbol = notation::symbol(name), meaning = in_full(symbol);
    if (meaning == symbol || notation::symbols_of(meaning).empty()) continue;
    parts.push_back(notation::typed_text(symbol) + " = " +
                    equality::shown_value(equality::at(point, meaning)));
  }
  return parts.empty() ? "" : ", where " + answers::joined(parts, " and ") + ",";
}

Expr Terms::in_full(Expr term) const {
  // An angle stays an angle where nothing is said of the mass ratio.
  Texts how;
  if (symbols.contains("alpha") || !foreign(term).empty()) term = answers::with_meanings(term, how);
  return kernel::substitute(term, values);
}

equality::Domain Terms::domain(const std::set<std::string>& wanted) const {
  std::set<std::string> all = wanted;
  all.insert(symbols.begin(), symbols.end());
  Texts ignored;
  equality::Domain domain = equality::read_domain(exercise.domain, all, ignored);
  std::erase_if(domain.ranges, [&](const auto& range) {
    return !wanted.contains(notation::name_of(range.first));
  });
  for (notation::Comparison& c : domain.further) {
    c.left = in_full(c.left);
    c.right = in_full(c.right);
  }
  std::erase_if(domain.further, [&](const notation::Comparison& c) {
    const std::set<std::string> needed = notation::symbols_of(c.left - c.right);
    return !std::includes(wanted.begin(), wanted.end(), needed.begin(), needed.end());
  });
  return domain;
}

Judgement Terms::compare_numbers(Expr given, Expr expected, Expr typed) const {
  equality::Verdict verdict;
  equality::Domain where;
  std::string why = "It could not be decided whether yours is equal to the answer.";
  try {
    where = domain(notation::symbols_of(kernel::eq(given, expected)));
    verdict = equality::decide(given, expected, where, equality::Wanted::Verdict);
  } catch (const kernel::Refused& r) {
    why = "It could not be compared: " + std::string(r.what()) + ".";
  }
  if (verdict.answer == equality::Answer::Undecided) {
    const std::string none = without_value(given, expected, where, 2, {given, expected});
    if (none.empty()) return {Mark::undecided, why};
    return {Mark::wrong,
            "Yours has no real value" + (none[0] == ':' ? none : ", for instance" + none) + "."};
  }
  if (const auto& c = verdict.counterexample)
    return {Mark::wrong, difference(*c, names_at(c->at, typed))};
  if (verdict.conditions.empty()) return {Mark::right, ""};
  return with_gaps(given, expected, where);
}

Judgement Terms::compare(Expr given, Expr expected, Expr typed) const {
  const bool is_matrix = kernel::is_matrix(expected);
  if (is_matrix != kernel::is_matrix(given))
    return {Mark::wrong, is_matrix ? "A matrix is asked for." : "A matrix is not asked for."};
  if (!is_matrix) return compare_numbers(given, expected, typed);
  const auto shape = [](Expr m) {
    return std::to_string(m.rows()) + " by " + std::to_string(m.cols());
  };
  if (shape(given) != shape(expected))
    return {Mark::wrong, "Yours is " + shape(given) + " (rows by columns); " + shape(expected) +
                             " is asked for."};
  Judgement all{Mark::right, ""};
  for (int row = 0; row < given.rows(); ++row)
    for (int column = 0; column < given.cols(); ++column) {
      Judgement one = compare_numbers(kernel::entry(given, row, column),
                                      kernel::entry(expected, row, column), typed);
      const std::string place =
          "row " + std::to_string(row + 1) + ", column " + std::to_string(column + 1) + ": ";
      for (const std::string& note : one.notes) all.notes.push_back(place + note);
      if (one.mark == Mark::right) continue;
      one.feedback = "R" + place.substr(1) + one.feedback;
      if (one.mark == Mark::wrong) return one;
      all = one;
    }
  return all;
}

Judgement Terms::mistake(Expr given, const std::string& otherwise) const {
  const auto was_given = [&](const std::string& answer) {
    return are_equal(given, in_full(content(answer)));
  };
  return learn::mistake(exercise, was_given, otherwise);
}

std::string Terms::quoted(const std::string& typed, Expr part) const {
  constexpr std::size_t longest = 160;
  if (typed.size() > longest || typed.find_first_of("\t\n\v\f\r") != typed.npos)
    return notation::typed_text(part);
  for (std::size_t size = 1; size <= typed.size(); ++size)
    for (std::size_t first = 0; first + size <= typed.size(); ++first) {
      const std::string some = typed.substr(first, size);
      if (first > 0 && typed[first - 1] == '\\') continue;
      if (std::ranges::count(some, '(') != std::ranges::count(some, ')')) continue;
      try {
        const Expr read = content(some);
        if (kernel::replace(read, part, part + 1) != read) return some;
      } catch (const InvalidInput&) {
      }
    }
  return notation::typed_text(part);
}

}  // namespace learn
