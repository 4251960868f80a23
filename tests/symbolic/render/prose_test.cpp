// SPDX-License-Identifier: GPL-2.0-or-later
#include "render/prose.hpp"

#include <catch2/catch.hpp>

#include "render/derivation_pages.hpp"
#include "render/wrapping.hpp"

using namespace magicmass::render;

namespace {
std::string shown(const std::string& words) {
  const std::string line = wrapped(prose_text(words, {.unicode = true}), "", 200);
  return line.substr(0, line.size() - 1);
}
}  // namespace

TEST_CASE("symbols among words are set as symbols, words are left alone", "[exam]") {
  CHECK(shown("Lambda leaves it where it is") == "Λ leaves it where it is");
  CHECK(shown("n integer, n >= 1") == "n integer, n ≥ 1");
  CHECK(shown("a_n and c'_(n-1) put in") == "aₙ and c′ₙ₋₁ put in");
  CHECK(shown("c'_n as a product") == "c′ₙ as a product");
  CHECK(shown("e'_3 is the axis") == "e′₃ is the axis");
  CHECK(shown("divide by M_1 (u_1 - v_1): done") == "divide by M₁ (u₁ − v₁): done");
  CHECK(shown("kinetic energy (both sides times two)") == "kinetic energy (both sides times two)");
  CHECK(shown("(2 M + m) V_CM = M V") == "(2 M + m) V_CM = M V");
  CHECK(shown("B takes a part of it; so does A") == "B takes a part of it; so does A");
  CHECK(shown("a(n) != a(n - 1), and so at every earlier n") ==
        "aₙ ≠ aₙ₋₁, and so at every earlier n");
  CHECK(shown("unbalanced ( and ) stay") == "unbalanced ( and ) stay");
}

TEST_CASE("sentences break between words, not within a short formula", "[exam]") {
  const std::string text = "For alpha = 1/8, n = 1: your A moves right at 0.8";
  CHECK(wrapped_sentences(text, "  ", 24) ==
        "  For alpha = 1/8,\n  n = 1: your A moves\n  right at 0.8\n");
  CHECK(wrapped_sentences(text, "", 100) == text + "\n");
  // one formula that fills the line is broken as a formula
  CHECK(wrapped_sentences("aaaa = bbbbb + ccccc + ddddd", "", 20) ==
        "aaaa = bbbbb + ccccc\n+ ddddd\n");
}
