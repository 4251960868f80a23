// SPDX-License-Identifier: GPL-2.0-or-later
#include "command/gnuplot.hpp"

#include <csignal>
#include <stdexcept>

#include <spawn.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include "answers/errors.hpp"
#include "answers/shown_text.hpp"

namespace command {
namespace {

/// A file without a name.
class Memory {
public:
  explicit Memory(const char* what) : descriptor(::memfd_create(what, MFD_CLOEXEC)) {
    if (descriptor < 0) throw std::runtime_error("no memory for a drawing");
  }
  ~Memory() { ::close(descriptor); }
  Memory(const Memory&) = delete;
  Memory& operator=(const Memory&) = delete;

  void write(const std::string& text) const {
    std::size_t done = 0;
    while (done < text.size()) {
      const auto count = ::write(descriptor, text.data() + done, text.size() - done);
      if (count <= 0) throw std::runtime_error("no memory for a drawing");
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

std::string drawn(const std::string& script) {
  const Memory input("script");
  const Memory output("picture");
  const Memory errors("errors");
  input.write(script);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, input.descriptor, STDIN_FILENO);
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
  std::string program = "gnuplot";
  std::string without_own_settings = "-d";
  std::string standard_input = "-";
  char* const words[] = {program.data(), without_own_settings.data(), standard_input.data(),
                         nullptr};
  pid_t child = 0;
  const int failed = ::posix_spawnp(&child, "gnuplot", &actions, &attributes, words, environ);
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&actions);
  int status = 0;
  if (failed == 0) ::waitpid(child, &status, 0);
  if (failed != 0 || (WIFEXITED(status) && WEXITSTATUS(status) == 127)) {
    throw answers::InvalidInput(
        "figure: drawing needs gnuplot (Debian: gnuplot-nox); allowed without it: --format csv");
  }
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) {
    throw std::runtime_error("figure: gnuplot could not draw: " +
                             answers::shown_text(errors.read(), 200));
  }
  return output.read();
}

}  // namespace command
