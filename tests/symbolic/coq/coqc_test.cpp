// SPDX-License-Identifier: GPL-2.0-or-later
// coqc accepts what is emitted for each rule, and nothing that was spoiled.
#include <cstdlib>
#include <fstream>

#include "catch.hpp"
#include "examples.hpp"

namespace {
/// What coqc says, "" where it accepts; compiled files stay in the folder of this test.
std::string refusal(const std::string& file, const std::string& text) {
  std::ofstream(file + ".v") << text;
  const std::string command =
      MAGICMASS_COQC " -q -w none -R . Magicmass " + file + ".v >" + file + ".said 2>&1";
  const bool is_accepted = std::system(command.c_str()) == 0;
  std::ifstream said(file + ".said");
  const std::string words{std::istreambuf_iterator<char>(said), {}};
  return is_accepted ? "" : words.empty() ? "refused" : words;
}
std::string said_of(const std::string& file) {
  std::ifstream said(file + ".said");
  return {std::istreambuf_iterator<char>(said), {}};
}
std::string spoiled(std::string text, const std::string& from, const std::string& to) {
  const std::size_t where = text.find(from);
  INFO(from);
  REQUIRE(where != std::string::npos);
  return text.replace(where, from.size(), to);
}
}  // namespace

TEST_CASE("coqc proves every step of the examples, and refuses what was spoiled") {
  std::map<std::string, std::string> texts;
  for (const auto& [name, text] : coq::files(examples::book()).texts) {
    const std::string file = name.substr(0, name.size() - 2);
    INFO(name);
    CHECK(refusal(file, text) == "");
    texts[file] = text;
  }
  CHECK(coq::foreign_assumption(said_of("assumptions")) == "");

  const std::string certificates = texts["certificates"];
  struct Spoiled {
    std::string chapter;
    std::string from;
    std::string to;
    std::string says;
  };
  for (const Spoiled& s : std::vector<Spoiled>{
           // a cofactor, a coefficient, what is not 0, a hypothesis
           {"certificates", "((x'0 + (2 * x'1)) * (", "((x'0 + (3 * x'1)) * (", "No applicable"},
           {"certificates", "((1 / 3) * ((x'2 + x'1) - 0))", "((1 / 4) * ((x'2 + x'1) - 0))",
            "No applicable"},
           {"certificates", "(0 < (x + y)) -> ", "(0 < (x + x)) -> ", "has type"},
           {"logic", "(x < y) -> (x < y)", "(y < x) -> (x < y)", "has type"},
           {"definitions", "(double_of x) = (2 * x)", "(double_of x) = (3 * x)", "nable to unify"},
           // what is shown is not what was proved
           {"certificates", "(4 * y * y)).\nProof. exact s'", "(4 * y * x)).\nProof. exact s'",
            "has type"},
       }) {
    INFO(s.from);
    const std::string said = refusal("spoiled", spoiled(texts[s.chapter], s.from, s.to));
    CHECK_THAT(said, ContainsSubstring("Error"));
    CHECK_THAT(said, ContainsSubstring(s.says));
  }
}
TEST_CASE("an axiom that is not of Coq's library is seen") {
  REQUIRE(refusal("prelude", coq::files({}).texts[0].second) == "");
  REQUIRE(refusal("hidden",
                  "From Magicmass Require Import prelude.\nAxiom hidden : 0 = 1.\n"
                  "Lemma one : 0 = 1 /\\ PI = PI. Proof. split; [exact hidden|easy]. Qed.\n"
                  "Print Assumptions one.\n") == "");
  CHECK(coq::foreign_assumption(said_of("hidden")) == "hidden");
}
