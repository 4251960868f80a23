// CLI11 writes help. It would read some words in ways that surprise: 010 as 8, -x as an option.
#include <algorithm>
#include <memory>
#include <sstream>

#include <CLI/CLI.hpp>

#include "command/command.hpp"
#include "magicmass/scenes/scene.hpp"

namespace command {
namespace {

using namespace answers;

/// The command's own options and those that all share.
std::vector<Option> options_of(const Command& command) {
  std::vector<Option> options = command.options;
  std::vector<std::string> columns;
  for (const Option& option : command.options)
    if (option.is_column) columns.push_back(option.name);
  if (!columns.empty())
    options.push_back(
        {"input", "FILE", "CSV of " + joined(columns) + ", others skipped; - is stdin"});
  options.push_back({"format", "FORMAT", joined(command.formats), command.formats});
  options.push_back({"output", "FILE", "write to FILE, whole or not at all; - is stdout"});
  std::string others;
  for (const auto& [word, limits] : command.limits_of)
    others +=
        "\n" + word + ": " + (limits.seconds == no_limit ? "none" : std::to_string(limits.seconds));
  options.push_back({"time-limit", "SECONDS",
                     "give up after so long, " + std::to_string(command.limits.seconds) +
                         " unless told otherwise" + others});
  options.push_back({"memory-limit", "MIB",
                     "at most so much memory, " + std::to_string(command.limits.mebibytes) +
                         " unless told otherwise"});
  return options;
}

class Formatter : public CLI::Formatter {
public:
  std::string make_subcommand(const CLI::App* app) const override {
    std::ostringstream text;
    CLI::detail::format_help(text, app->get_name(), app->get_description(), 14);
    return text.str();
  }

  std::string make_option_opts(const CLI::Option* option) const override {
    return option->get_type_size() == 0 ? "" : " " + option->get_type_name();
  }
};

/// Versions of CLI11 differ in empty lines at the end.
std::string help_of(const CLI::App& app) {
  std::string text = app.help();
  while (text.size() > 1 && text[text.size() - 2] == '\n') text.pop_back();
  return text;
}

/// Options by name, and what else there is. An option takes the next word, though it begin with a
/// minus sign (not with two); so may formulas, and what follows "--".
Request request_of(const Command& command, const std::vector<Option>& options,
                   const std::vector<std::string>& words, const std::string& help) {
  Request request;
  const auto refuse = [&](const std::string& word) {
    throw InvalidInput(command.name + ": no such option or word: " + shown_text(word) + "; see " +
                       help);
  };
  const auto end = std::ranges::find(words, "--");
  for (auto at = words.begin(); at != end; ++at) {
    const std::string word = *at == "-o" ? "--output" : *at;
    const std::size_t equals = word.find('=');
    const auto option = std::ranges::find(options, word.substr(0, equals),
                                          [](const Option& known) { return "--" + known.name; });
    if (word.starts_with("-o="))
      throw InvalidInput("-o= is not an option; allowed: -o FILE and --output=FILE");
    if (option == options.end()) {
      if (word != "-" && word.starts_with(command.takes_formulas ? "--" : "-")) refuse(word);
      request.words.push_back(word);
      continue;
    }
    const bool takes_value = !option->value.empty();
    const bool is_apart = equals == std::string::npos;
    if (!takes_value && !is_apart) throw InvalidInput("--" + option->name + " takes no value");
    std::string value = is_apart ? "" : word.substr(equals + 1);
    if (takes_value && is_apart && at + 1 != end) value = *++at;
    if (takes_value && (value.empty() || (is_apart && value.starts_with("--"))))
      throw InvalidInput("--" + option->name + " has no value; write --" + option->name + " " +
                         option->value + ": " + option->words.substr(0, option->words.find('\n')));
    if (!request.options.emplace(option->name, value).second)
      throw InvalidInput(command.name + ": --" + option->name + ": given twice");
  }
  if (end != words.end()) request.words.insert(request.words.end(), end + 1, words.end());
  if (command.words.empty() && !request.words.empty()) refuse(request.words[0]);
  return request;
}

Asked asked_for(const Command& command, const std::vector<Option>& options, Request request) {
  Limits usual = command.limits;
  for (const auto& [word, limits] : command.limits_of)
    if (request.has(word) || (!request.words.empty() && request.words[0] == word)) usual = limits;
  request.format = request.has("format") ? request.text("format") : command.formats.front();
  for (const Option& option : options) {
    const std::string value = request.text(option.name);
    const bool is_given = request.has(option.name);
    if (is_given && !option.choices.empty() && std::ranges::count(option.choices, value) == 0)
      throw InvalidInput(command.name + ": unknown " + option.name + " " + shown_text(value) +
                         "; allowed: " + joined(option.choices));
    if (option.is_required && !is_given && !(request.has("input") && option.is_column))
      throw InvalidInput(command.name + ": --" + option.name +
                         " is missing; example: " + command.example);
  }
  const Limits limits{request.whole("time-limit", 1, no_limit).value_or(usual.seconds),
                      request.whole("memory-limit", 16, 1'000'000'000).value_or(usual.mebibytes)};
  return {&command, std::move(request), limits};
}

void describe(CLI::App& app, const std::string& name, const std::string& summary,
              const std::string& example) {
  const auto formatter = std::make_shared<Formatter>();
  formatter->column_width(26);
  app.name(name);
  app.description("Example:\n  " + example + "\n\n" + summary + ".\n");
  app.formatter(formatter);
}

std::string help_of(const Program& program) {
  CLI::App app;
  describe(app, program.name, program.summary, program.commands.front().example);
  app.set_version_flag("--version", program.version, "print the version");
  app.footer(program.name +
             " COMMAND --help explains a command. Exit codes: 0 done,\n"
             "1 a check failed, 2 bad usage or input, 3 undecided or does not fit.");
  for (const Command& command : program.commands) app.add_subcommand(command.name, command.summary);
  return help_of(app);
}

std::string help_of(const std::string& name, const Command& command,
                    const std::vector<Option>& options) {
  CLI::App app;
  describe(app, name, command.summary, command.example);
  for (const Option& option : options) {
    const std::string names = (option.name == "output" ? "-o,--" : "--") + option.name;
    if (option.value.empty())
      app.add_flag(names, option.words);
    else
      app.add_option(names, option.words)->type_name(option.value);
  }
  std::vector<std::string> words;
  if (!command.words.empty()) app.add_option("words", words, command.words)->type_name("");
  return help_of(app);
}

}  // namespace

std::variant<Asked, std::string> parse(const Program& program, std::vector<std::string> words) {
  if (words.empty()) throw InvalidInput("no command; see " + program.name + " --help");
  const std::string first = words.front();
  words.erase(words.begin());
  if (first == "--help" || first == "-h") return help_of(program);
  if (first == "--version") return program.name + " " + program.version + "\n";
  const auto found = std::ranges::find(program.commands, first, &Command::name);
  if (found == program.commands.end())
    throw InvalidInput("unknown command " + shown_text(first) +
                       magicmass::scenes::meant(first, texts_of(program.commands, &Command::name),
                                                "; see " + program.name + " --help"));
  const Command& command = *found;
  const std::vector<Option> options = options_of(command);
  const std::string full_name = program.name + " " + command.name;
  if (std::ranges::count(words, "--help") + std::ranges::count(words, "-h") > 0)
    return help_of(full_name, command, options);
  return asked_for(command, options, request_of(command, options, words, full_name + " --help"));
}

}  // namespace command
