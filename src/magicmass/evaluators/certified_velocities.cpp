// SPDX-License-Identifier: MIT
#include "magicmass/evaluators/certified_velocities.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include "magicmass/counts.hpp"
#include "magicmass/errors.hpp"
#include "magicmass/evaluators/velocity_attempts.hpp"
#include "magicmass/simulator/valid_input.hpp"

namespace magicmass {
namespace {

void require_valid(double alpha, std::int64_t n) {
  require_positive_finite("alpha", alpha);
  if (n < 0) {
    throw InvalidInput("n must be 0 or more, got " + std::to_string(n));
  }
}

template <std::size_t Words>
std::optional<double> attempt_member(Velocity member, double alpha, std::uint64_t n) {
  const auto with = [&](const auto& form) { return attempt_velocity<Words>(form, alpha, n); };
  using Number = NearInteger<Words>;
  switch (member) {
    case Velocity::a:
      return with(generated::a_exact<Number, std::uint64_t>);
    case Velocity::b:
      return with(generated::b_exact<Number, std::uint64_t>);
    case Velocity::c:
      return with(generated::c_exact<Number, std::uint64_t>);
    case Velocity::c_prime:
      return with(generated::c_prime_exact<Number, std::uint64_t>);
  }
  throw InvalidInput("no such velocity");
}

}  // namespace

double certified_velocity(Velocity member, double alpha, std::int64_t n) {
  require_valid(alpha, n);
  if (n == 0) {
    return member == Velocity::a ? 1.0 : 0.0;
  }
  return certain("the rounding of a velocity", [&]<std::size_t Words>() {
    return attempt_member<Words>(member, alpha, static_cast<std::uint64_t>(n));
  });
}

generated::Velocities<double> certified_velocities(double alpha, std::int64_t n) {
  require_valid(alpha, n);
  if (n == 0) {
    return {1.0, 0.0, 0.0, 0.0};
  }
  generated::Velocities<std::optional<double>> found;
  using Result = std::optional<generated::Velocities<double>>;
  return certain("the rounding of a velocity", [&]<std::size_t Words>() -> Result {
    const auto now = attempt_velocities<Words>(alpha, static_cast<std::uint64_t>(n));
    found = {found.a ? found.a : now.a, found.b ? found.b : now.b, found.c ? found.c : now.c,
             found.c_prime ? found.c_prime : now.c_prime};
    if (!found.a || !found.b || !found.c || !found.c_prime) {
      return std::nullopt;
    }
    return generated::Velocities<double>{*found.a, *found.b, *found.c, *found.c_prime};
  });
}

double certified_energy_fraction(double alpha) {
  const std::optional<Counts> counts = count_collisions(alpha);
  // b_t (2+alpha) = 1 - (1+alpha) cos((2 N_B + 1) h) with |(2 N_B + 1) h - pi| <= h, so 1 - alpha <= b_t <= 1, and
  // alpha < 2^-123 where the counts are beyond 64 bits.
  if (!counts) {
    return 1.0;
  }
  return certain("the rounding of the energy fraction", [&]<std::size_t Words>() {
    return attempt_energy_fraction<Words>(alpha, static_cast<std::uint64_t>(counts->N_B));
  });
}

}  // namespace magicmass
