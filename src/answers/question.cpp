// SPDX-License-Identifier: GPL-2.0-or-later
#include "answers/question.hpp"

#include <sstream>

#include "answers/errors.hpp"
#include "answers/paper.hpp"
#include "answers/velocities.hpp"

namespace answers {

std::map<std::string, std::string> answer_to(const std::string& question) {
  static const std::map<std::string, Answer (*)(const Request&)> commands{
      {"angle", angle},       {"count", count},   {"eval", eval},
      {"extremum", extremum}, {"ratios", ratios}, {"terminal", terminal},
  };
  std::istringstream words(question);
  std::string command, option, value;
  words >> command;
  Request request;
  while (words >> option >> value) request.options.emplace(option.erase(0, 2), value);
  const auto found = commands.find(command);
  if (found == commands.end())
    throw InvalidInput("no numbers answer \"" + question +
                       "\"; allowed: angle, count, eval, extremum, ratios, terminal");
  const Table table = found->second(request).table;
  std::map<std::string, std::string> cells;
  for (std::size_t i = 0; i < table.columns.size(); ++i)
    cells.emplace(table.columns[i], table.rows.back()[i].text);
  return cells;
}

}  // namespace answers
