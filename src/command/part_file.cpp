// SPDX-License-Identifier: GPL-2.0-or-later
#include "command/part_file.hpp"

#include <cerrno>
#include <system_error>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

namespace magicmass::command {
namespace {

[[noreturn]] void fail(int error) { throw std::system_error(error, std::generic_category()); }

}  // namespace

PartFile::PartFile(const std::string& target) : target_(target) {
  constexpr int most_writers = 1000;
  const SignalsHeld held;
  for (int number = 1; !take(number); ++number)
    if (number == most_writers) fail(EBUSY);
  leftover_.put_on_list(name_.c_str());
}

// False where somebody else is writing it.
bool PartFile::take(int number) {
  name_ = target_ + ".part-" + std::to_string(number);
  descriptor_ =
      ::open(name_.c_str(), O_WRONLY | O_CREAT | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC, 0666);
  if (descriptor_ < 0) fail(errno);
  struct stat held {};
  struct stat named {};
  // Its writer may have renamed it, and be gone, since it was opened: then it is the target.
  const bool is_locked = ::flock(descriptor_, LOCK_EX | LOCK_NB) == 0;
  if (is_locked && ::fstat(descriptor_, &held) == 0 && ::lstat(name_.c_str(), &named) == 0 &&
      held.st_ino == named.st_ino && held.st_dev == named.st_dev && S_ISREG(held.st_mode) &&
      ::ftruncate(descriptor_, 0) == 0)
    return true;
  const int error = errno;
  const bool cannot_be_locked = !is_locked && error != EWOULDBLOCK;
  if (cannot_be_locked) ::unlink(name_.c_str());
  ::close(descriptor_);
  descriptor_ = -1;
  if (cannot_be_locked) fail(error);
  return false;
}

PartFile::~PartFile() {
  const SignalsHeld held;
  leftover_.strike_off();
  if (!name_.empty()) ::unlink(name_.c_str());
  ::close(descriptor_);
}

void PartFile::become_target() {
  // What close() would say of a full disk is asked while the lock still keeps others away.
  const int copy = ::dup(descriptor_);
  if (copy < 0 || ::close(copy) != 0) fail(errno);
  const SignalsHeld held;
  if (::rename(name_.c_str(), target_.c_str()) != 0) fail(errno);
  leftover_.strike_off();
  name_.clear();
}

}  // namespace magicmass::command
