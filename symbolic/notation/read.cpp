// The reader: one function for each level of the printer.
#include <deque>

#include "kernel/names.hpp"
#include "notation/tokens.hpp"
#include "notation/typed.hpp"

namespace notation {
using namespace kernel;
namespace {

const std::string ascii_letters = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ";
const std::string ascii_digits = "0123456789";
const std::string inside_names = ascii_letters + ascii_digits + "_'";  // c, c', c'_n

Token token(std::string_view text, std::size_t from) {
  const std::size_t i = std::min(text.find_first_not_of(' ', from), text.size());
  Token out{.column = i + 1, .is_spaced = i > from || i == 0};
  if (i == text.size()) return out;
  const auto is_of = [&](std::string_view all) { return all.find(text[i]) != all.npos; };
  out.kind = is_of(ascii_digits) ? Kind::Number : is_of(ascii_letters) ? Kind::Name : Kind::Sign;
  std::size_t end = i + 1;
  if (out.kind != Kind::Sign)
    end = text.find_first_not_of(out.kind == Kind::Number ? ascii_digits : inside_names, i);
  else if (is_of("!<>") && text.substr(end).starts_with('='))
    ++end;
  else if (!is_of("=<+-*/^()[],;:"))
    refuse("character " + std::to_string(i + 1) + " belongs to no formula");
  out.text = text.substr(i, end - i);
  return out;
}

class Reader : Words {
public:
  explicit Reader(std::string_view text) : Words({token(text, 0)}) {
    while (words.back().kind != Kind::End)
      words.push_back(token(text, words.back().column - 1 + words.back().text.size()));
  }
  Expr everything() {
    const Expr e = formula();
    if (now().kind != Kind::End) refuse("\"" + now().text + "\" is not expected");
    return e;
  }
  std::size_t at() const { return now().column; }

private:
  bool is_attached(std::string_view sign) const { return is(sign) && !now().is_spaced; }
  void need(std::string_view word) {
    if (!takes(word)) refuse("\"" + std::string(word) + "\" is expected");
  }
  std::string need(Kind kind, const std::string& what) {
    if (now().kind != kind) refuse(what + " is expected");
    return next().text;
  }

  Expr formula() {
    if (++depth > 200) refuse("brackets more than 200 deep");
    const Expr e = takes("for") ? for_every() : implication();
    --depth;
    return e;
  }
  Expr for_every() {
    need("every");
    const Sort sort = takes("integer") ? Sort::Int : Sort::Real;
    if (sort == Sort::Real) need("real");
    const std::string name = need(Kind::Name, "a variable");
    if (const std::string why = why_no_variable(name, sort); !why.empty()) refuse(why);
    bound.emplace_front(name, sort);
    const Expr least = takes(">=") ? sum() : Expr();
    need(":");
    Expr body = formula();
    if (least) body = imp(le(least, resolved(name)), body);
    bound.pop_front();
    return make({.op = Op::All, .args = {body}, .name = name, .variable = sort});
  }
  Expr implication() {
    const Expr left = disjunction();
    if (takes("implies")) return imp(left, disjunction());
    if (!takes("if")) return left;
    for (std::string_view word : {"and", "only", "if"}) need(word);
    return iff(left, disjunction());
  }
  Expr disjunction() { return joined("or", &Reader::conjunction, logic_or); }
  Expr conjunction() { return joined("and", &Reader::relation, logic_and); }
  Expr joined(std::string_view word, Expr (Reader::*part)(), Expr (*join)(const Exprs&)) {
    const Exprs all = parts(word, part);
    return all.size() == 1 ? all[0] : join(all);
  }
  Exprs parts(std::string_view sign, Expr (Reader::*part)()) {
    Exprs out{(this->*part)()};
    while (takes(sign)) out.push_back((this->*part)());
    return out;
  }
  Exprs list() { return parts(",", &Reader::formula); }
  Expr relation() {
    if (takes("not")) return logic_not(atom());
    const Expr left = sum();
    if (takes("=")) return eq(left, sum());
    if (takes("!=")) return neq(left, sum());
    if (takes("<")) return lt(left, sum());
    if (takes("<=")) return le(left, sum());
    return left;
  }
  Expr sum() {
    Expr e = takes("-") ? -product() : product();
    while (is("+") || is("-")) e = takes("+") ? e + product() : (need("-"), e - product());
    return e;
  }
  Expr product() {
    Expr e = power();
    const auto begins_atom = [&] {
      if (is("and") || is("or") || is("implies") || is("if")) return false;
      return now().kind == Kind::Name || is("(") || is("[");
    };
    while (is("*") || is("/") || (e.sort() == Sort::Matrix && begins_atom()))
      e = takes("*") ? e * power() : takes("/") ? e / power() : times(e, power());
    return e;
  }
  Expr power() {
    const Expr base = atom();
    if (!takes("^")) return base;
    if (base.sort() != Sort::Matrix) return kernel::power(base, small_number());
    return takes("T") ? transpose(base) : kernel::power(base, atom());
  }
  int small_number() {
    const std::string word = need(Kind::Number, "a whole number");
    if (word.size() > 9) refuse(word.substr(0, 20) + "... is too large here");
    return std::stoi(word);
  }

