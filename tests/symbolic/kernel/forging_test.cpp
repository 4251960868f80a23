// SPDX-License-Identifier: GPL-2.0-or-later
// Rooms that see the kernel hold no words by which C++ could make a theorem past its rules.
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>

#include "catch.hpp"

namespace {
namespace fs = std::filesystem;

std::string contents(const fs::path& file) {
  std::ifstream in(file);
  return {std::istreambuf_iterator<char>(in), {}};
}
// Without continued lines and needless blanks; comments are code, too, once without and once with
// their words, because "//" may stand in a string.
std::string bare(std::string code) {
  code = std::regex_replace(code, std::regex(R"(\\\r?\n)"), "");
  code += std::regex_replace(code, std::regex(R"(//[^\n]*|/\*[^*]*\*+([^/*][^*]*\*+)*/)"), " ");
  code = std::regex_replace(code, std::regex(R"(\s+)"), " ");
  code = std::regex_replace(code, std::regex(R"( ?:: ?)"), "::");
  code = std::regex_replace(code, std::regex(R"(# )"), "#");
  return std::regex_replace(code, std::regex("using namespace (::)?kernel"), "using kernel");
}
// "file: word" for each forging word in C++ below the folder, but not in the kernel itself.
std::vector<std::string> forged(const fs::path& folder) {
  std::vector<std::string> out;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    const std::string file = entry.path().generic_string();
    const bool is_code = file.ends_with(".cpp") || file.ends_with(".hpp");
    if (!is_code || file.find("symbolic/kernel/") != file.npos) continue;
    const std::string code = bare(contents(entry.path()));
    if (code.find("#include \"kernel/") == code.npos && file.find("symbolic/") == file.npos)
      continue;
    for (const char* word :
         {"namespace kernel", "const_cast", "reinterpret_cast", "bit_cast", "memcpy", "memmove",
          "Theorem::", "::content", "::Content", "::place",
          "Theorem kernel::", "Theorems kernel::", "#define", "%:", ".cpp\"", "asm(", "asm ("})
      if (code.find(word) != code.npos)
        out.push_back(entry.path().filename().string() + ": " + word);
  }
  return out;
}
}  // namespace

TEST_CASE("no room that sees the kernel holds a forging word") {
  for (const char* folder : {"symbolic", "src"})
    CHECK(forged(fs::path(MAGICMASS_SOURCE_DIR) / folder) == std::vector<std::string>{});
}

TEST_CASE("a planted forgery is found, and named") {
  const fs::path folder = fs::temp_directory_path() / "magicmass_forging_test" / "symbolic";
  fs::remove_all(folder);
  fs::create_directories(folder / "kernel");
  const auto plant = [&](const std::string& name, const std::string& code) {
    std::ofstream(folder / name) << code;
  };
  plant("kernel/rules.cpp", "namespace kernel { }");
  plant("honest.cpp", "using namespace kernel;\n// no cast here\nint x = kernel::f();\n");
  CHECK(forged(folder).empty());
  for (const auto& [code, word] : std::vector<std::pair<std::string, std::string>>{
           {"namespace kernel { struct Rules; }", "namespace kernel"},
           {"namespace\n kernel::inner {}", "namespace kernel"},
           {"namespace /* hidden */ kernel {}", "namespace kernel"},
           {"auto& e = const_cast<Exprs&>(t.hypotheses());", "const_cast"},
           {"auto& e = reinterpret_cast<Fake&>(t);", "reinterpret_cast"},
           {"auto t = std::bit_cast<Theorem>(fake);", "bit_cast"},
           {"std::memcpy(&t, &u, sizeof t);", "memcpy"},
           {"std::memmove(&t, &u, sizeof t);", "memmove"},
           {"using T = Theorem; template struct Thief<&T::content>;", "::content"},
           {"using T = Theorem; using C = T::Content;", "::Content"},
           {"template struct Thief<&Expr::place>;", "::place"},
           {"Theorem kernel::assume(Expr f) { return lie(f); }", "Theorem kernel::"},
           {"Theorems kernel::define_recursive() { return {}; }", "Theorems kernel::"},
           {"using S = kernel::Theorem :: Hidden;", "Theorem::"},
           {"auto s = \"//\"; auto& e = const_cast<Exprs&>(f);", "const_cast"},
           {"#define private public", "#define"},
           {"# def\\\nine private public", "#define"},
           {"#include \"kernel/logic.cpp\"", ".cpp\""}}) {
    INFO(code);
    plant("forged.cpp", code);
    CHECK(forged(folder) == std::vector<std::string>{"forged.cpp: " + word});
  }
  fs::remove_all(folder.parent_path());
}
