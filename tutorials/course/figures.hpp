// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "course/printed.hpp"

namespace magicmass::course {

/// Draws `magicmass figure NAME` into FILE.svg. Throws Refusal where there is no such figure, or no gnuplot.
void draw_figure(const std::string& magicmass, const std::string& name,
                 const std::filesystem::path& svg);

/// What {{name}} in a gnuplot script stands for.
std::vector<std::string> names_in(const std::string& script);

/// Draws a chapter's own gnuplot script: {{name}} in it becomes a file with the numbers of the block of that name.
void draw_plot(const std::string& script, const std::vector<Printed>& printed,
               const std::filesystem::path& svg);

}  // namespace magicmass::course
