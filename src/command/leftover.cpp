// SPDX-License-Identifier: GPL-2.0-or-later
#include "command/leftover.hpp"

#include <array>

#include <unistd.h>

namespace magicmass::command {
namespace {

constexpr std::array ending_signals{SIGINT, SIGTERM, SIGHUP};

// In a signal handler, which may not walk through a folder itself. More than once: somebody who was killed with it may
// have been putting a file there.
void remove_folder(const char* name) {
  if (::_Fork() != 0) return;  // without the locks that fork takes
  ::execl("/bin/sh", "sh", "-c",
          "for more in 1 2 3 4; do /bin/rm -rf -- \"$1\" 2>/dev/null && exit; /bin/sleep 1; done",
          "sh", name, static_cast<char*>(nullptr));
  ::_exit(127);
}

void kill_with_its_group(pid_t process) {
  ::kill(-process, SIGKILL);
  ::kill(process, SIGKILL);  // which may not have a group of its own yet
}

}  // namespace

std::atomic<Leftover*> Leftover::first_ = nullptr;
static_assert(std::atomic<Leftover*>::is_always_lock_free);  // a signal handler reads the list

SignalsHeld::SignalsHeld() {
  sigset_t held;
  ::sigemptyset(&held);
  for (const int signal : ending_signals) ::sigaddset(&held, signal);
  ::pthread_sigmask(SIG_BLOCK, &held, &before_);
}

void SignalsHeld::let_go() { ::pthread_sigmask(SIG_SETMASK, &before_, nullptr); }

void Leftover::put_on_list(const char* name) {
  name_ = name;
  put_on_list();
}

void Leftover::put_on_list(pid_t process) {
  process_ = process;
  put_on_list();
}

void Leftover::put_on_list() {
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
    switch (left->kind_) {
      case Leftover::Kind::file:
        ::unlink(left->name_);
        break;
      case Leftover::Kind::folder:
        remove_folder(left->name_);
        break;
      case Leftover::Kind::process:
        kill_with_its_group(left->process_);
        break;
    }
  }
  ::raise(signal);  // with the default action, once this has returned
}

void remove_leftovers_on_signals() {
  for (const int signal : ending_signals) {
    struct sigaction action {};
    if (::sigaction(signal, nullptr, &action) != 0 || action.sa_handler == SIG_IGN) continue;
    action.sa_handler = remove_leftovers;
    action.sa_flags = static_cast<int>(SA_RESETHAND);
    ::sigaction(signal, &action, nullptr);
  }
}

}  // namespace magicmass::command
