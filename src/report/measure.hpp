// Errors and times of each implementation on each family of difficult inputs.
#pragma once

#include <array>
#include <functional>
#include <limits>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include <cln/rational.h>

#include "magicmass/numbers/values.hpp"

namespace report {

using Random = std::mt19937_64;

enum class Quantity {
  velocities,  ///< a, b, c, c' at alpha and n
  collisions,  ///< t and s of collision j
  terminal,    ///< N_A, N_B; a_t, b_t, c_t, rho at alpha
  counts,      ///< N_A, N_B at alpha
  ratios       ///< alpha_k and beta_k
};
inline const std::vector<std::pair<Quantity, std::string>> quantities{
    {Quantity::velocities, "velocities"},
    {Quantity::collisions, "collisions"},
    {Quantity::terminal, "terminal"},
    {Quantity::counts, "counts"},
    {Quantity::ratios, "ratios"}};
inline std::string name_of(Quantity quantity) { return quantities[std::size_t(quantity)].second; }

/// The index is n of velocities, j of the last collision of cycle n, k of ratios, else 0.
struct Input {
  double alpha = 0;
  std::int64_t index = 0;
  friend bool operator==(const Input&, const Input&) = default;
};

struct Family {
  std::string name;
  std::string description;
  std::uint64_t seed;
  double (*alpha)(Random&);
  /// Some n for a motion whose last is N_A.
  std::int64_t (*n)(Random&, std::int64_t last);
};
/// Hardest first.
const std::vector<Family>& families();

/// So many draws of the family for the quantity, each input once. For terminal velocities and
/// counts those alpha whose counts fit 63 bits; for ratios the k = N_A of these.
std::vector<Input> inputs_of(const Family& family, Quantity quantity, std::size_t draws);

/// Inputs, and what an implementation makes of them.
struct Columns {
  explicit Columns(std::span<const Input> inputs);
  std::size_t size() const { return alpha.size(); }

  std::vector<double> alpha;
  std::vector<std::int64_t> index;
  std::array<std::vector<double>, 4> values;        ///< in the order of Quantity's words
  std::array<std::vector<std::int64_t>, 2> counts;  ///< N_A, N_B
};

struct Implementation {
  std::string name;
  Quantity quantity;
  /// Fills the results. Throws std::domain_error for an input that this way does not take.
  std::function<void(Columns&)> run;
  std::size_t most_timed = 500;  ///< rows of a pass that is timed: fewer where it is slow
};
/// The naive one of a quantity before its others.
const std::vector<Implementation>& implementations();

struct Truth {
  Input input;
  std::vector<cln::cl_RA> values = {};  ///< exact where n is small, else to 120 bits
  std::vector<double> rounded = {};     ///< the nearest doubles, with certainty
  std::vector<double> envelopes = {};   ///< max(1/2, |alpha y'/(2 y)|) in ulp; infinite where y = 0
  std::optional<magicmass::Counts> counts = {};  ///< of terminal and counts
};
Truth truth(Quantity quantity, const Input& input);

/// Where the exact value is 0 only 0 is right, and there is no ulp error. Counts have errors of
/// their own only where nothing else is asked: |got - exact|.
struct Errors {
  std::size_t samples = 0;
  double max_ulp = 0;        ///< infinite where a result is not finite
  Input worst = {};          ///< the input of max_ulp, or of the first wrong answer where that is 0
  double over_envelope = 0;  ///< the largest error over its envelope
  std::size_t misrounded = 0;  ///< values other than the nearest double
  std::size_t wrong = 0;       ///< counts, and values of the wrong sign
  friend bool operator==(const Errors&, const Errors&) = default;
};
/// Row i of the results belongs to truths[i].
Errors errors_of(const Columns& results, std::span<const Truth* const> truths);

struct Pair {
  std::function<void()> naive, ours;
  std::size_t evaluations;  ///< of one call of either
};
struct Times {
  static constexpr double none = std::numeric_limits<double>::quiet_NaN();
  double ns = none;                            ///< of one evaluation, the rounds' median
  double ratio = none;                         ///< ours over naive, the rounds' median
  double ratio_low = none, ratio_high = none;  ///< the least and the largest of the rounds
};
struct Rounds {
  std::size_t count = 9;
  double shortest_ns = 1e6;  ///< of one measurement
};

/// In each round each pair comes once, in random order, and in it either one first: what disturbs
/// the machine for a while disturbs a pair alike. A call that is not timed goes before each
/// measurement, and calls are repeated until it is long enough.
std::vector<Times> timed(const std::vector<Pair>& pairs, const Rounds& rounds);

struct Plan {
  std::vector<Implementation> implementations = report::implementations();
  std::size_t draws = 1000;  ///< of a family
  Rounds rounds = {};        ///< none: errors alone
  std::string only = {};     ///< a quantity, family or evaluator; "" for all
};

struct Measurement {
  std::string evaluator;
  Quantity quantity;
  std::string family;
  Errors errors;
  Times times;
};

/// A measurement for each implementation that takes any input of the family. Where there are
/// rounds, a quantity's first implementation is "naive".
std::vector<Measurement> measure(const Plan& plan);

}  // namespace report
