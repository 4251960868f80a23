// SPDX-License-Identifier: GPL-2.0-or-later
#include "magicmass/reference/ratios.hpp"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include <fmt/format.h>

#include "command/accuracy_options.hpp"
#include "command/commands.hpp"
#include "command/program.hpp"
#include "command/ratio_forms.hpp"
#include "command/records.hpp"
#include "magicmass/accurate.hpp"

namespace magicmass::command {
namespace {

struct RatiosOptions {
  std::int64_t count = 10;
  std::optional<std::string> digits;
  bool exact = false;
  OutputOptions output;
};

/// alpha_k and beta_k.
struct Row {
  Cell magic, deficient;
};

Row row(std::int64_t k, std::optional<int> digits) {
  if (digits)
    return {text_cell(reference::ratio_digits(Magic{k}, *digits)),
            text_cell(reference::ratio_digits(Deficient{k}, *digits))};
  const generated::Ratios<double> ratios = accurate::ratios(k);
  return {number_cell(ratios.magic), number_cell(ratios.deficient)};
}

void write_text(Destination& output, const RatiosOptions& options, std::optional<int> digits) {
  const std::size_t width = std::to_string(options.count).size() + 2;
  const auto head = [width](std::string text) { return text.append(width - text.size(), ' '); };
  output.write(ratio_lines(head("k"), "ratio", "value", {"exact", {}}));
  for (std::int64_t k = 1; k <= options.count; ++k) {
    const Row values = row(k, digits);
    output.write(ratio_lines(head(std::to_string(k)), "magic", values.magic.text,
                             magic_forms(k, options.exact)));
    output.write(ratio_lines(head(""), "deficient", values.deficient.text,
                             deficient_forms(k, options.exact)));
  }
}

Cell optional_cell(const std::optional<std::string>& text) {
  return text ? text_cell(*text) : missing_cell();
}

void write_records(Destination& output, const RatiosOptions& options, std::optional<int> digits) {
  RecordWriter writer(output, options.output.format,
                      {"k", "magic", "deficient", "magic_radicals", "magic_polynomial",
                       "deficient_radicals", "deficient_polynomial"},
                      false);
  for (std::int64_t k = 1; k <= options.count; ++k) {
    const Row values = row(k, digits);
    const ExactForms magic = magic_forms(k, options.exact);
    const ExactForms deficient = deficient_forms(k, options.exact);
    writer.write({number_cell(k), values.magic, values.deficient, optional_cell(magic.radicals),
                  optional_cell(magic.polynomial), optional_cell(deficient.radicals),
                  optional_cell(deficient.polynomial)});
  }
  writer.finish();
}

}  // namespace

void add_ratios(Program& program) {
  const auto options = std::make_shared<RatiosOptions>();
  CLI::App& command =
      add_command(program, "ratios", "Magic and deficient mass ratios alpha_k and beta_k",
                  "magicmass ratios --count 10");
  command.add_option("--count", options->count, "how many, k = 1, 2, ... (10)")
      ->type_name("K")
      ->check(CLI::Range(std::int64_t{1}, std::int64_t{1} << 53U).description(""));
  command
      .add_option_function<std::string>(
          "--digits", [options](const std::string& text) { options->digits = text; },
          "1 to 100000 certified decimal digits")
      ->type_name("D");
  command.add_flag("--exact", options->exact,
                   fmt::format("long minimal polynomials too, for k to {}", last_polynomial));
  add_output_options(command, options->output);
  on_run(program, command, [options] {
    std::optional<int> digits;
    if (options->digits) digits = parse_digits(*options->digits);
    Destination output(options->output.path);
    (options->output.format == "text" ? write_text : write_records)(output, *options, digits);
    output.finish();
    return ExitCode::done;
  });
}

}  // namespace magicmass::command
