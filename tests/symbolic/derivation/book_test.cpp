// The book is proved; a wrong formula, law or shape in its place is not.
#include <algorithm>

#include "catch.hpp"
#include "derivation/symbols.hpp"
#include "kernel/names.hpp"

using namespace derivation;

const auto refused = [](const std::string& because, const auto& act) {
  CHECK_THAT(refusal<Refused>(act), ContainsSubstring(because));
};

// The first of all: nothing is proved yet.
TEST_CASE("no chapter is proved beyond the one that is asked for") {
  CHECK(text(shown("contact.v_1").conclusion()).starts_with("v_1 = "));
  CHECK(!signature("Lambda"));
  CHECK(!is_shown("rotation.nothing"));
  CHECK(signature("Lambda"));
  CHECK(!signature("a_t"));
  refused("no theorem nowhere.at_all", [] { shown("nowhere.at_all"); });
  CHECK(signature("a_t"));
  CHECK(shown("power.a").conclusion() == the_book()["power.a"].conclusion());
}

TEST_CASE("the book is proved, and says each thing once") {
  std::set<std::string> ids;
  for (const Chapter& chapter : the_book().chapters())
    for (const Statement& s : chapter.statements) {
      INFO(s.id);
      CHECK(ids.insert(s.id).second);
      CHECK(s.words.size() > 1);
      std::string conditions;  // beyond those of its chapter
      for (const Expr& h : s.theorem.hypotheses())
        if (std::count(chapter.assumptions.begin(), chapter.assumptions.end(), h) == 0)
          conditions += (conditions.empty() ? "if " : " and ") + text(h);
      CHECK(conditions.size() <= 78);  // a line
    }
  CHECK(ids.size() > 90);
}

TEST_CASE("wrong formulas are not proved, and what is left over is said") {
  const Book& book = the_book();
  const Theorem p1 = positive(1 + alpha, {assume(alpha_positive)});
  const Theorems steps{book["cycle.P"]}, all{book["cycle.P"], p1};
  const auto momentum = [&](Expr mass) {
    return eq(a(n - 1) + mass * c_prime(n - 1), a(n) + mass * c(n));
  };
  CHECK_NOTHROW(equation(momentum(alpha), all));
  refused("no proof found of a_(n - 1) + 2*alpha*c'_(n - 1)",
          [&] { equation(momentum(2 * alpha), all); });
  refused("left over", [&] { equation(momentum(alpha), steps); });
  const Theorems values{book["rotation.cos_half_psi"], p1};
  refused("no proof found", [&] { equation(cos(psi() / 2), 1 / (1 + 2 * alpha), values); });
  refused("no theorem power.", [&] { book["power.nothing"]; });
}

TEST_CASE("tactics for angles refuse what does not follow") {
  const auto le_0 = assume(le(0, x)), less = assume(lt(x, y)), same = assume(le(x, y));
  const Theorem to_pi = assume(le(y, pi())), beyond = assume(le(y, 2 * pi()));
  const Theorems right{le_0, to_pi}, wide{le_0, beyond}, early{assume(le(-1, x)), to_pi};
  CHECK(text(cosine_falls(less, right).conclusion()) == "cos(y) < cos(x)");
  CHECK(text(cosine_falls(same, right).conclusion()) == "cos(y) <= cos(x)");
  refused("no linear combination of the facts gives y <= pi", [&] { cosine_falls(less, wide); });
  refused("gives 0 <= x", [&] { cosine_falls(less, early); });
  const Theorem y_from_0 = assume(le(0, y));
  CHECK(text(sine_not_negative(y, {y_from_0, to_pi}).conclusion()) == "0 <= sin(y)");
  CHECK_THROWS_AS(sine_not_negative(y, {y_from_0, beyond}), Refused);
  CHECK_THROWS_AS(sine_not_negative(y, {assume(le(-1, y)), to_pi}), Refused);
  CHECK_THROWS_AS(positive(cos(y), {y_from_0, assume(le(y, pi() / 2))}), Refused);
  CHECK(text(part_of_pi(8)->cosine) == "|- cos(pi/8) = sqrt(2 + sqrt(2))/2");
  for (const int d : {-2, 0, 7, 9, 25, 45}) CHECK_FALSE(part_of_pi(d));
  CHECK_THROWS_AS(solved_for(y, assume(eq(x, 0))), Refused);
  CHECK_THROWS_AS(otherwise(lt(x, y), {assume(lt(0, 1))}), Refused);
  CHECK_THROWS_AS(at("root squared", {{x, y}}), Refused);  // nothing says 0 <= y
  CHECK_THROWS_AS(same_sign(iff(lt(0, x), lt(x, 0)), 2, {}), Refused);
  CHECK_THROWS_AS(where_equal(x, y, lt(x, 0), assume(lt(0, y))), Refused);
  CHECK_THROWS_AS(by_induction(n, eq(turn(n), 0), Theorems{}, {}), Refused);
  CHECK_NOTHROW(linear(le(n, 2 * k), {assume(lt(n, 2 * k + 1))}));
  CHECK_THROWS_AS(linear(le(x, 2 * k), {assume(lt(x, 2 * k + 1))}), Refused);
  CHECK_THROWS_AS(positive(1 + alpha), Refused);  // known while deriving only
  CHECK(otherwise(lt(x, y), {assume(lt(0, 0))}).hypotheses() == Exprs{lt(0, 0)});
}

TEST_CASE("GiNaC solves linear equations, and says where they do not determine the unknowns") {
  const Expr u = real("u_1"), v = real("v_1");
  CHECK(solve({eq(u + v, 3), eq(u - v, 1)}, {u, v}) == Exprs{2, 1});
  const Exprs too_few{eq(u + v, 3)}, unknowns{u, v}, too_many{eq(u, 3), eq(u, 4)};
  refused("do not determine", [&] { solve(too_few, unknowns); });
  refused("do not determine", [&] { solve(too_many, {u}); });
  refused("GiNaC cannot solve", [&] { solve({eq(u * u, 4)}, {u}); });
  CHECK(text(simplified((u * u - v * v) / (u - v))) == "u_1 + v_1");
  CHECK(text(simplified(1 / sqrt(alpha))) == "sqrt(alpha)/alpha");
}

TEST_CASE("a statement whose terms may not make sense is not shown") {
  Book book;
  book.chapter("test", "Test", {});
  const Expr t = real("t_0");
  refused("test.quotient makes sense only where t_0 != 0",
          [&] { book.show("quotient", "words", equation(1 / t, 1 / t)); });
  book.show("guarded", "words", under({lt(0, t)}, equation(1 / t, 1 / t)));
  refused("two statements test.guarded", [&] { book.show("guarded", "words", equation(t, t)); });
}
