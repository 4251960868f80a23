// SPDX-License-Identifier: GPL-2.0-or-later
#include "command/program.hpp"

#include <memory>
#include <sstream>
#include <utility>

#include "magicmass/scenes/shown_text.hpp"

namespace magicmass::command {
namespace {

/// A description is the summary, a line feed, and the examples; help shows the examples first.
class ExampleFirst : public CLI::Formatter {
public:
  std::string make_description(const CLI::App* app) const override {
    const std::string description = app->get_description();
    const std::size_t end = description.find('\n');
    return "Example:" + description.substr(end) + "\n\n" + description.substr(0, end) + ".\n\n";
  }

  std::string make_subcommand(const CLI::App* command) const override {
    const std::string description = command->get_description();
    std::ostringstream text;
    CLI::detail::format_help(text, command->get_name(),
                             description.substr(0, description.find('\n')), 14);
    return text.str();
  }

  std::string make_option_opts(const CLI::Option* option) const override {
    const bool takes_value = option->get_type_size() != 0 && option->get_option_text().empty();
    const std::string type = option->get_type_name();  // NAME:{choices}, which the words tell
    return takes_value ? " " + type.substr(0, type.find(":{"))
                       : CLI::Formatter::make_option_opts(option);
  }
};

}  // namespace

CLI::App& add_command(Program& program, const std::string& name, const std::string& summary,
                      const std::string& example) {
  return *program.app.add_subcommand(name, summary + "\n  " + example);
}

void on_run(Program& program, CLI::App& command, std::function<ExitCode()> action) {
  command.callback([&program, action = std::move(action)] { program.action = action; });
}

void offer(CLI::Option& option, const std::vector<std::string>& values) {
  std::string list;
  for (const std::string& value : values) list += (list.empty() ? "" : ",") + value;
  option.check(CLI::Validator("{" + list + "}"));
}

void treat_values_alike(CLI::App& app) {
  for (CLI::App* command : app.get_subcommands([](CLI::App*) { return true; }))
    treat_values_alike(*command);
  for (CLI::Option* option : app.get_options()) {
    const std::string type = option->get_type_name();
    const auto begins = [&](const std::string& start) { return type.rfind(start, 0) == 0; };
    if (begins("FILE") || begins("DIR") || begins("FOLDER"))
      option->check([is_file = begins("FILE")](const std::string& name) {
        return std::string(!name.empty() ? "" : is_file ? "no file name" : "no folder name");
      });
    for (const char* const number : {"N", "D", "K", "NUMBER"})
      if (type.substr(0, type.find(':')) == number)
        option->transform(CLI::Validator(
            [](std::string& text) -> std::string {
              if (text.find_first_of("+ \t") != std::string::npos || text.find("0x") < 2 ||
                  text.find("0X") < 2)
                return shown_text(text, 40) + ": not a whole number in decimal digits";
              const std::size_t first = text.find_first_not_of('0');
              if (first != std::string::npos &&
                  text.find_first_not_of("0123456789") == std::string::npos)
                text.erase(0, first);
              return {};
            },
            ""));
  }
}

void describe(Program& program) {
  program.app.name("magicmass");
  program.app.description(
      "Magic mass ratios: from conservation laws to proved, generated, measured C++\n"
      "  magicmass derive --summary\n"
      "  magicmass eval --alpha 1/7 --n 2 --tier exact\n"
      "  magicmass ratios --count 10");
  program.app.footer(
      "magicmass COMMAND --help explains a command. Exit codes: 0 done,\n"
      "1 a check failed, 2 bad usage or input, 3 undecided or does not fit.");
  program.app.set_version_flag("--version", "magicmass " MAGICMASS_VERSION);
  program.app.require_subcommand(1);
  const auto formatter = std::make_shared<ExampleFirst>();
  formatter->column_width(26);
  program.app.formatter(formatter);
}

}  // namespace magicmass::command
