// SPDX-License-Identifier: GPL-2.0-or-later
// A chapter of the course: a text around a program, and the page that is made of both.
//
// In the text, outside of code:
//   {{name}}                  what the program printed under that name
//   {{theorem:id}}            a theorem, {{left:id}} and {{right:id}} its sides; displayed where
//                             they stand on a line of their own, and so is what is printed
//   $a_n$                     a term as the derivation prints it; it claims nothing
//   {{figure:name}} caption   a figure of `magicmass figure`
//   {{run:magicmass ...}}     a command of the chapter's session with what it prints
//   {{program}}, {{exercises}}, {{chapter:05_counting}}
// A number that is typed in the text is refused: it would not change with the program.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "learn/exercise.hpp"
#include "render/pages.hpp"

namespace course {

struct Chapter {
  std::string name;    ///< of its folder: "05_counting"
  std::string source;  ///< its text's file, as messages name it
  std::string text;    ///< "# Title", then the sections
  std::string program;
  std::string printed;  ///< by the program, as read_printed() has it
  std::string session;  ///< "$ magicmass ...", then its output, and so on
  std::vector<learn::Exercise> exercises;
};
/// What the text may refer to besides.
struct Surroundings {
  std::vector<render::Section> derivation;
  std::map<std::string, std::string> chapters;  ///< name to title
  std::map<std::string, std::string> figures;   ///< name to what is to be seen
};

/// Throws answers::InvalidInput, "FILE:1: ...", where the first line is not "# Title".
std::string title_of(const Chapter& chapter);
/// The text below its title as HTML; figures are expected at figures/NAME.svg. Throws
/// answers::InvalidInput, "FILE:LINE: ...": for a name that nothing has, sections that are missing,
/// a typed number, a claim without a theorem, a value or a command that is not shown.
std::string chapter_html(const Chapter& chapter, const Surroundings& surroundings);
/// A text without references.
std::string html_of(const std::string& markdown);

}  // namespace course
