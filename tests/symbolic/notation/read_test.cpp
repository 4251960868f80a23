// What the kernel prints is read back as the same tree; what people type; what is refused.
#include <functional>
#include <random>

#include "kernel/names.hpp"
#include "kernel/theorem.hpp"
#include "notation/alpha.hpp"
#include "notation/typed.hpp"
#include "rows.hpp"

using namespace kernel;
using namespace notation;

namespace {
struct Words {
  Expr x = real("x"), y = real("y'"), n = integer("n"), k = integer("k_1");
  Expr T = integer("T");
  Words() {
    if (is_known("a")) return;
    define_recursive({"a", "c'"}, {x}, n, {y, real("z")}, {x, 0}, {y + 1, y});
    define("alpha_", {x, n}, x + n, 1);
    define("C", {x, n, k}, x * n + k, 0);
    define("psi", {x}, 2 * x);
    define("N", {n}, n + 1);
    define("Lambda", {x}, matrix(2, {x, 1, 2, 3}));
    define("rho", {y}, matrix(2, {y, 0, 0, y}), 0);
    define("contact", {x, y}, lt(x, y), 0);
  }
};
Expr call(const std::string& name, auto... terms) { return fun(name, {terms...}); }
// Random trees over all that the kernel can make.
class Trees {
public:
  explicit Trees(unsigned seed) : random(seed) {}
  Expr integer_term(int depth) {
    const auto sub = [&] { return integer_term(depth - 1); };
    return one_of(depth, 5,
                  {[&] { return Expr(below(3)); }, [&] { return -Expr(below(30)); },
                   [&] { return w.n; }, [&] { return w.k; }, [&] { return w.T; },
                   [&] { return ceil(term(depth - 1)); }, [&] { return power(sub(), 2); },
                   [&] { return sub() * sub(); }, [&] { return sub() - sub(); }});
  }
  Expr term(int depth) {
    const auto sub = [&] { return term(depth - 1); };
    const auto at = [&] { return integer_term(depth - 1); };
    const auto base = [&] { return below(2) ? w.x : sub(); };
    const auto number = [&] { return Expr(below(9) - 4) / (1 + below(3)); };
    return one_of(depth, 4,
                  {number,
                   [&] { return w.x; },
                   [&] { return w.y; },
                   pi,
                   [&] { return sub() + sub() + sub(); },
                   [&] { return sub() * sub() * sub(); },
                   [&] { return number() * sub(); },
                   [&] { return call("inv", sub()); },
                   [&] { return power(fun("inv", {sub()}), 2 + below(2)); },
                   [&] { return power(sub(), 1 + below(3)); },
                   [&] { return -sub(); },
                   [&] { return sub() - sub(); },
                   [&] { return sub() / sin(sub()); },
                   [&] { return sub() / (2 * power(w.x, 2) * sqrt(sub())); },
                   [&] { return call(below(2) ? "a" : "c'", base(), at()); },
                   [&] { return call("alpha_", base(), at()); },
                   [&] { return call("C", sub(), at(), at()); },
                   [&] { return call("psi", base()); },
                   [&] { return call("N", below(2) ? w.n : at()); },
                   [&] { return entry(square(depth - 1), below(2), below(2)); },
                   [&] { return det(square(depth - 1)); },
                   at});
  }
  Expr square(int depth) {
    const auto sub = [&] { return square(depth - 1); };
    const auto entry = [&] { return term(depth - 1); };
    return one_of(
        depth, 2,
        {[&] { return call("Lambda", below(2) ? w.x : term(0)); },
         [&] { return call("rho", term(0)); }, [&] { return times(sub(), sub()); },
         [&] { return transpose(sub()); }, [&] { return power(sub(), integer_term(depth - 1)); },
         [&] {
           return matrix(2, {entry(), 1, entry(), term(0)});
         }});
  }
  Expr formula(int depth) {
    const auto sub = [&] { return formula(depth - 1); };
    const auto three = [&] { return Exprs{sub(), sub(), sub()}; };
    return one_of(
        depth, 5,
        {[&] { return eq(term(depth), term(depth)); }, [&] { return lt(term(depth), term(depth)); },
         [&] { return le(integer_term(depth), term(depth)); },
         [&] { return call("contact", term(depth), w.x); },
         [&] { return eq(square(depth), square(depth)); }, [&] { return logic_not(sub()); },
         [&] { return logic_and(three()); }, [&] { return logic_or(three()); },
         [&] { return imp(sub(), sub()); }, [&] { return iff(sub(), sub()); },
         [&] { return all(below(2) ? w.x : w.y, sub()); },
         [&] { return all(below(2) ? w.n : w.k, sub()); },
         [&] { return all(w.n, imp(le(integer_term(1), w.n), sub())); }});
  }

private:
  int below(int n) { return int(random() % unsigned(n)); }
  // The first ways are those without a part.
  Expr one_of(int depth, int leaves, const std::vector<std::function<Expr()>>& ways) {
    return ways[std::size_t(below(depth > 0 ? int(ways.size()) : leaves))]();
  }
  Words w;
  std::mt19937 random;
};
// What people type.
std::string reading(const std::string& typed, const std::set<std::string>& factors = {}) {
  const Typed read = read_typed(typed, factors);
  if (read.term.sort() != kernel::Sort::Matrix) return typed_text(read.term);
  std::string out;
  for (Expr e : entries(read.term)) out += (out.empty() ? "" : "; ") + typed_text(e);
  return out;
}
}  // namespace

