// generated/ is what the theorems give; the manifest tells of every header, each as that says.
#include <filesystem>
#include <regex>

#include <nlohmann/json.hpp>

#include "generate/quantities.hpp"
#include "rows.hpp"

namespace fs = std::filesystem;
using nlohmann::json;

namespace {
/// Comments are broken into lines.
std::string unbroken(const std::string& text) {
  const std::string bare = std::regex_replace(text, std::regex("[/\"]"), "");
  return std::regex_replace(bare, std::regex("[ \n]+"), " ");
}
void check_says(const std::string& header, const std::string& what) {
  CHECK_THAT(header, ContainsSubstring(unbroken(what)));
}
}  // namespace

TEST_CASE("the committed files are what the theorems give, and a second time the same") {
  const generate::Texts texts = generate::generated();
  CHECK(generate::differences(GENERATED, texts).empty());
  CHECK(generate::generated() == texts);
}
TEST_CASE("each entry's header is there and makes the claims of the entry") {
  const std::set<std::string> forms{"evaluator", "closed",   "product",    "tangent",
                                    "exact",     "matrices", "restitution"};
  const std::string errors = unbroken(contents_of(GENERATED "/magicmass/evaluators/errors.txt"));
  std::set<std::string> headers, seen;
  for (const json& entry : json::parse(contents_of(GENERATED "/manifest.json"))) {
    const std::string path = entry.at("header"), form = entry.at("form");
    INFO(path << ", " << std::string(entry.at("name")));
    seen.insert(form);
    headers.insert(path);
    const std::string code = contents_of(GENERATED "/" + path), header = unbroken(code);
    for (const std::string name : entry.at("outputs")) {
      check_says(header, name);
      const std::regex ceilings("Ceilings of rounded numbers, maybe off[^.]* " + name + "[,.]");
      const bool is_count = form != "evaluator" && name.starts_with("N_");
      CHECK(std::regex_search(header, ceilings) == is_count);
    }
    for (const std::string name : entry.at("inputs")) check_says(header, name);
    check_says(header, std::string(entry.at("labels")));
    check_says(header, "Operations: ");
    if (form != "evaluator" && form != "exact") check_says(header, "No bound is derived");
    // Behind each line or above it its formula, or whose part it is; but for a matrix's entries.
    const std::regex unsaid(
        "\n(?! *//)[^\n]*\n *const (T|N|Number) (?!of_|[A-Za-z_0-9]+_[1-3][1-3] )[^;]*;\n");
    CHECK_FALSE(std::regex_search(code, unsaid));
    CHECK_FALSE(entry.at("cases").empty());
    for (const json& c : entry.at("cases")) {
      check_says(header, std::string(c.at("domain")));
      CHECK_FALSE(c.at("theorems").empty());
      CHECK(c.at("bounds").empty() == (form != "evaluator"));
      for (const std::string bound : c.at("bounds")) check_says(errors, bound);
      if (form == "evaluator") continue;
      for (const std::string id : c.at("theorems")) check_says(header, id.substr(id.find('.') + 1));
    }
  }
  CHECK(seen == forms);
  for (const auto& file : fs::recursive_directory_iterator(fs::path(GENERATED) / "magicmass")) {
    const std::string path = fs::relative(file.path(), GENERATED).generic_string();
    if (file.path().extension() != ".hpp" || path.ends_with("polynomials.hpp")) continue;
    INFO(path);
    CHECK(headers.count(path) == 1);
  }
}
TEST_CASE("a form that there is none of is refused, as is one that there are two of") {
  CHECK_THROWS_WITH(generate::selected("open", {"a"}), ContainsSubstring("allowed: closed"));
  CHECK_THROWS_WITH(generate::selected("matrices", {"R"}), ContainsSubstring("no form matrices"));
  const codegen::PlainForm& one = generate::inventory().all.at(1);
  CHECK_THROWS_WITH(generate::texts({one, one}), ContainsSubstring("two files are called"));
}
TEST_CASE("each output has a header, beside any other of its quantity, too") {
  for (const auto& [quantity, form, of_float] : generate::inventory().all) {
    if (form == "evaluator" || form == "matrices" || form == "exact") continue;
    const auto outputs = codegen::outputs_of(quantity.cases[0]);
    for (const codegen::Output& one : outputs)
      for (const codegen::Output& other : outputs) {
        INFO(form << ": " << one.name << ", " << other.name);
        const std::string header = generate::selected(form, {one.name, other.name});
        CHECK(std::regex_search(header, std::regex(" \\{ Number [^;=]*\\b" + one.name + "[,;]")));
      }
  }
}
TEST_CASE("an entry, a range or a list of theorems of another shape is refused") {
  const auto refuses = [](const std::string& entries, const std::string& why) {
    CHECK_THROWS_WITH(generate::read("form: closed\nquantity: test\n" + entries),
                      ContainsSubstring(why));
  };
  refuses("output: a", "no entry is called output:");
  refuses("inputs: alpha 1", "inputs: alpha has 1 ends; allowed: 2");
  refuses("theorems: terminal.a", "no -> before outputs");
}
