// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>

#include "command/figure/figure.hpp"

namespace magicmass::command {

/// The figure as a file of this format, "svg", "png" or "pdf": the same bytes each time. SVG files hold title and
/// description. Throws InvalidInput without gnuplot, Undecided where gnuplot could not draw.
std::string drawn(const Figure& figure, const std::string& format);

/// What a gnuplot script that sets output to 'figure', and reads `data` as CSV, writes there. Throws likewise; without
/// gnuplot the message ends with what can be done.
std::string gnuplot_file(const std::string& data, const std::string& script,
                         const std::string& without_gnuplot);

}  // namespace magicmass::command
