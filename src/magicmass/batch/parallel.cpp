// SPDX-License-Identifier: MIT
#include "magicmass/parallel.hpp"

#include <algorithm>
#include <exception>
#include <system_error>
#include <thread>
#include <vector>

#include "magicmass/batch/columns.hpp"
#include "magicmass/errors.hpp"

namespace magicmass {

Threads Threads::all() { return {std::max(1U, std::thread::hardware_concurrency())}; }

void in_parallel(Threads threads, std::size_t size,
                 const std::function<void(std::size_t first, std::size_t rows)>& part) {
  if (threads.count == 0) throw InvalidInput("threads must be 1 or more, got 0");
  const std::size_t units = (size + least_part - 1) / least_part;
  const std::size_t parts = std::clamp<std::size_t>(units, 1, threads.count);
  std::vector<std::exception_ptr> thrown(parts);
  const auto run = [&](std::size_t number) {
    const std::size_t first = number * units / parts * least_part;
    const std::size_t end = std::min(size, (number + 1) * units / parts * least_part);
    try {
      if (first < end) part(first, end - first);
    } catch (...) {
      thrown[number] = std::current_exception();
    }
  };
  {
    std::vector<std::jthread> running;
    running.reserve(parts);
    std::size_t started = 0;
    try {
      for (; started + 1 < parts; ++started) running.emplace_back(run, started);
    } catch (const std::system_error&) {  // no more threads: the rest is done here
    }
    for (std::size_t number = started; number < parts; ++number) run(number);
  }
  for (const std::exception_ptr& exception : thrown)
    if (exception) std::rethrow_exception(exception);
}

void count_collisions(std::span<const double> alpha, std::span<std::int64_t> N_A,
                      std::span<std::int64_t> N_B, Threads threads) {
  batch::require_separate_columns(
      {batch::input("alpha", alpha), batch::output("N_A", N_A), batch::output("N_B", N_B)});
  in_parallel(threads, alpha.size(), [&](std::size_t first, std::size_t rows) {
    count_collisions(alpha.subspan(first, rows), N_A.subspan(first, rows),
                     N_B.subspan(first, rows));
  });
}

namespace {

using Doubles = std::span<double>;
using Integers = std::span<std::int64_t>;

template <class Serial>
void velocities_in_parts(Serial serial, std::span<const double> alpha,
                         std::span<const std::int64_t> n, Doubles a, Doubles b, Doubles c,
                         Doubles c_prime, Threads threads) {
  batch::require_separate_columns({batch::input("alpha", alpha), batch::input("n", n),
                                   batch::output("a", a), batch::output("b", b),
                                   batch::output("c", c), batch::output("c_prime", c_prime)});
  in_parallel(threads, alpha.size(), [&](std::size_t first, std::size_t rows) {
    serial(alpha.subspan(first, rows), n.subspan(first, rows), a.subspan(first, rows),
           b.subspan(first, rows), c.subspan(first, rows), c_prime.subspan(first, rows));
  });
}

template <class Serial>
void velocities_in_parts(Serial serial, std::span<const double> alpha, std::int64_t n, Doubles a,
                         Doubles b, Doubles c, Doubles c_prime, Threads threads) {
  batch::require_separate_columns({batch::input("alpha", alpha), batch::output("a", a),
                                   batch::output("b", b), batch::output("c", c),
                                   batch::output("c_prime", c_prime)});
  in_parallel(threads, alpha.size(), [&](std::size_t first, std::size_t rows) {
    serial(alpha.subspan(first, rows), n, a.subspan(first, rows), b.subspan(first, rows),
           c.subspan(first, rows), c_prime.subspan(first, rows));
  });
}

template <class Serial>
void terminal_in_parts(Serial serial, std::span<const double> alpha, Integers N_A, Integers N_B,
                       Doubles a_t, Doubles b_t, Doubles c_t, Threads threads) {
  batch::require_separate_columns({batch::input("alpha", alpha), batch::output("N_A", N_A),
                                   batch::output("N_B", N_B), batch::output("a_t", a_t),
                                   batch::output("b_t", b_t), batch::output("c_t", c_t)});
  in_parallel(threads, alpha.size(), [&](std::size_t first, std::size_t rows) {
    serial(alpha.subspan(first, rows), N_A.subspan(first, rows), N_B.subspan(first, rows),
           a_t.subspan(first, rows), b_t.subspan(first, rows), c_t.subspan(first, rows));
  });
}

// k past the largest std::int64_t have no ratios, and no number either.
template <class Serial>
void ratios_in_parts(Serial serial, std::int64_t first_k, Doubles magic, Doubles deficient,
                     Threads threads) {
  batch::require_separate_columns(
      {batch::output("magic", magic), batch::output("deficient", deficient)});
  const auto is_beyond = [&](std::size_t first) {
    std::int64_t k = 0;
    return __builtin_add_overflow(first_k, first, &k);
  };
  in_parallel(threads, magic.size(), [&](std::size_t first, std::size_t rows) {
    const Doubles of_magic = magic.subspan(first, rows),
                  of_deficient = deficient.subspan(first, rows);
    const std::int64_t none = -static_cast<std::int64_t>(rows);
    serial(is_beyond(first) ? none : first_k + static_cast<std::int64_t>(first), of_magic,
           of_deficient);
  });
}

}  // namespace

void fast::velocities(std::span<const double> alpha, std::span<const std::int64_t> n, Doubles a,
                      Doubles b, Doubles c, Doubles c_prime, Threads threads) {
  velocities_in_parts([](auto... columns) { velocities(columns...); }, alpha, n, a, b, c, c_prime,
                      threads);
}
void fast::velocities(std::span<const double> alpha, std::int64_t n, Doubles a, Doubles b,
                      Doubles c, Doubles c_prime, Threads threads) {
  velocities_in_parts([](auto... columns) { velocities(columns...); }, alpha, n, a, b, c, c_prime,
                      threads);
}
void fast::terminal(std::span<const double> alpha, Integers N_A, Integers N_B, Doubles a_t,
                    Doubles b_t, Doubles c_t, Threads threads) {
  terminal_in_parts([](auto... columns) { terminal(columns...); }, alpha, N_A, N_B, a_t, b_t, c_t,
                    threads);
}
void fast::transmission(std::span<const double> alpha, double e, Doubles rho, Threads threads) {
  batch::require_separate_columns({batch::input("alpha", alpha), batch::output("rho", rho)});
  transmission(alpha.first(0), e, rho.first(0));  // refuses what e may not be, also of no rows
  in_parallel(threads, alpha.size(), [&](std::size_t first, std::size_t rows) {
    transmission(alpha.subspan(first, rows), e, rho.subspan(first, rows));
  });
}
void fast::ratios(std::int64_t first_k, Doubles magic, Doubles deficient, Threads threads) {
  ratios_in_parts([](auto... columns) { ratios(columns...); }, first_k, magic, deficient, threads);
}

void accurate::velocities(std::span<const double> alpha, std::span<const std::int64_t> n, Doubles a,
                          Doubles b, Doubles c, Doubles c_prime, Threads threads) {
  velocities_in_parts([](auto... columns) { velocities(columns...); }, alpha, n, a, b, c, c_prime,
                      threads);
}
void accurate::velocities(std::span<const double> alpha, std::int64_t n, Doubles a, Doubles b,
                          Doubles c, Doubles c_prime, Threads threads) {
  velocities_in_parts([](auto... columns) { velocities(columns...); }, alpha, n, a, b, c, c_prime,
                      threads);
}
void accurate::terminal(std::span<const double> alpha, Integers N_A, Integers N_B, Doubles a_t,
                        Doubles b_t, Doubles c_t, Threads threads) {
  terminal_in_parts([](auto... columns) { terminal(columns...); }, alpha, N_A, N_B, a_t, b_t, c_t,
                    threads);
}
void accurate::ratios(std::int64_t first_k, Doubles magic, Doubles deficient, Threads threads) {
  ratios_in_parts([](auto... columns) { ratios(columns...); }, first_k, magic, deficient, threads);
}

}  // namespace magicmass
