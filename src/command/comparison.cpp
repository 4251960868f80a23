// SPDX-License-Identifier: GPL-2.0-or-later
#include "command/comparison.hpp"

#include <array>
#include <charconv>
#include <sstream>
#include <stdexcept>

#include "answers/question.hpp"

namespace command {
namespace {

using answers::answer_to;

Comparison paper_number(const std::string& line) {
  std::istringstream fields(line);
  Comparison row;
  for (std::string* field : {&row.label, &row.number, &row.printed, &row.question, &row.column})
    std::getline(fields, *field, ',');
  if (!fields) throw std::runtime_error("six fields are allowed");
  std::getline(fields, row.reason);
  return row;
}

std::size_t decimals(const std::string& number) {
  const std::size_t point = number.find('.');
  return point == std::string::npos ? 0 : number.size() - point - 1;
}
std::string with_decimals(const std::string& number, std::size_t digits) {
  std::array<char, 64> text{};
  char* const end = std::to_chars(text.data(), text.data() + text.size(), std::stod(number),
                                  std::chars_format::fixed, static_cast<int>(digits))
                        .ptr;
  return {text.data(), end};
}

bool agree(const std::string& printed, const std::string& ours) {
  if (decimals(printed) != 0) return with_decimals(ours, decimals(printed)) == printed;
  return answers::are_equal(printed, ours);
}

/// Why a number of the paper differs; "" where the reason given is none or does not hold.
std::string explanation(const Comparison& row) {
  const auto with_three_decimals = [&] {
    return answer_to(row.question + " --decimals 3").at(row.column);
  };
  if (row.reason == "cut off" &&
      with_decimals(row.ours, decimals(row.printed) + 6).starts_with(row.printed))
    return "The digits printed are cut off; those of the other rows are rounded.";
  if (row.reason == "rounded extremum" && agree(row.printed, with_three_decimals()))
    return "The paper's shift is that of the extremum rounded to three decimals.";
  return "";
}

Comparison compared(Comparison row) {
  const auto cells = answer_to(row.question);
  const auto ours = cells.find(row.column);
  if (ours == cells.end()) throw std::runtime_error("no column " + row.column);
  row.ours = ours->second;
  const auto other = cells.find(row.printed);  // b_t, which is c_t
  row.agrees = other != cells.end() ? other->second == row.ours : agree(row.printed, row.ours);
  if (row.agrees && row.reason.empty()) return row;
  const std::string why = explanation(row);
  row.is_fine = !row.agrees && !why.empty();
  row.reason = row.agrees           ? "It agrees: no reason is needed."
               : row.reason.empty() ? "Nobody knows why: one of the two is wrong."
               : row.is_fine        ? why
                                    : "The reason given does not hold: " + row.reason + ".";
  return row;
}

}  // namespace

std::vector<Comparison> comparisons(std::string_view paper_numbers) {
  std::istringstream lines{std::string(paper_numbers)};
  std::vector<Comparison> all;
  bool is_header = true;
  for (std::string line; std::getline(lines, line);) {
    if (line.empty() || line.front() == '#') continue;
    try {
      if (!is_header) all.push_back(compared(paper_number(line)));
    } catch (const std::exception& error) {
      throw std::runtime_error("paper_numbers.csv: " + line + ": " + error.what());
    }
    is_header = false;
  }
  return all;
}

}  // namespace command
