// A child holds one end of a pipe: a byte on it says that output begins, its end is the child's.
// How many rows are done stands in memory that both share.
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <cstring>

#include <cln/malloc.h>
#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include "command/command.hpp"
#include "host/child.hpp"

constexpr std::int64_t end_seconds = 5;

// There in a build with AddressSanitizer, whose shadow takes terabytes of addresses, and time.
extern "C" [[gnu::weak]] void __asan_init();

namespace command {
namespace {

using Clock = std::chrono::steady_clock;

void write_to_terminal(std::string_view text) {
  [[maybe_unused]] const ssize_t ignored = ::write(STDERR_FILENO, text.data(), text.size());
}

/// A line on the terminal that comes after a second and goes without a trace.
struct Progress {
  std::string name;
  std::string limit;
  bool may_show;
  std::int64_t shown = 0;  // seconds

  void show(Clock::duration so_far) {
    const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(so_far).count();
    if (!may_show || seconds <= shown) return;
    shown = seconds;
    write_to_terminal("\r" + name + ": " + std::to_string(seconds) + " s" + limit + "\033[K");
  }
  void hide() {
    if (shown > 0) write_to_terminal("\r\033[K");
    shown = 0;
    may_show = false;
  }
};

/// True where the child is at its end, false where its time is.
bool wait_for(int from_child, const Limits& limits, Progress& progress) {
  const auto start = Clock::now();
  const std::chrono::seconds limit(limits.seconds * (__asan_init == nullptr ? 1 : 4));
  while (Clock::now() - start < limit) {
    pollfd watched{from_child, POLLIN, 0};
    if (::poll(&watched, 1, 100) > 0) {
      char output_begins;
      const ssize_t bytes = ::read(from_child, &output_begins, 1);
      if (bytes == 0) return true;
      if (bytes == 1) progress.hide();
    }
    progress.show(Clock::now() - start);
  }
  return false;
}

}  // namespace

ExitCode run_bounded(const std::string& name, const Limits& limits,
                     const std::function<ExitCode(const Tell&)>& action) {
  std::array<int, 2> pipe{};
  if (::pipe2(pipe.data(), O_CLOEXEC) != 0)
    throw answers::Undecided(name + ": no pipe: " + std::strerror(errno));
  std::atomic<std::uint64_t>& rows = host::shared_number();
  const pid_t child = ::fork();
  if (child < 0) throw answers::Undecided(name + ": no process: " + std::strerror(errno));
  if (child == 0) {
    ::close(pipe[0]);
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    host::limit(RLIMIT_CORE, 0);
    host::limit(RLIMIT_STACK, rlim_t(128) << 20U);  // std::regex calls itself at each character
    if (__asan_init == nullptr) {
      host::limit(RLIMIT_AS, rlim_t(limits.mebibytes) << 20U);
      cln::malloc_hook = ::operator new;  // its own throws what an unproved step throws, too
      cln::free_hook = ::operator delete;
    }
    ::_exit(int(action([&](std::uint64_t done) {
      if (done > 0) return rows.store(done);
      [[maybe_unused]] const ssize_t ignored = ::write(pipe[1], "", 1);
    })));
  }
  ::close(pipe[1]);
  const std::string limit =
      limits.seconds == no_limit ? "" : " of at most " + std::to_string(limits.seconds) + " s";
  const std::string_view terminal = std::getenv("TERM") ? std::getenv("TERM") : "dumb";
  Progress progress{name, limit, ::isatty(STDERR_FILENO) != 0 && terminal != "dumb"};
  const bool is_done = wait_for(pipe[0], limits, progress);
  if (!is_done) {
    ::kill(child, SIGKILL);
    wait_for(pipe[0], {end_seconds, 0}, progress);  // what it started ends with it
  }
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) continue;
  ::close(pipe[0]);
  progress.hide();
  if (is_done && WIFEXITED(status)) return static_cast<ExitCode>(WEXITSTATUS(status));
  if (is_done) {
    const int signal = WTERMSIG(status);
    for (const int of_user : {SIGINT, SIGTERM, SIGHUP, SIGQUIT})
      if (signal == of_user) {
        std::signal(signal, SIG_DFL);
        std::raise(signal);
      }
    return say(name + ": ended by signal " + std::to_string(signal) + " (" + ::strsignal(signal) +
                   "); a smaller question may do, or more than --memory-limit " +
                   std::to_string(limits.mebibytes),
               ExitCode::undecided);
  }
  return say(name + ": not done after " + std::to_string(limits.seconds) + " s" +
                 (rows > 0 ? ", only " + std::to_string(rows) + " rows" : "") +
                 "; a smaller question may do, or a longer --time-limit",
             ExitCode::undecided);
}

ExitCode say(const std::string& message, ExitCode code) {
  write_to_terminal("magicmass: " + answers::shown_text(message, 4000) + "\n");
  return code;
}

}  // namespace command