TEST_CASE("thousands of random trees are read back, and a textbook's formulas") {
  Trees trees(20250101);
  for (int round = 0; round < 8000; ++round) {
    const int depth = 1 + round % 4;
    const Expr e = round % 3 == 0   ? trees.term(depth)
                   : round % 3 == 1 ? trees.formula(depth)
                                    : trees.square(depth);
    const std::string words = text(e);
    INFO(words);
    REQUIRE(read(words) == e);
  }
  for (const auto& row : rows_of("symbolic/notation/printed.tsv", 1))
    CHECK(text(read(row[0])) == row[0]);
}

TEST_CASE("what is no formula, has two readings or is no mass ratio is refused") {
  const Words w;
  const std::map<std::string, std::function<void(const std::string&)>> readers{
      {"formula", [](const std::string& words) { read(words); }},
      {"typed", [](const std::string& words) { notation::read_typed(words); }},
      {"condition", [](const std::string& words) { notation::read_comparisons(words); }},
      {"alpha", [](const std::string& words) { notation::read_alpha(words); }}};
  auto rows = rows_of("symbolic/notation/refusals.tsv", 3, 84);
  rows.push_back({"formula", std::string(201, '(') + "x", "brackets more than 200 deep"});
  rows.push_back({"formula", std::string(200001, '('), "more than 200000 characters"});
  rows.push_back({"formula", std::string(10001, '9'), "more than 10000 digits"});
  rows.push_back({"typed", std::string(20001, '-') + "x", "longer than 20000"});
  rows.push_back({"alpha", std::string(4097, '1'), "4097 characters long"});
  rows.push_back({"alpha", "\x1b[2J", "not a number: \"?[2J\""});
  for (const auto& row : rows) {
    INFO(row[0] << ": " << row[1].substr(0, 50));
    CHECK_THROWS_WITH(readers.at(row[0])(row[1]), ContainsSubstring(row[2]));
  }
  CHECK(read(std::string(199, '(') + "x" + std::string(199, ')')) == w.x);
  CHECK_FALSE(is_known("unknown"));
}

TEST_CASE("Plain text, Unicode and LaTeX are read alike, and a chosen reading is said") {
  for (const auto& row : rows_of("symbolic/notation/readings.tsv", 4, 56)) {
    INFO(row[0]);
    std::istringstream known(row[3]);
    const std::set<std::string> factors{std::istream_iterator<std::string>(known), {}};
    CHECK(reading(row[0], factors) == row[1]);
    if (row[1].find(';') == std::string::npos) CHECK(reading(row[1]) == row[1]);
    std::string said;
    for (const auto& note : read_typed(row[0], factors).notes)
      said += (said.empty() ? "" : "; ") + note;
    CHECK(said == row[2]);
  }
  CHECK(reading(std::string(199, '(') + "x" + std::string(199, ')')) == "x");
  CHECK(reading(std::string(15000, '-') + "x") == "x");
  CHECK(alike("M", {"m"}).empty());
}

TEST_CASE("of mass ratios, decimals and hex floats are the nearest double, p/q is exact") {
  for (const auto& row : rows_of("symbolic/notation/ratios.tsv", 2))
    CHECK(text(read_alpha(row[0])) == row[1]);
  CHECK(std::get<cln::cl_RA>(read_alpha("1/" + std::string(4094, '1'))) > 0);
}
