// SPDX-License-Identifier: GPL-2.0-or-later
#include <filesystem>
#include <map>
#include <string>

#include <catch2/catch.hpp>

#include "program_run.hpp"
#include "refusal.hpp"

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

TEST_CASE("one header with just what is asked for, the same bytes on every run", "[exam]") {
  const TemporaryFolder folder;
  const std::string file = folder / "header.hpp";
  const std::vector<std::string> command{"generate", "--quantity", "rho,a_t"};
  const ProgramRun to_stdout = run_program(command);
  CHECK(to_stdout.exit_code == 0);
  CHECK(to_stdout.errors.empty());
  CHECK(to_stdout.output.find("generate --quantity a_t,rho`") != std::string::npos);
  CHECK(run_program({"generate", "--quantity", "a_t,rho", "-o", file}).exit_code == 0);
  CHECK(read_file(file) == to_stdout.output);
  CHECK(run_program(command, "", {"setarch", "-R"}).output == to_stdout.output);
  CHECK(run_program({"generate", "--quantity", "a_t,rho", "--out", folder / "tree"}).exit_code ==
        0);
  CHECK(read_file(folder / "tree/magicmass/a_t_rho.hpp") == to_stdout.output);
}

TEST_CASE("a scene's header has what its outputs need", "[exam]") {
  const TemporaryFolder folder;
  const std::string scene = folder / "my scene.toml";
  write_file(scene, "alpha = \"magic:3\"\noutputs = [\"counts\"]\n");
  const ProgramRun run = run_program({"generate", "--scene", scene});
  CHECK(run.exit_code == 0);
  CHECK(run.output.find("namespace magicmass::generated::scene_my_scene {") != std::string::npos);
  CHECK(run.output.find("magic:3") != std::string::npos);
  CHECK(run.output.find("sine") == std::string::npos);
  CHECK(run.output.find(folder.path().string()) == std::string::npos);  // the same wherever it is
}

TEST_CASE("a header that cannot be is refused in one line, and nothing is written", "[exam]") {
  const TemporaryFolder folder;
  const std::string file = folder / "header.hpp";
  const std::pair<std::vector<std::string>, const char*> refused[] = {
      {{"--quantity", "rhoo"}, "no quantity is called \"rhoo\"; did you mean rho? allowed: a, b"},
      {{"--quantity", ""}, "no quantity is called \"(nothing)\"; did you mean"},
      {{"--quantity", "a,a_t"}, "a takes alpha and n and a_t takes alpha: one header"},
      {{"--quantity", "psi,alpha_k"}, "allowed together: a, b, c, c_prime, psi (of alpha and n);"},
      {{"--quantity", "a", "--check"}, "--check compares all of generated/"},
      {{"--quantity", "a", "--scene", "x.toml"}, "--quantity and --scene ask for two headers"},
      {{"--quantity", "a", "--format", "json"}, "a header has no --format"},
      {{"--quantity", "a", "--out", folder / "tree"}, "-o and --out are two places"},
      {{"--scene", folder / "none.toml"}, "none.toml: cannot be read"}};
  for (const auto& [options, message] : refused) {
    std::vector<std::string> command{"generate", "-o", file};
    command.insert(command.end(), options.begin(), options.end());
    const ProgramRun run = run_program(command);
    check_refused(run, message);
    CHECK(folder.names().empty());
  }
}
