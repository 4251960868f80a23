// SPDX-License-Identifier: GPL-2.0-or-later
// figure: pictures by gnuplot of data from answers.
#pragma once

#include "answers/request.hpp"

namespace command {

/// One figure by its name; formats svg, png, csv; "list": their names and titles.
answers::Answer figure(const answers::Request& request);

}  // namespace command
