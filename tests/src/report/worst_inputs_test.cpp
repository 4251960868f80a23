// SPDX-License-Identifier: GPL-2.0-or-later
// The pinned worst inputs, replayed. After a change that moves them, of all contestants or of one by its name:
//   MAGICMASS_PIN=1 magicmass_report_tests "[pin]"
//   MAGICMASS_PIN=fast magicmass_report_tests "[pin]"
#include "report/worst_inputs.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <sstream>

#include <catch2/catch.hpp>

#include "report/contestants.hpp"
#include "report/errors.hpp"
#include "report/evaluation.hpp"
#include "report/quantities.hpp"

using namespace magicmass;
using namespace magicmass::report;

namespace {

const std::string path = MAGICMASS_WORST_INPUTS;

std::vector<WorstInput> pinned() {
  std::ifstream file(path);
  REQUIRE(file);
  return read_worst_inputs(file);
}

/// Those that make promises or are to be made better; the others are what they are.
std::vector<Contestant> ours(const std::string& quantity) {
  std::vector<Contestant> all = generated_contestants(quantity);
  for (Contestant& one : certified_contestants(quantity)) all.push_back(std::move(one));
  for (Contestant& one : tier_contestants(quantity)) all.push_back(std::move(one));
  return all;
}

double figure(const WorstInput& one, const Deviation& d) {
  return one.figure == "ulp" ? d.ulp : one.figure == "envelope" ? d.over_envelope : d.promise_eps;
}

}  // namespace

TEST_CASE("what is written is read back, sorted", "[exam]") {
  const std::vector<WorstInput> some{
      {"naive", "double", "velocities", "b", "ulp", {1e-300, 5}, 1e15},
      {"naive", "double", "velocities", "a", "ulp", {0.1, 7}, HUGE_VAL},
  };
  std::ostringstream written;
  write_worst_inputs(written, some);
  std::istringstream file(written.str());
  const auto read = read_worst_inputs(file);
  REQUIRE(read.size() == 2);
  CHECK(read[0].member == "a");
  CHECK(std::isinf(read[0].error));
  CHECK(read[1].input.alpha == 1e-300);
  CHECK(read[1].input.index == 5);
  CHECK(read[1].error == 1e15);
}

TEST_CASE("a file that is something else is refused with the line", "[exam]") {
  const auto refused = [](const std::string& text, const std::string& says) {
    std::istringstream file(text);
    CHECK_THROWS_WITH(read_worst_inputs(file), Catch::Contains(says));
  };
  const std::string header = "quantity,contestant,precision,member,figure,alpha,index,error\n";
  refused("", "begin with");
  refused("alpha,n\n", "begin with");
  refused(header + "velocities,naive\n", "velocities,naive");
  refused(header + "velocities,naive,double,a,ulp,zero,1,2\n", "zero");
  refused(header + "velocities,naive,double,a,ulp,1p-3,1x,2\n", "1x");
}

TEST_CASE("the worse of what was known and what was found is kept", "[exam]") {
  ErrorRow row;
  row.contestant = "naive";
  row.precision = "double";
  row.quantity = "angle";
  row.member = "psi";
  row.max_ulp = 3;
  row.worst = {0.25, 0};
  const auto found = merged({}, {row});
  REQUIRE(found.size() == 1);  // no envelope and no eps: nothing was wrong by these
  CHECK(found[0].input.alpha == 0.25);
  row.max_ulp = 2;
  row.worst = {0.5, 0};
  CHECK(merged(found, {row})[0].input.alpha == 0.25);
  row.max_ulp = 4;
  CHECK(merged(found, {row})[0].input.alpha == 0.5);
  CHECK(worst_inputs_family("angle", found).inputs.size() == 1);
  row.worst = {5e-324, 0};
  row.max_ulp = HUGE_VAL;
  CHECK(merged(found, {row}).size() == 2);  // hides nothing
  CHECK(worst_inputs_family("ratios", found).inputs.empty());
}

TEST_CASE("the pinned inputs are no worse than when they were found", "[exam]") {
  // Another C library's functions round otherwise by an ulp each, which a bad place magnifies: twice as much is let
  // pass, and 2.
  const auto known = pinned();
  CHECK(known.size() > 50);
  for (const Quantity& quantity : quantities()) {
    Oracle oracle;
    for (const Contestant& one : ours(quantity.name))
      for (const WorstInput& worst : known) {
        if (worst.contestant != one.name || worst.precision != one.precision ||
            worst.quantity != quantity.name)
          continue;
        INFO(worst.contestant << " " << worst.precision << " " << worst.member << " "
                              << worst.figure << " at alpha " << worst.input.alpha << ", index "
                              << worst.input.index);
        const auto deviations = compared(one, worst.input, oracle);
        REQUIRE(deviations);
        const auto& members = quantity.members;
        const auto member = static_cast<std::size_t>(
            std::find(members.begin(), members.end(), worst.member) - members.begin());
        REQUIRE(member < members.size());
        const Deviation& deviation = deviations->at(member).value();
        CHECK(figure(worst, deviation) <= 2 * worst.error + 2);
        // what the tiers promise, at what is hardest for them
        if (worst.contestant == "accurate") CHECK(deviation.correctly_rounded);
        if (worst.contestant == "fast") CHECK(deviation.over_envelope <= 4);
      }
  }
}

TEST_CASE("pin the worst inputs", "[.pin]") {
  const char* const asked = std::getenv("MAGICMASS_PIN");
  if (asked == nullptr) return;
  const std::string name = asked;
  std::ifstream before(path);
  std::vector<WorstInput> known = before ? read_worst_inputs(before) : std::vector<WorstInput>{};
  for (const Quantity& quantity : quantities())
    for (const Family& family : families(quantity.name, 2000)) {
      Oracle oracle;
      for (const Contestant& one : ours(quantity.name))
        if (name == "1" || name == one.name)
          known = merged(std::move(known), measure(one, family, oracle, {200}));
    }
  std::ofstream file(path);
  write_worst_inputs(file, known);
  REQUIRE(file.good());
}
