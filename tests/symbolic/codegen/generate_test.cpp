// SPDX-License-Identifier: GPL-2.0-or-later
#include "codegen/generate.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>

#include <catch2/catch.hpp>
#include <ginac/ginac.h>

#include "derivation/derivation.hpp"
#include "magicmass/errors.hpp"
#include "proof/kernel.hpp"
#include "proof/names.hpp"
#include "whole_derivation.hpp"

using namespace magicmass;

namespace {

std::string contents(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

}  // namespace

TEST_CASE("the committed files are what the theorems give, byte for byte", "[exam][shared]") {
  const std::filesystem::path committed = MAGICMASS_GENERATED;
  std::set<std::string> paths;
  for (const codegen::GeneratedFile& file : codegen::generate(whole_derivation().theorems)) {
    INFO(file.path);
    CHECK(contents(committed / file.path) == file.content);
    paths.insert(file.path);
  }
  for (const auto& entry : std::filesystem::recursive_directory_iterator(committed)) {
    if (!entry.is_regular_file() || entry.path().filename() == "CMakeLists.txt") continue;
    INFO("stale file " << entry.path());
    CHECK(paths.contains(std::filesystem::relative(entry.path(), committed).generic_string()));
  }
}

TEST_CASE("generating twice gives the same bytes", "[check][shared]") {
  const auto once = codegen::generate(whole_derivation().theorems),
             again = codegen::generate(derivation::derive().theorems);
  REQUIRE(once.size() == again.size());
  for (std::size_t i = 0; i < once.size(); ++i) CHECK(once[i].content == again[i].content);
}

TEST_CASE("a missing theorem is named", "[exam]") {
  CHECK_THROWS_WITH(codegen::generate({}), Catch::Contains("no theorem is called"));
}

TEST_CASE("an output that is a definition needs a theorem that ties it to the motion",
          "[exam][shared]") {
  const GiNaC::ex x = proof::symbol("x");
  const auto refusal = [](const std::vector<std::string>& ids, const auto& claimed) {
    proof::Kernel kernel{proof::Domain()};
    std::vector<proof::Theorem> theorems = whole_derivation().theorems;
    for (proof::Theorem& theorem : theorems)
      if (std::find(ids.begin(), ids.end(), theorem.id()) != ids.end())
        theorem = claimed(kernel, theorem.id());
    try {
      codegen::generate(theorems);
    } catch (const InvalidInput& error) {
      return std::string(error.what());
    }
    return std::string("none");
  };
  const auto identity = [&](proof::Kernel& kernel, const std::string& id) {
    return kernel.identity({.id = id, .statement = {x + x, 2 * x}});
  };
  const auto hypothesis = [&](proof::Kernel& kernel, const std::string& id) {
    return kernel.hypothesis({.id = id, .statement = {x, 1}});
  };
  CHECK(refusal({"times.t_of_P", "times.t_of_Q"}, identity) ==
        "times.t is a definition, and no theorem of Encounters ties it to the motion");
  CHECK(refusal({"times.t_of_P"}, hypothesis) ==
        "times.t_of_P is not proved, and Encounters cites it");
}
