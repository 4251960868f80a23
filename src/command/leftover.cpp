// SPDX-License-Identifier: GPL-2.0-or-later
#include "command/leftover.hpp"

#include <csignal>

#include <unistd.h>

namespace magicmass::command {
namespace {

// In a signal handler, which may not walk through a folder itself.
void remove_folder(const char* name) {
  if (::fork() != 0) return;
  ::execl("/bin/rm", "rm", "-rf", "--", name, static_cast<char*>(nullptr));
  ::_exit(127);
}

}  // namespace

std::atomic<Leftover*> Leftover::first_ = nullptr;
static_assert(std::atomic<Leftover*>::is_always_lock_free);  // a signal handler reads the list

void Leftover::put_on_list(const char* name) {
  name_ = name;
  next_ = first_.load();
  first_ = this;
}

void Leftover::strike_off() {
  std::atomic<Leftover*>* link = &first_;
  while (*link != nullptr && *link != this) link = &link->load()->next_;
  if (*link == this) *link = next_.load();
}

void remove_leftovers(int signal) {
  for (const Leftover* left = Leftover::first_; left != nullptr; left = left->next_) {
    if (left->kind_ == Leftover::Kind::folder) {
      remove_folder(left->name_);
    } else {
      ::unlink(left->name_);
    }
  }
  ::raise(signal);  // with the default action, once this has returned
}

void remove_leftovers_on_signals() {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    struct sigaction action {};
    if (::sigaction(signal, nullptr, &action) != 0 || action.sa_handler == SIG_IGN) continue;
    action.sa_handler = remove_leftovers;
    action.sa_flags = static_cast<int>(SA_RESETHAND);
    ::sigaction(signal, &action, nullptr);
  }
}

}  // namespace magicmass::command
