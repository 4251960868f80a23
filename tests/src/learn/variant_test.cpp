// SPDX-License-Identifier: GPL-2.0-or-later
// Variants: the same question with other numbers.
#include "answers/errors.hpp"
#include "catch.hpp"
#include "learn/judge.hpp"
#include "refusal.hpp"

using learn::read_exercise;

namespace {

const std::string sound = R"toml(id = "x"
title = "x"
chapter = "x"
kind = "predict"
prompt = "The mass ratio is {alpha}."
run = "count --alpha {alpha}"
answer = "N_A"
hints = ["Not {beta}."]
variants = [{ alpha = "1/7" }, { alpha = "2" }]
[[misconceptions]]
name = "alpha"
answers = ["{alpha}"]
feedback = "This is {alpha}."
)toml";

std::string refused(const std::string& from, const std::string& to) {
  std::string text = sound;
  REQUIRE(text.find(from) != text.npos);
  text.replace(text.find(from), from.size(), to);
  return refusal<answers::InvalidInput>([&] { read_exercise(text, "x.toml"); });
}

}  // namespace

TEST_CASE("A variant fills all texts of an exercise") {
  for (const auto& [number, alpha, answer] :
       {std::tuple{0, "1/7", "3"}, {1, "2", "1"}, {2, "1/7", "3"}, {1000000001, "2", "1"}}) {
    const learn::Exercise e = read_exercise(sound, "x.toml", static_cast<std::size_t>(number));
    CHECK(e.prompt == std::string("The mass ratio is ") + alpha + ".");
    CHECK(learn::judge(e, answer).mark == learn::Mark::right);
    const learn::Judgement said = learn::judge(e, alpha);
    CHECK(said.feedback == std::string("This is ") + alpha + ".");
    CHECK(said.misconception == "alpha");
    CHECK(e.hints == learn::Texts{"Not {beta}."});
  }
  CHECK(learn::judge(read_exercise(sound, "x.toml"), "5").misconception.empty());
}

TEST_CASE("Variants that do not fit are refused by line") {
  CHECK(refused("Not", "Not") == "not refused");
  CHECK_THAT(refused("[{ alpha = \"1/7\" }, { alpha = \"2\" }]", "[]"),
             ContainsSubstring("x.toml:9: variants: at least one"));
  CHECK_THAT(refused("[{ alpha = \"1/7\" }, { alpha = \"2\" }]", "{ alpha = \"2\" }"),
             ContainsSubstring("variants: at least one"));
  CHECK_THAT(refused("{ alpha = \"2\" }", "\"2\""), ContainsSubstring("names and texts"));
  CHECK_THAT(refused("{ alpha = \"2\" }", "{ alpha = 2 }"), ContainsSubstring("quotation marks"));
  CHECK_THAT(refused("{ alpha = \"2\" }", "{ beta = \"2\" }"),
             ContainsSubstring("{beta} is not in each variant and in a text"));
  CHECK_THAT(refused("{ alpha = \"1/7\" }", "{ alpha = \"1/7\", gamma = \"1\" }"),
             ContainsSubstring("{gamma} is not in each variant and in a text"));
  CHECK_THAT(refused("{ alpha = \"1/7\" }", "{ alpha = \"1/7\", beta = \"1\" }"),
             ContainsSubstring("a name is missing"));
  CHECK_THAT(refused("predict", "code"), ContainsSubstring("variants: not of code"));
  CHECK_THAT(refused("id = \"x\"", "id = \"../x\""), ContainsSubstring("id: allowed: letters"));
}
