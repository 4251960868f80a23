// Where what people type has two readings: it is refused with both, or a note says how it was read.
#pragma once

#include <span>

#include "notation/tokens.hpp"
#include "notation/typed.hpp"

namespace notation {
class Readings : protected Words {
protected:
  Readings(std::string_view text, const std::set<std::string>& the_factors)
      : Words(tokens(text)), factors(the_factors) {}
  const std::set<std::string>& factors;
  std::vector<std::string> notes;

  [[noreturn]] void refuse_here(const std::string& why) const { refuse_at(now().column, why); }
  [[noreturn]] void refuse_comma(std::size_t at) const {
    const std::string& sign = words[at].quoted;
    refuse_at(words[at].column, "unexpected " + (sign == "," ? "comma" : sign) +
                                    "; decimals are written 0.5, matrices [[a, b], [c, d]], "
                                    "logarithms to another base log(x)/log(b)");
  }
  bool is_relation() const {
    return is("=") || is("<") || is(">") || is("<=") || is(">=") || is("!=");
  }
  void note(const std::string& how) {
    if (std::ranges::count(notes, how) == 0) notes.push_back(how);
  }
  // M_2u_2, as LaTeX has it, becomes two words: a power belongs to the last one.
  void part_names() {
    std::vector<Token> all;
    for (Token word : words) {
      std::string names = word.text.find('_') == names.npos ? "" : parted(word.text, factors);
      if (names.find(' ') == names.npos) {
        all.push_back(word);
        continue;
      }
      note(word.quoted + " is read as " + names);
      word.typed = "";
      for (std::istringstream each(names); each >> word.text; word.is_spaced = true) {
        word.quoted = word.text;
        all.push_back(word);
      }
    }
    words = all;
  }
  // 6 (3 + 3), 2V (1.998V), but not 3(4 + 1), 2 (a + b).
  bool is_remark() const {
    const Token& before = words[place - 1];
    const bool is_value = before.kind == Kind::Number || before.text == "V";
    std::size_t end = place;
    for (int depth = 0; is_value && is("(") && now().is_spaced; ++end) {
      const std::string& word = words[end].text;
      depth += word == "(" ? 1 : word == ")" ? -1 : 0;
      if (depth == 0) return true;
      const bool is_number = words[end].kind == Kind::Number || word == "pi" || word == before.text;
      if (!is_number && (words[end].kind != Kind::Sign || word == "," || word == ";")) return false;
    }
    return false;
  }
  // 1/2 M_1, L/V sin(...) and a/(b)^2 (c) have one usual reading; 1/2(1+alpha) and a/b c have two.
  void read_after_slash(std::size_t from, std::size_t slash, std::size_t at) {
    const bool numbers = slash == from + 1 && at == slash + 2 && words[from].kind == Kind::Number &&
                         words[slash + 1].kind == Kind::Number;
    const std::size_t last = words[at - 2].text == "^" ? at - 3 : at - 1;
    const bool brackets = words[slash + 1].text == "(" && words[last].text == ")";
    const Token& factor = words[at];
    const std::span above(&words[from], slash - from);  // sin x/V sin y has two
    const bool is_apart = is_call(factor) && std::ranges::none_of(above, is_call);
    if (!factor.is_spaced || (!numbers && !brackets && !is_apart))
      refuse_at(factor.column, "is " + factor.quoted +
                                   " above or below the fraction line? write a * or parentheses");
    const std::string left = typed(from, at);
    note(left + " " + factor.quoted + "... is read as (" + left + ")*" + factor.quoted + "...");
  }
  // i to n: no angle.
  static bool is_of_indices(Expr e) {
    return std::ranges::all_of(symbols_of(e), [](const std::string& name) {
      return name.size() == 1 && name[0] >= 'i' && name[0] <= 'n';
    });
  }
  // sin(n + 1/4) psi, \sin(4n+1)\frac{x}{4}: is an angle missing? log(x)^-1: of which of both?
  void read_after_bracket(const Token& function, const std::string& taken, Expr argument) {
    const std::string &f = function.quoted, &name = function.text;
    const bool is_inverse = name == "log" || name == "ln" ||
                            (name[0] == 'a' && is_function(name.substr(name[1] == 'r' ? 3 : 1)));
    if (is_inverse && is("^")) {
      const std::string& open = words[place + 1].text;
      const std::size_t inside = open == "(" || open == "{" ? place + 2 : place + 1;
      if (words[inside].text == "-")
        refuse_here(f + taken + "^-... has two readings: write 1/" + f + taken + " or " + f +
                    "(1/" + taken + ")");
      note(f + taken + "^... is read as (" + f + taken + ")^...");
    }
    if (!is_name() && !is("frac")) return;
    const std::string next = now().quoted + (is("frac") ? "..." : ""), factor = "*" + next;
    static const std::set<std::string> of_angles{"sin", "cos", "tan", "sec", "csc", "cot"};
    if (of_angles.contains(name) && is_of_indices(argument))
      refuse_here(f + taken + next + " has two readings: write " + f + "(" + taken + factor +
                  ") or " + f + taken + factor);
    if (argument.op() == kernel::Op::Add || argument.op() == kernel::Op::Num)
      note(f + taken + next + " is read as " + f + taken + factor);
  }
  // x > 1 y > 2 and 0 < 2 x < 1: a product, or is a comma missing?
  void refuse_two_conditions(std::size_t from) const {
    for (std::size_t i = from + 1; i < place; ++i)
      if (words[i].is_spaced && words[i].kind != Kind::Sign && words[i - 1].kind != Kind::Sign)
        refuse_at(words[i].column,
                  "two conditions or a product? write a comma or a * before " + words[i].quoted);
  }
  // |x|y|z| is |x|*y*|z| or |x*|y|*z|.
  void refuse_bars(std::size_t from) const {
    for (std::size_t i = from; i + 1 < place; ++i)
      if (words[i].text == "|" && words[place - 1].text != "|")
        refuse_here("which | belong together? write abs(...)");
  }
  // Behind the slash of x^1/2 and x^3/2, but not of x^2/2.
  void note_fraction_after_power() {
    const std::string minus = place > 4 && words[place - 3].text == "-" ? "-" : "";
    if (place < 4 || words[place - 3 - minus.size()].text != "^") return;
    const Token &above = words[place - 2], &below = now();
    if (!is_whole(above.text) || !is_whole(below.text) || number_of(below) == 0) return;
    if (cln::denominator(number_of(above) / number_of(below)) == 1) return;
    const std::string power = minus + above.text, fraction = power + "/" + below.text;
    note("^" + fraction + " is read as (...^" + power + ")/" + below.text + ", not as ^(" +
         fraction + ")");
  }
  bool is_name() const { return now().kind == Kind::Name && !is_call(now()); }
  static bool is_call(const Token& token) {
    return token.kind == Kind::Name && is_function(token.text);
  }
};
}  // namespace notation
