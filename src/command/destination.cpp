// SPDX-License-Identifier: GPL-2.0-or-later
#include "command/destination.hpp"

#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <system_error>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include "magicmass/errors.hpp"
#include "magicmass/scenes/shown_text.hpp"

namespace magicmass::command {
namespace {

constexpr std::size_t buffer_size = std::size_t{1} << 16U;

/// The file a path stands for, there or not yet; a symbolic link keeps pointing to it.
std::string behind_links(const std::string& path) {
  constexpr int most_links = 40;  // as the kernel follows
  std::filesystem::path file = path;
  std::error_code error;
  for (int links = 0; links < most_links && std::filesystem::is_symlink(file, error); ++links) {
    const std::filesystem::path next = std::filesystem::read_symlink(file, error);
    if (error) return path;
    file = file.parent_path() / next;
  }
  return file.string();
}

}  // namespace

std::string words_of(const std::filesystem::filesystem_error& error) {
  return shown_text(error.path1().string(), 300) + ": " + error.code().message();
}

bool is_stdout(const std::string& path) { return path.empty() || path == "-"; }

Destination::Destination(const std::string& path) : name_("stdout") {
  if (is_stdout(path)) return;
  name_ = shown_text(path, 200);
  struct stat existing {};
  const bool exists = ::stat(path.c_str(), &existing) == 0;
  if (exists && !S_ISREG(existing.st_mode)) {
    descriptor_ = ::open(path.c_str(), O_WRONLY | O_CLOEXEC);
    if (descriptor_ < 0) refuse(errno);
    return;
  }
  const std::string target = behind_links(path);
  if (exists && ::access(target.c_str(), W_OK) != 0) refuse(errno);
  try {
    part_.emplace(target);
  } catch (const std::system_error& error) {
    refuse(error.code().value());
  }
  descriptor_ = part_->descriptor();
  if (exists && ::fchmod(descriptor_, existing.st_mode & 07777U) != 0) refuse(errno);
}

Destination::~Destination() {
  if (!part_ && descriptor_ >= 0 && descriptor_ != STDOUT_FILENO) ::close(descriptor_);
}

void Destination::refuse(int error) const {
  if (error == EPIPE) throw ClosedPipe();
  throw InvalidInput("cannot write " + name_ + ": " + std::generic_category().message(error));
}

void Destination::write(std::string_view text) {
  buffer_ += text;
  if (buffer_.size() >= buffer_size) flush();
}

void Destination::flush() {
  std::string_view rest = buffer_;
  while (!rest.empty()) {
    const ssize_t written = ::write(descriptor_, rest.data(), rest.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) refuse(errno);
    rest.remove_prefix(static_cast<std::size_t>(written));
  }
  buffer_.clear();
}

void Destination::finish() {
  flush();
  if (part_) {
    try {
      part_->become_target();
    } catch (const std::system_error& error) {
      refuse(error.code().value());
    }
  } else if (descriptor_ != STDOUT_FILENO) {
    const int descriptor = descriptor_;
    descriptor_ = -1;
    if (::close(descriptor) != 0) refuse(errno);
  }
}

bool Destination::is_colourful() const {
  const char* no_colour = std::getenv("NO_COLOR");
  const char* terminal = std::getenv("TERM");
  return descriptor_ == STDOUT_FILENO && ::isatty(STDOUT_FILENO) != 0 &&
         (no_colour == nullptr || *no_colour == '\0') &&
         (terminal == nullptr || std::string_view(terminal) != "dumb");
}

}  // namespace magicmass::command
