// SPDX-License-Identifier: GPL-2.0-or-later
// A program on the frame of magicmass whose commands do what may go wrong.
#include <chrono>
#include <csignal>
#include <stdexcept>
#include <thread>

#include "answers/errors.hpp"
#include "answers/shown_text.hpp"
#include "command/command.hpp"

namespace {

using answers::Answer;
using answers::Request;
using answers::Type;

Answer document(const std::string& text) {
  Answer answer;
  answer.document = text;
  return answer;
}

const std::vector<answers::Column> echo_columns = {{"text", Type::text, "", "what was said"},
                                                   {"times", Type::whole, "1", "how often"}};

Answer echo(const Request& request) {
  const auto times = request.whole("times", 1, 99);
  if (request.text("text") == "hard") {
    throw answers::Undecided("hard is not decided");
  }
  Answer answer;
  answer.table = {echo_columns,
                  {{answers::text_cell(answers::shown_text(request.text("text"))),
                    times ? answers::whole_cell(*times) : answers::missing_cell()}},
                  false};
  return answer;
}

Answer many(const Request& request) {
  const auto lines = request.whole("lines", 0, 100'000'000).value_or(0);
  std::string text;
  for (std::int64_t line = 1; line <= lines; ++line) {
    text += std::to_string(line) + "\n";
  }
  return document(text);
}

Answer false_check(const Request&) {
  Answer answer = document("not proved\n");
  answer.check_failed = true;
  return answer;
}

Answer wait(const Request&) {
  std::this_thread::sleep_for(std::chrono::seconds(60));
  return document("late\n");
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

command::Command plain(const std::string& name, Answer (*run)(const Request&)) {
  return {name, "Does what " + name + " does", "rehearse " + name, {}, "", {"text"}, {}, run};
}

}  // namespace

int main(int argc, char** argv) {
  const command::Command echo_row = {"echo",
                                     "Says a text again",
                                     "rehearse echo --text hello",
                                     {{"text", "TEXT", "what to say", {}, true, true},
                                      {"times", "N", "how often, from 1 to 99", {}, false, true},
                                      {"voice", "VOICE", "loud, soft", {"loud", "soft"}},
                                      {"twice", "", "a flag"}},
                                     "",
                                     {"text", "json", "csv"},
                                     echo_columns,
                                     echo};
  const command::Command many_row = {
      "many", "Many lines", "rehearse many --lines 9", {{"lines", "N", "how many"}}, "", {"text"},
      {},     many};
  const command::Command words_row = {
      "words",
      "Says its words",
      "rehearse words a b",
      {},
      "WORD...",
      {"text"},
      {},
      [](const Request& request) { return document(answers::joined(request.words) + "\n"); }};
  const command::Program program = {
      "rehearse",
      "A program for tests",
      "1.2.3",
      {echo_row, many_row, words_row, plain("check", false_check), plain("wait", wait),
       plain("fill", fill), plain("deep", deep), plain("crash", crash), plain("bug", bug)},
      {"simulate"},
      "not in this version yet"};
  return command::run_program(program, {argv + 1, argv + argc});
}
