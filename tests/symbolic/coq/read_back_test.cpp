// SPDX-License-Identifier: GPL-2.0-or-later
// The statements in the emitted files are those of the kernel: read back, they are the same terms.
// So what writes them need not be trusted for what the theorems say.
#include <cmath>
#include <regex>

#include "catch.hpp"
#include "coq/files.hpp"
#include "derivation/book.hpp"
#include "kernel/names.hpp"

using namespace kernel;

namespace {
/// Reads a statement: all but the outermost part stands in brackets.
class Reader {
public:
  explicit Reader(const std::string& statement) {
    const std::regex token(R"([\w']+|->|<->|<=|/\\|\\/|[^\s])");
    for (std::sregex_iterator it(statement.begin(), statement.end(), token), end; it != end; ++it)
      tokens.push_back(it->str());
    tokens.push_back("");
  }
  struct Statement {
    Exprs hypotheses;
    Expr conclusion;
    bool has_sorts;  ///< the integer variables, and no others, are said to be integers
  };
  Statement statement() {
    if (takes("forall")) {
      while (next() != ",") {
      }
    }
    Exprs parts;
    std::set<Expr> integers;
    do {
      if (takes("isint"))
        integers.insert(part());
      else
        parts.push_back(part());
    } while (takes("->"));
    REQUIRE(peek() == "");
    std::set<Expr> expected;
    for (Expr v : free_variables(logic_and(parts)))
      if (v.sort() == Sort::Int) expected.insert(v);
    const Expr conclusion = parts.back();
    parts.pop_back();
    return {parts, conclusion, integers == expected};
  }

private:
  const std::string& peek() const { return tokens[at]; }
  std::string next() { return tokens[at++]; }
  bool takes(const std::string& token) {
    const bool here = peek() == token;
    if (here) ++at;
    return here;
  }
  bool is_number() const { return std::isdigit(static_cast<unsigned char>(peek()[0])) != 0; }
  cln::cl_RA number() { return cln::cl_I(next().c_str()); }
  int small() { return std::stoi(next()); }
  Expr closed(Expr e) {
    REQUIRE(next() == ")");
    return e;
  }
  /// The file does not say it: columns are 1 unless the matrix is square.
  static int columns_of(std::size_t entries) {
    const int n = int(std::sqrt(double(entries)));
    return std::size_t(n) * std::size_t(n) == entries ? n : 1;
  }
  Expr part() {
    if (takes("(")) return closed(inside());
    if (takes("[")) {
      Exprs entries{part()};
      while (takes(";")) entries.push_back(part());
      next();
      return matrix(columns_of(entries.size()), entries);
    }
    if (is_number()) return Expr(number());
    return named(next(), {});
  }
  Expr inside() {
    if (takes("~")) return logic_not(part());
    if (takes("/")) return fun("inv", {part()});
    if (takes("forall")) return quantified();
    if (takes("-")) return rational(-number());
    if (is_number() && tokens[at + 1] == "/") return rational(number());
    if (peek() != "(" && peek() != "[" && !is_number() && is_application()) return application();
    const Expr first = part();
    const std::string op = next();
    if (op == "^") return power(first, small());
    Exprs all{first, part()};
    while (takes(op)) all.push_back(part());
    static const std::map<std::string, Op> operations = {
        {"+", Op::Add},  {"*", Op::Mul},   {"=", Op::Eq},   {"<", Op::Lt},   {"<=", Op::Le},
        {"->", Op::Imp}, {"/\\", Op::And}, {"\\/", Op::Or}, {"<->", Op::Iff}};
    return make({.op = operations.at(op), .args = all});
  }
  Expr rational(const cln::cl_RA& above) {
    return takes("/") ? Expr(above / number()) : Expr(above);
  }
  /// How many sizes stand before the matrix.
  inline static const std::map<std::string, std::size_t> of_matrices = {
      {"mtimes", 3}, {"mtranspose", 2}, {"mpow", 1}, {"entry", 0}, {"det", 1}};
  bool is_application() const {
    const Signature* s = signature(kernel_name(peek()));
    return of_matrices.count(peek()) != 0 || (s != nullptr && !s->args.empty());
  }
  Expr application() {
    const std::string head = next();
    if (const auto shape = of_matrices.find(head); shape != of_matrices.end()) {
      at += shape->second;
      const Expr of = part();
      if (head == "det") return det(of);
      if (head == "mtranspose") return transpose(of);
      if (head == "mtimes") return times(of, part());
      if (head == "entry") return make({.op = Op::Entry, .args = {of}, .index = small()});
      at += 2;  // (toN
      return closed(power(of, part()));
    }
    Exprs args;
    while (peek() != ")") args.push_back(part());
    return named(head, args);
  }
  Expr quantified() {
    const std::string v = next();
    at += 3;  // : R,
    const bool is_integer = takes("isint");
    if (is_integer) at += 2;  // its name ->
    bound[v] = is_integer ? Sort::Int : Sort::Real;
    ++depth;
    const Expr body = part();
    --depth;
    return make({.op = Op::All, .args = {body}, .name = v, .variable = bound[v]});
  }
  static std::string kernel_name(const std::string& word) {
    if (word == "PI") return "pi";
    return word.size() > 2 && word.ends_with("'k") ? word.substr(0, word.size() - 2) : word;
  }
  Expr named(const std::string& word, const Exprs& args) {
    if (word.starts_with("q'"))
      return make({.op = Op::Bound,
                   .index = depth - 1 - std::stoi(word.substr(2)),
                   .variable = bound.at(word)});
    const Expr variable = known_variable(kernel_name(word));
    return variable ? variable : fun(kernel_name(word), args);
  }

