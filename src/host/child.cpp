#include "host/child.hpp"

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <stdexcept>

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace host {
namespace {

/// A file without a name.
class Memory {
public:
  explicit Memory(const char* what) {
    const int low = ::memfd_create(what, MFD_CLOEXEC);
    descriptor = ::fcntl(low, F_DUPFD_CLOEXEC, 10);  // above those that the other program gets
    ::close(low);
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
    ssize_t count = 0;
    while ((count = ::read(descriptor, block, sizeof block)) > 0)
      text.append(block, static_cast<std::size_t>(count));
    return text;
  }
  int descriptor = -1;
};

struct Streams {
  Memory given{"input"}, output{"output"}, errors{"errors"}, results{"results"}, refused{"refused"};
};

[[noreturn]] void become(const std::vector<char*>& words, const Bounds& bounds,
                         const Streams& streams) {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  ::dup2(streams.given.descriptor, STDIN_FILENO);
  ::dup2(streams.output.descriptor, STDOUT_FILENO);
  ::dup2(streams.errors.descriptor, STDERR_FILENO);
  ::dup2(streams.results.descriptor, results_descriptor);
  ::close_range(results_descriptor + 1, ~0U, CLOSE_RANGE_CLOEXEC);
  for (const int ours : {SIGPIPE, SIGXFSZ, SIGALRM, SIGTERM}) std::signal(ours, SIG_DFL);
  rlimit memory{};
  ::getrlimit(RLIMIT_AS, &memory);
  if (bounds.seconds > 0) {
    limit(RLIMIT_CORE, 0);
    limit(RLIMIT_CPU, bounds.seconds + 1);  // should the watcher be gone
    limit(RLIMIT_STACK, rlim_t{8} << 20U);
    limit(RLIMIT_FSIZE, bounds.file_bytes);
    memory.rlim_cur = memory.rlim_max = std::min(bounds.bytes, memory.rlim_max);
  }
  if (bounds.instead) {
    streams.output.write(bounds.instead());
    ::_exit(0);
  }
  const bool is_there = bounds.folder.empty() || ::chdir(bounds.folder.c_str()) == 0;
  if (!is_there || (bounds.confine && !bounds.confine(words[0], &memory))) {
    [[maybe_unused]] const ssize_t ignored = ::write(streams.refused.descriptor, "x", 1);
    ::_exit(not_there);
  }
  // From here on nothing asks for memory: AddressSanitizer has none within such a limit.
  if (::setrlimit(RLIMIT_AS, &memory) == 0) ::execvp(words[0], words.data());
  ::_exit(not_there);
}

/// Between this program and the other: ends with all when time is up, or when this one is gone.
[[noreturn]] void watch(const std::vector<char*>& words, const Bounds& bounds,
                        const Streams& streams, pid_t parent) {
  ::setsid();  // a group of its own, and no terminal
  for (const int signal : {SIGALRM, SIGTERM}) std::signal(signal, [](int) { ::kill(0, SIGKILL); });
  ::prctl(PR_SET_PDEATHSIG, SIGTERM);
  if (::getppid() != parent) ::_exit(not_there);
  ::alarm(bounds.seconds);
  const pid_t child = ::fork();
  if (child == 0) become(words, bounds, streams);
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) continue;
  ::_exit(WIFEXITED(status) ? WEXITSTATUS(status) : of_signal + WTERMSIG(status));
}

}  // namespace

std::atomic<std::uint64_t>& shared_number() {
  using Number = std::atomic<std::uint64_t>;
  void* const place =
      ::mmap(nullptr, sizeof(Number), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  if (place == MAP_FAILED) throw std::runtime_error("no memory to share");
  return *new (place) Number(0);
}

void limit(__rlimit_resource resource, rlim_t value) {
  const rlimit limits{value, value};
  ::setrlimit(resource, &limits);
}

End end_of(std::vector<std::string> words, const std::string& input, const Bounds& bounds) {
  const Streams streams;
  streams.given.write(input);
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  const pid_t parent = ::getpid();
  const pid_t watcher = ::fork();
  if (watcher < 0) throw std::runtime_error("no process for " + words[0]);
  if (watcher == 0) watch(arguments, bounds, streams, parent);
  siginfo_t ignored{};
  while (::waitid(P_PID, static_cast<id_t>(watcher), &ignored, WEXITED | WNOWAIT) < 0 &&
         errno == EINTR) {
  }
  ::kill(-watcher, SIGKILL);  // whom it left behind
  int status = 0;
  ::waitpid(watcher, &status, 0);
  const bool is_late = !WIFEXITED(status);
  return {streams.refused.read().empty(),
          is_late,
          is_late ? -1 : WEXITSTATUS(status),
          streams.output.read(),
          streams.errors.read(),
          streams.results.read()};
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
  ::setsid();  // what ends a group of processes does not end this one
  ::close(alive_);
  char nothing = 0;
  while (::read(pipe[0], &nothing, 1) < 0 && errno == EINTR) continue;
  std::filesystem::remove_all(path, error);
  ::_exit(0);
}

TemporaryFolder::~TemporaryFolder() {
  ::close(alive_);
  ::waitpid(cleaner_, nullptr, 0);
}

}  // namespace host
