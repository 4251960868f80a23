// SPDX-License-Identifier: GPL-2.0-or-later
#include "command/child.hpp"

#include <csignal>
#include <stdexcept>

#include <spawn.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

namespace command {
namespace {

/// A file without a name.
class Memory {
public:
  explicit Memory(const char* what) : descriptor(::memfd_create(what, MFD_CLOEXEC)) {
    if (descriptor < 0) throw std::runtime_error("no memory for another program");
  }
  ~Memory() { ::close(descriptor); }
  Memory(const Memory&) = delete;
  Memory& operator=(const Memory&) = delete;

  void write(const std::string& text) const {
    std::size_t done = 0;
    while (done < text.size()) {
      const auto count = ::write(descriptor, text.data() + done, text.size() - done);
      if (count <= 0) throw std::runtime_error("no memory for another program");
      done += static_cast<std::size_t>(count);
    }
    ::lseek(descriptor, 0, SEEK_SET);
  }
  std::string read() const {
    ::lseek(descriptor, 0, SEEK_SET);
    std::string text;
    char block[1 << 16];
    for (auto count = ::read(descriptor, block, sizeof block); count > 0;
         count = ::read(descriptor, block, sizeof block))
      text.append(block, static_cast<std::size_t>(count));
    return text;
  }
  int descriptor;
};

}  // namespace

std::optional<Said> said_by(std::vector<std::string> words, const std::string& input) {
  const Memory given("input");
  const Memory output("output");
  const Memory errors("errors");
  given.write(input);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, given.descriptor, STDIN_FILENO);
  posix_spawn_file_actions_adddup2(&actions, output.descriptor, STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&actions, errors.descriptor, STDERR_FILENO);
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  sigset_t ours;
  sigemptyset(&ours);
  sigaddset(&ours, SIGPIPE);
  sigaddset(&ours, SIGXFSZ);
  posix_spawnattr_setsigdefault(&attributes, &ours);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGDEF);
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  pid_t child = 0;
  const int failed =
      ::posix_spawnp(&child, arguments[0], &actions, &attributes, arguments.data(), environ);
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&actions);
  int status = 0;
  if (failed == 0) ::waitpid(child, &status, 0);
  if (failed != 0 || (WIFEXITED(status) && WEXITSTATUS(status) == 127)) return {};
  return Said{WIFEXITED(status) && WEXITSTATUS(status) == 0, output.read(), errors.read()};
}

}  // namespace command
