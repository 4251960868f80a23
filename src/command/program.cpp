#include <csignal>
#include <new>

#include <fcntl.h>
#include <unistd.h>

#include "command/command.hpp"
#include "command/streams.hpp"

namespace command {
namespace {

using answers::InvalidInput;

/// A message for whatever the action throws, after the place where it was.
ExitCode guarded(const std::string& name, const std::string& place,
                 const std::function<ExitCode()>& action) try {
  return action();
} catch (const ClosedPipe&) {
  return ExitCode::done;
} catch (const InvalidInput& error) {
  return say(place + error.what(), ExitCode::bad_input);
} catch (const std::bad_alloc&) {
  return say(name + ": does not fit into memory; a larger --memory-limit may do",
             ExitCode::undecided);
} catch (const std::logic_error& error) {
  return say(name + ": a bug: " + error.what(), ExitCode::undecided);
} catch (const std::exception& error) {
  return say(place + error.what(), ExitCode::undecided);
}

/// Of rows of the input, written a block at a time.
void write_answers(const Asked& asked, CsvReader& reader, answers::Rows rows, Destination& output,
                   const Tell& tell, std::string& place) {
  constexpr std::size_t rows_at_once = 1024;
  constexpr std::size_t most_bytes = std::size_t{1} << 20U;
  const Command& command = *asked.command;
  const answers::Format format = answers::format_of(asked.request.format);
  answers::Writer writer(format, command.run_block(rows).names, true);
  std::uint64_t done = 0;
  std::string text;
  std::vector<answers::Row> alone;  // to follow the text
  std::size_t bytes = 0;            // of these
  const auto write = [&] {
    output.write(text);
    output.write(writer.rows(alone));
    text.clear();
    alone.clear();
    bytes = 0;
  };
  while (reader.read(rows.fields, rows_at_once)) {
    answers::Block block;
    const bool shows_widths = format == answers::Format::text && done == 0;
    if (!shows_widths) block = command.run_block(rows);
    const std::size_t size = rows.fields.size();
    for (std::size_t row = 0; row < size; ++row) {
      if (block.answers(row)) {
        if (!alone.empty()) write();
        writer.append(text, block, row);
        continue;
      }
      place = reader.position(size - 1 - row);
      for (auto& cells : command.run(rows.request(row)).table.rows) {
        for (const answers::Cell& cell : cells) bytes += cell.text.size() + cell.json.size();
        alone.push_back(std::move(cells));
      }
      place.clear();
      if (bytes > most_bytes) write();
      tell(done + row + 1);
    }
    write();
    if (reader.waits()) output.flush();
    tell(done += size);
  }
  output.write(writer.rows({}) + writer.end());
}

/// Each row of the input is a request.
void answer_rows(const Asked& asked, Destination& output, const Tell& tell, std::string& place) {
  std::vector<std::string> may_be_columns;
  std::map<std::string, std::string> others;
  for (const Option& option : asked.command->options) {
    if (option.is_column) may_be_columns.push_back(option.name);
    if (!option.symbol.empty()) others[option.symbol] = "; is " + option.name + " meant?";
    if (!option.is_column)
      others[option.name] = ": not a column but one option for all rows, --" + option.name;
  }
  CsvReader reader(asked.request.text("input"), may_be_columns, others);
  const answers::Rows rows{asked.request, reader.columns()};
  answers::Request any_row = asked.request;
  for (const std::string& column : rows.columns)
    if (!any_row.options.insert({column, ""}).second)
      throw InvalidInput(column + ": given twice, as an option and as a column");
  for (const Option& option : asked.command->options)
    if (option.is_required && !any_row.has(option.name))
      throw InvalidInput(reader.position() + "no column " + option.name);
  write_answers(asked, reader, rows, output, tell, place);
}

ExitCode answer(const Asked& asked, const Tell& tell, std::string& place) {
  const answers::Format format = answers::format_of(asked.request.format);
  const bool is_folder = asked.request.format == asked.command->folder_format;
  Destination output(is_folder ? "" : asked.request.text("output"), [&] { tell(0); });
  ExitCode code = ExitCode::done;
  if (asked.request.has("input")) {
    answer_rows(asked, output, tell, place);
  } else {
    const answers::Answer given = asked.command->run(asked.request);
    if (given.stream)
      given.stream([&](std::string_view text) {
        output.write(text);
        if (text.empty()) output.flush();
      });
    else
      output.write(given.document.empty() ? answers::written(given.table, format) : given.document);
    if (given.is_undecided) code = ExitCode::undecided;
    if (given.check_failed) code = ExitCode::check_failed;
    if (!given.note.empty()) say(given.note, code);
  }
  output.finish();
  return code;
}

}  // namespace

int run_program(const Program& program, const std::vector<std::string>& words) {
  // Where one was closed, a file would get its number, and what is meant for the terminal.
  for (const int descriptor : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    if (::fcntl(descriptor, F_GETFD) < 0)
      ::open("/dev/null", descriptor == STDIN_FILENO ? O_WRONLY : O_RDONLY);  // which is refused
  std::signal(SIGXFSZ, SIG_IGN);  // a file too large for its limit is refused as on a full disk
  std::signal(SIGPIPE, SIG_IGN);  // a reader that has seen enough is no error: see ClosedPipe
  return static_cast<int>(guarded(program.name, "", [&] {
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
      std::string place;  // of the row of input
      return guarded(name, place, [&] { return answer(asked, tell, place); });
    });
  }));
}

}  // namespace command
