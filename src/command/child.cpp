// SPDX-License-Identifier: GPL-2.0-or-later
#include "command/child.hpp"

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <stdexcept>

#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace command {
namespace {

constexpr int not_there = 127;  // as shells say it

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
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  const pid_t parent = ::getpid();
  const pid_t child = ::fork();
  if (child < 0) throw std::runtime_error("no process for " + words[0]);
  if (child == 0) {
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (::getppid() != parent) ::_exit(not_there);
    ::dup2(given.descriptor, STDIN_FILENO);
    ::dup2(output.descriptor, STDOUT_FILENO);
    ::dup2(errors.descriptor, STDERR_FILENO);
    for (const int ours : {SIGPIPE, SIGXFSZ}) std::signal(ours, SIG_DFL);
    ::execvp(arguments[0], arguments.data());
    ::_exit(not_there);
  }
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  if (WIFEXITED(status) && WEXITSTATUS(status) == not_there) return {};
  return Said{WIFEXITED(status) && WEXITSTATUS(status) == 0, output.read(), errors.read()};
}

TemporaryFolder::TemporaryFolder(const std::string& name) {
  std::error_code error;
  const std::filesystem::path place = std::filesystem::temp_directory_path(error);
  path = ((error ? "/tmp" : place) / "magicmass-XXXXXX").string();
  int pipe[2] = {-1, -1};
  if (::mkdtemp(path.data()) == nullptr || ::pipe(pipe) != 0)
    throw std::runtime_error(name + ": no folder can be made: " + path);
  alive_ = pipe[1];
  cleaner_ = ::fork();
  if (cleaner_ < 0) throw std::runtime_error(name + ": no process");
  if (cleaner_ > 0) {
    ::close(pipe[0]);
    return;
  }
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGQUIT}) std::signal(signal, SIG_IGN);
  ::prctl(PR_SET_PDEATHSIG, 0);
  ::close(alive_);
  char nothing = 0;
  while (::read(pipe[0], &nothing, 1) < 0 && errno == EINTR) {
  }
  std::filesystem::remove_all(path, error);
  ::_exit(0);
}

TemporaryFolder::~TemporaryFolder() {
  ::close(alive_);
  ::waitpid(cleaner_, nullptr, 0);
}

}  // namespace command
