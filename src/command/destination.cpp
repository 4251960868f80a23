// O_TMPFILE, linkat and rename; an O_EXCL name where the file system knows no files without one.
#include <cerrno>
#include <filesystem>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include "answers/request.hpp"
#include "command/streams.hpp"

namespace command {
namespace {

constexpr std::size_t buffer_size = std::size_t{1} << 16U;

/// The descriptor a path names (/dev/fd/3), or -1: opened anew it overwrites what others wrote.
int named_descriptor(const std::string& path) {
  if (path.empty() || path == "-" || path == "/dev/stdout") return STDOUT_FILENO;
  if (path == "/dev/stderr") return STDERR_FILENO;
  for (const std::string folder : {"/dev/fd/", "/proc/self/fd/"})
    if (path.starts_with(folder) && path.size() <= folder.size() + 4)
      if (const auto number = answers::read_whole(path.substr(folder.size())))
        return static_cast<int>(*number);
  return -1;
}

/// The file a path stands for, there or not yet.
std::string behind_links(const std::string& path) {
  constexpr int most_links = 40;  // as the system follows
  std::filesystem::path file = path;
  std::error_code error;
  for (int links = 0; links < most_links && std::filesystem::is_symlink(file, error); ++links)
    file = file.parent_path() / std::filesystem::read_symlink(file, error);
  return file.string();
}

std::string folder_of(const std::string& target) {
  const std::string folder = std::filesystem::path(target).parent_path().string();
  return folder.empty() ? "." : folder;
}

/// A name beside the target that nobody has: make(name) is to fail with EEXIST where one has.
std::string fresh_name(const std::string& target, const auto& make) {
  for (int number = 0; number < 1000; ++number) {
    const std::string name = folder_of(target) + "/.magicmass-" + std::to_string(::getpid()) + "-" +
                             std::to_string(number);
    if (make(name.c_str()) >= 0) return name;
    if (errno != EEXIST) break;
  }
  return "";
}

}  // namespace

Destination::Destination(const std::string& path, std::function<void()> before_writing)
    : shown_(answers::shown_text(path, 200)),
      descriptor_(named_descriptor(path)),
      before_writing_(std::move(before_writing)) {
  if (descriptor_ == STDOUT_FILENO) shown_ = "stdout";
  if (descriptor_ >= 0) return;
  struct stat status {};
  const bool exists = ::stat(path.c_str(), &status) == 0;
  if (!exists && errno != ENOENT) refuse(errno);  // a link to itself, for one
  if (exists && !S_ISREG(status.st_mode)) {
    descriptor_ = ::open(path.c_str(), O_WRONLY | O_CLOEXEC);
    if (descriptor_ < 0) refuse(errno);
    return;
  }
  target_ = behind_links(path);
  if (exists && ::access(target_.c_str(), W_OK) != 0) refuse(errno);
  constexpr mode_t mode = 0666;
  descriptor_ = ::open(folder_of(target_).c_str(), O_TMPFILE | O_WRONLY | O_CLOEXEC, mode);
  if (descriptor_ < 0)
    name_ = fresh_name(target_, [&](const char* name) {
      return descriptor_ = ::open(name, O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, mode);
    });
  if (descriptor_ < 0) refuse(errno);
  if (exists && ::fchmod(descriptor_, status.st_mode & 07777U) != 0) refuse(errno);
}

Destination::~Destination() {
  if (!name_.empty()) ::unlink(name_.c_str());
  if (!target_.empty()) ::close(descriptor_);
}

void Destination::refuse(int error) const {
  if (error == EPIPE) throw ClosedPipe();
  throw answers::InvalidInput("cannot write " + shown_ + ": " +
                              std::generic_category().message(error));
}

void Destination::write(std::string_view text) {
  buffer_ += text;
  if (buffer_.size() >= buffer_size) flush();
}

void Destination::flush() {
  if (target_.empty() && before_writing_) std::exchange(before_writing_, nullptr)();
  std::string_view rest = buffer_;
  while (!rest.empty()) {
    const ssize_t written = ::write(descriptor_, rest.data(), rest.size());
    if (written < 0 && errno == EAGAIN) {  // a pipe that its other users made non-blocking
      pollfd full{descriptor_, POLLOUT, 0};
      ::poll(&full, 1, -1);
      continue;
    }
    if (written < 0) refuse(errno);
    rest.remove_prefix(static_cast<std::size_t>(written));
  }
  buffer_.clear();
}

void Destination::finish() {
  flush();
  const int copy = ::dup(descriptor_);  // close() is where a quota is reported
  if (copy < 0 || ::close(copy) != 0) refuse(errno);
  if (target_.empty()) return;
  if (name_.empty()) {
    const std::string open_file = "/proc/self/fd/" + std::to_string(descriptor_);
    name_ = fresh_name(target_, [&](const char* name) {
      return ::linkat(AT_FDCWD, open_file.c_str(), AT_FDCWD, name, AT_SYMLINK_FOLLOW);
    });
    if (name_.empty()) refuse(errno);
  }
  if (::rename(name_.c_str(), target_.c_str()) != 0) refuse(errno);
  name_.clear();
}

}  // namespace command
