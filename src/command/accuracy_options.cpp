// SPDX-License-Identifier: GPL-2.0-or-later
#include "command/accuracy_options.hpp"

#include <charconv>

#include "command/program.hpp"
#include "magicmass/errors.hpp"
#include "magicmass/scenes/shown_text.hpp"

namespace magicmass::command {

void add_accuracy_options(CLI::App& command, AccuracyOptions& options) {
  command
      .add_option_function<std::string>(
          "--tier", [&options](const std::string& text) { options.tier = text; },
          "fast, accurate (the nearest double) or exact")
      ->type_name("TIER");
  command
      .add_option_function<std::string>(
          "--digits", [&options](const std::string& text) { options.digits = text; },
          "1 to 100000 certified digits (tier exact)")
      ->type_name("D");
}

int parse_digits(const std::string& text) {
  int digits = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), digits);
  if (error != std::errc{} || end != text.data() + text.size() || digits < 1 || digits > 100000)
    throw InvalidInput("--digits must be a whole number from 1 to 100000, got " + shown_text(text));
  return digits;
}

Accuracy accuracy(const AccuracyOptions& options) {
  const std::string tier = options.tier.value_or(options.digits ? "exact" : "fast");
  if (tier != "fast" && tier != "accurate" && tier != "exact")
    throw InvalidInput("unknown tier \"" + shown_text(tier) + "\"; allowed: fast, accurate, exact");
  if (tier != "exact" && options.digits)
    throw InvalidInput("--digits goes with --tier exact; tier " + tier + " computes in doubles");
  Accuracy result{tier, std::nullopt};
  if (options.digits) result.digits = parse_digits(*options.digits);
  return result;
}

}  // namespace magicmass::command
