// SPDX-License-Identifier: GPL-2.0-or-later
#include "command/report/progress.hpp"

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <ctime>
#include <iostream>

#include <fmt/format.h>
#include <unistd.h>

namespace magicmass::command {
namespace {

volatile std::sig_atomic_t interrupted = 0;

volatile std::sig_atomic_t interrupted_at = 0;  // seconds

struct sigaction action_before {};  // what SIGINT does otherwise

// The first asks for an end, another ends the program at once; but one keystroke may come twice, from the terminal and
// from a program that passes it on.
void on_interrupt(int) {
  timespec now{};
  ::clock_gettime(CLOCK_MONOTONIC, &now);
  const auto seconds = static_cast<std::sig_atomic_t>(now.tv_sec);
  if (interrupted != 0 && seconds - interrupted_at > 1) {
    ::sigaction(SIGINT, &action_before, nullptr);
    std::raise(SIGINT);
  }
  if (interrupted == 0) interrupted_at = seconds;
  interrupted = 1;
}

}  // namespace

Progress::Progress() : is_shown_(::isatty(STDERR_FILENO) != 0) {
  struct sigaction action {};
  action.sa_handler = on_interrupt;
  action.sa_flags = SA_RESTART;  // a pipe to a peer is read on
  ::sigaction(SIGINT, &action, &action_before);
}

Progress::~Progress() {
  clear();
  ::sigaction(SIGINT, &action_before, nullptr);
}

bool Progress::step(const std::string& words, double done) {
  const auto now = std::chrono::steady_clock::now();
  if (is_shown_ && (words != last_words_ || now - last_ > std::chrono::milliseconds(100))) {
    last_ = now;
    last_words_ = words;
    std::cerr << fmt::format("\r\x1b[K{:3.0f} %  {}", 100 * done, words.substr(0, 70))
              << std::flush;
  }
  return !was_interrupted();
}

void Progress::clear() {
  if (is_shown_ && !last_words_.empty()) std::cerr << "\r\x1b[K" << std::flush;
  last_words_.clear();
}

bool Progress::was_interrupted() { return interrupted != 0; }

void Progress::end_as_interrupted() {
  ::sigaction(SIGINT, &action_before, nullptr);
  std::raise(SIGINT);
  std::_Exit(130);
}

}  // namespace magicmass::command
