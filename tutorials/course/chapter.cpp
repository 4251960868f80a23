// SPDX-License-Identifier: GPL-2.0-or-later
#include "course/chapter.hpp"

#include <algorithm>
#include <sstream>
#include <tuple>
#include <utility>

#include "course/refusal.hpp"
#include "course/shell.hpp"

namespace magicmass::course {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

void require_sections(const Chapter& chapter) {
  std::vector<std::string> found;
  for (const std::string& line : lines_of(chapter.text))
    if (line.starts_with("## ")) found.push_back(line.substr(3));
  if (found == section_titles()) return;
  std::string all;
  for (const std::string& title : section_titles())
    all += (all.empty() ? "" : ", ") + title;
  throw Refusal(chapter.file("intro.md") +
                ": its sections (##) must be, in this order: " + all);
}

void require_expected(const Chapter& chapter, const std::string& output) {
  const auto expected = lines_of(read(chapter.folder / "expected_output.txt"));
  const auto got = lines_of(output);
  const auto differ =
      std::mismatch(got.begin(), got.end(), expected.begin(), expected.end());
  if (differ.first == got.end() && differ.second == expected.end()) return;
  const auto shown = [](auto at, auto end) {
    return at == end ? "nothing more" : "\"" + *at + "\"";
  };
  throw Refusal(chapter.file("expected_output.txt:") +
                std::to_string(differ.first - got.begin() + 1) +
                ": the program prints " + shown(differ.first, got.end()) +
                ", expected is " + shown(differ.second, expected.end()));
}

/// Of a line `name = value` in TOML, without quotes; empty if there is none.
std::string value_of(const std::vector<std::string>& lines,
                     const std::string& name) {
  const std::string beginning = name + " = ";
  for (const std::string& line : lines) {
    if (!line.starts_with(beginning)) continue;
    const auto first = line.find_first_not_of('"', beginning.size());
    return line.substr(first, line.find_last_not_of('"') + 1 - first);
  }
  return "";
}

}  // namespace

const std::vector<std::string>& section_titles() {
  static const std::vector<std::string> titles{
      "Goal",   "Derivation", "Check it yourself",
      "Figure", "Exercises",  "Possibilities for extensions"};
  return titles;
}

Chapter load_chapter(const fs::path& folder, const fs::path& program) {
  Chapter chapter;
  chapter.folder = folder;
  chapter.name = folder.filename().string();
  const std::string intro = read(folder / "intro.md");
  const auto end = intro.find('\n');
  if (!intro.starts_with("# ") || end == std::string::npos)
    throw Refusal(chapter.file("intro.md") +
                  ":1: the first line must be \"# \" and the title");
  chapter.title = intro.substr(2, end - 2);
  chapter.text = intro.substr(end + 1);
  require_sections(chapter);
  chapter.program = read(folder / "tutorial.cpp");
  chapter.program.erase(0, chapter.program.find('\n') + 1);
  const Ran ran = run(quoted(program.string()));
  if (ran.status != 0)
    throw Refusal(chapter.file("tutorial.cpp") + ": its program " +
                  program.string() +
                  (fs::exists(program) ? " failed" : " is not built"));
  require_expected(chapter, ran.output);
  chapter.printed = read_printed(ran.output, chapter.file("tutorial.cpp"));
  return chapter;
}

std::vector<fs::path> chapter_folders(const fs::path& tutorials) {
  std::vector<fs::path> folders;
  for (const auto& entry : fs::directory_iterator(tutorials))
    if (fs::exists(entry.path() / "intro.md")) folders.push_back(entry.path());
  std::sort(folders.begin(), folders.end());
  return folders;
}

std::vector<Exercise> exercises(const fs::path& chapter) {
  std::vector<std::pair<std::string, Exercise>> found;  // by difficulty
  if (fs::exists(chapter / "exercises"))
    for (const auto& entry : fs::directory_iterator(chapter / "exercises")) {
      if (!fs::exists(entry.path() / "exercise.toml")) continue;
      const auto lines = lines_of(read(entry.path() / "exercise.toml"));
      const std::string id = value_of(lines, "id"),
                        title = value_of(lines, "title");
      if (id.empty() || title.empty())
        throw Refusal((entry.path() / "exercise.toml").string() +
                      ": needs id = \"...\" and title = \"...\"");
      found.emplace_back(value_of(lines, "difficulty"), Exercise{id, title});
    }
  std::sort(found.begin(), found.end(), [](const auto& x, const auto& y) {
    return std::tie(x.first, x.second.id) < std::tie(y.first, y.second.id);
  });
  std::vector<Exercise> result;
  for (const auto& [difficulty, exercise] : found) result.push_back(exercise);
  return result;
}

}  // namespace magicmass::course
