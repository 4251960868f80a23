// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <vector>

#include "codegen/ir.hpp"

namespace magicmass::codegen {

// Whether a stage ends with a node: what is looked up or takes a polynomial.
bool ends_a_stage(const Node& node);

// A program cut into stages: each ends where a root, an arctangent or a sine-cosine pair is known, so that in a loop
// over a block nothing waits for the last step of the same element; where it `cuts_turns`, where the angle of a pair is
// known, too. `stage[i]` of node i counts from 0.
struct Stages {
  std::vector<int> stage;
  int count = 0;
};
Stages stages_of(const Program& program, bool cuts_turns);

// The number of factors of a node, counted like a polynomial's degree: those that a root, an arctangent, a sine or a cosine makes
// count as one, exact ones as none.
int degree_of(const Program& program, int number);

// How many operations have to be done one after the other for a node.
int depth_of(const Program& program, int number);

}  // namespace magicmass::codegen
