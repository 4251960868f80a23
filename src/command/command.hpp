// A command is a row of a table: it feeds the parser, help, and what runs it.
#pragma once

#include "answers/request.hpp"

namespace command {

enum class ExitCode { done = 0, check_failed = 1, bad_input = 2, undecided = 3 };

constexpr std::int64_t no_limit = 1'000'000'000;  // seconds

struct Limits {
  std::int64_t seconds = 30;
  std::int64_t mebibytes = 1024;
};

/// --name VALUE, or a flag.
struct Option {
  std::string name;                       ///< without dashes
  std::string value;                      ///< how help calls it; "" for a flag
  std::string words;                      ///< what it does
  std::vector<std::string> choices = {};  ///< what is allowed, if not everything
  bool is_required = false;
  bool is_column = false;   ///< may be a column of --input, which commands with such an option have
  std::string symbol = {};  ///< of the paper, which is no column's name
};

struct Command {
  std::string name;
  std::string summary;
  std::string example;  ///< a line to try, with which help begins
  std::vector<Option> options = {};
  std::string words = {};  ///< how help calls the words that no option takes; "" for none
  std::vector<std::string> formats = {"text", "json", "csv"};  ///< the first unless told otherwise
  std::function<answers::Answer(const answers::Request&)> run;
  /// The same answers for many rows of --input, which may be none, and in any case their columns;
  /// rows without an answer are handed to `run`.
  std::function<answers::Block(const answers::Rows&)> run_block = {};
  Limits limits = {};              ///< unless told otherwise
  std::string folder_format = {};  ///< that is a folder of files, which `run` writes to --output
  bool takes_formulas = false;     ///< its words may begin with a minus sign
  std::map<std::string, Limits> limits_of = {};  ///< with this option, or this first word
};

/// The program: all that differs between magicmass and a test's.
struct Program {
  std::string name;
  std::string summary;
  std::string version;
  std::vector<Command> commands;
};

Program magicmass();
/// Answers the command line; returns the exit code.
int run_program(const Program& program, const std::vector<std::string>& words);

struct Asked {
  const Command* command = nullptr;
  answers::Request request;  ///< with what all commands share: input, output
  Limits limits;             ///< --time-limit, --memory-limit
};

/// What was asked, or the text of --help or --version. Throws answers::InvalidInput for all else.
std::variant<Asked, std::string> parse(const Program& program, std::vector<std::string> words);

/// Tells how many rows are done; 0: output begins, so that the terminal's progress line goes.
using Tell = std::function<void(std::uint64_t rows)>;

/// Runs the action in a child with these limits and returns its exit code. Where that was late, out
/// of memory or crashed, says so after `name`, with the rows done and what would do, and returns
/// ExitCode::undecided. After a second a terminal on stderr shows how long it has been. Ends by the
/// signal that ended the child, where that was the user's.
ExitCode run_bounded(const std::string& name, const Limits& limits,
                     const std::function<ExitCode(const Tell&)>& action);

/// One line on stderr, whatever the message holds.
ExitCode say(const std::string& message, ExitCode code);

}  // namespace command
