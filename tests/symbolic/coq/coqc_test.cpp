// coqc accepts what is emitted for each rule, kind of definition and axiom, and nothing spoiled.
#include <cstdlib>
#include <regex>

#include "coq/files.hpp"
#include "rows.hpp"

using namespace kernel;

namespace {
// All are names of the kernel: what the emitted proofs bind must be none.
const Expr x = real("x"), y = real("y"), z = real("z'"), k = real("k'");
const Expr n = integer("core"), m = integer("in");

coq::Chapter logic() {
  const Theorem equation = assume(eq(x, y + z));
  const Theorem whole = assume(all(n, lt(power(x + 1, 2), n)));
  const Theorem ordered = assume(logic_or({le(y + x, z), lt(x, y)}));
  return {"logic",
          {{"discharge", discharge(lt(x, y), assume(lt(x, y)))},
           {"instance", instantiate(equation, {{x, x * y}, {z, Expr(n)}})},
           {"generalized", generalize(n, discharge(lt(0, n), assume(lt(0, n))))},
           {"specialized", specialize(whole, 2 * n + power(m, 2))},
           {"restated", restate(all(n, lt(1 + 2 * x + x * x, Expr(0) + n)), whole)},
           {"rewritten", rewrite(equation, assume(lt(sin(x) + z, x)))},
           {"order", tautology(logic_or({logic_not(lt(z, x + y)), lt(x, y)}), {ordered})},
           {"lost", tautology(lt(x, y), {assume(lt(x, y)), axiom("discrete")})},
           {"classical", tautology(logic_or({lt(x, y), logic_not(lt(x, y))}), {})},
           {"not less", tautology(le(y, x), {assume(logic_not(lt(x, y)))})},
           {"if and only if", tautology(iff(eq(x, y), eq(x, y + 0)), {})}}};
}
coq::Chapter certificates() {
  const Theorem equation = assume(eq(x, 2 * y));
  const Theorem positive = assume(lt(0, x + y));
  const Theorem other = assume(neq(z, 0)), at_least = assume(le(y, z / 2));
  Certificate multiplied;
  multiplied.multipliers = {positive};
  multiplied.products = {{cln::cl_RA(1) / 3, {positive, positive}, {}}, {2, {at_least}, {x}}};
  multiplied.equations = {
      {1, assume(eq(power(x + y, 2) / 3 + 2 * (z / 2 - y) * x * x, (x + y) * (y - sin(x + x))))}};
  return {"certificates",
          {{"square", arithmetic(eq(x * x, 4 * y * y), {.equations = {{x + 2 * y, equation}}})},
           {"inverses", arithmetic(eq(x / (x + y) / z + y / (y + x) / z, 1 / z),
                                   {.nonzero = {positive, other}})},
           {"multiplier", arithmetic(lt(sin(2 * x), y), multiplied)},
           {"root", arithmetic(le(2 * x * y, x * x + y * y), {.products = {{1, {}, {x - y}}}})},
           {"numbers", arithmetic(eq(Expr(1) / Expr(2) + fun("inv", {1 + Expr(1)}), 1), {})}}};
}
coq::Chapter definitions() {
  const Theorem even = define("even_of", {n}, 2 * n);
  const Theorem turned = define("turned", {x}, matrix(2, {cos(x), -sin(x), sin(x), cos(x)}));
  const Expr turn = fun("turned", {x});
  const Theorems counted =
      define_recursive({"count_of", "sum_of"}, {k}, n, {x, z}, {0, k}, {x + 1, z * k + n});
  const Theorem least = define_least("first_of", {y}, n, 0, lt(y, n));
  const Expr count = fun("count_of", {k, n}), counts = eq(count, n);
  const Theorem from_0 = assume(logic_and({le(0, n), counts}));
  const Theorem next =
      tautology(counted[2].conclusion().arg(1), {counted[2], tautology(le(0, n), {from_0})});
  const Theorem step = arithmetic(eq(fun("count_of", {k, n + 1}), n + 1),
                                  {.equations = {{1, next}, {1, tautology(counts, {from_0})}}});
  const Theorem hold = discharge(from_0.conclusion(), step);
  const Expr entries = logic_and({eq(entry(turn, 0, 0), cos(x)), eq(entry(turn, 0, 1), -sin(x)),
                                  eq(entry(turn, 1, 0), sin(x)), eq(entry(turn, 1, 1), cos(x))});
  const Expr a = matrix(2, {x, y, z, 1});
  const Theorem same = assume(eq(times(a, power(turn, n)), transpose(a)));
  return {"definitions",
          {{"name", define("double_of", {x}, 2 * x)},
           {"integer", instantiate(least, {{n, fun("even_of", {n})}})},
           {"predicate", instantiate(define("is_small", {x, y}, lt(power(x, 2), y)), {{y, y + 1}})},
           {"matrix", tautology(entries, {turned})},
           {"entries", restate(eq(times(a, power(turn, n + 0)), matrix(2, {x, z, y, 1})), same)},
           {"start", counted[0]},
           {"next", counted[3]},
           {"least", least},
           {"powers", matrix_power(turn, n)},
           {"even", even},
           {"determinant", arithmetic(eq(det(a), x - y * z), {})},
           {"induction", induction(n, 0, counts, counted[0], hold)}}};
}

coq::Chapter axioms() {
  coq::Chapter out{"axioms", {}};
  for (const std::string& name : axiom_names()) out.shown.emplace_back(name, axiom(name));
  return out;
}
/// What coqc says, "" where it accepts; compiled files stay in the folder of this test.
std::string refusal(const std::string& file, const std::string& text) {
  std::ofstream(file + ".v") << text;
  const std::string command =
      MAGICMASS_COQC " -q -w none -R . Magicmass " + file + ".v >" + file + ".said 2>&1";
  if (std::system(command.c_str()) == 0) return "";
  const std::string words = contents_of(file + ".said");
  return words.empty() ? "refused" : words;
}
}  // namespace

TEST_CASE("coqc proves every step of the examples, and refuses what was spoiled") {
  std::map<std::string, std::string> texts;
  for (const auto& [name, text] :
       coq::files({axioms(), logic(), certificates(), definitions()}).texts) {
    const std::string file = name.substr(0, name.size() - 2);
    INFO(name);
    CHECK(refusal(file, text) == "");
    texts[file] = text;
  }
  CHECK(coq::foreign_assumption(contents_of("assumptions.said")) == "");

  for (auto& row : rows_of("symbolic/coq/spoiled.tsv", 4, 6)) {
    for (std::string& field : row) field = std::regex_replace(field, std::regex(R"(\\n)"), "\n");
    INFO(row[1]);
    std::string text = texts.at(row[0]);
    const std::size_t where = text.find(row[1]);
    REQUIRE(where != std::string::npos);
    const std::string said = refusal("spoiled", text.replace(where, row[1].size(), row[2]));
    CHECK_THAT(said, ContainsSubstring("Error"));
    CHECK_THAT(said, ContainsSubstring(row[3]));
  }
}
TEST_CASE("an axiom that is not of Coq's library is seen") {
  REQUIRE(refusal("prelude", coq::files({}).texts[0].second) == "");
  REQUIRE(refusal("hidden",
                  "From Magicmass Require Import prelude.\nAxiom hidden : 0 = 1.\n"
                  "Lemma one : 0 = 1 /\\ PI = PI. Proof. split; [exact hidden|easy]. Qed.\n"
                  "Print Assumptions one.\n") == "");
  CHECK(coq::foreign_assumption(contents_of("hidden.said")) == "hidden");
  CHECK(coq::foreign_assumption("") == "what coqc does not say");
}
