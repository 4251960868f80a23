// SPDX-License-Identifier: GPL-2.0-or-later
#include "command/demo/demo_report.hpp"

#include <fmt/format.h>

#include "render/wrapping.hpp"

namespace magicmass::command {

void DemoReport::heading(const std::string& text) {
  const std::string line = fmt::format("{}. {}", ++headings_, text);
  output_.write(
      fmt::format("{}{}\n{}\n", headings_ == 1 ? "" : "\n", line, std::string(line.size(), '-')));
  output_.flush();
}

void DemoReport::print(const std::string& text) {
  output_.write(text);
  output_.flush();
}

void DemoReport::check(const std::string& what, bool holds) {
  count_in(holds);
  const std::string verdict = holds ? "ok" : "FAILED";
  const std::size_t used = what.size() + verdict.size();
  const std::string gap(used < render::page_width ? render::page_width - used : 1, ' ');
  const char* colour = holds ? "32" : "31";
  print(what + gap +
        (is_colourful() ? fmt::format("\x1b[{}m{}\x1b[0m", colour, verdict) : verdict) + "\n");
}

}  // namespace magicmass::command
