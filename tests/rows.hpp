// Tables of tests.
#pragma once

#include <fstream>
#include <sstream>
#include <string>
#include <vector>

/// Of a file in tests: a row a line but comments (#), of so many fields, with tabs between them.
inline std::vector<std::vector<std::string>> rows_of(const std::string& file, std::size_t columns) {
  std::ifstream in(MAGICMASS_SOURCE "/tests/" + file);
  std::vector<std::vector<std::string>> rows;
  for (std::string line; std::getline(in, line);) {
    if (line.starts_with('#')) continue;
    std::istringstream fields(line);
    for (std::string& field : rows.emplace_back(columns)) std::getline(fields, field, '\t');
  }
  return rows;
}
