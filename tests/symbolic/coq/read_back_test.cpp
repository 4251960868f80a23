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
/// A word, or what stands in brackets.
struct Part {
  std::string word;
  std::vector<Part> parts = {};

  bool is_number() const { return std::isdigit(static_cast<unsigned char>(word[0])) != 0; }
  cln::cl_RA number() const { return cln::cl_I(word.c_str()); }
};
using Parts = std::vector<Part>;
/// To the bracket that closes.
Parts inside(std::sregex_iterator& it) {
  Parts out;
  while (true) {
    REQUIRE(it != std::sregex_iterator());
    const std::string word = (it++)->str();
    if (word == ")" || word == "]") return out;
    out.push_back({word});
    if (word == "(" || word == "[") out.back().parts = inside(it);
  }
}
std::map<std::string, Sort> bound;  // by their names
int depth = 0;
Expr of(const Part& p);
Exprs every_other(const Parts& parts, const std::string& between) {
  Exprs out;
  for (std::size_t k = 0; k < parts.size(); k += 2) {
    out.push_back(of(parts[k]));
    if (k + 1 < parts.size()) REQUIRE(parts[k + 1].word == between);
  }
  return out;
}
/// A number, perhaps over another one.
cln::cl_RA ratio(const Parts& s, std::size_t k) {
  if (s.size() == k + 1) return s[k].number();
  REQUIRE((s.size() == k + 3 && s[k + 1].word == "/"));
  return s[k].number() / s[k + 2].number();
}
Expr quantified(const Parts& s) {  // forall v : R, isint v -> (...)
  const std::string v = s.at(1).word;
  const bool is_integer = s.at(5).word == "isint";
  REQUIRE(s.size() == (is_integer ? 9 : 6));
  bound[v] = is_integer ? Sort::Int : Sort::Real;
  ++depth;
  const Expr body = of(s.back());
  --depth;
  return make({.op = Op::All, .args = {body}, .name = v, .variable = bound[v]});
}
Expr named(const std::string& word, const Exprs& args) {
  if (word.starts_with("q'"))
    return make({.op = Op::Bound,
                 .index = depth - 1 - std::stoi(word.substr(2)),
                 .variable = bound.at(word)});
  const bool is_marked = word.size() > 2 && word.ends_with("'k");
  const std::string bare = is_marked ? word.substr(0, word.size() - 2) : word;
  const std::string name = word == "PI" ? "pi" : bare;
  const Expr variable = known_variable(name);
  return variable && args.empty() ? variable : fun(name, args);
}
Expr of(const Part& p) {
  const Parts& s = p.parts;
  if (p.word == "[") {  // the file does not say it: columns are 1 unless the matrix is square
    const Exprs entries = every_other(s, ";");
    const int n = int(std::sqrt(double(entries.size())));
    return matrix(n * n == int(entries.size()) ? n : 1, entries);
  }
  if (p.word != "(") return p.is_number() ? Expr(p.number()) : named(p.word, {});
  const std::string head = s.at(0).word, second = s.at(1).word;
  // Before the arguments of matrices stand sizes.
  static const std::map<std::string, std::size_t> sizes = {
      {"~", 2}, {"/", 2}, {"mtimes", 6}, {"mtranspose", 4}, {"mpow", 4}, {"entry", 3}, {"det", 3}};
  if (const auto size = sizes.find(head); size != sizes.end()) REQUIRE(s.size() == size->second);
  if (head == "~") return logic_not(of(s[1]));
  if (head == "/") return fun("inv", {of(s[1])});
  if (head == "mtimes") return times(of(s[4]), of(s[5]));
  if (head == "mtranspose") return transpose(of(s[3]));
  if (head == "mpow") return power(of(s[2]), of(s[3].parts.at(1)));  // (toN n)
  if (head == "entry")
    return make({.op = Op::Entry, .args = {of(s[1])}, .index = std::stoi(s[2].word)});
  if (head == "det") return det(of(s[2]));
  if (head == "forall") return quantified(s);
  if (head == "-") return Expr(-ratio(s, 1));
  if (second == "/") return Expr(ratio(s, 0));
  if (second == "^" && s.size() == 3) return power(of(s[0]), std::stoi(s[2].word));
  static const std::map<std::string, Op> operations = {
      {"+", Op::Add},  {"*", Op::Mul},   {"=", Op::Eq},   {"<", Op::Lt},   {"<=", Op::Le},
      {"->", Op::Imp}, {"/\\", Op::And}, {"\\/", Op::Or}, {"<->", Op::Iff}};
  if (const auto op = operations.find(second); op != operations.end())
    return make({.op = op->second, .args = every_other(s, second)});
  Exprs args;
  for (std::size_t k = 1; k < s.size(); ++k) args.push_back(of(s[k]));
  return named(head, args);
}
struct Statement {
  Exprs hypotheses;
  Expr conclusion;
  bool has_sorts;  ///< the integer variables, and no others, are said to be integers
};
/// All but the outermost part of it stands in brackets.
Statement read(const std::string& text) {
  const std::string closed = text + " )";
  const std::regex token(R"([\w']+|->|<->|<=|/\\|\\/|[^\s])");
  std::sregex_iterator it(closed.begin(), closed.end(), token);
  const Parts all = inside(it);
  REQUIRE(it == std::sregex_iterator());
  auto at = all.begin();
  if (at->word == "forall")
    while (at++->word != ",") {
    }
  Exprs parts;
  std::set<Expr> integers;
  for (; at != all.end(); ++at) {
    if (at->word == "isint")
      integers.insert(of(*++at));
    else
      parts.push_back(of(*at));
    if (++at == all.end()) break;
    REQUIRE(at->word == "->");
  }
  std::set<Expr> expected;
  for (Expr v : free_variables(logic_and(parts)))
    if (v.sort() == Sort::Int) expected.insert(v);
  const Expr conclusion = parts.back();
  parts.pop_back();
  return {parts, conclusion, integers == expected};
}
}  // namespace

