// SPDX-License-Identifier: GPL-2.0-or-later
#include "equality/bounded.hpp"

#include <catch2/catch.hpp>

#include "equality/message.hpp"

using namespace magicmass::equality;

TEST_CASE("a question that takes too long is undecided, and says so", "[exam]") {
  std::string nested = "x";  // differentiating and expanding this is hopeless
  for (int i = 0; i < 60; ++i) nested = "tan(" + nested + "+1/7)";
  const Verdict verdict = answer_within({nested, nested + "*(sin(x)^2+cos(x)^2)", {}},
                                        {.time = std::chrono::milliseconds(150)});
  CHECK(verdict.answer == Answer::undecided);
  CHECK_THAT(verdict.proof, Catch::Contains("within 150 ms"));
}

TEST_CASE("what the child says arrives whole", "[exam]") {
  const Question question{"alpha_k", "sec(pi/(2*k+1)) - 1", {}};
  const Verdict here = answer(question);
  const Verdict there = answer_within(question);
  CHECK(there.answer == Answer::equal);
  CHECK(there.proof == here.proof);
  CHECK(there.domain == here.domain);
  CHECK(there.notes == here.notes);
  const Verdict different = answer_within({"x", "abs(x)", {}});
  REQUIRE(different.counterexample);
  CHECK(different.counterexample->point.at("x") == "-1");
  CHECK_THROWS_AS(answer_within({"1/0", "1", {}}), Refused);
}

TEST_CASE("a message that is cut off waits for the rest", "[exam]") {
  Message message;
  message.is_final = true;
  message.verdict.proof = "12:34";
  message.verdict.conditions = {"a", ""};
  const std::string bytes = packed(message);
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    std::string part = bytes.substr(0, size);
    CHECK_FALSE(take(part));
  }
  std::string two = bytes + bytes;
  REQUIRE(take(two));
  const auto second = take(two);
  REQUIRE(second);
  CHECK(two.empty());
  CHECK(second->verdict.proof == "12:34");
  CHECK(second->verdict.conditions == message.verdict.conditions);
}
