// SPDX-License-Identifier: GPL-2.0-or-later
#include "command/report/subprocess.hpp"

#include <array>
#include <cerrno>

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

namespace magicmass::command {

Subprocess::Subprocess(std::vector<std::string> words) {
  std::array<int, 2> in{};
  std::array<int, 2> out{};
  if (::pipe2(in.data(), O_CLOEXEC) != 0) return;
  if (::pipe2(out.data(), O_CLOEXEC) != 0) {
    ::close(in[0]);
    ::close(in[1]);
    return;
  }
  std::vector<char*> arguments;
  arguments.reserve(words.size() + 1);
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, in[0], STDIN_FILENO);
  posix_spawn_file_actions_adddup2(&actions, out[1], STDOUT_FILENO);
  posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
  if (::posix_spawnp(&child_, arguments[0], &actions, nullptr, arguments.data(), environ) != 0)
    child_ = -1;
  posix_spawn_file_actions_destroy(&actions);
  ::close(in[0]);
  ::close(out[1]);
  to_ = in[1];
  from_ = out[0];
}

Subprocess::~Subprocess() {
  if (to_ >= 0) ::close(to_);
  if (from_ >= 0) ::close(from_);
  while (child_ > 0 && ::waitpid(child_, nullptr, 0) < 0 && errno == EINTR) {
  }
}

std::string Subprocess::ask(const std::string& line) {
  if (child_ < 0) return "";
  if (!line.empty()) {
    const std::string whole = line + "\n";
    for (std::size_t sent = 0; sent < whole.size();) {
      const ssize_t now = ::write(to_, whole.data() + sent, whole.size() - sent);
      if (now < 0 && errno == EINTR) continue;
      if (now <= 0) return "";
      sent += static_cast<std::size_t>(now);
    }
  }
  std::size_t end = received_.find('\n');
  while (end == std::string::npos) {
    std::array<char, 4096> buffer{};
    const ssize_t now = ::read(from_, buffer.data(), buffer.size());
    if (now < 0 && errno == EINTR) continue;
    if (now <= 0) return "";
    received_.append(buffer.data(), static_cast<std::size_t>(now));
    end = received_.find('\n');
  }
  std::string answer = received_.substr(0, end);
  received_.erase(0, end + 1);
  return answer;
}

}  // namespace magicmass::command
