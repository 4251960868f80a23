// SPDX-License-Identifier: GPL-2.0-or-later
#include "report/targets.hpp"

#include <algorithm>
#include <cmath>

#include <catch2/catch.hpp>

#include "magicmass/batch/instruction_set.hpp"
#include "report/contestants.hpp"
#include "report/errors.hpp"
#include "report/family.hpp"

using namespace magicmass::report;

namespace {

Contestant contestant(const std::string& quantity, const std::string& name) {
  for (Contestant& one : contestants(quantity))
    if (one.name == name && one.precision == "double") return one;
  FAIL("no contestant " << name << " for " << quantity);
  return {};
}

/// Adds to a member's answer on the inputs that `where` chooses.
template <class Where>
Contestant spoiled(Contestant one, std::size_t member, Where where, double added) {
  one.evaluate = [=, right = one.evaluate](const Input& input, long double* members) {
    right(input, members);
    if (where(input)) members[member] += added;
  };
  return one;
}

std::vector<ErrorRow> errors_of(const Contestant& one, const std::vector<Family>& families) {
  Oracle oracle;
  std::vector<ErrorRow> all;
  for (const Family& family : families)
    for (const ErrorRow& row : measure(one, family, oracle, {5})) all.push_back(row);
  return all;
}

TargetResult result(const Figures& figures, const std::string& name) {
  for (const TargetResult& one : judged(figures))
    if (one.target.name == name) return one;
  FAIL("nothing was seen of: " << name);
  return {};
}

/// Batches of times of two contestants on everyday inputs; the ratio of the second to naive is 2.
Figures timed(const std::string& quantity, const std::string& mine, const std::string& other,
              std::vector<double> ratios) {
  Figures figures;
  for (const double ratio : ratios) {
    TimeRow row;
    row.precision = "double";
    row.quantity = quantity;
    row.family = "everyday";
    row.contestant = mine;
    row.ratio = 2 * ratio;
    figures.batches.push_back({row});
    row.contestant = other;
    row.ratio = 2;
    figures.batches.back().push_back(row);
  }
  return figures;
}

}  // namespace

TEST_CASE("an error of 5 envelopes on one family of a fast tier is found", "[exam]") {
  const std::string target = "fast, largest error / envelope";
  const std::vector<Family> families = {
      easiest_family("ratios", 40), {"large k", "", "ratios", {{0.0, 1 << 20}, {0.0, 1 << 21}}}};
  const Contestant sound = contestant("ratios", "fast");
  CHECK(result({errors_of(sound, families), {}, {}, {}}, target).verdict != Verdict::missed);
  // alpha_k is near 1e-12 there, 2.5 ulp are 5 envelopes of half an ulp
  const Contestant bad = spoiled(
      sound, 0, [](const Input& in) { return in.index == 1 << 20; }, 2.5 * 0x1p-92);
  const TargetResult seen = result({errors_of(bad, families), {}, {}, {}}, target);
  CHECK(seen.verdict == Verdict::missed);
  CHECK(seen.seen.value > 4);
  CHECK(seen.seen.where == "magic of fast in ratios, large k");
}

TEST_CASE("one misrounded last bit of an accurate tier is found", "[exam]") {
  const std::string target = "accurate, not correctly rounded";
  const std::vector<Family> families = {easiest_family("velocities", 40)};
  for (const char* name : {"accurate", "batch_accurate", "batch_accurate_baseline"}) {
    if (std::string(name).ends_with("baseline") &&
        magicmass::best_instruction_set() == magicmass::InstructionSet::baseline)
      continue;
    const Contestant sound = contestant("velocities", name);
    const std::vector<ErrorRow> right = errors_of(sound, families);
    CHECK(result({right, {}, {}, {}}, target).verdict == Verdict::aim_reached);
    const Input where = families[0].inputs[7];
    long double members[4];
    sound.evaluate(where, members);
    const auto b = static_cast<double>(members[1]);
    const Contestant bad = spoiled(
        sound, 1,
        [=](const Input& in) { return in.alpha == where.alpha && in.index == where.index; },
        std::nextafter(b, 2 * b) - b);
    const TargetResult seen = result({errors_of(bad, families), {}, {}, {}}, target);
    CHECK(seen.verdict == Verdict::missed);
    CHECK(seen.seen.value >= 1);
    CHECK(seen.seen.where.find(std::string("first b of ") + name + " in velocities, everyday") !=
          std::string::npos);
  }
}

TEST_CASE("one wrong count is found, alone and beside velocities", "[exam]") {
  for (const auto& [quantity, name, member] :
       {std::tuple("counts", "batch_count", 1), std::tuple("elastic_terminal", "fast", 4)}) {
    const std::vector<Family> families = {easiest_family(quantity, 20)};
    const Contestant sound = contestant(quantity, name);
    const double alpha = families[0].inputs[3].alpha;
    const Contestant bad = spoiled(
        sound, static_cast<std::size_t>(member), [=](const Input& in) { return in.alpha == alpha; },
        1);
    const std::string target = "counts, wrong answers";
    CHECK(result({errors_of(sound, families), {}, {}, {}}, target).seen.value == 0);
    const TargetResult seen = result({errors_of(bad, families), {}, {}, {}}, target);
    CHECK(seen.seen.value >= 1);
    CHECK(seen.verdict == Verdict::missed);
  }
}

