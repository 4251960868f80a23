// SPDX-License-Identifier: GPL-2.0-or-later
#include "long_run/plan.hpp"

#include <algorithm>
#include <stdexcept>

#include "report/alpha_sources.hpp"
#include "report/family.hpp"

namespace magicmass::long_run {
namespace {

using report::AlphaSource;

const AlphaSource& source_named(const std::string& name) {
  for (const AlphaSource& source : report::alpha_sources())
    if (source.name == name) return source;
  throw std::logic_error("no family " + name);
}

constexpr const char* ratio_families[] = {"first k", "k above 2^32", "any number of digits"};

Inputs ratio_chunk(const Row& row, std::int64_t number, std::int64_t size) {
  report::PortableRandom random(static_cast<std::uint64_t>(number) << 32U);
  Inputs inputs;
  for (std::int64_t i = 0; i < size; ++i) {
    std::int64_t k = number * chunk_size + i + 1;
    if (row.family == ratio_families[1])
      k = random.whole(std::int64_t{1} << 32U, (std::int64_t{1} << 62U) - 1);
    if (row.family == ratio_families[2]) k = random.log_whole(std::int64_t{1} << 62U);
    inputs.push_back({0.0, k});
  }
  return inputs;
}

}  // namespace

std::vector<Row> rows(const Plan& plan) {
  std::vector<Row> all;
  for (const char* quantity : {"velocities", "terminal", "encounters", "angle"}) {
    for (const AlphaSource& source : report::alpha_sources())
      all.push_back(
          {quantity, source.name, source.name == "everyday" ? plan.everyday : plan.inputs});
  }
  for (const char* family : ratio_families) all.push_back({"ratios", family, plan.inputs});
  if (plan.quantity) {
    std::erase_if(all, [&](const Row& row) { return row.quantity != *plan.quantity; });
  }
  return all;
}

Inputs chunk(const Row& row, std::int64_t number) {
  const std::int64_t size = std::min(chunk_size, row.wanted - number * chunk_size);
  if (size <= 0) return {};
  if (row.quantity == "ratios") return ratio_chunk(row, number, size);
  const AlphaSource& source = source_named(row.family);
  // the same few numbers each time: once with each index is all there is
  if (row.family == "alpha = 1" && number > 0) return {};
  // what follows the last collision depends on alpha alone
  const std::string drawn_as = row.quantity == "terminal" ? "angle" : row.quantity;
  if (row.family == "closest thresholds" && drawn_as == "angle" && number > 0) return {};
  return report::family_of(source, drawn_as, static_cast<std::size_t>(size),
                           static_cast<std::uint64_t>(number))
      .inputs;
}

}  // namespace magicmass::long_run