TEST_CASE("each shown theorem is read back from its file as the kernel's terms") {
  std::vector<coq::Chapter> chapters;
  for (const derivation::Chapter& chapter : derivation::the_book().chapters()) {
    chapters.push_back({chapter.name, {}});
    for (const auto& s : chapter.statements) chapters.back().shown.emplace_back(s.id, s.theorem);
  }
  const coq::Files files = coq::files(chapters);
  std::map<std::string, std::string> texts(files.texts.begin(), files.texts.end());
  for (const coq::Chapter& chapter : chapters) {
    const std::string& text = texts.at(chapter.name + ".v");
    for (const auto& [id, theorem] : chapter.shown) {
      INFO(id);
      const std::size_t begin = text.find(" : ", text.find("(* " + id + " *)")) + 3;
      const auto [hypotheses, conclusion, has_sorts] =
          read(text.substr(begin, text.find(".\nProof", begin) - begin));
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
    const Statement found = read(statement);
    return found.hypotheses == hypotheses && found.conclusion == conclusion && found.has_sorts;
  };
  const Expr positive = lt(0, x + n);
  CHECK(is("forall n x : R, isint n -> (0 < x) -> (0 < (x + n))", {lt(0, x)}, positive));
  CHECK_FALSE(is("forall n x : R, isint n -> (0 <= x) -> (0 < (x + n))", {lt(0, x)}, positive));
  CHECK_FALSE(is("forall n x : R, isint n -> (0 < x) -> (0 <= (x + n))", {lt(0, x)}, positive));
  CHECK_FALSE(is("forall n x : R, (0 < x) -> (0 < (x + n))", {lt(0, x)}, positive));
  CHECK_FALSE(is("forall n x : R, isint n -> (0 < (x + n))", {lt(0, x)}, positive));
}
