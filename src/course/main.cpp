// magicmass_course TUTORIALS OUT: the course's pages from the tutorials and OUT/figures/*.svg.
#include <fstream>
#include <iostream>

#include "answers/derivation.hpp"
#include "course/chapter.hpp"
#include "magicmass/scenes/files.hpp"

namespace {

using magicmass::scenes::text_of;
namespace fs = std::filesystem;

/// Of a drawing, for those who cannot see it.
std::string description(const std::string& svg) {
  const std::string before = "<desc id=\"desc\">";
  const std::size_t begin = svg.find(before), end = svg.find('<', begin + 1);
  return begin == svg.npos ? "" : svg.substr(begin, end - begin).erase(0, before.size());
}

}  // namespace

int main(int argc, char** argv) try {
  if (argc != 3) throw answers::InvalidInput("usage: magicmass_course TUTORIALS OUT");
  const fs::path tutorials = argv[1], out = argv[2];
  std::vector<course::Chapter> chapters;
  for (const fs::path& folder : course::files_in(tutorials))
    if (fs::exists(folder / "intro.md")) chapters.push_back(course::read_chapter(folder));
  course::Surroundings around{answers::derivation_sections(), {}, {}};
  for (const auto& c : chapters) around.chapters.emplace(c.name, title_of(c));
  for (const fs::path& file : course::files_in(out / "figures"))
    around.figures[file.stem()] = description(text_of(file));
  std::vector<course::Page> pages;
  for (const auto& c : chapters) pages.push_back({c.name, title_of(c), chapter_html(c, around)});
  const std::string welcome = course::html_of(text_of(tutorials / "course/index.md"));
  for (const auto& [name, text] : files_of(pages, welcome, render::html_body(around.derivation)))
    if (!(std::ofstream(out / name) << text << std::flush))
      throw std::runtime_error("cannot write " + (out / name).string());
  std::cout << "the course: " << (out / "index.html").string() << "\n";
} catch (const answers::InvalidInput& error) {
  std::cerr << error.what() << "\n";
  return 2;
} catch (const std::exception& error) {
  std::cerr << "magicmass_course: " << error.what() << "\n";
  return 1;
}
