// SPDX-License-Identifier: GPL-2.0-or-later
// What `magicmass generate --out DIR` does, in a program that includes nothing of what it writes: it builds where
// generated/ is stale, or is not there.
#include <cstdio>
#include <cstring>
#include <exception>

#include "codegen/generate.hpp"
#include "command/generated_tree.hpp"
#include "command/leftover.hpp"
#include "derivation/derivation.hpp"
#include "magicmass/errors.hpp"

using namespace magicmass;

int main(int arguments, char** values) {
  if (arguments != 3 || std::strcmp(values[1], "--out") != 0) {
    std::fputs("Example: magicmass_generator --out generated\n", stderr);
    return 2;
  }
  command::remove_leftovers_on_signals();
  try {
    const derivation::Derivation derivation = derivation::derive();
    if (derivation.refused) {
      std::fprintf(stderr, "magicmass_generator: not proved: %s\n", derivation.refused->what());
      return 1;
    }
    command::write_tree(values[2], codegen::generate(derivation.theorems));
    return 0;
  } catch (const InvalidInput& error) {
    std::fprintf(stderr, "magicmass_generator: %s\n", error.what());
    return 2;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "magicmass_generator: %s\n", error.what());
    return 1;
  }
}
