// Rooms that see the kernel, and their tests, hold none of the words by which C++ is known to make
// theorems past its rules. A cast of C's is an error there: symbolic/kernel/CMakeLists.txt.
#include <algorithm>
#include <filesystem>
#include <map>
#include <regex>
#include <set>

#include "rows.hpp"

namespace {
namespace fs = std::filesystem;

// Without continued lines and needless blanks; comments are code, too, once without and once with
// their words, because "//" may stand in a string.
std::string bare(std::string code) {
  code = std::regex_replace(code, std::regex(R"(\\\r?\n)"), "");
  code += std::regex_replace(code, std::regex(R"(//[^\n]*|/\*[^*]*\*+([^/*][^*]*\*+)*/)"), " ");
  code = std::regex_replace(code, std::regex(R"(\[\[[^\]]*\]\])"), " ");  // attributes
  code = std::regex_replace(code, std::regex(R"(\s+)"), " ");
  code = std::regex_replace(code, std::regex(R"( ?(::|\*|&) ?)"), "$1");
  code = std::regex_replace(code, std::regex(R"(\bnew\()"), "new (");
  code = std::regex_replace(code, std::regex(R"(# )"), "#");
  return std::regex_replace(code, std::regex("using namespace (::)?kernel"), "using kernel");
}
/// C++ in the folders that sees the kernel, not in it: it includes a file of it, or one that does.
std::map<std::string, std::string> seeing(const std::vector<fs::path>& folders) {
  std::map<std::string, std::string> all, found;
  for (const fs::path& folder : folders)
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
      const std::string file = entry.path().generic_string();
      if (file.ends_with(".cpp") || file.ends_with(".hpp"))
        all.emplace(file, bare(contents_of(file)));
    }
  std::vector<std::string> open{"kernel/"};  // ends of names as others write them
  const auto take = [&](const std::string& file) {
    const auto code = all.find(file);
    if (file.find("symbolic/kernel/") != file.npos || !found.insert(*code).second) return;
    for (auto slash = file.rfind('/'); slash != file.npos && slash > 0;
         slash = file.rfind('/', slash - 1))
      open.push_back(file.substr(slash + 1) + '"');
  };
  while (!open.empty()) {
    const std::string included = "#include \"" + open.back();
    open.pop_back();
    for (const auto& [file, code] : all)
      if (code.find(included) != code.npos) take(file);
  }
  for (const auto& [file, code] : all)
    if (file.find("symbolic/") != file.npos) take(file);
  return found;
}
const std::string no_header = "code that is no header", of_kernel = "a function of the kernel";
/// kernel::f(...) and a brace: its own function, made anew.
bool defines_function_of_kernel(const std::string& code) {
  static const std::regex head(R"(\w+\()"), tail(R"( ?(noexcept ?|try ?|-> ?[\w:<>]+ ?)*\{)");
  constexpr auto here = std::regex_constants::match_continuous;
  for (std::size_t at = code.find("kernel::"); at != code.npos; at = code.find("kernel::", at)) {
    at += 8;
    const auto start = code.begin() + std::ptrdiff_t(at);
    std::smatch name;
    if (!std::regex_search(start, code.end(), name, head, here)) continue;
    auto end = start + name.length();
    for (int open = 1; open > 0 && end != code.end(); ++end)
      open += *end == '(' ? 1 : *end == ')' ? -1 : 0;
    if (std::regex_search(end, code.end(), tail, here)) return true;
  }
  return false;
}
/// Those by which the rows of the table are found.
std::set<std::string> forging_words() {
  std::set<std::string> words;
  for (const auto& row : rows_of("symbolic/kernel/forged.tsv", 2)) words.insert(row[1]);
  words.erase(no_header);
  words.erase(of_kernel);
  return words;
}
/// "file: word" for each forging word in it.
std::vector<std::string> forged(const std::vector<fs::path>& folders) {
  const std::set<std::string> words = forging_words();
  std::vector<std::string> out;
  for (const auto& [file, code] : seeing(folders)) {
    for (const std::string& word : words)
      if (code.find(word) != code.npos)
        out.push_back(fs::path(file).filename().string() + ": " + word);
    if (std::regex_search(code, std::regex(R"(#include "[^"]*\.cpp")")))
      out.push_back(fs::path(file).filename().string() + ": " + no_header);
    if (defines_function_of_kernel(code))
      out.push_back(fs::path(file).filename().string() + ": " + of_kernel);
  }
  return out;
}
}  // namespace

TEST_CASE("no room that sees the kernel holds a forging word", "[source]") {
  std::vector<fs::path> folders;
  for (const char* folder : {"symbolic", "src", "tutorials", "examples", "tests"})
    folders.push_back(fs::path(MAGICMASS_SOURCE) / folder);
  CHECK(forged(folders) == std::vector<std::string>{});
  const auto all = seeing(folders);
  CHECK(all.size() > 100);
  const auto sees = [&](const std::string& end) {
    return std::ranges::any_of(all, [&](const auto& file) { return file.first.ends_with(end); });
  };
  CHECK(sees("src/command/coq.cpp"));  // through other rooms
  CHECK_FALSE(sees("numbers/ziv.cpp"));
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
  CHECK(forged({folder}).empty());
  CHECK(forging_words().size() == 26);
  for (const auto& row : rows_of("symbolic/kernel/forged.tsv", 2, 38)) {
    const std::string code = std::regex_replace(row[0], std::regex(R"(\\n)"), "\n");
    INFO(code);
    plant("forged.cpp", code);
    CHECK(forged({folder}) == std::vector<std::string>{"forged.cpp: " + row[1]});
  }
  fs::remove(folder / "forged.cpp");
  const fs::path room = folder.parent_path() / "src";
  fs::create_directories(room);
  std::ofstream(room / "far.cpp") << "#include \"src/near.hpp\"\n#define private public";
  std::ofstream(room / "blind.cpp") << "#define harmless";
  std::ofstream(room / "near.hpp") << "int x;";
  CHECK(forged({folder, room}).empty());
  std::ofstream(room / "near.hpp") << "#include \"kernel/theorem.hpp\"";
  CHECK(forged({folder, room}) == std::vector<std::string>{"far.cpp: #define"});
  fs::remove_all(folder.parent_path());
}
