// SPDX-License-Identifier: GPL-2.0-or-later
#include <cmath>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "command/report/report_tables.hpp"
#include "magicmass/batch/instruction_set.hpp"
#include "report/quantities.hpp"

namespace magicmass::command {
namespace {

/// To the two decimals that are shown, so that none reads -0.00.
double rounded(double exponent) { return std::round(exponent * 100) / 100 + 0.0; }

}  // namespace

std::string short_number(double value) {
  if (std::isnan(value)) return "-";
  if (std::isinf(value)) return "inf";
  if (value != 0 && value < 0.001) return fmt::format("{:.0e}", value);
  if (value < 10) return fmt::format("{:.2f}", value);
  if (value < 100) return fmt::format("{:.1f}", value);
  if (value < 9999.5) return fmt::format("{:.0f}", value);
  std::string text = fmt::format("{:.{}e}", value, value < 9.95e99 ? 1 : 0);
  const std::size_t plus = text.find('+');
  text.erase(plus, text[plus + 1] == '0' ? 2 : 1);
  return text;
}

std::string shown_ratio(const report::TimeRow& time) {
  return (time.is_steady ? "" : "?") + short_number(time.ratio);
}

std::string shown_ratio_with_interval(const std::optional<report::TimeRow>& time) {
  if (!time || std::isnan(time->ratio)) return "-";
  return fmt::format("{} ({} to {})", shown_ratio(*time), short_number(time->ratio_low),
                     short_number(time->ratio_high));
}

std::string short_precision(const std::string& precision) {
  return precision == "double"        ? "d"
         : precision == "float"       ? "f"
         : precision == "long double" ? "ld"
                                      : precision;
}

std::string shown_input(const std::string& quantity, const report::Input& input) {
  const report::Quantity& one = report::quantity_named(quantity);
  std::vector<std::string> parts;
  if (one.takes("alpha")) parts.push_back(fmt::format("alpha = {:a}", input.alpha));
  if (one.takes("e")) parts.push_back(fmt::format("e = {:a}", input.e));
  if (!one.index().empty()) parts.push_back(fmt::format("{} = {}", one.index(), input.index));
  return fmt::format("{}", fmt::join(parts, ", "));
}

std::string shown_exponents(const report::Growth& growth) {
  const auto shown = [&](const char* what, const std::optional<report::PowerLaw>& law) {
    return law ? fmt::format("{} ~ {}^({:.2f} +- {:.2f})", what, growth.scale,
                             rounded(law->exponent), law->spread)
               : std::string();
  };
  const std::string time = shown("time", growth.time);
  const std::string error = shown("error", growth.error);
  return time + (time.empty() || error.empty() ? "" : ", ") + error;
}

std::string report_legend(const Measurement& measurement) {
  const SelfComparison& self = measurement.self;
  std::string text =
      "Hard cases first, each kind by itself. f, d, ld: float, double, long double. ulp: largest "
      "error in units in the last place, for counts how far off; behind a ~ the order of "
      "operations, and so the last bits, change from run to run. eps: largest error in eps of the "
      "body's largest velocity. wrong: signs, or counts. ns: median time of an evaluation, one "
      "after the other; late: each waits for the one before, latency; slow: the slowest single "
      "call. ratio: to naive in double on the same inputs, paired round by round, with a 95 % "
      "interval over batches of rounds, each in a process of its own; behind a ? it is wider than "
      "a tenth, as the batches disagree.";
  text += fmt::format(
      " batch_... and stream work on whole arrays, with {} where the name says nothing else.",
      to_text(best_instruction_set()));
  if (self.families > 0)
    text += fmt::format(
        " Naive against a second copy of itself: ratios {:.3f} to {:.3f}, {} of {} intervals hold "
        "1.",
        self.lowest, self.highest, self.holding_one, self.families);
  return text;
}

}  // namespace magicmass::command
