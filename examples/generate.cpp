// SPDX-License-Identifier: MIT
// A C++ header that computes two quantities and nothing else, from theorems. Needs magicmass::symbolic.
#include <iostream>

#include "codegen/specialised.hpp"
#include "derivation/derivation.hpp"

int main() {
  namespace codegen = magicmass::codegen;
  const auto theorems = magicmass::derivation::derive().theorems;
  const auto groups = codegen::grouped({"alpha_k", "beta_k"});
  const auto header = codegen::specialised_header(groups, "", "examples/generate", {}, theorems);
  std::cout << header.content;
}
