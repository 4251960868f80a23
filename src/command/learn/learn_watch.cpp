// SPDX-License-Identifier: GPL-2.0-or-later
#include <chrono>
#include <cstdlib>
#include <thread>

#include <unistd.h>

#include "command/learn/learn.hpp"
#include "command/terminal_style.hpp"

namespace magicmass::command {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds between_looks{200};

/// What is in the file now; empty while an editor replaces it.
std::string content_of(const fs::path& file) {
  std::error_code error;
  return fs::is_regular_file(file, error) ? text_of(file) : "";
}

bool is_clearing_terminal() {
  const char* const kind = std::getenv("TERM");
  return ::isatty(STDOUT_FILENO) == 1 && kind != nullptr && std::string(kind) != "dumb";
}

class Watch {
public:
  Watch(const LearnOptions& options, Destination& output)
      : options_(options),
        catalogue_{fs::path(options.content)},
        student_(student_folder(options)),
        output_(output),
        style_(text_style(output, options.ascii)),
        can_clear_(is_stdout(options.output.path) && is_clearing_terminal()) {}

  void run() {
    const Clock::time_point start = Clock::now();
    const Exercise* exercise =
        options_.id.empty() ? next_exercise(catalogue_, student_, "") : &catalogue_.at(options_.id);
    while (exercise != nullptr) {
      show(*exercise);
      std::string before = content_of(student_.answer_of(*exercise));
      for (bool is_right = false; !is_right;) {
        std::this_thread::sleep_for(between_looks);
        if (options_.seconds > 0 &&
            std::chrono::duration<double>(Clock::now() - start).count() > options_.seconds)
          return;
        std::string now = content_of(student_.answer_of(*exercise));
        if (now == before || now.empty()) continue;
        before = std::move(now);
        clear();
        is_right = check_and_say(catalogue_, *exercise, student_, before, "text", output_, style_)
                       .verdict == Judged::right;
      }
      exercise = next_exercise(catalogue_, student_, exercise->id);
    }
    output_.write("All exercises are right.\n");
  }

private:
  void clear() {
    if (can_clear_) output_.write("\x1b[2J\x1b[H");
  }

  void show(const Exercise& exercise) {
    const Posed posed = posed_to(student_, exercise);
    student_.begin(exercise, prompt_page(posed, student_, {}));
    student_.save();
    output_.write("\n" + prompt_page(posed, student_, style_) +
                  "\nWatching that file: save it, and it is checked.\n");
    output_.flush();
  }

  const LearnOptions& options_;
  Catalogue catalogue_;
  StudentFolder student_;
  Destination& output_;
  render::TextStyle style_;
  bool can_clear_;
};

}  // namespace

ExitCode learn_watch(const LearnOptions& options) {
  Destination output(options.output.path);
  Watch(options, output).run();
  output.finish();
  return ExitCode::done;
}

}  // namespace magicmass::command
