// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

/// What the program did.
struct ProgramRun {
  int exit_code;
  std::string output;  // stdout
  std::string errors;  // stderr
};

/// Runs magicmass with these arguments; `before` goes in front ("setarch", "-R"), `input` to stdin.
ProgramRun run_program(const std::vector<std::string>& arguments, const std::string& input = "",
                       const std::vector<std::string>& before = {});

/// The same, requiring exit code 0, as JSON.
nlohmann::json json_of(std::vector<std::string> arguments);

/// A new empty folder, removed with all in it at the end.
class TemporaryFolder {
public:
  TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder(TemporaryFolder&&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(TemporaryFolder&&) = delete;
  ~TemporaryFolder();

  const std::filesystem::path& path() const { return path_; }
  std::string operator/(const std::string& name) const { return (path_ / name).string(); }
  /// Names of the files directly in it, sorted.
  std::vector<std::string> names() const;

private:
  std::filesystem::path path_;
};

std::string read_file(const std::filesystem::path& path);
void write_file(const std::filesystem::path& path, const std::string& content);
std::vector<std::string> lines_of(const std::string& text);
