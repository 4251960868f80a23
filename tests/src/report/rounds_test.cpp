// SPDX-License-Identifier: GPL-2.0-or-later
#include "report/rounds.hpp"

#include <algorithm>
#include <map>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

using namespace magicmass::report;

namespace {

/// Work that takes `cost` by its own clock for a repetition and writes down that it ran.
Timed pretended(double cost, std::string& log, char letter) {
  return {[cost, &log, letter](std::size_t repetitions) {
            log += letter;
            return cost * static_cast<double>(repetitions);
          },
          4.0};
}

}  // namespace

TEST_CASE("orders are shuffled, complete, and the same for the same seed on every machine",
          "[exam]") {
  RandomOrder order(1);
  const std::vector<std::size_t> first = order.next(8);
  std::vector<std::size_t> sorted = first;
  std::sort(sorted.begin(), sorted.end());
  CHECK(sorted == std::vector<std::size_t>{0, 1, 2, 3, 4, 5, 6, 7});
  CHECK(first != order.next(8));
  CHECK(first == RandomOrder(1).next(8));
  CHECK(first != RandomOrder(2).next(8));
  CHECK(order.next(0).empty());
  // Pinned: splitmix64 and the shuffle, worked out by another program.
  CHECK(first == std::vector<std::size_t>{4, 3, 2, 7, 5, 6, 0, 1});
}

TEST_CASE("every place in an order is as likely as any other", "[check]") {
  RandomOrder order(3);
  constexpr int trials = 6000;
  std::map<std::vector<std::size_t>, int> seen;
  for (int i = 0; i < trials; ++i) ++seen[order.next(3)];
  REQUIRE(seen.size() == 6);
  for (const auto& [permutation, times] : seen)
    CHECK(std::abs(times - trials / 6) < 150);  // 5 sigma
}

TEST_CASE("times are per evaluation, repetitions long enough, rounds complete", "[exam]") {
  std::string log;
  const std::vector<Group> groups = {{pretended(8.0, log, 'a'), pretended(20.0, log, 'b')},
                                     {pretended(1e9, log, 'c')}};
  const RoundTimes times = interleaved_rounds(groups, {.rounds = 51, .shortest_ns = 1e6});
  REQUIRE(times.size() == 2);
  CHECK(times[0][0] == std::vector<double>(51, 2.0));
  CHECK(times[0][1] == std::vector<double>(51, 5.0));
  CHECK(times[1][0] == std::vector<double>(51, 2.5e8));
  // Of the rounds themselves, each work comes twice in a row: warm-up, measurement.
  const std::string rounds = log.substr(log.size() - 51 * 6);
  int b_first = 0;
  for (std::size_t i = 0; i < rounds.size(); i += 6) {
    const std::string round = rounds.substr(i, 6);
    const bool is_known =
        round == "aabbcc" || round == "bbaacc" || round == "ccaabb" || round == "ccbbaa";
    CHECK(is_known);
    b_first += round.find('b') < round.find('a') ? 1 : 0;
  }
  CHECK(b_first > 12);
  CHECK(b_first < 39);  // 3.8 sigma from half
  std::string again;
  interleaved_rounds(
      {{pretended(8.0, again, 'a'), pretended(20.0, again, 'b')}, {pretended(1e9, again, 'c')}},
      {.rounds = 51, .shortest_ns = 1e6});
  CHECK(again.substr(again.size() - rounds.size()) == rounds);
}

TEST_CASE("no measurement is too short for the clock, whatever is asked", "[exam]") {
  std::size_t largest = 0;
  const Timed timed{[&](std::size_t repetitions) {
                      largest = std::max(largest, repetitions);
                      return static_cast<double>(repetitions);
                    },
                    1.0};
  interleaved_rounds({{timed}}, {.rounds = 1, .shortest_ns = 0.0});
  CHECK(clock_tick() > 0.0);
  CHECK(static_cast<double>(largest) >= 500 * clock_tick());  // another tick was seen then
}

TEST_CASE("stopped early, a group's works have the same number of rounds", "[exam]") {
  std::string log;
  int asked = 0;
  Plan plan{.rounds = 51, .shortest_ns = 1e6};
  plan.go_on = [&](double done) {
    CHECK(done >= 0.0);
    CHECK(done < 1.0);
    return ++asked < 40;
  };
  const RoundTimes times = interleaved_rounds(
      {{pretended(8.0, log, 'a'), pretended(20.0, log, 'b')}, {pretended(9.0, log, 'c')}}, plan);
  CHECK(times[0][0].size() == times[0][1].size());
  CHECK(times[0][0].size() + times[1][0].size() == 37);  // two questions came before the rounds
}
