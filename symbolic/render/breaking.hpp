// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <functional>
#include <vector>

#include "render/formula.hpp"

namespace magicmass::render {

/// Part of a formula that stays on one line; lines end between pieces.
struct Piece {
  std::string sign = {};  // "+", "-", "=", "= -" before it; nothing in a product
  Formula formula = {};   // a factor among others if `factor`
  bool factor = false;
  int opens = 0;  // parentheses before it, each closed behind a later piece
  int closes = 0;
};

using WidthOf = std::function<double(const Formula&)>;

/// A formula as pieces, none wider than `room` where that can be: at the terms of its sums, at the factors of its products,
/// within the parentheses of a factor or of a numerator that is too wide itself ((x + y)/z as 1/z (x + y)).
std::vector<Piece> pieces(const Formula& formula, const WidthOf& width, double room);

}  // namespace magicmass::render
