#include "report/measure.hpp"

#include <bit>
#include <chrono>
#include <cmath>
#include <memory>
#include <numeric>
#include <set>

#include "magicmass/numbers/counts.hpp"
#include "magicmass/oracle/certain.hpp"

namespace report {
namespace {

namespace oracle = magicmass::oracle;

// Random numbers that are the same on every machine: whole numbers and exactly rounded operations.
// The standard fixes what its engines give, not what its distributions do.

/// From low to high, both included; 0 <= low <= high < 2^63.
std::int64_t whole(Random& random, std::int64_t low, std::int64_t high) {
  return low + std::int64_t(random() % (std::uint64_t(high - low) + 1));
}
/// From 1 to high >= 1, with a uniform number of bits.
std::int64_t log_whole(Random& random, std::int64_t high) {
  const int longest = int(std::bit_width(std::uint64_t(high)));
  for (;;) {
    const std::uint64_t top = std::uint64_t{1} << (whole(random, 1, longest) - 1);
    const auto drawn = std::int64_t(top | (random() & (top - 1)));
    if (drawn <= high) return drawn;
  }
}
/// A double from low to high, both included and positive, each as likely as the next: in the
/// normal range its logarithm is uniform but for some percent of a factor of 2.
double among(Random& random, double low, double high) {
  return std::bit_cast<double>(
      whole(random, std::bit_cast<std::int64_t>(low), std::bit_cast<std::int64_t>(high)));
}

constexpr double largest = std::numeric_limits<double>::max();

/// At most so many doubles away from x.
double neighbour(Random& random, double x, std::int64_t most) {
  const std::int64_t steps = whole(random, 0, 2 * most) - most;
  return std::bit_cast<double>(std::bit_cast<std::int64_t>(x) + steps);
}

/// The double nearest to alpha_k or beta_k, for some k up to 2^bits.
double threshold(Random& random, oracle::MassRatio (*of)(const cln::cl_I&), unsigned bits) {
  const long long k = log_whole(random, std::int64_t{1} << bits);
  return oracle::certain(of(k), oracle::Itself(), oracle::to_double())[0];
}

std::int64_t anywhere(Random& random, std::int64_t last) { return whole(random, 0, last); }
std::int64_t ends(Random& random, std::int64_t last) {
  const std::int64_t from_either = whole(random, 0, 1);
  return whole(random, 0, 1) == 0 ? from_either : last - from_either;
}
/// a_n and c'_n all but vanish at the last cycle of a magic ratio.
std::int64_t mostly_last(Random& random, std::int64_t last) {
  return whole(random, 0, 3) == 0 ? anywhere(random, last) : last - whole(random, 0, 1);
}

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

const std::vector<Family>& families() {
  static const std::vector<Family> all{
      {"closest thresholds", "3 ulp around the two closest to a double", 1,
       [](Random& r) {
         const bool is_magic = whole(r, 0, 1) == 0;  // alpha_539, else beta_19530
         return neighbour(r, is_magic ? 0x1.1c7397cb68b7ep-18 : 0x1.bc7fb47556f22p-29, 3);
       },
       mostly_last},
      {"magic neighbours", "alpha_k and 3 ulp around it, k to 2^50", 2,
       [](Random& r) { return neighbour(r, threshold(r, oracle::magic, 50), 3); }, mostly_last},
      {"deficient neighbours", "beta_k and 3 ulp around it, k to 2^20", 3,
       [](Random& r) { return neighbour(r, threshold(r, oracle::deficient, 20), 3); }, mostly_last},
      {"alpha = 1", "1 and 3 ulp around it", 4, [](Random& r) { return neighbour(r, 1, 3); }, ends},
      {"first and last", "alpha from 1e-20 to 100, n = 0, 1, N - 1, N", 5,
       [](Random& r) { return among(r, 1e-20, 100); }, ends},
      {"many collisions", "alpha from 5.9e-38 to 2e-19, N from 2^32 to 2^62", 6,
       [](Random& r) { return among(r, 5.9e-38, 2e-19); }, log_whole},
      {"tiny", "alpha from 1e-300 to 1e-30", 7, [](Random& r) { return among(r, 1e-300, 1e-30); },
       log_whole},
      // As many leading zeros as one likes, else nearly all would be next to the normal range.
      {"subnormal", "alpha below 2.3e-308", 8,
       [](Random& r) { return std::bit_cast<double>(log_whole(r, (1LL << 52U) - 1)); }, log_whole},
      {"huge", "alpha from 1e3 to the largest double", 9,
       [](Random& r) { return whole(r, 0, 15) == 0 ? largest : among(r, 1e3, largest); }, ends},
      {"any double", "every positive double alike", 10,
       [](Random& r) { return among(r, 0x1p-1074, largest); }, log_whole},
      {"everyday", "alpha from 1e-4 to 1", 11, [](Random& r) { return among(r, 1e-4, 1); },
       anywhere},
  };
  return all;
}

std::vector<Input> inputs_of(const Family& family, Quantity quantity, std::size_t draws) {
  Random random(family.seed);
  std::vector<Input> inputs;
  std::set<std::pair<double, std::int64_t>> seen;
  for (std::size_t draw = 0; draw < draws; ++draw) {
    const double alpha = family.alpha(random);
    // The counts only choose what is asked: the oracle finds its own.
    const std::optional<magicmass::Counts> counts = magicmass::count_collisions(alpha);
    const std::int64_t n = family.n(random, counts ? counts->N_A : std::int64_t{1} << 62U);
    if (!counts && quantity != Quantity::velocities) continue;
    const Input input = quantity == Quantity::velocities ? Input{alpha, n}
                        : quantity == Quantity::collisions
                            ? Input{alpha, n + std::min(n, counts->N_B) - (n > 0 ? 1 : 0)}
                        : quantity == Quantity::ratios ? Input{0, counts->N_A}
                                                       : Input{alpha, 0};
    if (seen.insert({input.alpha, input.index}).second) inputs.push_back(input);
  }
  return inputs;
}

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
