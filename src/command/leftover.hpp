// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <atomic>

namespace magicmass::command {

/// A file or a folder that SIGINT, SIGTERM and SIGHUP remove while it is on their list.
class Leftover {
public:
  enum class Kind { file, folder };

  explicit Leftover(Kind kind) : kind_(kind) {}
  Leftover(const Leftover&) = delete;
  Leftover(Leftover&&) = delete;
  Leftover& operator=(const Leftover&) = delete;
  Leftover& operator=(Leftover&&) = delete;
  ~Leftover() { strike_off(); }

  /// `name` must last until it is struck off.
  void put_on_list(const char* name);
  void strike_off();

private:
  Kind kind_;
  const char* name_ = nullptr;
  std::atomic<Leftover*> next_ = nullptr;

  static std::atomic<Leftover*> first_;
  friend void remove_leftovers(int signal);
};

/// From now on those signals remove what is on the list before they end the program, as they do by default.
void remove_leftovers_on_signals();

}  // namespace magicmass::command
