// SPDX-License-Identifier: GPL-2.0-or-later
#include "command/manual/manual_page.hpp"

#include <algorithm>
#include <cctype>
#include <sstream>

#include <fmt/format.h>

namespace magicmass::command {
namespace {

/// Text that troff prints as it is: its own signs escaped, and no line taken for a request.
std::string plain(const std::string& text) {
  std::string page = text.starts_with('.') || text.starts_with('\'') ? "\\&" : "";
  for (const char character : text) {
    switch (character) {
      case '\\':
        page += "\\(rs";
        break;
      case '-':
        page += "\\-";
        break;
      case '^':
        page += "\\(ha";
        break;
      case '~':
        page += "\\(ti";
        break;
      case '`':
        page += "\\(ga";
        break;
      case '\'':
        page += "\\(aq";
        break;
      default:
        page += character;
    }
  }
  return page;
}

std::string bold(const std::string& text) { return "\\fB" + plain(text) + "\\fR"; }
std::string italic(const std::string& text) { return "\\fI" + plain(text) + "\\fR"; }

std::string hyphened(std::string name) {
  std::replace(name.begin(), name.end(), ' ', '-');
  return name;
}

std::string argument(const OptionText& text) {
  const std::string name = italic(text.names.front());
  return text.is_required ? name : "[" + name + "]";
}

std::string synopsis(const CommandText& command) {
  std::string line = bold(command.name) + " [" + italic("OPTION") + "]...";
  for (const OptionText& text : command.arguments) line += " " + argument(text);
  if (!command.commands.empty()) line += " " + italic("COMMAND");
  return ".SH SYNOPSIS\n" + line + "\n";
}

std::string page_names(const OptionText& option) {
  std::string line;
  for (const std::string& name : option.names) line += (line.empty() ? "" : ", ") + bold(name);
  return option.value.empty() ? line : line + " " + italic(option.value);
}

std::string entry(const std::string& head, const std::string& words) {
  return ".TP\n" + head + "\n" + plain(words) + "\n";
}

std::string lines_as_they_are(const std::string& title, const std::vector<std::string>& lines) {
  std::string page = ".SH " + title + "\n.nf\n";
  for (const std::string& line : lines) page += plain(line) + "\n";
  return page + ".fi\n";
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

std::string see_also(const CommandText& command) {
  std::string line;
  const std::size_t parent = command.name.rfind(' ');
  if (parent != std::string::npos) line = bold(hyphened(command.name.substr(0, parent))) + "(1)";
  for (const CommandText& below : command.commands)
    if (!below.is_hidden) line += (line.empty() ? "" : ",\n") + bold(hyphened(below.name)) + "(1)";
  return line.empty() ? "" : ".SH SEE ALSO\n" + line + "\n";
}

}  // namespace

std::string manual_page_name(const CommandText& command) { return hyphened(command.name) + ".1"; }

std::string manual_page(const CommandText& command, const std::string& version) {
  std::string title = hyphened(command.name);
  for (char& letter : title)
    letter = static_cast<char>(std::toupper(static_cast<unsigned char>(letter)));
  std::string page = fmt::format(
      ".\\\" SPDX-License-Identifier: GPL-2.0-or-later\n"
      ".\\\" Written by `magicmass manual` from the command line itself.\n"
      ".TH {} 1 \"\" \"{}\" \"magicmass\"\n.SH NAME\n{} \\- {}\n",
      plain(title), version, plain(hyphened(command.name)), plain(command.summary));
  page += synopsis(command) + lines_as_they_are("EXAMPLES", command.examples);
  if (!command.arguments.empty()) page += ".SH ARGUMENTS\n";
  for (const OptionText& text : command.arguments)
    page += entry(italic(text.names.front()), text.words);
  page += ".SH OPTIONS\n";
  for (const OptionText& option : command.options) page += entry(page_names(option), option.words);
  if (!command.commands.empty()) page += ".SH COMMANDS\n";
  for (const CommandText& below : command.commands)
    if (!below.is_hidden) page += entry(bold(below.last_word()), below.summary);
  return page + lines_as_they_are("NOTES", lines_of(command.notes)) + see_also(command);
}

}  // namespace magicmass::command
