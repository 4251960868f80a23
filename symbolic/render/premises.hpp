// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <vector>

#include "proof/theorem.hpp"

namespace magicmass::render {

/// What a step rests on: its premises, and the definitions of the names that it mentions, as ids in the derivation's
/// order. Only steps before it count.
std::vector<std::string> foundations(const proof::Step& step, const std::vector<proof::Step>& all);

/// A line of a tree: a step, and how deep it stands below what was asked for.
struct TreeLine {
  proof::Step step;                   ///< what the line shows
  std::size_t depth = 0;              ///< 0 for what was asked for
  bool last = true;                   ///< of those below one step
  bool seen = false;                  ///< it and its foundations stand further up already
  bool has_below = false;             ///< its foundations follow
  std::vector<bool> open_above = {};  ///< for each level above, whether more lines follow there
};

/// The steps with all that they rest on below them, each with its foundations once.
std::vector<TreeLine> premise_tree(const std::vector<proof::Step>& roots,
                                   const std::vector<proof::Step>& all);

/// The same steps, each once, in the derivation's order.
std::vector<proof::Step> steps_of_tree(const std::vector<TreeLine>& tree,
                                       const std::vector<proof::Step>& all);

}  // namespace magicmass::render
