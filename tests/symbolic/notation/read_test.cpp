// SPDX-License-Identifier: GPL-2.0-or-later
// What the kernel prints is read back as the same tree; what is refused by each reader.

#include <functional>
#include <random>

#include "catch.hpp"
#include "kernel/names.hpp"
#include "kernel/theorem.hpp"
#include "notation/alpha.hpp"
#include "notation/typed.hpp"
#include "rows.hpp"

using namespace kernel;
using notation::read;

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
/// One of the kind, as in forms.tsv.
std::string random_form(std::mt19937& random, char kind, int depth) {
  static const auto all = rows_of("symbolic/notation/forms.tsv", 2);
  std::vector<std::string> forms;
  for (const auto& row : all) {
    const bool is_leaf = row[1].find_first_of(kind == 'F' ? "F" : "RIMF") == std::string::npos;
    if (row[0][0] == kind && (depth > 0 || is_leaf)) forms.push_back(row[1]);
  }
  std::string out;
  for (const char c : forms[random() % forms.size()])
    out += std::string("DRIMF").find(c) == std::string::npos ? std::string(1, c)
                                                             : random_form(random, c, depth - 1);
  return out;
}
}  // namespace

TEST_CASE("thousands of random trees are read back") {
  const Words w;
  std::mt19937 random(20250101);
  for (int round = 0; round < 8000; ++round) {
    const std::string form = random_form(random, "RFM"[round % 3], 1 + round % 4);
    INFO(form);
    const Expr e = read(form);
    const std::string words = text(e);
    INFO(words);
    Expr back;
    REQUIRE_NOTHROW(back = read(words));
    REQUIRE(text(back) == words);
    REQUIRE(back == e);
  }
}

TEST_CASE("a textbook's way of writing") {
  const Words w;
  const Expr x = w.x, n = w.n, a = fun("a", {x, n - 1});
  for (const auto& [e, words] : std::vector<std::pair<Expr, std::string>>{
           {2 * x / (3 * w.y), "2*x/(3*y')"},
           {-pi() / 2, "-pi/2"},
           {-power(x, 2), "-x^2"},
           {(1 - x) / (1 + x) * a, "(1 - x)/(1 + x)*a_(n - 1)"},
           {fun("a", {x, n}), "a_n"},
           {fun("a", {x, 3}), "a_3"},
           {fun("a", {2, n}), "a_n(2)"},
           {fun("alpha_", {x, n}), "alpha_n"},
           {fun("c'", {x, n}), "c'_n"},
           {fun("inv", {0}), "inv(0)"},
           {power(fun("a", {x, power(w.k, 2)}), 2), "a_(k_1^2)^2"},
           {1 / power(x, 2), "1/x^2"},
           {power(Expr(1) / x, 2) - 1, "1/x^2 - 1"},
           {fun("inv", {power(x, 2)}), "inv(x^2)"},
           {all(x, all(x, lt(x, fun("psi", {x})))),
            "for every real x: for every real x': x' < psi(x')"},
           {all(n, imp(le(0, n), eq(fun("a", {x, n}), 0))), "for every integer n >= 0: a_n = 0"},
           {eq(power(fun("Lambda", {x}), n),
               times(fun("rho", {n * w.y}), transpose(fun("rho", {1})))),
            "Lambda^n = rho(n*y') rho(1)^T"},
           {entry(power(fun("Lambda", {x}), w.T), 0, 1), "(Lambda^(T))[1,2]"}}) {
    CHECK(text(e) == words);
    CHECK(read(words) == e);
  }
}

TEST_CASE("what is no formula, has two readings or is no mass ratio is refused") {
  const Words w;
  const std::map<std::string, std::function<void(const std::string&)>> readers{
      {"formula", [](const std::string& words) { read(words); }},
      {"typed", [](const std::string& words) { notation::read_typed(words); }},
      {"alpha", [](const std::string& words) { notation::read_alpha(words); }}};
  auto rows = rows_of("symbolic/notation/refusals.tsv", 3);
  REQUIRE(rows.size() > 80);
  rows.push_back({"formula", std::string(201, '(') + "x", "brackets more than 200 deep"});
  rows.push_back({"formula", std::string(200001, '('), "more than 200000 characters"});
  rows.push_back({"formula", std::string(10001, '9'), "more than 10000 digits"});
  rows.push_back({"alpha", std::string(4097, '1'), "4097 characters long"});
  rows.push_back({"alpha", "\x1b[2J", "not a number: \"?[2J\""});
  for (const auto& row : rows) {
    INFO(row[0] << ": " << row[1].substr(0, 50));
    CHECK_THROWS_WITH(readers.at(row[0])(row[1]), ContainsSubstring(row[2]));
  }
  CHECK(read(std::string(199, '(') + "x" + std::string(199, ')')) == w.x);
  CHECK_FALSE(is_known("unknown"));
}
