// SPDX-License-Identifier: GPL-2.0-or-later
// Writes the evaluators of the tests' quantities into a folder.
#include <filesystem>
#include <fstream>
#include <iostream>

#include "codegen/generate.hpp"
#include "quantities.hpp"

int main(int count, char** arguments) {
  if (count != 2) return 2;
  const std::filesystem::path folder = arguments[1];
  try {
    const std::vector<codegen::Quantity>& all = test::quantities();
    for (const auto& [path, text] :
         codegen::generate(all, {{all[0], "product"}, {all[1], "product"}})) {
      std::filesystem::create_directories((folder / path).parent_path());
      std::ofstream(folder / path) << text;
    }
  } catch (const std::exception& e) {
    std::cerr << e.what() << '\n';
    return 1;
  }
}
