// SPDX-License-Identifier: GPL-2.0-or-later
// Error bounds as they are printed for a reader, read back and evaluated.
#pragma once

#include <algorithm>
#include <cmath>
#include <map>
#include <regex>
#include <sstream>
#include <string>

namespace test {
using Printed = std::map<std::string, std::string>;

/// "2^-73.7 |P| + 2^-147.4" with the sizes of values at a point; an unnamed one is that of the
/// value itself.
double evaluated(const std::string& bound, const auto& values, double own) {
  std::istringstream words(bound + " +");
  double sum = 0;
  double product = 1;
  for (std::string word; words >> word;) {
    if (word == "+") {
      sum += product;
      product = 1;
    } else if (word[0] != '|') {
      product *= word == "0" ? 0 : std::exp2(std::stod(word.substr(2)));
    } else {
      const auto found = values.find(word.substr(1, word.size() - 2));
      product *= found == values.end() ? own : found->second.size;
    }
  }
  return sum;
}
/// The bounds below a heading: "STEP plus", "OUTPUT a", "SIGN distance". A
/// value that is another, unnamed one times a power of 2 has bounds in terms of
/// that one's size: by both steps, a share.
inline Printed bounds_in(const std::string& errors, const std::string& heading) {
  Printed r;
  const std::size_t from = errors.find(heading + "\n");
  std::istringstream lines(errors.substr(from, errors.find("\n\n", from) - from));
  static const std::regex single("2\\^(\\S+) \\|(t[0-9]+)\\|");
  std::smatch term;
  std::map<std::string, std::string> shares;
  std::map<std::string, double> exponents;
  for (std::string line; std::getline(lines, line);) {
    const std::size_t colon = line.find(": ");  // a line may be too long for std::regex
    if (!line.starts_with("  ") || colon == std::string::npos) continue;
    const std::string name = line.substr(2, colon - 2);
    const bool is_step = name.find(' ') == std::string::npos;
    if (!is_step && !name.starts_with("OUTPUT ") && !name.starts_with("SIGN ")) continue;
    std::string text = line.substr(colon + 2);
    text.erase(std::min(text.find(';'), text.size()));
    if (text.starts_with("off by ")) text.erase(0, 7);
    if (text.size() < 100 && std::regex_match(text, term, single)) {
      const double exponent = std::stod(term[1]);
      if (is_step) {
        const double share = exponents.insert({term[2], exponent}).first->second - exponent;
        shares[term[2]] = "2^" + std::to_string(share) + " ";
      }
      text = shares[term[2]] + text;
    }
    r[(is_step ? "STEP " : "") + name] = text;
  }
  return r;
}
}  // namespace test
