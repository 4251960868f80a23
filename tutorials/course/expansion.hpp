// SPDX-License-Identifier: GPL-2.0-or-later
// From a chapter's text to Markdown with nothing left to look up. In the text, outside of code:
//   {{name}}          what the program printed under that name; a block on a line of its own
//   {{theorem:id}}    a step of the derivation, displayed on a line of its own
//   {{left:id}}, {{right:id}}    one side of it; displayed on a line of its own, as is
//   {{math:name}}     what the program printed, as a formula
//   $a(n)$            a term in the derivation's notation; it claims nothing
//   {{figure:name}} caption      magicmass figure name
//   {{plot:name}} caption        the chapter's name.gnuplot
//   {{run:magicmass ...}}        a command with what it prints
//   {{program}}       tutorial.cpp
//   {{chapter:name}}  a link to another chapter
//   {{exercises}}     the chapter's exercises
// A number typed in the text is refused: it would not change with the program.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "course/chapter.hpp"
#include "course/formulas.hpp"

namespace magicmass::course {

/// What a text may refer to besides its own program.
struct Surroundings {
  Steps steps;
  std::map<std::string, std::string> chapters;  // name -> title
  std::string magicmass;                        // the program
  /// Draws a figure of `magicmass figure`, or a chapter's plot; gives the file to show. Throws Refusal.
  std::function<std::string(const Chapter& chapter, const std::string& kind,
                            const std::string& name)>
      draw;
};

/// Throws Refusal: for a name that is unknown, one that the program prints and the text does not use, a typed number, a
/// term that claims something. The message begins with file and line.
std::string expanded(const Chapter& chapter, const Surroundings& surroundings);

/// Minutes that reading takes, from an expanded text.
int reading_minutes(const std::string& markdown);

}  // namespace magicmass::course