  Expr atom() {
    Expr e = bare_atom();
    while (is_attached("[")) {
      need("[");
      const int row = small_number();
      need(",");
      e = entry(e, row - 1, small_number() - 1);
      need("]");
    }
    return e;
  }
  Expr bare_atom() {
    if (now().kind == Kind::Number) return number();
    if (takes("[")) return matrix_entries();
    if (takes("(")) {
      const Expr e = formula();
      need(")");
      return e;
    }
    const std::string name = need(Kind::Name, "a number, a name or a bracket");
    if (name != "det") return resolved(name);
    const Exprs of = arguments();
    if (of.size() != 1) refuse("det has another number of arguments");
    return det(of[0]);
  }
  Expr number() {
    if (now().text.size() > 10000) refuse("a number of more than 10000 digits");
    return Expr(cln::cl_RA(cln::cl_I(next().text.c_str())));
  }
  Expr matrix_entries() {
    Exprs entries = list();
    const int cols = int(entries.size());
    while (takes(";")) {
      const Exprs row = list();
      if (int(row.size()) != cols) refuse("rows of different lengths");
      entries.insert(entries.end(), row.begin(), row.end());
    }
    need("]");
    return matrix(cols, entries);
  }
  Exprs arguments() {
    need("(");
    Exprs out = list();
    while (takes(";"))
      for (Expr e : list()) out.push_back(e);
    need(")");
    return out;
  }

  // A bound variable, a variable, a function with what follows it, or a function at an index.
  Expr resolved(const std::string& name) {
    for (std::size_t i = 0; i < bound.size(); ++i)
      if (bound[i].first == name)
        return make({.op = Op::Bound, .index = int(i), .variable = bound[i].second});
    if (const Expr v = known_variable(name)) return v;
    const std::size_t split = name.rfind('_');
    const std::string index = split == name.npos ? "" : name.substr(split + 1);
    const bool has_indices = split != name.npos && index.empty() && is_attached("(");
    if (!has_indices && signature(name)) return applied(name, {});
    const std::string function = indexed(name, split);
    if (index.empty()) return applied(function, arguments());
    const Expr at = is_whole(index) ? Expr(cln::cl_RA(cln::cl_I(index.c_str()))) : resolved(index);
    return applied(function, {at});
  }
  // alpha_ or alpha, of alpha_3
  std::string indexed(const std::string& name, std::size_t split) {
    for (const std::string& f : {name.substr(0, split + 1), name.substr(0, split)})
      if (const Signature* s = signature(f); s && s->indexed()) return f;
    refuse("the name " + name + " is not known");
  }
  Expr applied(const std::string& name, Exprs indices) {
    const Signature& s = *signature(name);
    Exprs plain = is_attached("(") ? arguments() : Exprs();
    const std::size_t given = indices.size() + plain.size();
    const bool hidden = given != s.args.size() && given + s.params.size() == s.args.size();
    Exprs args = hidden ? s.params : Exprs();
    for (std::size_t i = args.size(); i < s.args.size(); ++i) {
      Exprs& from = s.args[i] == Sort::Int ? indices : plain;
      if (from.empty()) refuse(name + " has another number of arguments");
      args.push_back(from.front());
      from.erase(from.begin());
    }
    if (!indices.empty() || !plain.empty()) refuse(name + " has another number of arguments");
    return fun(name, args);
  }

  int depth = 0;
  std::deque<std::pair<std::string, Sort>> bound;  // innermost first
};
}  // namespace

Expr read(std::string_view text) {
  if (text.size() > 200000) refuse("a formula of more than 200000 characters");
  Reader reader(text);
  try {
    return reader.everything();
  } catch (const Refused& r) {
    throw Refused("before character " + std::to_string(reader.at()) + ": " + r.what());
  }
}
}  // namespace notation
