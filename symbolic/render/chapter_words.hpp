// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>

namespace magicmass::render {

struct ChapterWords {
  std::string title;
  std::string introduction;  // a sentence or two; may be empty
};

/// What a chapter is about; one that is not known has its name for a title.
ChapterWords chapter_words(const std::string& chapter);

}  // namespace magicmass::render
