// The report finds what is wrong, where it is wrong, and nothing else.
#include "report/report.hpp"

#include <cmath>
#include <fstream>

#include <nlohmann/json.hpp>

#include "catch.hpp"
#include "magicmass/numbers/accurate.hpp"

namespace {

using namespace report;

Plan errors_alone() { return {.draws = 40, .rounds = {.count = 0}}; }
const std::vector<Measurement>& all() {
  static const std::vector<Measurement> measurements = measure(errors_alone());
  return measurements;
}
const Errors& errors_of(const std::string& name, Quantity quantity, const std::string& family) {
  for (const Measurement& one : all())
    if (one.evaluator == name && one.quantity == quantity && one.family == family)
      return one.errors;
  throw std::out_of_range(name + ", " + family);
}

}  // namespace

TEST_CASE("Naive is known to be bad near thresholds, and found to be", "[check]") {
  for (const std::string family : {"closest thresholds", "magic neighbours"}) {
    INFO(family);
    CHECK(errors_of("naive", Quantity::counts, family).wrong > 0);
    CHECK(errors_of("naive", Quantity::terminal, family).max_ulp > 1e6);
    CHECK(errors_of("naive", Quantity::velocities, family).over_envelope > 1e3);
  }
}

TEST_CASE("Tiers keep their promises", "[check]") {
  for (const Measurement& one : all()) {
    INFO(one.evaluator << ", " << name_of(one.quantity) << ", " << one.family);
    const std::string& name = one.evaluator;
    const bool is_accurate = name.starts_with("accurate") || name == "exact rational";
    if (is_accurate) CHECK((one.errors.misrounded == 0 && one.errors.max_ulp <= 0.5));
    if (name.starts_with("fast")) CHECK(one.errors.over_envelope <= 4);
    if (is_accurate || name.starts_with("count")) CHECK(one.errors.wrong == 0);
  }
}

TEST_CASE("Three ulp planted in one family are found there alone", "[check]") {
  Plan plan = errors_alone();
  const auto planted = [](Columns& columns) {
    auto& [a, b, c, c_prime] = columns.values;
    magicmass::accurate::velocities(columns.alpha, columns.index, {a, b, c, c_prime});
    for (std::size_t i = 0; i < columns.size(); ++i)
      if (columns.alpha[i] < std::numeric_limits<double>::min())
        for (int ulp = 0; ulp < 3; ++ulp) b[i] = std::nextafter(b[i], 1.0);
  };
  plan.implementations = {{"planted", Quantity::velocities, planted}};
  for (const Measurement& one : measure(plan)) {
    INFO(one.family);
    const bool is_there = one.family == "subnormal";
    CHECK((one.errors.max_ulp > 2.4) == is_there);
    CHECK((one.errors.misrounded > 0) == is_there);
    if (is_there) CHECK((one.errors.max_ulp <= 3.5 && one.errors.worst.alpha < 0x1p-1022));
  }
}

TEST_CASE("A zero, a sign, a NaN and a count", "[exam]") {
  const Input one{1, 1};
  const auto seen = [&](double a, double b, Quantity quantity = Quantity::velocities) {
    Columns columns({&one, 1});
    columns.values = {{{a}, {b}, {1}, {0}}};
    columns.counts = {{{4}, {1}}};
    const Truth exact = truth(quantity, one);  // 0, 1, 1, 0; counts 1 and 1
    const Truth* const truths[] = {&exact};
    return report::errors_of(columns, truths);
  };
  const Errors right{1, 0, {}, 0, 0, 0};
  CHECK(seen(0, 1) == right);
  CHECK(seen(-0.0, 1) == right);
  CHECK(seen(1e-300, 1) == Errors{1, 0, one, 0, 1, 1});
  const Errors turned = seen(0, -1);
  CHECK((turned.wrong == 1 && turned.max_ulp == 0x1p53));
  const Errors lost = seen(0, std::nan(""));
  CHECK((lost.wrong == 1 && std::isinf(lost.max_ulp) && lost.misrounded == 1));
  CHECK(seen(std::nan(""), 1).wrong == 1);
  CHECK(truth(Quantity::counts, one).counts == magicmass::Counts{1, 1});
  const Errors off = seen(0, 0, Quantity::counts);
  CHECK((off.wrong == 1 && off.max_ulp == 3 && off.worst == one));
}

TEST_CASE("Every pair is called in every round, naive as often as ours", "[check]") {
  std::map<std::string, int> calls;
  const auto work = [&](const std::string& name) { return [&calls, name] { ++calls[name]; }; };
  const std::vector<Pair> pairs{{work("a"), work("b"), 1}, {work("c"), work("d"), 1}};
  const std::vector<Times> times = timed(pairs, {.count = 9, .shortest_ns = 0});
  CHECK(calls == std::map<std::string, int>{{"a", 19}, {"b", 19}, {"c", 19}, {"d", 19}});
  REQUIRE(times.size() == 2);
  for (const Times& one : times) CHECK((one.ratio_low <= one.ratio && one.ratio <= one.ratio_high));
}

TEST_CASE("Each form that the manifest has of a quantity is measured", "[exam]") {
  const std::map<std::string, std::string> ours{
      {"collision", "collisions"}, {"magic", "ratios"},
      {"deficient", "ratios"},     {"evaluator", "accurate"},
      {"exact", "exact rational"}, {"counts evaluator", "count_collisions"}};
  const auto word = [&](const std::string& of) { return ours.contains(of) ? ours.at(of) : of; };
  std::map<std::string, std::set<std::string>> forms;
  for (const Implementation& one : implementations()) forms[name_of(one.quantity)].insert(one.name);
  for (const auto& entry : nlohmann::json::parse(std::ifstream(MANIFEST))) {
    const std::string name = entry.at("name"), form = entry.at("form"), both = name + " " + form;
    INFO(both);
    const auto of = forms.find(word(name));
    const std::string wanted = word(ours.contains(both) ? both : form);
    CHECK((of == forms.end() || of->second.contains(wanted)));
  }
}

TEST_CASE("The worst of all families stands beside the time of everyday ones", "[check]") {
  const auto seen = [](const char* family, double ulp, double ratio) {
    const Times times{.ratio = ratio, .ratio_low = ratio, .ratio_high = 1.5 * ratio};
    return Measurement{"naive", Quantity::velocities, family, {.max_ulp = ulp}, times};
  };
  const std::string both = document_of({seen("everyday", 1, 7), seen("tiny", 2, 9)}, true);
  CHECK(both.find("\n| naive | tiny | 2 | 0 | 0 | 7 +-50 % |") != std::string::npos);
}