  std::vector<std::string> tokens = {};
  std::size_t at = 0;
  std::map<std::string, Sort> bound = {};
  int depth = 0;
};

std::vector<coq::Chapter> chapters() {
  std::vector<coq::Chapter> out;
  for (const derivation::Chapter& chapter : derivation::the_book().chapters()) {
    out.push_back({chapter.name, {}});
    for (const auto& s : chapter.statements) out.back().shown.emplace_back(s.id, s.theorem);
  }
  return out;
}
}  // namespace

TEST_CASE("each shown theorem is read back from its file as the kernel's terms") {
  const coq::Files files = coq::files(chapters());
  std::map<std::string, std::string> texts(files.texts.begin(), files.texts.end());
  for (const coq::Chapter& chapter : chapters()) {
    const std::string& text = texts.at(chapter.name + ".v");
    for (const auto& [id, theorem] : chapter.shown) {
      INFO(id);
      const std::size_t title = text.find("(* " + id + " *)");
      const std::size_t begin = text.find(" : ", title) + 3;
      const auto [hypotheses, conclusion, has_sorts] =
          Reader(text.substr(begin, text.find(".\nProof", begin) - begin)).statement();
      CHECK((hypotheses == theorem.hypotheses()));
      CHECK((conclusion == theorem.conclusion()));
      CHECK(has_sorts);
    }
    for (const char* word : {"Axiom", "Admitted", "admit", "Parameter", "Hypothesis", "Variable"})
      CHECK_THAT(text, !ContainsSubstring(word));
  }
}
TEST_CASE("a weaker statement is read as another one") {
  const Expr x = real("x"), n = integer("n");
  const auto is = [](const std::string& statement, const Exprs& hypotheses, Expr conclusion) {
    const auto read = Reader(statement).statement();
    return read.hypotheses == hypotheses && read.conclusion == conclusion && read.has_sorts;
  };
  const Expr positive = lt(0, x + n);
  CHECK(is("forall n x : R, isint n -> (0 < x) -> (0 < (x + n))", {lt(0, x)}, positive));
  CHECK_FALSE(is("forall n x : R, isint n -> (0 <= x) -> (0 < (x + n))", {lt(0, x)}, positive));
  CHECK_FALSE(is("forall n x : R, isint n -> (0 < x) -> (0 <= (x + n))", {lt(0, x)}, positive));
  CHECK_FALSE(is("forall n x : R, (0 < x) -> (0 < (x + n))", {lt(0, x)}, positive));
  CHECK_FALSE(is("forall n x : R, isint n -> (0 < (x + n))", {lt(0, x)}, positive));
}
