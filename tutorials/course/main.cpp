// SPDX-License-Identifier: GPL-2.0-or-later
// The course from the tutorials: pages, and one PDF.
#include <filesystem>
#include <iostream>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "course/chapter.hpp"
#include "course/expansion.hpp"
#include "course/figures.hpp"
#include "course/pages.hpp"
#include "course/refusal.hpp"
#include "course/shell.hpp"
#include "derivation/derivation.hpp"
#include "render/derivation_pages.hpp"
#include "render/formula_mathml.hpp"
#include "render/steps.hpp"

namespace magicmass::course {
namespace {

namespace fs = std::filesystem;

struct Options {
  std::string tutorials, programs, magicmass, out;
  bool pdf = true;
};

/// <img> for a drawing with its description: what `magicmass figure` wrote into it, or the script's first line.
std::string image(const std::string& file, const std::string& description) {
  return "<img src=\"figures/" + file + "\" width=\"800\" alt=\"" + description +
         "\"/>";
}

std::string between(const std::string& text, const std::string& first,
                    const std::string& last) {
  const auto from = text.find(first);
  if (from == std::string::npos) return "";
  return text.substr(from + first.size(),
                     text.find(last, from) - from - first.size());
}

std::string drawn(const Options& options, const Chapter& chapter,
                  const std::string& kind, const std::string& name) {
  if (kind == "figure") {
    if (options.out.empty()) {
      const std::string names =
          run(quoted(options.magicmass) + " figure --list").output;
      if (("\n" + names).find("\n" + name + " ") == std::string::npos)
        throw Refusal("magicmass figure knows no " + name);
      return "";
    }
    const fs::path svg = fs::path(options.out) / "figures" / (name + ".svg");
    draw_figure(options.magicmass, name, svg);
    return image(name + ".svg",
                 between(read(svg), "<desc id=\"desc\">", "</desc>"));
  }
  const std::string script = read(chapter.folder / (name + ".gnuplot"));
  if (!script.starts_with("# "))
    throw Refusal(chapter.file(name + ".gnuplot") +
                  ": its first line must be \"# \" and what is to be seen");
  if (options.out.empty()) return "";
  const std::string file = chapter.name + "_" + name + ".svg";
  draw_plot(script, chapter.printed, fs::path(options.out) / "figures" / file);
  return image(file, render::html_escaped(between(script, "# ", "\n")));
}

void write_pdf(const fs::path& out) {
  if (!is_installed("chromium")) {
    std::cout << "course.pdf is left out: it needs the Debian package chromium "
                 "(./setup --all)\n";
    return;
  }
  const fs::path pdf = out / "course.pdf";
  // --no-sandbox: Chromium's own needs rights that containers do not give; the page is our own file.
  run("chromium --headless --no-sandbox --disable-gpu --no-pdf-header-footer "
      "--print-to-pdf=" +
      quoted(pdf.string()) + " " +
      quoted("file://" + fs::absolute(out / "course.html").string()) + " 2>&1");
  if (!fs::exists(pdf)) throw Refusal("chromium could not write " + pdf.string());
}

int render_course(const Options& options) {
  std::vector<Chapter> chapters;
  for (const fs::path& folder : chapter_folders(options.tutorials))
    chapters.push_back(
        load_chapter(folder, fs::path(options.programs) / folder.filename()));
  if (chapters.empty())
    throw Refusal(options.tutorials +
                  ": holds no chapter (a folder with intro.md)");
  const derivation::Derivation derivation = derivation::derive();
  if (derivation.refused) throw Refusal(derivation.refused->what());
  const std::vector<proof::Step> steps = render::steps_of(derivation);
  Surroundings around{by_id(steps),
                      {},
                      options.magicmass,
                      [&](const auto& chapter, const auto& kind, const auto& name) {
                        return drawn(options, chapter, kind, name);
                      }};
  for (const Chapter& chapter : chapters)
    around.chapters[chapter.name] = chapter.title;
  Chapter opening;
  opening.folder = fs::path(options.tutorials) / "course";
  opening.name = "course";
  opening.text = read(opening.folder / "index.md");
  opening.text.insert(0, "\n");

  std::vector<Page> pages;
  std::vector<std::string> texts;
  for (const Chapter& chapter : chapters) {
    texts.push_back(expanded(chapter, around));
    pages.push_back(
        {chapter.name, chapter.title, "", reading_minutes(texts.back())});
  }
  const std::string opening_text = expanded(opening, around);
  for (const Page& page : pages)
    std::cout << page.name << ": " << page.minutes << " minutes\n";
  if (options.out.empty()) return 0;

  const fs::path out = options.out;
  const bool has_pdf = options.pdf && is_installed("chromium");
  for (std::size_t i = 0; i < pages.size(); ++i)
    pages[i].body = html_of(texts[i], pages[i].name + "-");
  const std::string opening_body = html_of(opening_text, "opening-");
  for (std::size_t i = 0; i < pages.size(); ++i)
    write(out / (pages[i].name + ".html"), chapter_page(pages, i));
  write(out / "index.html", index_page(pages, opening_body, has_pdf));
  write(out / "course.html", whole_page(pages, opening_body));
  write(out / "derivation.html", proofs_page(render::derivation_html(steps)));
  write(out / "course.css", read(opening.folder / "course.css"));
  if (options.pdf) write_pdf(out);
  std::cout << "the course is in " << (out / "index.html").string() << "\n";
  return 0;
}

}  // namespace
}  // namespace magicmass::course

int main(int argc, char** argv) {
  magicmass::course::Options options;
  CLI::App app{
      "Example:\n  magicmass_course --tutorials tutorials --programs "
      "build/default/bin/tutorials "
      "--out build/course"};
  app.add_option("--tutorials", options.tutorials, "the chapters' folders")
      ->required();
  app.add_option("--programs", options.programs, "the folder of their programs")
      ->required();
  app.add_option("--magicmass", options.magicmass, "the program magicmass")
      ->required();
  app.add_option("--out", options.out,
                 "where the pages go; without it the texts are only checked");
  app.add_flag("--pdf,--no-pdf{false}", options.pdf, "one PDF of it all, too");
  CLI11_PARSE(app, argc, argv);
  if (!options.out.empty() && !magicmass::course::is_installed("pandoc")) {
    constexpr int left_out = 77;  // whoever installs goes on without the course
    std::cerr << "magicmass_course: the course needs the Debian package pandoc "
                 "(./setup --all)\n";
    return left_out;
  }
  try {
    return magicmass::course::render_course(options);
  } catch (const std::exception& error) {
    std::cerr << "magicmass_course: " << error.what() << "\n";
    return 1;
  }
}
