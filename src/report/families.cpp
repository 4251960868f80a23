#include <bit>
#include <set>

#include "magicmass/numbers/counts.hpp"
#include "magicmass/oracle/certain.hpp"
#include "report/measure.hpp"

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

}  // namespace report
