// SPDX-License-Identifier: GPL-2.0-or-later
#include "report/pinned_inputs.hpp"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <utility>

#include <catch2/catch.hpp>

#include "report/contestants.hpp"
#include "report/errors.hpp"
#include "report/evaluation.hpp"
#include "report/instruction_sets.hpp"
#include "report/quantities.hpp"

namespace magicmass::testing {
namespace {

using namespace report;

const std::string path = MAGICMASS_WORST_INPUTS;

/// Those that make promises or are to be made better; the others are what they are. Of arrays those with the best
/// instruction set: the others' results are the same bits.
std::vector<Contestant> ours(const std::string& quantity) {
  std::vector<Contestant> all = generated_contestants(quantity);
  for (const auto part : {certified_contestants, tier_contestants, batch_contestants})
    for (Contestant& one : part(quantity)) all.push_back(std::move(one));
  for (Contestant& one : sequence_contestants(quantity))
    if (!one.is_yardstick) all.push_back(std::move(one));
  std::erase_if(all, [](const Contestant& one) {
    return std::any_of(std::begin(all_instruction_sets), std::end(all_instruction_sets),
                       [&](InstructionSet set) {
                         return !suffix(set).empty() && one.name.ends_with(suffix(set));
                       });
  });
  return all;
}

double figure(const WorstInput& one, const Deviation& d) {
  return one.figure == "ulp" ? d.ulp : one.figure == "envelope" ? d.over_envelope : d.promise_eps;
}

}  // namespace

std::vector<WorstInput> pinned_inputs() {
  std::ifstream file(path);
  REQUIRE(file);
  return read_worst_inputs(file);
}

std::size_t replay_pinned(const std::string& quantity, Oracle& oracle) {
  // Another C library's functions round otherwise by an ulp each, which a bad place magnifies: twice as much is let
  // pass, and 2.
  const std::vector<WorstInput> known = pinned_inputs();
  const std::vector<std::string>& members = quantity_named(quantity).members;
  std::size_t replayed = 0;
  for (const Contestant& one : ours(quantity))
    for (const WorstInput& worst : known) {
      if (worst.contestant != one.name || worst.precision != one.precision ||
          worst.quantity != quantity)
        continue;
      INFO(worst.quantity << " " << worst.contestant << " " << worst.precision << " "
                          << worst.member << " " << worst.figure << " at alpha "
                          << worst.input.alpha << ", index " << worst.input.index << ", e "
                          << worst.input.e);
      const auto deviations = compared(one, worst.input, oracle);
      REQUIRE(deviations);
      const auto member = static_cast<std::size_t>(
          std::find(members.begin(), members.end(), worst.member) - members.begin());
      REQUIRE(member < members.size());
      REQUIRE(deviations->at(member));
      const Deviation& deviation = *deviations->at(member);
      CHECK(figure(worst, deviation) <= 2 * worst.error + 2);
      // what the tiers promise, at what is hardest for them
      if (worst.contestant.ends_with("accurate")) CHECK(deviation.correctly_rounded);
      if (worst.contestant.ends_with("fast")) CHECK(deviation.over_envelope <= 4);
      ++replayed;
    }
  return replayed;
}

void pin_worst(const std::string& quantity, Oracle& oracle, std::size_t size) {
  const char* const asked = std::getenv("MAGICMASS_PIN");
  if (asked == nullptr) return;
  const std::string name = asked;
  std::vector<WorstInput> known = pinned_inputs();
  std::vector<Family> all = families(quantity, size);
  all.push_back(worst_inputs_family(quantity, known));
  for (const Family& family : all)
    for (const Contestant& one : ours(quantity))
      if (name == "1" || name == one.name)
        known = merged(std::move(known), measure(one, family, oracle, {size / 10}));
  std::ofstream file(path);
  write_worst_inputs(file, known);
  REQUIRE(file.good());
}

}  // namespace magicmass::testing
