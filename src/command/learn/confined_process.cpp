// SPDX-License-Identifier: GPL-2.0-or-later
#include "command/learn/confined_process.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <system_error>

#include <fcntl.h>
#include <poll.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "command/descriptor.hpp"
#include "command/leftover.hpp"

namespace magicmass::command {
namespace {

using Clock = std::chrono::steady_clock;
constexpr int not_started = 127;
constexpr int results_descriptor = 3;

[[noreturn]] void no_process(const char* what) {
  throw std::system_error(errno, std::generic_category(), what);
}

void limit(int resource, rlim_t value) {
  rlimit limits{};
  if (::getrlimit(static_cast<__rlimit_resource>(resource), &limits) != 0) return;
  limits.rlim_max = limits.rlim_cur = std::min(value, limits.rlim_max);
  ::setrlimit(static_cast<__rlimit_resource>(resource), &limits);
}

/// False where the system cannot.
bool apply(const ProcessLimits& limits) {
  limit(RLIMIT_CORE, 0);
  limit(RLIMIT_CPU, static_cast<rlim_t>(limits.time.count() / 1000 + 1));
  if (limits.memory > 0) limit(RLIMIT_AS, limits.memory);
  limit(RLIMIT_NOFILE, 64);
  if (!limits.is_computing_only) {
    limit(RLIMIT_FSIZE, rlim_t{64} << 20U);
    return true;
  }
  limit(RLIMIT_FSIZE, 0);
  limit(RLIMIT_NPROC, 0);
  limit(RLIMIT_MSGQUEUE, 0);
  return allow_computing_only();
}

/// What the child needs, made before fork: between fork and exec there is nothing but system calls.
struct Start {
  std::vector<char*> arguments;
  const char* folder;
  int input, output, results;
  const ProcessLimits& limits;
};

[[noreturn]] void become(const Start& start) {
  ::setsid();  // a process group of its own, and no terminal to type into
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  std::signal(SIGPIPE, SIG_DFL);
  const int results = ::fcntl(start.results, F_DUPFD, 10);  // out of the way of 0 to 3
  if (::chdir(start.folder) != 0 || ::dup2(start.input, STDIN_FILENO) < 0 ||
      ::dup2(start.output, STDOUT_FILENO) < 0 || ::dup2(start.output, STDERR_FILENO) < 0 ||
      ::dup2(results, results_descriptor) < 0)
    ::_exit(not_started);
  ::close(results);
  if (apply(start.limits)) ::execvp(start.arguments.front(), start.arguments.data());
  ::_exit(not_started);
}

/// Reads what is there; false at the end.
bool read_some(int descriptor, std::string& text) {
  std::array<char, 65536> buffer{};
  const ssize_t count = ::read(descriptor, buffer.data(), buffer.size());
  if (count < 0) return errno == EINTR || errno == EAGAIN;
  text.append(buffer.data(), static_cast<std::size_t>(count));
  return count > 0;
}

void listen(ProcessEnd& end, int output, int results, const ProcessLimits& limits,
            Clock::time_point deadline) {
  std::array<pollfd, 2> waiting{{{output, POLLIN, 0}, {results, POLLIN, 0}}};
  while (waiting[0].fd >= 0 || waiting[1].fd >= 0) {
    const auto left =
        std::chrono::duration_cast<std::chrono::milliseconds>(deadline - Clock::now()).count();
    if (left <= 0) {
      end.is_late = true;
      return;
    }
    if (::poll(waiting.data(), waiting.size(), static_cast<int>(left)) <= 0) continue;
    if (waiting[0].revents != 0 && !read_some(output, end.output)) waiting[0].fd = -1;
    if (waiting[1].revents != 0 && !read_some(results, end.results)) waiting[1].fd = -1;
    if (end.output.size() + end.results.size() > limits.output) {
      end.is_verbose = true;
      return;
    }
  }
}

/// waitpid; a process that has ended is nobody's to kill any more.
bool has_ended(pid_t child, int& status, int options, Leftover& running) {
  const SignalsHeld held;
  if (::waitpid(child, &status, options) != child) return false;
  running.strike_off();
  ::kill(-child, SIGKILL);  // whom it left behind
  return true;
}

/// The status of a child that is given until the deadline to end by itself.
int status_of(pid_t child, ProcessEnd& end, Clock::time_point deadline, Leftover& running) {
  int status = 0;
  while (!end.is_late && !end.is_verbose) {
    if (has_ended(child, status, WNOHANG, running)) return status;
    end.is_late = Clock::now() > deadline;
    ::usleep(1000);
  }
  ::kill(-child, SIGKILL);
  ::kill(child, SIGKILL);
  while (!has_ended(child, status, 0, running) && errno == EINTR) {
  }
  return status;
}

int memory_file(const std::string& content) {
  const int descriptor = ::memfd_create("input", MFD_CLOEXEC);
  if (descriptor < 0) no_process("memfd_create");
  for (std::size_t done = 0; done < content.size();) {
    const ssize_t count = ::write(descriptor, content.data() + done, content.size() - done);
    if (count <= 0) no_process("write");
    done += static_cast<std::size_t>(count);
  }
  ::lseek(descriptor, 0, SEEK_SET);
  return descriptor;
}

}  // namespace

ProcessEnd run_confined(const std::vector<std::string>& words, const std::string& input,
                        const std::filesystem::path& folder, const ProcessLimits& limits) {
  if (limits.is_computing_only && !can_allow_computing_only())
    throw std::system_error(
        ENOSYS, std::generic_category(),
        "others' code is run with a filter of system calls, which this kernel does not have");
  std::vector<std::string> kept = words;
  const Descriptor in(memory_file(input));
  std::array<int, 2> ends{};
  if (::pipe2(ends.data(), O_CLOEXEC) != 0) no_process("pipe");
  const Descriptor output(ends[0]);
  Descriptor output_end(ends[1]);
  if (::pipe2(ends.data(), O_CLOEXEC) != 0) no_process("pipe");
  const Descriptor results(ends[0]);
  Descriptor results_end(ends[1]);
  Start start{{}, folder.c_str(), in.number(), output_end.number(), results_end.number(), limits};
  for (std::string& word : kept) start.arguments.push_back(word.data());
  start.arguments.push_back(nullptr);
  SignalsHeld held;
  const pid_t child = ::fork();
  if (child < 0) no_process("fork");
  if (child == 0) {
    held.let_go();
    become(start);
  }
  Leftover running(Leftover::Kind::process);
  running.put_on_list(child);
  held.let_go();
  output_end.close();
  results_end.close();
  ProcessEnd end;
  const Clock::time_point deadline = Clock::now() + limits.time;
  listen(end, output.number(), results.number(), limits, deadline);
  const int status = status_of(child, end, deadline, running);
  if (WIFEXITED(status)) end.exit_code = WEXITSTATUS(status);
  if (WIFSIGNALED(status)) end.signal = WTERMSIG(status);
  return end;
}

}  // namespace magicmass::command
