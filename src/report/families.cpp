// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>
#include <cstdint>

#include "report/alpha_sources.hpp"
#include "report/family.hpp"
#include "report/last_collision.hpp"
#include "report/quantities.hpp"

namespace magicmass::report {
namespace {

constexpr std::int64_t two_32 = std::int64_t{1} << 32U;

/// Index i of a family: of a cycle n <= N_A, or of a collision j.
std::int64_t picked(Pick pick, const Alpha& alpha, std::int64_t last, bool is_cycle, std::size_t i,
                    PortableRandom& random) {
  const auto turn = [&](std::int64_t count) { return static_cast<std::int64_t>(i) % count; };
  switch (pick) {
    case Pick::at_threshold:
      return is_cycle ? std::min(alpha.k, last) : last;
    case Pick::around_threshold: {
      const std::int64_t near[] = {last, last - 1, is_cycle ? alpha.k : 2 * alpha.k,
                                   random.whole(0, last), alpha.k - 1};
      return std::clamp<std::int64_t>(near[turn(5)], 0, last);
    }
    case Pick::near_the_last: {
      const std::int64_t near[] = {last, last - 1, last - random.whole(0, 1000),
                                   random.whole(0, last)};
      return near[turn(4)];
    }
    case Pick::beyond_2_32:
      return random.whole(std::min(two_32, last), last);
    case Pick::few:
      return turn(2) == 0 ? std::min<std::int64_t>(random.whole(0, 9), last)
                          : random.log_whole(last);
    case Pick::ends: {
      const std::int64_t ends[] = {0, std::min<std::int64_t>(1, last),
                                   std::max<std::int64_t>(0, last - 1), last};
      // shifted every 7, so that the same alpha gets another end the next time
      return ends[(i + 2 * (i / 7)) % 4];
    }
    case Pick::anywhere:
      return turn(2) == 0 ? random.whole(0, last)
                          : random.log_whole(std::max<std::int64_t>(1, last));
  }
  return 0;
}

/// Of what takes k alone.
std::vector<Family> ratio_families(const std::string& quantity, std::size_t size) {
  std::vector<Family> all{
      {"closest thresholds", "alpha_539 and beta_19530, the closest to a double", quantity, {}},
      {"k above 2^32", "k from 2^32 to 2^62", quantity, {}},
      {"k to 1e6", "k to 1e6 with a uniform number of digits", quantity, {}},
      {"first k", "k = 1, 2, 3, ...", quantity, {}}};
  PortableRandom random(21);
  all[0].inputs = {{0.0, 539}, {0.0, 19530}};
  for (std::size_t i = 0; i < size; ++i) {
    all[1].inputs.push_back({0.0, random.log_whole(std::int64_t{1} << 30U) << 32U});
    all[2].inputs.push_back({0.0, random.log_whole(1000000)});
    all[3].inputs.push_back({0.0, static_cast<std::int64_t>(i) + 1});
  }
  for (Family& family : all)
    if (family.inputs.size() > size) family.inputs.resize(size);
  return all;
}

/// Places in sequences with room for what is timed from there on.
Family long_sequences(const std::string& quantity, std::size_t size) {
  Family family{
      "long sequences", "alpha 1e-20 to 1e-10, any n with 4096 more to come", quantity, {}};
  PortableRandom random(22);
  for (std::size_t i = 0; i < size; ++i) {
    const double alpha = random.log_uniform(1e-20, 1e-10);
    family.inputs.push_back({alpha, random.whole(0, last_collision(alpha).N_A - 4096)});
  }
  return family;
}

}  // namespace

Family easiest_family(const std::string& quantity, std::size_t size) {
  const std::string& name = quantity_named(quantity).name;
  if (!takes_alpha(name) || name == "sequence") return families(name, size).back();
  return family_of(alpha_sources().back(), name, size);
}

Family family_of(const AlphaSource& source, const std::string& quantity, std::size_t size,
                 std::uint64_t round) {
  PortableRandom random(source.seed + (round << 32U));
  Family family{source.name, source.description, quantity, {}};
  const Quantity& asked = quantity_named(quantity);
  const bool is_cycle = asked.takes("n");
  std::size_t i = 0;
  for (const Alpha& alpha : source.draw(random, size)) {
    Input input{alpha.value, 0};
    if (!asked.index().empty()) {
      const LastCollision collisions = last_collision(alpha.value);
      const std::int64_t last = is_cycle ? collisions.N_A : collisions.total() - 1;
      input.index = std::min(last, picked(source.pick, alpha, last, is_cycle, i++, random));
    }
    if (has_counts(quantity) && !last_collision(alpha.value).is_known) continue;
    if (asked.takes("e"))
      input.e = family.inputs.size() % 4 == 0 ? 1.0 : random.log_uniform(0.01, 1.0);
    family.inputs.push_back(input);
  }
  return family;
}

std::vector<Family> families(const std::string& quantity, std::size_t size) {
  const std::string& name = quantity_named(quantity).name;
  if (!takes_alpha(name)) return ratio_families(name, size);
  if (name == "sequence") return {long_sequences(name, size)};
  std::vector<Family> all;
  for (const AlphaSource& source : alpha_sources())
    if (source.has_count || !has_counts(name)) all.push_back(family_of(source, name, size));
  return all;
}

}  // namespace magicmass::report
