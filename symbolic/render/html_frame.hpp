// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <vector>

namespace magicmass::render {

/// An entry of the navigation: the anchor of a part of the page, and its title.
struct PageChapter {
  std::string anchor;
  std::string title;
};

/// A whole page: no script, no network, light and dark, narrow and wide; well-formed XML.
std::string html_page(const std::string& title, const std::vector<PageChapter>& chapters,
                      const std::string& body);

/// Words with formulas as MathML.
std::string html_prose(const std::string& words);

}  // namespace magicmass::render
