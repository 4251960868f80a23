// SPDX-License-Identifier: GPL-2.0-or-later
// The course's pages: a frame around what chapters say. They ask no network for anything.
#pragma once

#include <map>
#include <string>
#include <vector>

namespace course {

struct Page {
  std::string name, title;
  std::string body;  ///< HTML
};
/// By name of file: a page a chapter, the first page and, to be printed, all of it on one page;
/// derivation.html shows the proofs.
std::map<std::string, std::string> files_of(const std::vector<Page>& chapters,
                                            const std::string& welcome, const std::string& proofs);

}  // namespace course
