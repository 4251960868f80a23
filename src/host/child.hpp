// Another program, its input and output in memory, its files in a folder for the time being.
#pragma once

#include <atomic>
#include <functional>
#include <string>
#include <vector>

#include <sys/resource.h>

namespace host {

constexpr int results_descriptor = 3;  // of the other program
constexpr int not_there = 127;         // as shells say it
constexpr int of_signal = 128;         // and this, with the signal added

/// What another program may take; without seconds there are no bounds.
struct Bounds {
  unsigned seconds = 0;     ///< on the clock
  rlim_t bytes = 0;         ///< of memory
  rlim_t file_bytes = 0;    ///< in each file, output too
  std::string folder = {};  ///< where it runs; "": here
  /// Called in the process that then sets this limit and becomes the program `word`, and does
  /// nothing else; where it says false, none runs.
  std::function<bool(const char* word, const rlimit* memory)> confine = {};
  /// Instead of a program, with the memory of this one; what it returns is the output.
  std::function<std::string()> instead = {};
};
struct End {
  bool was_confined;  ///< false: it was not run
  bool is_late;
  int code;  ///< exit code, or of_signal + the signal that ended it
  std::string output, errors, results;
};
/// How the program words[0] ends; with it ends whatever it started. They end where this one does.
End end_of(std::vector<std::string> words, const std::string& input = "",
           const Bounds& bounds = {});

/// 0, for this process and those that it forks from now on to see and change. Throws
/// std::runtime_error where the system refuses.
std::atomic<std::uint64_t>& shared_number();

/// Of this process and those that it starts.
void limit(__rlimit_resource resource, rlim_t value);

/// A folder that goes with all that is in it, however this process ends: another one waits for
/// that, and for the programs that were run meanwhile.
class TemporaryFolder {
public:
  /// Throws std::runtime_error after `name` where the system refuses.
  explicit TemporaryFolder(const std::string& name);
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  std::string path;

private:
  int alive_ = -1;  // the end of a pipe that is closed with the last process that has it
  int cleaner_ = -1;
};

}  // namespace host
