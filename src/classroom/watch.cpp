// Looks at the times of change: that works on every file system, for every way to save.
#include <chrono>
#include <thread>

#include "classroom/classroom.hpp"

namespace classroom {
void watch(const std::vector<Exercise>& all, const std::string& folder, const learn::Run& run,
           const std::function<void(std::string_view)>& say) {
  std::error_code error;
  const std::string place = std::filesystem::canonical(folder, error);
  const auto tell = [&](const std::string& text) {
    say(text);
    say("");
  };
  /// Time of change and size: others where it was saved, or something was renamed over it.
  using Stamp = std::pair<std::filesystem::file_time_type, std::uintmax_t>;
  std::map<std::string, Stamp> last, judged;
  std::set<std::string> reported;
  for (bool is_first = true;; is_first = false) {
    const std::filesystem::directory_iterator entries(place, error);
    if (error)
      throw InvalidInput("learn watch: cannot read the folder " + answers::shown_text(folder, 200) +
                         ": " + error.message());
    for (const auto& entry : entries) {
      const std::string name = entry.path().filename();
      const auto found = std::ranges::find(all, name, answer_file);
      if (found == all.end()) {
        if (const auto said = misnamed(name, all); said && reported.insert(name).second)
          tell(answers::shown_text(name) + ": " + *said + "\n");
        continue;
      }
      const Stamp now{entry.last_write_time(error), entry.file_size(error)};
      if (error || now.second == 0) continue;  // as for a moment while an editor saves
      if (is_first) judged[name] = now;
      const bool is_written = std::exchange(last[name], now) != now;  // perhaps it goes on
      if (is_written || std::exchange(judged[name], now) == now) continue;
      std::optional<Judgement> said = judged_file(*found, place, run);
      if (!said) continue;
      remember(*found, *said);
      tell("\n" + written(one_row(told(*found, *said)), answers::Format::text));
    }
    if (is_first)
      tell("Watching " + answers::shown_text(place, 200) +
           ": save an answer as ID.txt, or ID.cpp for code. Ctrl-C ends this.\n");
    std::this_thread::sleep_for(std::chrono::milliseconds(150));
  }
}

}  // namespace classroom
