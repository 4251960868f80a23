// SPDX-License-Identifier: GPL-2.0-or-later
#include "report/contestants.hpp"

#include <cstdint>
#include <iterator>
#include <utility>

#include "magicmass/counts.hpp"
#include "magicmass/evaluators.hpp"
#include "report/make_contestant.hpp"
#include "report/quantities.hpp"
#include "report/table_contestants.hpp"
#include "report/transcription.hpp"

namespace magicmass::report {
namespace {

void append(std::vector<Contestant>& all, std::vector<Contestant> more) {
  all.insert(all.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
}

template <class Real>
std::vector<Contestant> generated_in(const std::string& quantity) {
  std::vector<Contestant> all;
  const auto add = [&]<const auto & table>(const char* name, const char*, const char*) {
    if (name == quantity) all = table_contestants<Real, table>(quantity);
  };
  generated::visit_tables<Real>(add);
  return all;
}

/// The transcription of a quantity with these types.
template <class Real, class Angle>
Contestant naive(const std::string& quantity, const std::string& name, const std::string& form) {
  const auto make = [&](auto evaluate) {
    return make_contestant(name, quantity, form, precision_name<Real>(), evaluate);
  };
  using namespace transcription;
  if (quantity == "velocities" || quantity == "sequence")
    return make([](const Input& in) {
      return velocities<Real, Angle>(static_cast<Real>(in.alpha), in.index);
    });
  if (quantity == "encounters")
    return make([](const Input& in) {
      return encounters<Real, Angle>(static_cast<Real>(in.alpha), in.index);
    });
  if (quantity == "ratios")
    return make([](const Input& in) { return ratios<Real, Angle>(in.index); });
  if (quantity == "counts")
    return make([](const Input& in) { return counts<Real, Angle>(static_cast<Real>(in.alpha)); });
  if (quantity == "elastic_terminal")
    return make([](const Input& in) { return ending<Real, Angle>(static_cast<Real>(in.alpha)); });
  return make([](const Input& in) {
    return static_cast<Real>(psi<Real, Angle>(static_cast<Real>(in.alpha)));
  });
}

}  // namespace

std::vector<Contestant> naive_contestants(const std::string& quantity) {
  std::vector<Contestant> all{naive<double, double>(quantity, "naive", "naive"),
                              naive<float, float>(quantity, "naive", "naive"),
                              naive<long double, long double>(quantity, "naive", "naive")};
  for (Contestant& one : all) one.is_naive = true;
  if (quantity == "sequence") return all;
  if (quantity == "velocities")
    all.push_back(
        make_contestant("naive_four_calls", quantity, "naive, each velocity by itself", "double",
                        [](const Input& in) -> generated::Velocities<double> {
                          using namespace transcription;
                          return {a_alone(in.alpha, in.index), b_alone(in.alpha, in.index),
                                  c_alone(in.alpha, in.index), c_prime_alone(in.alpha, in.index)};
                        }));
  all.push_back(
      naive<double, long double>(quantity, "naive_long_angles", "naive, angles in long double"));
  return all;
}

std::vector<Contestant> generated_contestants(const std::string& quantity) {
  std::vector<Contestant> all;
  append(all, generated_in<double>(quantity));
  append(all, generated_in<float>(quantity));
  append(all, generated_in<long double>(quantity));
  return all;
}

std::vector<Contestant> certified_contestants(const std::string& quantity) {
  if (quantity != "counts") return {};
  Contestant one =
      make_contestant("count_collisions", quantity, "certified", "double", [](const Input& in) {
        return count_collisions(in.alpha).value_or(Counts{-1, -1});
      });
  one.ulp_bound = 0;
  return {one};
}

std::vector<Contestant> contestants(const std::string& quantity) {
  const auto& [name, members, inputs, is_known] = quantity_named(quantity);
  if (!is_known) return generated_contestants(name);
  std::vector<Contestant> all;
  for (const auto& part :
       {naive_contestants, generated_contestants, certified_contestants, tier_contestants,
        batch_contestants, sequence_contestants, stepping_contestants, rational_contestants,
        digits_contestants, vector_contestants})
    append(all, part(name));
  return all;
}

}  // namespace magicmass::report