TEST_CASE("a speed is judged by the median of its batches, each paired", "[exam]") {
  const auto speed_up = [](double ratio) {
    return result(timed("velocities", "batch_fast", "naive_four_calls",
                        {ratio, ratio, ratio, ratio, ratio, ratio, 1.0}),
                  "batch (i), speed-up over naive_four_calls");
  };
  CHECK(speed_up(1 / 50.0).verdict == Verdict::aim_reached);
  CHECK(speed_up(1 / 30.0).verdict == Verdict::met);
  CHECK(speed_up(1 / 20.0).verdict == Verdict::missed);
  const Seen seen = speed_up(1 / 20.0).seen;
  CHECK(seen.value == Approx(20));
  CHECK(seen.low == Approx(1));  // of seven batches the interval is the whole range
  CHECK(seen.high == Approx(20));
  const auto accurate = [](double ratio) {
    return result(timed("ratios", "accurate", "naive", {ratio}), "accurate, time / naive: ratios");
  };
  Figures figures = timed("velocities", "accurate", "naive", {2.0});
  CHECK(result(figures, "accurate, time / naive: velocities").verdict == Verdict::met);
  CHECK(std::isnan(result(figures, "accurate, time / naive: velocities").seen.low));
  for (TimeRow& row : figures.batches[0]) row.family = "zeros";
  CHECK(judged(figures).empty());  // not on everyday inputs
  CHECK_FALSE(accurate(4.0).verdict != Verdict::missed);
}

TEST_CASE("the slowest family and the slowest call are found, and where", "[exam]") {
  Figures figures;
  const auto add = [&](const char* contestant, const char* family, double ratio, double slowest) {
    TimeRow row;
    row.contestant = contestant;
    row.precision = "double";
    row.quantity = "velocities";
    row.family = family;
    row.ratio = ratio;
    row.ns_median = 100;
    row.slowest_call_ns = slowest;
    figures.times.push_back(row);
  };
  add("fast", "zeros", 1.25, 0);
  add("fast", "everyday", 0.5, 0);
  add("accurate", "zeros", 9, 2e6);
  add("accurate", "everyday", 1, 200);
  add("stepping", "zeros", 99, 9e9);
  CHECK(result(figures, "fast, time / naive, slowest family").seen.where == "velocities, zeros");
  CHECK(result(figures, "fast, time / naive, slowest family").verdict == Verdict::missed);
  CHECK(result(figures, "accurate, slowest single call").seen.value == Approx(2));
  CHECK(result(figures, "accurate, slowest single call").verdict == Verdict::missed);
  CHECK(result(figures, "accurate, slowest call / median").seen.value == Approx(2e4));
}

TEST_CASE("calls that end in certified arithmetic are counted", "[exam]") {
  Contestant one = contestant("velocities", "accurate");
  const std::string target = "accurate, certified arithmetic: velocities";
  CHECK(result({{}, {}, {}, count_fallbacks({one}, 2000)}, target).verdict == Verdict::aim_reached);
  const double alpha = easiest_family("velocities", 2000).inputs[11].alpha;
  one.falls_back = [=](const Input& in) { return in.alpha == alpha; };
  const TargetResult seen = result({{}, {}, {}, count_fallbacks({one}, 2000)}, target);
  CHECK(seen.verdict == Verdict::missed);
  CHECK(seen.seen.value == Approx(0.05));
  CHECK(seen.seen.where == "1 of 2000, everyday");
  // what no double decides is certified: alpha = 1 has exact zeros
  CHECK(contestant("velocities", "accurate").falls_back({0x1p-1000, 1}));
}

TEST_CASE("the simulator's figures are judged by their names", "[exam]") {
  Figures figures;
  figures.events = {{events::velocities, 199.0}, {events::long_chain, 2.5}, {events::memory, 250}};
  CHECK(result(figures, events::velocities).verdict == Verdict::missed);
  CHECK(result(figures, events::long_chain).verdict != Verdict::missed);
  CHECK(result(figures, events::memory).verdict == Verdict::missed);
  CHECK(judged(figures).size() == 3);
}

TEST_CASE("the simulator's figures are all there, and a body costs at most 200 bytes", "[check]") {
  Plan plan;
  plan.rounds = 1;
  plan.shortest_ns = 1;
  const std::vector<EventFigure> seen = event_figures(plan);
  Figures figures;
  figures.events = seen;
  CHECK(judged(figures).size() == 6);
  for (const EventFigure& figure : seen) {
    INFO(figure.name);
    CHECK(std::isfinite(figure.value));
    if (figure.name == events::memory) CHECK(figure.value <= 200.0);
    if (figure.name == events::memory) CHECK(figure.value >= 50.0);  // everything was counted
  }
  plan.go_on = [](double) { return false; };
  CHECK(event_figures(plan).empty());
}

TEST_CASE("nothing is said of what was not measured", "[exam]") { CHECK(judged({}).empty()); }
