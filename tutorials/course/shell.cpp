// SPDX-License-Identifier: GPL-2.0-or-later
#include "course/shell.hpp"

#include <array>
#include <cstdio>
#include <fstream>
#include <iterator>

#include <sys/wait.h>

#include "course/refusal.hpp"

namespace magicmass::course {

Ran run(const std::string& line) {
  FILE* const pipe = popen(line.c_str(), "r");
  if (pipe == nullptr) throw Refusal("no process could be started for: " + line);
  Ran ran;
  std::array<char, 4096> part{};
  for (std::size_t got = 0; (got = fread(part.data(), 1, part.size(), pipe)) > 0;)
    ran.output.append(part.data(), got);
  const int status = pclose(pipe);
  ran.status = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  return ran;
}

std::string quoted(const std::string& word) {
  std::string result = "'";
  for (const char letter : word)
    result += letter == '\'' ? "'\\''" : std::string(1, letter);
  return result + "'";
}

bool is_installed(const std::string& program) {
  return run("command -v " + quoted(program) + " 2>/dev/null").status == 0;
}

std::string read(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw Refusal(file.string() + ": cannot be read");
  return {std::istreambuf_iterator<char>(stream), {}};
}

void write(const std::filesystem::path& file, const std::string& text) {
  std::filesystem::create_directories(file.parent_path());
  std::ofstream stream(file, std::ios::binary);
  stream << text;
  stream.close();
  if (!stream) throw Refusal(file.string() + ": cannot be written");
}

}  // namespace magicmass::course
