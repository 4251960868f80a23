// SPDX-License-Identifier: GPL-2.0-or-later
// Error bounds as they are printed for a reader, read back and evaluated.
#pragma once

#include <cmath>
#include <map>
#include <regex>
#include <sstream>
#include <string>

namespace test {
using Printed = std::map<std::string, std::string>;

/// "2^-73.7 |P| + 2^-147.4" with the sizes at a point; an unnamed one is that
/// of the value itself.
inline double evaluated(const std::string& bound, const std::map<std::string, double>& sizes,
                        double own) {
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
      const auto found = sizes.find(word.substr(1, word.size() - 2));
      product *= found == sizes.end() ? own : found->second;
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
  static const std::regex bound("  (OUTPUT |SIGN |)([^ :]+): (?:off by )?([^;]*).*");
  static const std::regex single("2\\^(\\S+) \\|(t[0-9]+)\\|");
  std::smatch part, term;
  std::map<std::string, std::string> shares;
  std::map<std::string, double> exponents;
  for (std::string line; std::getline(lines, line);) {
    if (!std::regex_match(line, part, bound)) continue;
    const std::string kind = part[1] == "" ? "STEP " : part.str(1);
    std::string text = part[3];
    if (std::regex_match(text, term, single)) {
      const double exponent = std::stod(term[1]);
      if (kind == "STEP ") {
        const double share = exponents.insert({term[2], exponent}).first->second - exponent;
        shares[term[2]] = "2^" + std::to_string(share) + " ";
      }
      text = shares[term[2]] + text;
    }
    r[kind + part.str(2)] = text;
  }
  return r;
}
}  // namespace test
