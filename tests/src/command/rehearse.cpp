// A program on the frame of magicmass whose commands do what may go wrong.
#include <chrono>
#include <csignal>
#include <thread>

#include "command/command.hpp"
#include "command/files.hpp"
#include "host/child.hpp"
#include "magicmass/scenes/files.hpp"

namespace {

using namespace answers;

Answer document(const std::string& text) { return {{}, text}; }

const Names echo_columns{"text", "times"};

Answer echo(const Request& request) {
  const auto times = request.whole("times", 1, 99);
  if (request.text("text") == "hard") throw Undecided("hard is not decided");
  const Row row{text_cell(shown_text(request.text("text"))),
                times ? whole_cell(*times) : missing_cell()};
  return {{echo_columns, {row}, false}, ""};
}

Answer many(const Request& request) {
  const auto lines = request.whole("lines", 0, 100'000'000).value_or(0);
  std::string text;
  for (std::int64_t line = 1; line <= lines; ++line) text += std::to_string(line) + "\n";
  return document(text);
}

Answer false_check(const Request&) { return {{}, "not proved\n", true}; }

Answer wait(const Request&) {
  std::this_thread::sleep_for(std::chrono::seconds(60));
  return document("late\n");
}

/// Another program that takes too long, with a folder.
Answer other(const Request&) {
  const host::TemporaryFolder folder("other");
  const std::string script = "touch \"$0\"/file; exec sleep 60";
  return document(host::end_of({"bash", "-c", script, folder.path}).output);
}

Answer fill(const Request&) {
  std::string much;
  much.reserve(std::size_t{4} << 30U);
  return document("it fits\n");
}

std::size_t depth(const std::string& text) {
  const std::string deeper = text + "x";
  return deeper.empty() ? 0 : depth(deeper.substr(0, 8)) + deeper.size();
}

Answer deep(const Request& request) {
  return document(std::to_string(depth(request.format)) + "\n");
}

Answer crash(const Request&) {
  std::raise(SIGABRT);
  return document("alive\n");
}

Answer bug(const Request&) { throw std::logic_error("index past the end"); }

command::Command plain(const std::string& name, Answer (*run)(const Request&),
                       const std::vector<command::Option>& options = {},
                       const std::string& words = "") {
  return {.name = name,
          .summary = "Does what " + name + " does",
          .example = "rehearse " + name,
          .options = options,
          .words = words,
          .formats = {"text"},
          .run = run};
}
/// Numbers of a paper, which may be spoiled.
Answer compare(const Request& request) {
  const std::string numbers = magicmass::scenes::text_of(request.words.at(0));
  return command::page_of(command::comparisons(numbers), "text");
}
Answer words(const Request& request) { return document(joined(request.words) + "\n"); }

}  // namespace

int main(int argc, char** argv) {
  const command::Command echo_row{
      .name = "echo",
      .summary = "Says a text again",
      .example = "rehearse echo --text hello",
      .options = {{"text", "TEXT", "what to say", {}, true, true},
                  {"times", "N", "how often, from 1 to 99", {}, false, true},
                  {"voice", "VOICE", "loud, soft", {"loud", "soft"}},
                  {"twice", "", "a flag"}},
      .run = echo,
      .run_block = [](const Rows&) { return Block{echo_columns}; }};
  const command::Program program = {
      "rehearse",
      "A program for tests",
      "1.2.3",
      {echo_row, plain("many", many, {{"lines", "N", "how many"}}),
       plain("words", words, {}, "WORD..."), plain("compare", compare, {}, "FILE"),
       plain("check", false_check), plain("wait", wait), plain("other", other), plain("fill", fill),
       plain("deep", deep), plain("crash", crash), plain("bug", bug)}};
  return command::run_program(program, {argv + 1, argv + argc});
}
