// Writes generated/ from the theorems; links no numbers, so it runs while generated/ is stale.
#include <cstdio>
#include <exception>

#include "generate/quantities.hpp"

int main(int count, char** words) {
  if (count != 2 || words[1][0] == '-') {
    std::fputs("Usage: magicmass_generate FOLDER\n", stderr);
    return 2;
  }
  try {
    generate::write(words[1], generate::generated());
    return 0;
  } catch (const std::exception& problem) {
    std::fprintf(stderr, "magicmass_generate: %s\n", problem.what());
    return 1;
  }
}
