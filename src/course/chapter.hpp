// A chapter of the course: a text around a program, and the page that is made of both. What may
// stand in the text: TEACHERS.md, "Writing a chapter".
#pragma once

#include <filesystem>

#include "answers/table.hpp"
#include "learn/exercise.hpp"
#include "render/pages.hpp"

namespace course {

using answers::InvalidInput;
using render::html_code, render::html_link, render::html_text;
using Texts = std::map<std::string, std::string>;

struct Chapter {
  std::string name;    ///< of its folder: "05_counting"
  std::string source;  ///< its text's file, as messages name it
  std::string text;    ///< "# Title", then the sections
  std::string program;
  std::string printed;       ///< by the program, as read_printed() has it
  std::string session = {};  ///< "$ magicmass ...", then its output, and so on
  std::vector<learn::Exercise> exercises = {};
};
struct Surroundings {
  std::vector<render::Section> derivation;
  Texts chapters;  ///< name to title
  Texts figures;   ///< name to what is to be seen
};

Chapter read_chapter(const std::filesystem::path& folder);
std::set<std::filesystem::path> files_in(const std::filesystem::path& folder);
/// Throws answers::InvalidInput, "FILE:1: ...", where the first line is not "# Title".
std::string title_of(const Chapter& chapter);
/// The text below its title as HTML; figures are expected at figures/NAME.svg. Throws
/// answers::InvalidInput, "FILE:LINE: ...": for a name that nothing has, sections that are missing,
/// a typed number, a claim without a theorem, a value or a command that is not shown.
std::string chapter_html(const Chapter& chapter, const Surroundings& surroundings);
std::string html_of(const std::string& markdown);

/// By name: "name: value", or "name:" above lines that begin with two blanks, a block, each of
/// whose lines ends with \n; "# ..." is for the terminal alone. Throws answers::InvalidInput for
/// any other line and for a name that is printed twice.
Texts read_printed(const std::string& output);
Texts read_session(const std::string& session);
/// A term in the derivation's notation, or the letter of a body, as MathML. Throws
/// answers::InvalidInput for what cannot be read and for what claims something.
std::string term_html(const std::string& text);
/// -1e-20 as a power of ten with a sign of its own; a formula; words.
std::string value_html(const std::string& text);
/// A table where lines have cells, "a | b"; else the lines as they are.
std::string block_html(const std::string& lines);

struct Page {
  std::string name, title, html;
};
/// By name of file: a page a chapter, the first page and, to be printed, all of it on one page;
/// derivation.html shows the proofs. They ask no network for anything.
Texts files_of(const std::vector<Page>& pages, const std::string& top, const std::string& proofs);

}  // namespace course
