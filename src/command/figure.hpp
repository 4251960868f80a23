// SPDX-License-Identifier: GPL-2.0-or-later
// figure.
#pragma once

#include "answers/figures.hpp"
#include "answers/request.hpp"

namespace command {

/// Those of the paper, and of the report.
std::vector<answers::Figure> all_figures();

/// A figure of its data in svg, png, pdf or csv: the same bytes from every run, PDF but for
/// the date where cairo compresses it.
std::string picture(const answers::Figure& figure, const answers::Table& data,
                    const std::string& format);

/// By its name; list: all names.
answers::Answer figure(const answers::Request& request);

}  // namespace command
