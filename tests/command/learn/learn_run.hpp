// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <vector>

#include "../program_run.hpp"

/// Wrapped lines as one.
inline std::string unwrapped(const std::string& output) {
  std::string text;
  for (const std::string& line : lines_of(output)) {
    const std::size_t first = line.find_first_not_of(' ');
    if (first != std::string::npos) text += (text.empty() ? "" : " ") + line.substr(first);
  }
  return text;
}

/// A student with a folder of their own.
class Student {
public:
  ProgramRun learn(std::vector<std::string> arguments, const std::string& input = "") const {
    const std::vector<std::string> words{"learn", arguments.front()};
    arguments.erase(arguments.begin());
    std::vector<std::string> all = words;
    all.insert(all.end(), arguments.begin(), arguments.end());
    all.insert(all.end(), {"--folder", folder()});
    return run_program(all, input);
  }
  nlohmann::json check(const std::string& id, const std::string& answer) const {
    return nlohmann::json::parse(learn({"check", id, answer, "--format", "json"}).output);
  }
  std::string folder() const { return folder_ / "mine"; }
  std::string file(const std::string& name) const { return folder() + "/" + name; }

private:
  TemporaryFolder folder_;
};
