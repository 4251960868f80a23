// SPDX-License-Identifier: GPL-2.0-or-later
#include <filesystem>
#include <map>
#include <string>

#include <catch2/catch.hpp>

#include "program_run.hpp"

namespace {

namespace fs = std::filesystem;

/// Content of every file below a folder that `generate` may write.
std::map<std::string, std::string> tree(const fs::path& folder) {
  std::map<std::string, std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file() && entry.path().filename() != "CMakeLists.txt")
      files[entry.path().lexically_relative(folder).string()] = read_file(entry.path());
  return files;
}

const fs::path committed = fs::path(MAGICMASS_SOURCE_DIR) / "generated";

}  // namespace

TEST_CASE("generated/ is what the derivation generates", "[exam]") {
  const ProgramRun run = run_program({"generate", "--check"});
  INFO(run.output);
  CHECK(run.exit_code == 0);
  CHECK(json_of({"generate", "--check"}).at("status") == "up to date");
}

TEST_CASE("the same bytes with addresses at random and fixed", "[exam]") {
  const TemporaryFolder folder;
  const auto expected = tree(committed);
  REQUIRE(expected.contains("manifest.json"));
  for (const std::string name : {"first", "second", "third"}) {
    const ProgramRun run = run_program({"generate", "--out", folder / name});
    CHECK(run.exit_code == 0);
    CHECK(tree(folder / name) == expected);
  }
  if (run_program({"--version"}, "", {"setarch", "-R"}).exit_code != 0) {
    WARN("skipped: needs setarch -R");
    return;
  }
  CHECK(run_program({"generate", "--out", folder / "fixed"}, "", {"setarch", "-R"}).exit_code == 0);
  CHECK(tree(folder / "fixed") == expected);
}

TEST_CASE("generate --check names what is missing, different and extra", "[exam]") {
  const TemporaryFolder folder;
  REQUIRE(run_program({"generate", "--out", folder.path().string()}).exit_code == 0);
  fs::remove(folder / "magicmass/quantities.hpp");
  write_file(folder / "magicmass/evaluators.hpp", "// edited by hand\n");
  write_file(folder / "magicmass/by_hand.hpp", "\n");
  write_file(folder / "CMakeLists.txt", "# no generated file\n");
  const ProgramRun run =
      run_program({"generate", "--check", "--out", folder.path().string(), "--format", "json"});
  CHECK(run.exit_code == 1);
  CHECK(lines_of(run.errors).size() == 1);
  const nlohmann::json answer = nlohmann::json::parse(run.output);
  CHECK(answer.at("status") == "stale");
  CHECK(answer.at("missing") == nlohmann::json{"magicmass/quantities.hpp"});
  CHECK(answer.at("different") == nlohmann::json{"magicmass/evaluators.hpp"});
  CHECK(answer.at("extra") == nlohmann::json{"magicmass/by_hand.hpp"});
  CHECK(read_file(folder / "magicmass/evaluators.hpp") == "// edited by hand\n");
}

TEST_CASE("generate leaves alone what is up to date", "[exam]") {
  const TemporaryFolder folder;
  REQUIRE(run_program({"generate", "--out", folder.path().string()}).exit_code == 0);
  const fs::path file = folder / "manifest.json";
  const auto long_ago = fs::last_write_time(file) - std::chrono::hours(1);
  fs::last_write_time(file, long_ago);
  REQUIRE(run_program({"generate", "--out", folder.path().string()}).exit_code == 0);
  CHECK(fs::last_write_time(file) == long_ago);
}

TEST_CASE("generate changes nothing where it cannot write everything", "[exam]") {
  const TemporaryFolder folder;
  fs::create_directories(folder /
                         "magicmass/velocities_product.hpp");  // a folder where a file should go
  const ProgramRun run = run_program({"generate", "--out", folder.path().string()});
  CHECK(run.exit_code == 2);
  CHECK(run.output.empty());
  CHECK(lines_of(run.errors).size() == 1);
  CHECK(folder.names() == std::vector<std::string>{"magicmass"});
  for (const auto& entry : fs::directory_iterator(folder / "magicmass"))
    CHECK(entry.is_directory());
}
