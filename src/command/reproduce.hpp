// SPDX-License-Identifier: GPL-2.0-or-later
// reproduce.
#pragma once

#include "answers/request.hpp"

namespace command {

/// Every number of the paper beside ours; formats text, markdown, json, csv. With out: the figures
/// of the paper and the tables in a folder, too.
answers::Answer reproduce(const answers::Request& request);

}  // namespace command
