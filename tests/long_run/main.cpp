// SPDX-License-Identifier: GPL-2.0-or-later
// magicmass_long_run [--inputs N] [--everyday N] [--oracle-every N] [--threads N] [--quantity Q]
// Random inputs of every family through tier `accurate`, far more than a test suite has time for. Exit code 1 if a single
// result is not the nearest double or a count is wrong.
#include <algorithm>
#include <charconv>
#include <cstdio>
#include <exception>
#include <limits>
#include <string>
#include <string_view>

#include "long_run/plan.hpp"
#include "magicmass/errors.hpp"

using namespace magicmass;
using namespace magicmass::long_run;

namespace {

constexpr const char* quantities[] = {"velocities", "terminal", "encounters", "angle", "ratios"};

std::int64_t whole_number(std::string_view option, std::string_view text) {
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  constexpr std::int64_t most = std::numeric_limits<std::int32_t>::max();
  if (error != std::errc{} || end != text.data() + text.size() || value < 1 || value > most) {
    throw InvalidInput(std::string(option) + " must be a whole number from 1 to " +
                       std::to_string(most) + ", got \"" + std::string(text) + "\"");
  }
  return value;
}

Plan plan_of(int count, const char* const* arguments) {
  Plan plan;
  for (int i = 1; i < count; i += 2) {
    const std::string option = arguments[i];
    if (i + 1 == count) throw InvalidInput(option + " needs a value");
    const std::string value = arguments[i + 1];
    if (option == "--inputs") {
      plan.inputs = whole_number(option, value);
    } else if (option == "--everyday") {
      plan.everyday = whole_number(option, value);
    } else if (option == "--oracle-every") {
      plan.oracle_every = static_cast<std::size_t>(whole_number(option, value));
    } else if (option == "--threads") {
      plan.threads = static_cast<unsigned>(whole_number(option, value));
    } else if (option == "--quantity") {
      if (std::find(std::begin(quantities), std::end(quantities), value) == std::end(quantities))
        throw InvalidInput(
            "--quantity must be velocities, terminal, encounters, angle or ratios, got \"" + value +
            "\"");
      plan.quantity = value;
    } else {
      throw InvalidInput("unknown option " + option +
                         "; there are --inputs, --everyday, --oracle-every, --threads, --quantity");
    }
  }
  return plan;
}

void print(const std::string& quantity, const std::string& family, const Tally& tally) {
  const auto number = [](std::int64_t x) { return static_cast<long long>(x); };
  std::printf("%-11s%-22s%11lld%9lld%8lld%8lld%11lld%9lld%10lld%8lld%7lld\n", quantity.c_str(),
              family.c_str(), number(tally.inputs), number(tally.misrounded_single),
              number(tally.misrounded_batch), number(tally.wrong_counts), number(tally.by_stage[0]),
              number(tally.by_stage[1]), number(tally.by_stage[2]), number(tally.oracle_inputs),
              number(tally.oracle_wrong));
  std::fflush(stdout);
}

}  // namespace

int main(int count, char** arguments) try {
  const Plan plan = plan_of(count, arguments);
  std::printf("%-33s%11s%9s%8s%8s%11s%9s%10s%8s%7s\n", "", "", "misr.", "misr.", "wrong",
              "decided at", "", "", "oracle", "");
  std::printf("%-11s%-22s%11s%9s%8s%8s%11s%9s%10s%8s%7s\n", "quantity", "family", "inputs",
              "single", "batch", "counts", "stage 1", "stage 2", "certified", "inputs", "wrong");
  Tally all;
  for (const Row& row : rows(plan)) {
    std::vector<Row> one{row};
    run(plan, one);
    print(row.quantity, row.family, one[0].tally);
    all += one[0].tally;
  }
  print("all", "", all);
  return all.is_clean() ? 0 : 1;
} catch (const InvalidInput& problem) {
  std::fprintf(stderr, "magicmass_long_run: %s\n", problem.what());
  return 2;
} catch (const std::exception& problem) {
  std::fprintf(stderr, "magicmass_long_run: %s\n", problem.what());
  return 3;
}
