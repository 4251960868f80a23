// SPDX-License-Identifier: MIT
// The batch functions on several threads, for arrays past the cache: the results are the same bits as without. A call
// with fewer than some ten thousand rows gains nothing. Every function of batch.hpp is here but velocity_stream, each row of which
// takes the one before.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>

#include "magicmass/batch.hpp"

namespace magicmass {

/// How many threads a call may use, the caller's one of them: 1 or more.
struct Threads {
  unsigned count = 1;  ///< the caller's included

  /// One a processor that this machine has.
  static Threads all();
};

/// Rows of a part are a multiple of this, and a part has at least so many.
inline constexpr std::size_t least_part = 4096;

/// Calls part(first, rows) for consecutive parts that make up 0, 1, ..., size - 1, on as many threads, and returns when all are
/// done. Where the parts begin depends on size and threads alone. If calls throw, the exception of the first such part is
/// thrown again; a thread that the system refuses leaves its part to the caller's. Throws InvalidInput for 0 threads.
void in_parallel(Threads threads, std::size_t size,
                 const std::function<void(std::size_t first, std::size_t rows)>& part);

/// As in batch.hpp, on these threads.
void count_collisions(std::span<const double> alpha, std::span<std::int64_t> N_A,
                      std::span<std::int64_t> N_B, Threads threads);
namespace fast {
/// As in batch.hpp, on these threads.
void velocities(std::span<const double> alpha, std::span<const std::int64_t> n, std::span<double> a,
                std::span<double> b, std::span<double> c, std::span<double> c_prime,
                Threads threads);
/// As in batch.hpp, on these threads.
void velocities(std::span<const double> alpha, std::int64_t n, std::span<double> a,
                std::span<double> b, std::span<double> c, std::span<double> c_prime,
                Threads threads);
/// As in batch.hpp, on these threads.
void terminal(std::span<const double> alpha, std::span<std::int64_t> N_A,
              std::span<std::int64_t> N_B, std::span<double> a_t, std::span<double> b_t,
              std::span<double> c_t, Threads threads);
/// As in batch.hpp, on these threads.
void transmission(std::span<const double> alpha, double e, std::span<double> rho, Threads threads);
/// As in batch.hpp, on these threads.
void ratios(std::int64_t first_k, std::span<double> magic, std::span<double> deficient,
            Threads threads);
}  // namespace fast
namespace accurate {
/// As in batch.hpp, on these threads.
void velocities(std::span<const double> alpha, std::span<const std::int64_t> n, std::span<double> a,
                std::span<double> b, std::span<double> c, std::span<double> c_prime,
                Threads threads);
/// As in batch.hpp, on these threads.
void velocities(std::span<const double> alpha, std::int64_t n, std::span<double> a,
                std::span<double> b, std::span<double> c, std::span<double> c_prime,
                Threads threads);
/// As in batch.hpp, on these threads.
void terminal(std::span<const double> alpha, std::span<std::int64_t> N_A,
              std::span<std::int64_t> N_B, std::span<double> a_t, std::span<double> b_t,
              std::span<double> c_t, Threads threads);
/// As in batch.hpp, on these threads.
void ratios(std::int64_t first_k, std::span<double> magic, std::span<double> deficient,
            Threads threads);
}  // namespace accurate

}  // namespace magicmass
