// SPDX-License-Identifier: GPL-2.0-or-later
// What is emitted: the same bytes again, no long line, every temporary explained or named.
#include <fstream>
#include <sstream>

#include "catch.hpp"
#include "codegen/emit_evaluator.hpp"
#include "codegen/generate.hpp"
#include "codegen/polynomials.hpp"
#include "quantities.hpp"

TEST_CASE("emission gives the same bytes again, in lines of at most 100 columns") {
  for (const codegen::Quantity& q : test::quantities()) {
    const codegen::Evaluator e = codegen::emit_evaluator(q);
    CHECK(codegen::emit_evaluator(q).header == e.header);
    std::istringstream lines(e.header + codegen::emit_polynomials());
    for (std::string line; std::getline(lines, line);) {
      INFO(line);
      REQUIRE(line.size() <= 100);
    }
  }
}
TEST_CASE("a header states licence, theorems, domain, bounds, operations and arguments") {
  const std::string header = codegen::emit_evaluator(test::quantities()[1]).header;
  for (const char* part :
       {"// SPDX-License-Identifier: MIT", "do not edit: run `magicmass generate`", "eq:NA-ans",
        "alpha from 0x1p-100 to 0x1.fffffffffffffp-1", "/// Theorem: N_A = ceil(",
        "/// Accurate is off by at most a_t: 2^", "/// Operations: arctangents: 1",
        "r < h/2 is tested of computed values", "// half_h = atan(t)", "doubt_of_sign(to_next"}) {
    CHECK_THAT(header, ContainsSubstring(part));
  }
}
TEST_CASE("the tiers' bounds grow from Slow to Accurate to Fast") {
  const std::string errors = codegen::emit_evaluator(test::quantities()[0]).errors;
  for (const char* part :
       {"VelocitiesSmall, Accurate", "VelocitiesSmall, Fast", "VelocitiesSmall, Slow",
        "VelocitiesSmall, Ziv", "OUTPUT c_prime: 2^-"}) {
    CHECK_THAT(errors, ContainsSubstring(part));
  }
}
TEST_CASE("cases are disjoint conditions, rational theorems give exact forms, files are listed") {
  const kernel::Expr alpha = kernel::real("alpha");
  const kernel::Theorem product = kernel::define("swap", {alpha}, (1 + alpha) * (1 - alpha));
  const kernel::Expr swap = product.conclusion().arg(0);
  const kernel::Theorem sum = kernel::restate(kernel::eq(swap, 1 - alpha * alpha), product);
  codegen::Quantity q{"swap", "none", {{alpha, {0x1p-20, 0x1p20}, {0x1p-20, 0x1p20}}}, {}};
  q.cases = {{"below", {{"alpha", {0, 1}}}, {}, {product}, {}, {}},
             {"above", {{"alpha", {0x1.0000000000001p0, 0x1p20}}}, {}, {sum}, {}, {}}};
  const auto files = codegen::generate({q}, {{q, "product"}});
  const std::string header = files.at("evaluators/swap.hpp");
  CHECK_THAT(header, ContainsSubstring("in.alpha >= 0x1p-20 && in.alpha <= 0x1p+0"));
  CHECK_THAT(header, ContainsSubstring("in.alpha >= 0x1.0000000000001p+0 && in.alpha <= 0x1p+20"));
  CHECK_THAT(files.at("plain/product.hpp"),
             ContainsSubstring("alpha >= Number(0x1.0000000000001p+0)"));
  CHECK_THAT(files.at("manifest.json"), ContainsSubstring("\"form\": \"product\""));
  CHECK_THROWS_WITH(codegen::generate({q, q}, {}), ContainsSubstring("two files are called"));
}
