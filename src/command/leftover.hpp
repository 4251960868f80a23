// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <atomic>
#include <csignal>

#include <sys/types.h>

namespace magicmass::command {

/// While one lives, SIGINT, SIGTERM and SIGHUP wait: what has been made gets onto their list first.
class SignalsHeld {
public:
  SignalsHeld();
  SignalsHeld(const SignalsHeld&) = delete;
  SignalsHeld(SignalsHeld&&) = delete;
  SignalsHeld& operator=(const SignalsHeld&) = delete;
  SignalsHeld& operator=(SignalsHeld&&) = delete;
  ~SignalsHeld() { let_go(); }

  /// As before; also for the child of a fork, which has no destructors to come to.
  void let_go();

private:
  sigset_t before_{};
};

/// A file or a folder that SIGINT, SIGTERM and SIGHUP remove, or a process whose group they kill, while it is on
/// their list: what came last goes first.
class Leftover {
public:
  enum class Kind { file, folder, process };

  explicit Leftover(Kind kind) : kind_(kind) {}
  Leftover(const Leftover&) = delete;
  Leftover(Leftover&&) = delete;
  Leftover& operator=(const Leftover&) = delete;
  Leftover& operator=(Leftover&&) = delete;
  ~Leftover() { strike_off(); }

  /// `name` must last until it is struck off.
  void put_on_list(const char* name);
  void put_on_list(pid_t process);
  void strike_off();

private:
  void put_on_list();

  Kind kind_;
  const char* name_ = nullptr;
  pid_t process_ = 0;
  std::atomic<Leftover*> next_ = nullptr;

  static std::atomic<Leftover*> first_;
  friend void remove_leftovers(int signal);
};

/// From now on those signals remove what is on the list before they end the program, as they do by default.
void remove_leftovers_on_signals();

}  // namespace magicmass::command
