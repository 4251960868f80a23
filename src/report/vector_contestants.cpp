// SPDX-License-Identifier: GPL-2.0-or-later
// The paper's formulas four at a time through the vector functions of glibc, as a compiler would call them if it were
// allowed to guess (-ffast-math, which is not used): each is good to 4 ulp by glibc's own statement; and through those of
// SLEEF, good to 1 ulp by its own.
#include "report/contestants.hpp"

#if defined(MAGICMASS_HAS_LIBMVEC) || defined(MAGICMASS_HAS_SLEEF)
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <numbers>

#include <immintrin.h>

#include "report/make_contestant.hpp"

// Vector ABI names: d for AVX2, N unmasked, 4 lanes.
extern "C" {
[[gnu::target("avx2")]] __m256d _ZGVdN4v_sin(__m256d);
[[gnu::target("avx2")]] __m256d _ZGVdN4v_cos(__m256d);
[[gnu::target("avx2")]] __m256d _ZGVdN4v_atan(__m256d);
// as sleef.h declares them for who compiles everything for AVX2
[[gnu::target("avx2")]] __m256d Sleef_sind4_u10avx2(__m256d);
[[gnu::target("avx2")]] __m256d Sleef_cosd4_u10avx2(__m256d);
[[gnu::target("avx2")]] __m256d Sleef_atand4_u10avx2(__m256d);
}

namespace magicmass::report {
namespace {

constexpr std::size_t lanes = 4;

struct Glibc {
  [[gnu::target("avx2")]] static __m256d sin(__m256d x) { return _ZGVdN4v_sin(x); }
  [[gnu::target("avx2")]] static __m256d cos(__m256d x) { return _ZGVdN4v_cos(x); }
  [[gnu::target("avx2")]] static __m256d atan(__m256d x) { return _ZGVdN4v_atan(x); }
};

struct Sleef {
  [[gnu::target("avx2")]] static __m256d sin(__m256d x) { return Sleef_sind4_u10avx2(x); }
  [[gnu::target("avx2")]] static __m256d cos(__m256d x) { return Sleef_cosd4_u10avx2(x); }
  [[gnu::target("avx2")]] static __m256d atan(__m256d x) { return Sleef_atand4_u10avx2(x); }
};

[[gnu::target("avx2")]] inline __m256d all(double x) { return _mm256_set1_pd(x); }

/// Ee & Lee eq. def:psi.
template <class Library>
[[gnu::target("avx2")]] inline __m256d psi(__m256d alpha) {
  return all(2) * Library::atan(_mm256_sqrt_pd(alpha * (all(2) + alpha)));
}

/// Ee & Lee eqs. eq:a-final to eq:c'-final.
template <class Library>
struct VelocityKernel {
  static constexpr std::size_t members = 4;
  [[gnu::target("avx2")]] static void four(__m256d alpha, __m256d n, __m256d* result) {
    const __m256d V_CM = all(1) / (all(2) + alpha);
    const __m256d turn = psi<Library>(alpha);
    const __m256d half = Library::cos(turn * all(0.5));
    const __m256d quarter = Library::sin(turn * all(0.25));
    result[0] = V_CM * (all(1) + Library::cos(n * turn) / half);
    result[1] = V_CM * (all(1) - Library::cos((n + all(0.5)) * turn) / half);
    result[2] = V_CM * (all(1) + Library::sin((n - all(0.25)) * turn) / quarter);
    result[3] = V_CM * (all(1) - Library::sin((n + all(0.25)) * turn) / quarter);
  }
};

template <class Library>
struct EncounterKernel {
  static constexpr std::size_t members = 2;
  [[gnu::target("avx2")]] static void four(__m256d alpha, __m256d j, __m256d* result) {
    const __m256d half_turn = psi<Library>(alpha) * all(0.5);
    const __m256d below = Library::sin((j + all(1)) * half_turn);
    result[0] = Library::sin(j * half_turn) / below;
    result[1] = Library::sin(half_turn) / below;
  }
};

template <class Library>
struct AngleKernel {
  static constexpr std::size_t members = 1;
  [[gnu::target("avx2")]] static void four(__m256d alpha, __m256d, __m256d* result) {
    result[0] = psi<Library>(alpha);
  }
};

/// Ee & Lee eqs. exact:ak and exact:bk.
template <class Library>
struct RatioKernel {
  static constexpr std::size_t members = 2;
  [[gnu::target("avx2")]] static void four(__m256d, __m256d k, __m256d* result) {
    const __m256d pi = all(std::numbers::pi);
    result[0] = all(1) / Library::cos(pi / (all(2) * k + all(1))) - all(1);
    result[1] = all(1) / Library::cos(pi / (all(2) * (k + all(1)))) - all(1);
  }
};

/// Ee & Lee eq. eq:NA-ans.
template <class Library>
struct CountKernel {
  static constexpr std::size_t members = 2;
  [[gnu::target("avx2")]] static void four(__m256d alpha, __m256d, __m256d* result) {
    const __m256d cycles = all(std::numbers::pi) / psi<Library>(alpha);
    result[0] = _mm256_ceil_pd(cycles - all(0.5));
    result[1] = _mm256_ceil_pd(cycles - all(1));
  }
};

/// Ee & Lee eqs. eq:a-terminal to eq:ct.
template <class Library>
struct EndingKernel {
  static constexpr std::size_t members = 5;
  [[gnu::target("avx2")]] static void four(__m256d alpha, __m256d, __m256d* result) {
    const __m256d turn = psi<Library>(alpha);
    const __m256d cycles = all(std::numbers::pi) / turn;
    const __m256d V_CM = all(1) / (all(2) + alpha);
    result[3] = _mm256_ceil_pd(cycles - all(0.5));
    result[4] = _mm256_ceil_pd(cycles - all(1));
    result[0] = V_CM * (all(1) + (all(1) + alpha) * Library::cos(result[3] * turn));
    result[1] = V_CM * (all(1) - (all(1) + alpha) * Library::cos((result[4] + all(0.5)) * turn));
    result[2] = (all(1) - result[0] - result[1]) / alpha;
  }
};

/// The four inputs from `first` on; past the end the last one again.
struct FourInputs {
  std::array<double, lanes> alpha;
  std::array<double, lanes> index;

