// Tables of tests.
#pragma once

#include <fstream>
#include <iterator>
#include <sstream>
#include <vector>

#include "catch.hpp"

inline std::string contents_of(const std::string& file) {
  std::ifstream in(file);
  INFO(file);
  REQUIRE(in);
  return {std::istreambuf_iterator<char>(in), {}};
}
/// Of a file in tests: a row a line but comments (#), of so many fields between tabs; enough rows.
inline std::vector<std::vector<std::string>> rows_of(const std::string& file, std::size_t columns,
                                                     std::size_t least = 1) {
  std::ifstream in(MAGICMASS_SOURCE "/tests/" + file);
  std::vector<std::vector<std::string>> rows;
  for (std::string line; std::getline(in, line);) {
    if (line.starts_with('#')) continue;
    std::istringstream fields(line);
    for (std::string& field : rows.emplace_back(columns)) std::getline(fields, field, '\t');
  }
  INFO(file);
  REQUIRE(rows.size() >= least);
  return rows;
}
