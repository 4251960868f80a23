// Answers in files, and what was said to those of this user.
#include <cctype>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <new>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include "classroom/classroom.hpp"
#include "host/child.hpp"

namespace classroom {
namespace {

using learn::Mark;

constexpr std::size_t most_bytes = std::size_t{1} << 16U;

struct Descriptor {
  int number;
  ~Descriptor() { ::close(number); }
};

/// Follows no link, waits for no writer. Nothing where there is no such file.
std::optional<std::string> text_in(const std::string& folder, const std::string& name) {
  constexpr int careful = O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_NOCTTY | O_CLOEXEC;
  const auto refuse = [] {
    throw InvalidInput(errno == ELOOP || errno == ENOTDIR ? "a link" : std::strerror(errno));
  };
  const Descriptor place{::open(folder.c_str(), careful | O_DIRECTORY)};
  if (place.number < 0) refuse();
  const Descriptor file{::openat(place.number, name.c_str(), careful)};
  if (file.number < 0 && errno == ENOENT) return {};
  if (file.number < 0) refuse();
  struct stat about {};
  if (::fstat(file.number, &about) != 0) refuse();
  if (!S_ISREG(about.st_mode)) throw InvalidInput("not a file with text");
  std::string text(most_bytes + 1, '\0');
  std::size_t size = 0;
  for (ssize_t count = 1; count > 0; size += std::size_t(count))  // a read may end early
    if ((count = ::read(file.number, &text[size], text.size() - size)) < 0) refuse();
  text.resize(size);
  if (text.size() > most_bytes) throw InvalidInput("more than 64 KiB");
  if (text.find('\0') != text.npos) throw InvalidInput("it has a zero byte; save it as UTF-8");
  return text;
}

std::string packed(const Judgement& said) {
  learn::Texts fields{std::to_string(int(said.mark)), said.feedback, said.misconception};
  fields.insert(fields.end(), said.notes.begin(), said.notes.end());
  return answers::joined(fields, std::string_view("\0", 1)) + '\0';
}

Judgement judged_apart(const Exercise& e, const std::string& text, const learn::Run& run,
                       unsigned seconds) {
  static std::set<std::string> prepared;  // the derivation is proved, own programs are run
  if (prepared.insert(e.source + '\0' + e.id).second) faults(e, run);
  const auto judged = [&] {
    try {
      return packed(judge(e, text, run));
    } catch (const std::bad_alloc&) {
      return packed({Mark::undecided, "It does not fit into memory."});
    } catch (const std::exception& error) {
      return packed({Mark::undecided, error.what()});
    }
  };
  const host::End end = host::end_of(
      {"an answer"}, "", {.seconds = seconds, .file_bytes = 64U << 20U, .instead = judged});
  const learn::Texts fields = learn::fields(end.output, '\0');  // as packed
  if (end.code == 0 && !end.is_late && !fields.empty())
    return {
        Mark(std::stoi(fields[0])), fields.at(1), {fields.begin() + 3, fields.end()}, fields[2]};
  return {Mark::undecided,
          end.is_late ? "It was not judged within " + std::to_string(seconds) + " s."
          : end.code > host::of_signal
              ? "Judging it crashed: signal " + std::to_string(end.code - host::of_signal) + "."
              : "Its judge ended before it said anything."};
}

constexpr std::size_t misses_without_hint = 2;  // and answers that were not understood

/// "" where the environment names no place.
std::filesystem::path memory() {
  for (const auto& [name, rest] : {std::pair{"XDG_STATE_HOME", ""}, {"HOME", ".local/state"}})
    if (const char* const place = std::getenv(name); place != nullptr && *place == '/')
      return std::filesystem::path(place) / rest / "magicmass/answers.tsv";
  return {};
}

/// In one write, so that lines of programs that run at once do not mix.
void keep(const learn::Texts& fields) {
  const std::filesystem::path path = memory();
  std::error_code error;
  std::filesystem::create_directories(path.parent_path(), error);
  constexpr int at_its_end = O_WRONLY | O_APPEND | O_CREAT | O_NONBLOCK | O_CLOEXEC;
  const Descriptor file{::open(path.c_str(), at_its_end, 0600)};
  if (file.number < 0) return;
  const std::string line = answers::joined(fields, "\t") + "\n";
  [[maybe_unused]] const ssize_t ignored = ::write(file.number, line.data(), line.size());
}

bool is_miss(const std::string& verdict) {
  return verdict == "wrong" || verdict == "incomplete" || verdict == "other form";
}

}  // namespace

std::string answer_file(const Exercise& e) { return e.id + (e.kind == "code" ? ".cpp" : ".txt"); }

std::optional<std::string> misnamed(const std::string& file, const std::vector<Exercise>& all) {
  if (file.starts_with('.') || file.ends_with('~')) return {};
  const auto stem = [](std::string name) {
    name.erase(std::min(name.find('.'), name.size()));
    for (char& c : name) c = c == ' ' ? '_' : char(std::tolower(static_cast<unsigned char>(c)));
    return name;
  };
  const learn::Texts names = answers::texts_of(all, answer_file);
  if (std::ranges::count(names, file) != 0) return {};
  for (const std::string& name : names)  // Half angle.docx
    if (stem(name) == stem(file)) return "no exercise has this file; is " + name + " meant?";
  if (!file.ends_with(".txt") && !file.ends_with(".cpp")) return {};
  return "no exercise has this file" + learn::meant(file, names, "; see learn list");
}

std::optional<Judgement> judged_file(const Exercise& e, const std::string& folder,
                                     const learn::Run& run, unsigned seconds) try {
  const std::optional<std::string> text = text_in(folder, answer_file(e));
  return text ? std::optional(judged_apart(e, *text, run, seconds)) : std::nullopt;
} catch (const InvalidInput& error) {
  return Judgement{Mark::unread, std::string("Not read: ") + error.what() + "."};
}

answers::Fields told(const Exercise& e, const Judgement& said) {
  const auto shown = [](const std::string& note) { return answers::shown_text(note, 300); };
  const learn::Texts notes = answers::texts_of(said.notes, shown);
  return {{"id", text_cell(e.id)},
          {"verdict", text_cell(word(said.mark))},
          {"feedback", text_cell(said.feedback)},
          {"notes", notes.empty() ? answers::missing_cell() : answers::list_cell(notes)}};
}

std::map<std::string, Attempts> attempts() {
  std::map<std::string, Attempts> all;
  const std::filesystem::path path = memory();
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) return all;
  std::ifstream file(path);
  for (std::string line; std::getline(file, line);) {
    learn::Texts fields = learn::fields(line, '\t');
    fields.resize(2);  // others may have written here
    const std::string& said = fields[1];
    Attempts& one = all[fields[0]];
    one.misses += is_miss(said) ? 1 : 0;
    one.unread += said == word(Mark::unread) ? 1 : 0;
    if (said.starts_with("hint "))
      one.shown.insert(said);
    else if (one.done != "right")
      one.done = said == "right" ? said : "tried";
  }
  return all;
}

void remember(const Exercise& e, Judgement& said) {
  const std::string verdict = word(said.mark);
  const Attempts before = attempts()[e.id];  // nothing where there is no memory
  keep({e.id, verdict, said.misconception.empty() ? "" : answers::shown_text(said.misconception)});
  if (said.mark == Mark::unread && before.unread >= misses_without_hint)
    said.feedback += (said.feedback.find_last_of(".?!") + 1 == said.feedback.size() ? " " : ". ") +
                     how_to_write(e, said.feedback);
  if (!is_miss(verdict) || before.misses < misses_without_hint) return;
  std::size_t next = 1;
  while (before.shown.contains("hint " + std::to_string(next))) ++next;
  const bool is_left = next <= e.hints.size();
  said.feedback += is_left
                       ? " Hint " + std::to_string(next) + ": " + e.hints[next - 1]
                       : " There are no more hints: magicmass learn solution " + e.id + e.options;
  if (is_left) remember_hint(e, next);
}

void remember_hint(const Exercise& e, std::size_t n) { keep({e.id, "hint " + std::to_string(n)}); }

}  // namespace classroom
