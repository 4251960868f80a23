#include "report/measure.hpp"

#include <chrono>
#include <cmath>
#include <memory>
#include <numeric>
#include <set>

#include "magicmass/oracle/certain.hpp"

namespace report {
namespace {

namespace oracle = magicmass::oracle;

void add(Truth& truth, const oracle::MassRatio& alpha, const auto& quantity) {
  const auto add_all = [](auto& to, const auto& more) {
    to.insert(to.end(), more.begin(), more.end());
  };
  add_all(truth.values, oracle::certain(alpha, quantity, oracle::to_within(120)));
  add_all(truth.rounded, oracle::certain(alpha, quantity, oracle::to_double()));
  add_all(truth.envelopes, oracle::envelopes(alpha, quantity));
}

void note(Errors& errors, const Input& input, double ulp, bool is_wrong) {
  const bool is_first = errors.max_ulp == 0 && errors.wrong == 0 && is_wrong;
  if (ulp > errors.max_ulp || is_first) errors.worst = input;
  errors.max_ulp = std::max(errors.max_ulp, ulp);
  errors.wrong += is_wrong ? 1 : 0;
}

bool same_sign(double x, double y) { return (x > 0) == (y > 0) && (x < 0) == (y < 0); }

bool takes(const Implementation& implementation, const Input& input) try {
  Columns one({&input, 1});
  implementation.run(one);
  return true;
} catch (const std::domain_error&) {
  return false;
}

/// The same rows for both, the inputs again and again until there are enough.
Pair paired(const Implementation& baseline, const Implementation& ours,
            const std::vector<Input>& inputs) {
  std::vector<Input> rows;
  for (std::size_t i = 0; i < ours.most_timed; ++i) rows.push_back(inputs[i % inputs.size()]);
  const auto work = [&rows](const Implementation& one) {
    return [&one, columns = std::make_shared<Columns>(rows)] { one.run(*columns); };
  };
  return {work(baseline), work(ours), rows.size()};
}

double nanoseconds(const std::function<void()>& work, std::size_t repetitions) {
  const auto start = std::chrono::steady_clock::now();
  for (std::size_t i = 0; i < repetitions; ++i) work();
  const std::chrono::duration<double, std::nano> taken = std::chrono::steady_clock::now() - start;
  return taken.count();
}

std::size_t long_enough(const std::function<void()>& work, double shortest_ns) {
  std::size_t repetitions = 1;
  while (nanoseconds(work, repetitions) < shortest_ns) repetitions *= 2;
  return repetitions;
}

}  // namespace

Truth truth(Quantity quantity, const Input& input) {
  Truth found{.input = input};
  const cln::cl_I index = static_cast<long long>(input.index);
  const cln::cl_RA alpha = oracle::exact(input.alpha);
  if (quantity == Quantity::ratios) {
    add(found, oracle::magic(index), oracle::Itself());
    add(found, oracle::deficient(index), oracle::Itself());
  } else if (quantity == Quantity::collisions) {
    add(found, oracle::ratio(alpha), oracle::AtCollision(index));
  } else if (quantity == Quantity::velocities) {
    add(found, oracle::ratio(alpha), oracle::OfCycle(index));
  } else {
    const oracle::Counts counts = oracle::count_collisions(alpha);
    found.counts = {cln::cl_I_to_long(counts.N_A), cln::cl_I_to_long(counts.N_B)};
    if (quantity == Quantity::terminal) add(found, oracle::ratio(alpha), oracle::AtEnd(counts));
  }
  return found;
}

Errors errors_of(const Columns& results, std::span<const Truth* const> truths) {
  Errors errors{.samples = truths.size()};
  for (std::size_t row = 0; row < truths.size(); ++row) {
    const Truth& truth = *truths[row];
    for (std::size_t i = 0; i < truth.values.size(); ++i) {
      const double got = results.values[i][row];
      const double nearest = truth.rounded[i];
      const double ulp = cln::zerop(truth.values[i]) ? 0 : oracle::ulp_error(got, truth.values[i]);
      errors.over_envelope = std::max(errors.over_envelope, ulp / truth.envelopes[i]);
      errors.misrounded += got != nearest ? 1 : 0;
      note(errors, truth.input, ulp, std::isnan(got) || !same_sign(got, nearest));
    }
    if (!truth.counts) continue;
    const std::int64_t exact[] = {truth.counts->N_A, truth.counts->N_B};
    for (std::size_t i = 0; i < 2; ++i) {
      const double off = std::abs(double(results.counts[i][row] - exact[i]));
      note(errors, truth.input, truth.values.empty() ? off : 0, off != 0);
    }
  }
  return errors;
}

/// Not Google Benchmark: that times one after the other, and has no ratio paired round by round.
std::vector<Times> timed(const std::vector<Pair>& pairs, const Rounds& rounds) {
  struct Seen {
    std::array<std::size_t, 2> repetitions;
    std::vector<double> ns = {}, ratios = {};
  };
  std::vector<Seen> seen;
  for (const Pair& pair : pairs)
    seen.push_back({{long_enough(pair.naive, rounds.shortest_ns),
                     long_enough(pair.ours, rounds.shortest_ns)}});
  std::mt19937_64 random(1);
  std::array<std::size_t, 2> sides{0, 1};  // naive, ours
  std::vector<std::size_t> order(pairs.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  for (std::size_t round = 0; round < rounds.count; ++round) {
    std::ranges::shuffle(order, random);
    for (const std::size_t i : order) {
      std::array<double, 2> ns{};
      std::ranges::shuffle(sides, random);
      for (const std::size_t which : sides) {
        const auto& work = which == 0 ? pairs[i].naive : pairs[i].ours;
        work();
        ns[which] = nanoseconds(work, seen[i].repetitions[which]) /
                    double(seen[i].repetitions[which] * pairs[i].evaluations);
      }
      seen[i].ns.push_back(ns[1]);
      seen[i].ratios.push_back(ns[1] / ns[0]);
    }
  }
  std::vector<Times> times;
  for (Seen& one : seen) {
    std::sort(one.ns.begin(), one.ns.end());
    std::sort(one.ratios.begin(), one.ratios.end());
    const std::size_t middle = rounds.count / 2;
    times.push_back({one.ns[middle], one.ratios[middle], one.ratios.front(), one.ratios.back()});
  }
  return times;
}

std::vector<Measurement> measure(const Plan& plan) {
  std::vector<Measurement> all;
  std::vector<Pair> pairs;
  for (const auto& [quantity, name] : quantities)
    for (const Family& family : families()) {
      std::vector<Truth> samples;  // made when the first implementation asks for them
      const Implementation* naive = nullptr;
      for (const Implementation& one : plan.implementations) {
        if (one.quantity != quantity) continue;
        if (one.name == "naive") naive = &one;
        if (!std::set{std::string(), one.name, name, family.name}.contains(plan.only)) continue;
        if (samples.empty())
          for (const Input& input : inputs_of(family, quantity, plan.draws))
            samples.push_back(truth(quantity, input));
        std::vector<Input> inputs;
        std::vector<const Truth*> truths;
        for (const Truth& sample : samples) {
          if (!takes(one, sample.input)) continue;
          inputs.push_back(sample.input);
          truths.push_back(&sample);
        }
        if (inputs.empty()) continue;
        Columns results(inputs);
        one.run(results);
        all.push_back({one.name, quantity, family.name, errors_of(results, truths), {}});
        if (plan.rounds.count > 0) pairs.push_back(paired(*naive, one, inputs));
      }
    }
  const std::vector<Times> times = timed(pairs, plan.rounds);
  for (std::size_t i = 0; i < times.size(); ++i) all[i].times = times[i];
  return all;
}

}  // namespace report
