#include <algorithm>
#include <sstream>

#include "answers/commands.hpp"
#include "command/files.hpp"
#include "magicmass/scenes/scene.hpp"

namespace command {
namespace {

using namespace answers;

std::size_t decimals(const std::string& number) {
  const std::size_t point = number.find('.');
  return point == std::string::npos ? 0 : number.size() - point - 1;
}
std::string with_decimals(const std::string& number, std::size_t digits) {
  return formatted("%." + std::to_string(digits) + "f", std::stod(number));
}

/// To the decimals that are printed; else exactly, but as doubles where ours has decimals.
bool agree(const std::string& printed, const std::string& ours) {
  if (decimals(printed) != 0) return with_decimals(ours, decimals(printed)) == printed;
  const auto left = magicmass::scenes::read_value(printed);
  const auto right = magicmass::scenes::read_value(ours);
  if (decimals(ours) != 0) return left.to_double() == right.to_double();
  return right.exact() != nullptr && left.is(*right.exact());
}

Row compared(const std::string& line) {
  std::istringstream fields(line);
  std::string label, number, printed, question, column, reason;
  for (std::string* field : {&label, &number, &printed, &question, &column})
    std::getline(fields, *field, ',');
  if (!fields) throw std::runtime_error("six fields are allowed");
  std::getline(fields, reason);
  const auto cells = answer_to(question);
  if (!cells.contains(column)) throw std::runtime_error("no column " + column);
  const std::string& ours = cells.at(column);
  const auto other = cells.find(printed);  // b_t, which is c_t
  const bool agrees = other != cells.end() ? other->second == ours : agree(printed, ours);
  if (agrees && !reason.empty()) throw std::runtime_error("it agrees: no reason is needed");
  std::string verdict = agrees ? "agrees" : "explained";
  if (reason == "cut off" && with_decimals(ours, decimals(printed) + 6).starts_with(printed)) {
    reason = "The digits printed are cut off; those of the other rows are rounded.";
  } else if (reason == "rounded extremum" &&
             agree(printed, answer_to(question + " --decimals 3").at(column))) {
    reason = "The paper's shift is that of the extremum rounded to three decimals.";
  } else if (!agrees) {
    verdict = "differs";
    reason = reason.empty() ? "Nobody knows why: one of the two is wrong."
                            : "The reason given does not hold: " + reason + ".";
  }
  return {text_cell(label),   text_cell(number),
          text_cell(printed), text_cell(ours),
          text_cell(verdict), reason.empty() ? missing_cell() : text_cell(reason)};
}

/// A heading and a narrow table for each label, and under it why numbers differ.
std::string sections_of(const Table& all, bool is_markdown) {
  std::string text;
  for (auto first = all.rows.begin(); first != all.rows.end();) {
    const std::string label = first->front().text;
    const auto last = std::find_if(first, all.rows.end(),
                                   [&](const Row& row) { return row.front().text != label; });
    const Table its{all.columns, {first, last}};
    const std::string kind = label[0] == 't' ? "Table " : label[0] == 'f' ? "Figure " : "Equation ";
    const Table shown = selected(its, {"number", "printed", "ours", "verdict"});
    text += section(kind + label, shown, is_markdown);
    std::set<std::string> said{""};
    for (; first != last; ++first)
      if (said.insert(first->back().text).second) text += "\n" + first->back().text + "\n";
  }
  return text;
}

}  // namespace

Table comparisons(std::string_view paper_numbers) {
  std::istringstream lines{std::string(paper_numbers)};
  Table all{{"label", "number", "printed", "ours", "verdict", "reason"}, {}};
  bool is_header = true;
  for (std::string line; std::getline(lines, line);) {
    if (line.empty() || line.front() == '#' || std::exchange(is_header, false)) continue;
    all.rows.push_back(with_place<std::exception, std::runtime_error>(
        "paper_numbers.csv: " + line + ": ", [&] { return compared(line); }));
  }
  return all;
}

Answer page_of(const Table& comparisons, const std::string& format) {
  const auto count = [&](const std::string& which) {
    return std::ranges::count(comparisons.rows, which, [](const Row& row) { return row[4].text; });
  };
  Answer answer{.table = comparisons, .check_failed = count("differs") > 0};
  if (format == "text" || format == "markdown")
    answer.document = std::to_string(comparisons.rows.size()) +
                      " numbers of the paper: " + std::to_string(count("agrees")) + " agree, " +
                      std::to_string(count("explained")) + " differ for the reason given, " +
                      std::to_string(count("differs")) +
                      " without one\nHeadings are labels of its LaTeX source.\n" +
                      sections_of(comparisons, format == "markdown");
  return answer;
}

}  // namespace command