  FourInputs(std::span<const Input> inputs, std::size_t first) {
    for (std::size_t lane = 0; lane < lanes; ++lane) {
      const Input& input = inputs[std::min(first + lane, inputs.size() - 1)];
      alpha[lane] = input.alpha;
      index[lane] = static_cast<double>(input.index);
    }
  }
};

template <class Kernel>
[[gnu::target("avx2")]] void evaluate_one(const Input& input, long double* members) {
  __m256d result[Kernel::members];
  Kernel::four(all(input.alpha), all(static_cast<double>(input.index)), result);
  for (std::size_t i = 0; i < Kernel::members; ++i)
    members[i] = static_cast<long double>(_mm256_cvtsd_f64(result[i]));
}

/// A group waits for all of the one before if chained; the time of a group is shared by its four.
template <class Kernel, bool is_chained>
[[gnu::target("avx2")]] void evaluate_groups(std::span<const Input> inputs) {
  const __m256d zero =
      _mm256_castsi256_pd(_mm256_set1_epi64x(static_cast<std::int64_t>(opaque_zero())));
  __m256d last = zero;
  for (std::size_t first = 0; first < inputs.size(); first += lanes) {
    const FourInputs four(inputs, first);
    __m256d result[Kernel::members];
    Kernel::four(_mm256_xor_pd(_mm256_loadu_pd(four.alpha.data()), last),
                 _mm256_xor_pd(_mm256_loadu_pd(four.index.data()), last), result);
    asm volatile("" : : "m"(result) : "memory");
    if constexpr (is_chained) {
      last = result[0];
      for (std::size_t i = 1; i < Kernel::members; ++i) last = _mm256_xor_pd(last, result[i]);
      last = _mm256_and_pd(last, zero);
    }
  }
}

template <class Kernel>
Contestant vectorised(const std::string& quantity) {
  Contestant one;
  one.quantity = quantity;
  one.precision = "double";
  one.can = [](const Input&) { return true; };
  one.evaluate = evaluate_one<Kernel>;
  one.evaluate_all = evaluate_groups<Kernel, false>;
  one.evaluate_chained = evaluate_groups<Kernel, true>;
  return one;
}

template <class Library>
std::vector<Contestant> through(const std::string& name, const std::string& quantity) {
  using Make = Contestant (*)(const std::string&);
  const Make make = quantity == "velocities"         ? vectorised<VelocityKernel<Library>>
                    : quantity == "encounters"       ? vectorised<EncounterKernel<Library>>
                    : quantity == "angle"            ? vectorised<AngleKernel<Library>>
                    : quantity == "ratios"           ? vectorised<RatioKernel<Library>>
                    : quantity == "counts"           ? vectorised<CountKernel<Library>>
                    : quantity == "elastic_terminal" ? vectorised<EndingKernel<Library>>
                                                     : nullptr;
  if (make == nullptr) return {};
  Contestant one = make(quantity);
  one.name = name;
  one.form = "naive, vector functions";
  return {one};
}

}  // namespace

std::vector<Contestant> vector_contestants(const std::string& quantity) {
  std::vector<Contestant> all;
  if (!__builtin_cpu_supports("avx2")) return all;
#ifdef MAGICMASS_HAS_LIBMVEC
  for (Contestant& one : through<Glibc>("naive_libmvec", quantity)) all.push_back(std::move(one));
#endif
#ifdef MAGICMASS_HAS_SLEEF
  for (Contestant& one : through<Sleef>("naive_sleef", quantity)) all.push_back(std::move(one));
#endif
  return all;
}

}  // namespace magicmass::report

#else

namespace magicmass::report {

std::vector<Contestant> vector_contestants(const std::string&) { return {}; }

}  // namespace magicmass::report

#endif

namespace magicmass::report {

bool has_sleef() {
#ifdef MAGICMASS_HAS_SLEEF
  return true;
#else
  return false;
#endif
}

}  // namespace magicmass::report
