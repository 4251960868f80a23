// SPDX-License-Identifier: GPL-2.0-or-later
// From the command line to an exit code.
#include <csignal>
#include <new>
#include <utility>

#include <fcntl.h>
#include <unistd.h>

#include "answers/errors.hpp"
#include "command/bounded.hpp"
#include "command/command.hpp"
#include "command/destination.hpp"
#include "command/parse.hpp"
#include "command/rows.hpp"

namespace command {
namespace {

using answers::InvalidInput;

/// A message for whatever the action throws.
ExitCode guarded(const std::string& name, const std::function<ExitCode()>& action) {
  try {
    return action();
  } catch (const ClosedPipe&) {
    return ExitCode::done;
  } catch (const InvalidInput& error) {
    return say(error.what(), ExitCode::bad_input);
  } catch (const std::bad_alloc&) {
    return say(name + ": does not fit into memory; a larger --memory-limit may do",
               ExitCode::undecided);
  } catch (const std::logic_error& error) {
    return say(name + ": a bug: " + error.what(), ExitCode::undecided);
  } catch (const std::exception& error) {
    return say(error.what(), ExitCode::undecided);
  }
}

/// Where one was closed, a file would get its number, and what is meant for the terminal: it gets a
/// stream that takes and gives nothing.
void open_standard_streams() {
  for (const int descriptor : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    if (::fcntl(descriptor, F_GETFD) < 0)
      ::open("/dev/null", descriptor == STDIN_FILENO ? O_WRONLY : O_RDONLY);
}

/// Answers rows of the input, written a block at a time.
class RowsAnswered {
public:
  RowsAnswered(const Asked& asked, const CsvReader& reader, Destination& output,
               answers::Names columns, const Tell& tell)
      : command_(*asked.command),
        reader_(reader),
        output_(output),
        format_(answers::format_of(asked.request.format)),
        writer_(format_, std::move(columns), true),
        tell_(tell) {}

  void add(const answers::Rows& rows) {
    answers::Block block;
    if (command_.run_block && format_ != answers::Format::text) block = command_.run_block(rows);
    for (std::size_t row = 0; row < rows.fields.size(); ++row) {
      if (block.answers(row)) {
        if (!alone_.empty()) write_alone();
        writer_.append(text_, block, row);
      } else {
        answer_alone(rows.request(row), reader_.place(rows.fields.size() - 1 - row));
        if (bytes_ > most_bytes) write_alone();
        tell_(done_ + row + 1);
      }
    }
    write_alone();
    tell_(done_ += rows.fields.size());
  }
  void end() {
    write_alone();
    output_.write(writer_.end());
  }

private:
  const Command& command_;
  const CsvReader& reader_;
  Destination& output_;
  answers::Format format_;
  answers::Writer writer_;
  const Tell& tell_;
  std::uint64_t done_ = 0;
  std::vector<answers::Row> alone_ = {};
  std::size_t bytes_ = 0;  // of these
  std::string text_ = {};
  static constexpr std::size_t most_bytes = std::size_t{1} << 20U;

  void answer_alone(const answers::Request& request, const std::string& place) {
    try {
      answers::Table table = command_.run(request).table;
      for (answers::Row& row : table.rows) {
        for (const answers::Cell& cell : row) bytes_ += cell.text.size() + cell.json.size();
        alone_.push_back(std::move(row));
      }
    } catch (const InvalidInput& error) {
      throw InvalidInput(place + error.what());
    } catch (const answers::Undecided& error) {
      throw answers::Undecided(place + error.what());
    }
  }
  void write_alone() {
    output_.write(text_ + writer_.rows(alone_));
    text_.clear();
    alone_.clear();
    bytes_ = 0;
  }
};

/// Each row of the input is a request.
void answer_rows(const Asked& asked, Destination& output, const Tell& tell) {
  constexpr std::size_t rows_at_once = 4096;
  std::vector<std::string> may_be_columns, others;
  for (const Option& option : asked.command->options)
    (option.is_column ? may_be_columns : others).push_back(option.name);
  CsvReader reader(asked.request.text("input"), may_be_columns, others);
  answers::Rows rows{asked.request, reader.columns()};
  answers::Request any_row = asked.request;
  for (const std::string& column : rows.columns)
    if (!any_row.options.insert({column, ""}).second)
      throw InvalidInput(column + ": given twice, as an option and as a column");
  for (const Option& option : asked.command->options)
    if (option.is_required && !any_row.has(option.name))
      throw InvalidInput(reader.place() + "no column " + option.name);
  RowsAnswered answered(asked, reader, output, asked.command->columns(any_row), tell);
  while (reader.read(rows.fields, rows_at_once)) answered.add(rows);
  answered.end();
}

ExitCode answer(const Asked& asked, const Tell& tell) {
  const bool is_folder = asked.request.format == asked.command->folder_format;
  Destination output(is_folder ? "" : asked.request.text("output"), [&] { tell(0); });
  ExitCode code = ExitCode::done;
  if (asked.request.has("input")) {
    answer_rows(asked, output, tell);
  } else {
    const answers::Answer given = asked.command->run(asked.request);
    if (given.stream)
      given.stream([&](std::string_view text) {
        output.write(text);
        if (text.empty()) output.flush();
      });
    else if (given.document.empty())
      output.write(answers::written(given.table, answers::format_of(asked.request.format)));
    else
      output.write(given.document);
    code = given.check_failed   ? ExitCode::check_failed
           : given.is_undecided ? ExitCode::undecided
                                : ExitCode::done;
    if (!given.note.empty()) say(given.note, code);
  }
  output.finish();
  return code;
}

ExitCode run(const Program& program, const std::vector<std::string>& words) {
  const auto parsed = parse(program, words);
  if (const auto* text = std::get_if<std::string>(&parsed)) {
    Destination output("", [] {});
    output.write(*text);
    output.finish();
    return ExitCode::done;
  }
  const Asked& asked = std::get<Asked>(parsed);
  const std::string& name = asked.command->name;
  return run_bounded(name, asked.limits, [&](const Tell& tell) {
    return guarded(name, [&] { return answer(asked, tell); });
  });
}

}  // namespace

int run_program(const Program& program, const std::vector<std::string>& words) {
  open_standard_streams();
  std::signal(SIGXFSZ, SIG_IGN);  // a file too large for its limit is refused as on a full disk
  std::signal(SIGPIPE, SIG_IGN);  // a reader that has seen enough is no error: see ClosedPipe
  return static_cast<int>(guarded(program.name, [&] { return run(program, words); }));
}

}  // namespace command
