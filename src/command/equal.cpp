// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>
#include <array>
#include <cctype>
#include <iostream>
#include <memory>
#include <system_error>

#include "command/commands.hpp"
#include "command/program.hpp"
#include "command/records.hpp"
#include "equality/bounded.hpp"
#include "magicmass/errors.hpp"
#include "magicmass/scenes/shown_text.hpp"
#include "render/wrapping.hpp"

namespace magicmass::command {
namespace {

using equality::Answer;
using equality::Verdict;

constexpr std::size_t longest_input =
    100000;  // bytes; a longer one is refused, as the parser would

std::string name_of(Answer answer) {
  if (answer == Answer::equal) return "equal";
  return answer == Answer::different ? "different" : "undecided";
}

ExitCode exit_code(Answer answer) {
  if (answer == Answer::equal) return ExitCode::done;
  return answer == Answer::different ? ExitCode::check_failed : ExitCode::undecided;
}

/// "-" stands for what is on stdin, no more of it than could be an expression.
std::string expression(const std::string& argument) {
  if (argument != "-") return argument;
  std::string text;
  std::array<char, 4096> buffer{};
  while (text.size() <= longest_input) {
    std::cin.read(buffer.data(), buffer.size());
    text.append(buffer.data(), static_cast<std::size_t>(std::cin.gcount()));
    if (!std::cin) break;
  }
  return text;
}

std::string agreement(const Verdict& verdict) {
  if (verdict.points == 0) return "";
  return "both sides agree to " + std::to_string(verdict.agreeing_digits) + " digits" +
         (verdict.domain.empty() ? ""
                                 : " at each of " + std::to_string(verdict.points) + " points");
}

std::string proof_of(const Verdict& verdict) {
  std::string proof = verdict.proof;
  if (!agreement(verdict).empty()) proof += "; " + agreement(verdict);
  return proof;
}

std::string json_counterexample(const equality::Counterexample& counterexample) {
  std::vector<std::string> names;
  std::vector<Cell> values;
  for (const auto& [name, value] : counterexample.point) {
    names.push_back(name);
    values.push_back(text_cell(value));
  }
  return json_object(
      {"at", "left", "right", "difference"},
      {{json_object(names, values)},
       text_cell(counterexample.left),
       text_cell(counterexample.right),
       counterexample.difference.empty() ? missing_cell() : text_cell(counterexample.difference)});
}

std::string json(const Verdict& verdict) {
  const Cell counterexample =
      verdict.counterexample ? Cell{json_counterexample(*verdict.counterexample)} : missing_cell();
  const Cell digits =
      verdict.points > 0 ? number_cell(std::int64_t{verdict.agreeing_digits}) : missing_cell();
  return json_object({"verdict", "proof", "counterexample", "domain", "conditions", "notes",
                      "agreeing_digits"},
                     {text_cell(name_of(verdict.answer)),
                      text_cell(proof_of(verdict)),
                      counterexample,
                      {json_array(verdict.domain)},
                      {json_array(verdict.conditions)},
                      {json_array(verdict.notes)},
                      digits}) +
         "\n";
}

std::string joined(const std::vector<std::string>& texts) {
  constexpr std::size_t most = 12;
  std::string result;
  for (std::size_t i = 0; i < texts.size() && i < most; ++i)
    result += (i == 0 ? "" : "; ") + texts[i];
  if (texts.size() > most)
    result += "; and " + std::to_string(texts.size() - most) + " more (--format json)";
  return result;
}

std::string page(const Verdict& verdict) {
  std::string lines = name_of(verdict.answer) + "\n";
  const auto add = [&](const std::string& title, const std::string& text) {
    if (!text.empty())
      lines += render::wrapped(text, "  " + title + std::string(10 - title.size(), ' '));
  };
  if (verdict.counterexample) {
    std::string at;
    for (const auto& [name, value] : verdict.counterexample->point)
      at += (at.empty() ? "" : ", ") + name + " = " + value;
    add("at", at);
    add("left", verdict.counterexample->left);
    add("right", verdict.counterexample->right);
    add("apart by", verdict.counterexample->difference);
  }
  add("proof", proof_of(verdict));
  add("domain", joined(verdict.domain));
  add("if", joined(verdict.conditions));
  for (const std::string& note : verdict.notes) add("note", note);
  return lines;
}

struct EqualOptions {
  equality::Question question;
  std::string left, right;
  OutputOptions output;
};

ExitCode equal(EqualOptions& options) {
  if (options.left == "-" && options.right == "-")
    throw InvalidInput("one side alone can be read from stdin");
  options.question.lhs = expression(options.left);
  options.question.rhs = expression(options.right);
  Destination output(options.output.path);
  const Verdict verdict = equality::answer_within(options.question);
  output.write(options.output.format == "json" ? json(verdict) : page(verdict));
  output.finish();
  return exit_code(verdict.answer);
}

}  // namespace

// A blank in front is nothing to an expression, and to the parser of options it says that this is none.
std::vector<std::string> with_expressions_marked(int argc, char** argv) {
  std::vector<std::string> words(argv + 1, argv + argc);
  const bool is_check = words.size() > 2 && words[0] == "learn" && words[1] == "check";
  if (words.empty() || (words.front() != "equal" && !is_check)) return words;
  static const std::array<std::string, 6> options{"-", "-o", "-h", "--", "--help", "--output"};
  for (std::size_t i = is_check ? 3 : 1; i < words.size(); ++i) {
    std::string& word = words[i];
    if (!word.starts_with('-') ||
        std::find(options.begin(), options.end(), word) != options.end() ||
        (word.starts_with("--") && word.size() > 2 &&
         std::isalpha(static_cast<unsigned char>(word[2])) != 0))
      continue;
    word.insert(0, " ");
  }
  return words;
}

void add_equal(Program& program) {
  const auto options = std::make_shared<EqualOptions>();
  CLI::App& command =
      add_command(program, "equal", "Decide whether two expressions are equal; exit code 1 if not",
                  "magicmass equal \"sec(pi/5) - 1\" \"sqrt(5) - 2\"\n"
                  "  magicmass equal \"sqrt(x^2)\" \"x\" --domain \"x real\"");
  command.add_option("LHS", options->left, "an expression; - reads it from stdin")
      ->required()
      ->type_name("");
  command.add_option("RHS", options->right, "an expression")->required()->type_name("");
  command
      .add_option("--domain", options->question.domain,
                  "\"0 < x <= 1, n integer, y real\"; repeatable")
      ->type_name("CONDITIONS")
      ->allow_extra_args(false);
  add_output_options(command, options->output, {"text", "json"});
  command.footer(
      "Expressions: + - * / ^ ( ) pi, sqrt cbrt root(x,n) abs exp log, sin cos tan sec\n"
      "csc cot and their inverses asin acos atan. Decimals are exact: 0.1 is 1/10.\n"
      "e is the coefficient of restitution; roots of even order and fractional\n"
      "powers want numbers >= 0. psi, theta, V_CM, alpha_k, beta_k, a_n, b_n, c_n and\n"
      "c_prime_n are the paper's. Unless --domain says otherwise alpha, V, L, M, M_A,\n"
      "M_B, m > 0, 0 < e <= 1, n and k are integers >= 1, j >= 0, other names real.\n"
      "Exit codes: 0 equal, 1 different (with a counterexample), 2 bad usage or\n"
      "input, 3 undecided (nothing proved within 1.6 s and 400 MiB).");
  on_run(program, command, [options] { return equal(*options); });
}

}  // namespace magicmass::command
