// SPDX-License-Identifier: GPL-2.0-or-later
#include "equality/bounded.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <new>
#include <system_error>

#include <poll.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "equality/message.hpp"

namespace magicmass::equality {
namespace {

using Clock = std::chrono::steady_clock;

#if defined(__SANITIZE_ADDRESS__)
constexpr bool shadow_memory = true;
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
constexpr bool shadow_memory = true;
#else
constexpr bool shadow_memory = false;
#endif
#else
constexpr bool shadow_memory = false;
#endif

void limit(int resource, rlim_t value) {
  rlimit limits{};
  if (getrlimit(static_cast<__rlimit_resource>(resource), &limits) != 0) return;
  limits.rlim_cur = std::min(value, limits.rlim_max);
  setrlimit(static_cast<__rlimit_resource>(resource), &limits);
}

void write_all(int descriptor, const std::string& bytes) {
  for (std::size_t done = 0; done < bytes.size();) {
    const ssize_t count = write(descriptor, bytes.data() + done, bytes.size() - done);
    if (count < 0 && errno != EINTR) return;
    if (count > 0) done += static_cast<std::size_t>(count);
  }
}

// In the child: answers, says so, and is gone without the parent's destructors.
[[noreturn]] void run_child(const Question& question, const Bounds& bounds, int descriptor) {
  limit(RLIMIT_CORE, 0);
  limit(RLIMIT_STACK, rlim_t{64} << 20U);
  limit(RLIMIT_CPU, static_cast<rlim_t>(bounds.time.count() / 1000 + 1));
  if (!shadow_memory) limit(RLIMIT_AS, bounds.memory);
  Message message;
  message.is_final = true;
  try {
    message.verdict = answer(question, [&](const Verdict& verdict) {
      write_all(descriptor, packed({.verdict = verdict}));
    });
  } catch (const Refused& error) {
    message.is_refusal = true;
    message.refusal = error.what();
  } catch (const std::bad_alloc&) {
    _exit(2);
  } catch (const std::exception& error) {  // GiNaC and CLN, of what they cannot do
    message.verdict.proof = std::string("the algebra gave up: ") + error.what();
  }
  write_all(descriptor, packed(message));
  _exit(0);
}

struct Process {
  pid_t id;
  int descriptor;

  ~Process() {
    kill(id, SIGKILL);
    while (waitpid(id, nullptr, 0) < 0 && errno == EINTR) {
    }
    close(descriptor);
  }
};

}  // namespace

Verdict answer_within(const Question& question, const Bounds& bounds) {
  const Clock::time_point deadline = Clock::now() + bounds.time;
  std::array<int, 2> ends{};
  if (pipe(ends.data()) != 0) throw std::system_error(errno, std::generic_category(), "pipe");
  const pid_t child = fork();
  if (child < 0) {
    close(ends[0]);
    close(ends[1]);
    throw std::system_error(errno, std::generic_category(), "fork");
  }
  if (child == 0) {
    close(ends[0]);
    run_child(question, bounds, ends[1]);
  }
  close(ends[1]);
  const Process process{child, ends[0]};

  Verdict last;
  last.proof = "neither a proof nor a counterexample was found";
  std::string stream;
  const auto gave_up = [&](const std::string& reason) {
    last.proof = reason;
    return last;
  };
  for (;;) {
    const auto left =
        std::chrono::duration_cast<std::chrono::milliseconds>(deadline - Clock::now());
    pollfd waiting{ends[0], POLLIN, 0};
    const int ready = left.count() > 0 ? poll(&waiting, 1, static_cast<int>(left.count())) : 0;
    if (ready < 0 && errno == EINTR) continue;
    if (ready <= 0)
      return gave_up("no proof and no counterexample within " +
                     std::to_string(bounds.time.count()) + " ms");
    std::array<char, 4096> buffer{};
    const ssize_t count = read(ends[0], buffer.data(), buffer.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0)
      return gave_up("the algebra broke off: it took more than " +
                     std::to_string(bounds.memory >> 20U) + " MiB, or too much stack");
    stream.append(buffer.data(), static_cast<std::size_t>(count));
    while (const auto message = take(stream)) {
      if (message->is_refusal) throw Refused(message->refusal);
      if (message->is_final) return message->verdict;
      last = message->verdict;
    }
  }
}

}  // namespace magicmass::equality
