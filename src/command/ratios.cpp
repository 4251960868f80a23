// SPDX-License-Identifier: GPL-2.0-or-later
#include "magicmass/reference/ratios.hpp"

#include <cstdint>
#include <memory>
#include <optional>

#include "command/commands.hpp"
#include "command/records.hpp"
#include "command/velocity_tiers.hpp"
#include "magicmass/ratios_product.hpp"

namespace magicmass::command {
namespace {

struct RatiosOptions {
  std::int64_t count = 10;
  std::optional<std::string> digits;
  OutputOptions output;
};

/// Computed in long double and rounded once, so within 1 ulp of the double nearest to the ratio.
std::vector<Cell> row(std::int64_t k, std::optional<int> digits) {
  if (digits)
    return {number_cell(k), text_cell(reference::ratio_digits(Magic{k}, *digits)),
            text_cell(reference::ratio_digits(Deficient{k}, *digits))};
  const generated::Ratios<long double> ratios = generated::ratios_product<long double>(k);
  return {number_cell(k), number_cell(static_cast<double>(ratios.magic)),
          number_cell(static_cast<double>(ratios.deficient))};
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
          "1 to 10000 certified decimal digits")
      ->type_name("D");
  add_output_options(command, options->output);
  on_run(program, command, [options] {
    std::optional<int> digits;
    if (options->digits) digits = parse_digits(*options->digits);
    Destination output(options->output.path);
    RecordWriter writer(output, options->output.format, {"k", "magic", "deficient"}, false);
    for (std::int64_t k = 1; k <= options->count; ++k) writer.write(row(k, digits));
    writer.finish();
    output.finish();
    return ExitCode::done;
  });
}

}  // namespace magicmass::command
