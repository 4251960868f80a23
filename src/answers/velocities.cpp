// SPDX-License-Identifier: GPL-2.0-or-later
#include "answers/velocities.hpp"

#include <sstream>

#include <cln/integer_io.h>

#include "answers/errors.hpp"
#include "answers/evaluate.hpp"
#include "answers/motion.hpp"
#include "answers/shown_text.hpp"
#include "derivation/book.hpp"
#include "kernel/print.hpp"
#include "magicmass/exact/exact.hpp"
#include "magicmass/numbers/accurate.hpp"
#include "magicmass/numbers/fast.hpp"

namespace answers {
namespace {

using notation::Alpha;

constexpr std::int64_t most_digits = 10000;

Cell alpha_cell(const Alpha& alpha) {
  if (const auto* value = std::get_if<double>(&alpha)) return real_cell(*value);
  return exact_cell(notation::text(alpha));
}
std::string digits_of(const cln::cl_I& n) { return kernel::digits(n); }
/// The digits that are asked for. Throws Undecided for more than are given at once.
std::optional<std::int64_t> digits_wanted(const Request& request) {
  const auto digits = request.whole("digits", 1, INT64_MAX);
  if (digits.value_or(0) > most_digits) {
    throw Undecided("digits: " + std::to_string(*digits) +
                    " are more than are given at once; at most " + std::to_string(most_digits));
  }
  return digits;
}

/// The tier that is asked for; "exact" where digits are.
std::string tier_of(const Request& request) {
  if (!request.has("tier")) return request.has("digits") ? "exact" : "accurate";
  const std::string tier = request.text("tier");
  if (request.has("digits") && tier != "exact")
    throw InvalidInput("--digits belongs to --tier exact, not to --tier " + tier);
  return tier;
}

/// The mass ratio as a fraction. Throws InvalidInput for one that is none, Undecided where
/// fractions after so many cycles would be too long.
cln::cl_RA fraction_of(const Alpha& alpha, const cln::cl_I& cycles) {
  constexpr int longest = 1 << 22;
  const auto* rational = std::get_if<cln::cl_RA>(&alpha);
  const auto* value = std::get_if<double>(&alpha);
  if (rational == nullptr && value == nullptr) {
    throw InvalidInput("alpha: velocities at " + notation::text(alpha) +
                       " are no fractions; add --digits D");
  }
  const cln::cl_RA q = rational != nullptr ? *rational : exact(*value);
  const auto length =
      cln::integer_length(cln::numerator(q)) + cln::integer_length(cln::denominator(q));
  const cln::cl_I bits = 2 * cycles * static_cast<long long>(length);
  if (bits > longest) {
    throw Undecided("exact fractions after " + digits_of(cycles) + " cycles would have some " +
                    digits_of(bits) + " bits; add --digits D");
  }
  return q;
}
std::array<Cell, 4> exact_cells(const std::array<cln::cl_RA, 4>& values) {
  std::array<Cell, 4> out;
  for (std::size_t i = 0; i < 4; ++i) out[i] = exact_cell(kernel::digits(values[i]));
  return out;
}
bool wants_fractions(const Request& request) {
  return tier_of(request) == "exact" && !request.has("digits");
}

/// The double that tiers fast and accurate answer for, if it is one and no digits are asked for.
const double* as_number(const Alpha& alpha, const Request& request) {
  return tier_of(request) == "exact" ? nullptr : std::get_if<double>(&alpha);
}
std::array<Cell, 4> real_cells(const std::array<double, 4>& values) {
  return {real_cell(values[0]), real_cell(values[1]), real_cell(values[2]), real_cell(values[3])};
}
/// None where the counts do not fit 64 bits.
std::optional<magicmass::Terminal> terminal_number(const Alpha& alpha, const Request& request) {
  const double* value = as_number(alpha, request);
  if (value == nullptr) return {};
  return tier_of(request) == "fast" ? magicmass::fast::terminal(*value)
                                    : magicmass::accurate::terminal(*value);
}

/// Four cells for a tier.
std::array<Cell, 4> cells(const Velocities& values, const std::array<bool, 4>& is_zero,
                          const Request& request) {
  std::array<Cell, 4> out;
  const auto digits = digits_wanted(request);
  if (digits) {
    const auto texts = decimals(values, is_zero, static_cast<int>(*digits));
    for (std::size_t i = 0; i < 4; ++i) out[i] = exact_cell(texts[i]);
    return out;
  }
  const auto numbers = nearest_doubles(values, is_zero);
  for (std::size_t i = 0; i < 4; ++i) out[i] = real_cell(numbers[i]);
  return out;
}

}  // namespace

std::vector<Column> eval_columns() {
  return {{"alpha", Type::exact, "1", "mass ratio"},
          {"n", Type::whole, "1", "cycles"},
          {"tier", Type::text, "", "fast, accurate or exact"},
          {"a", Type::real, "V", "A after P_n"},
          {"b", Type::real, "V", "B after Q_n"},
          {"c", Type::real, "V", "the ball after P_n"},
          {"c_prime", Type::real, "V", "the ball after Q_n"}};
}

Answer eval(const Request& request) {
  const Alpha alpha = alpha_of(request.text("alpha"));
  const auto n = request.whole("n", 0, INT64_MAX);
  const std::string tier = tier_of(request);
  const LargeCounts counts = count_collisions(alpha);
  const cln::cl_I cycles = cln::cl_I(static_cast<long long>(*n));
  if (cycles > counts.N_A) {
    throw InvalidInput("n: " + std::to_string(*n) +
                       " is beyond the last collision; allowed: 0 to " + digits_of(counts.N_A) +
                       " for this alpha");
  }
  std::array<Cell, 4> four;
  if (wants_fractions(request)) {
    const auto v = magicmass::generated::velocities_exact(fraction_of(alpha, cycles), *n);
    four = exact_cells({v.a, v.b, v.c, v.c_prime});
  } else if (const auto* value = as_number(alpha, request)) {
    const auto v = tier == "fast" ? magicmass::fast::velocities(*value, *n)
                                  : magicmass::accurate::velocities(*value, *n);
    four = real_cells({v.a, v.b, v.c, v.c_prime});
  } else {
    four = cells(velocities(alpha, cycles), zeros(alpha, cycles), request);
  }
  return {
      {eval_columns(),
       {{alpha_cell(alpha), whole_cell(*n), text_cell(tier), four[0], four[1], four[2], four[3]}},
       false},
      ""};
}

std::vector<Column> count_columns() {
  return {{"alpha", Type::exact, "1", "mass ratio"},
          {"N_A", Type::whole, "1", "collisions of A"},
          {"N_B", Type::whole, "1", "collisions of B"}};
}

Answer count(const Request& request) {
  const Alpha alpha = alpha_of(request.text("alpha"));
  const LargeCounts counts = count_collisions(alpha);
  return {
      {count_columns(),
       {{alpha_cell(alpha), whole_cell(digits_of(counts.N_A)), whole_cell(digits_of(counts.N_B))}},
       false},
      ""};
}

std::vector<Column> terminal_columns() {
  return {{"alpha", Type::exact, "1", "mass ratio"},
          {"N_A", Type::whole, "1", "collisions of A"},
          {"N_B", Type::whole, "1", "collisions of B"},
          {"a_t", Type::real, "V", "A's terminal velocity"},
          {"b_t", Type::real, "V", "B's terminal velocity"},
          {"c_t", Type::real, "V", "the ball's terminal velocity"},
          {"rho", Type::real, "1", "B's share of the energy"}};
}

Answer terminal(const Request& request) {
  const Alpha alpha = alpha_of(request.text("alpha"));
  const LargeCounts counts = count_collisions(alpha);
  std::array<bool, 4> is_zero = zeros(alpha, counts.N_A);
  is_zero = {is_zero[0], false, is_zero[3], false};
  std::array<Cell, 4> four;
  if (wants_fractions(request)) {
    const cln::cl_RA q = fraction_of(alpha, counts.N_A);
    const auto v = magicmass::generated::terminal_exact(q, cln::cl_I_to_long(counts.N_A),
                                                        cln::cl_I_to_long(counts.N_B));
    four = exact_cells({v.a_t, v.b_t, v.c_t, v.rho});
  } else if (const auto end = terminal_number(alpha, request)) {
    four = real_cells({end->a_t, end->b_t, end->c_t, end->rho});
  } else {
    four = cells(terminal(alpha, counts), is_zero, request);
  }
  return {{terminal_columns(),
           {{alpha_cell(alpha), whole_cell(digits_of(counts.N_A)),
             whole_cell(digits_of(counts.N_B)), four[0], four[1], four[2], four[3]}},
           false},
          ""};
}

std::vector<Column> ratios_columns() {
  return {{"k", Type::whole, "1", "which"},
          {"magic", Type::real, "1", "alpha_k"},
          {"deficient", Type::real, "1", "beta_k"},
          {"magic_radicals", Type::text, "1", "alpha_k in square roots"},
          {"deficient_radicals", Type::text, "1", "beta_k in square roots"}};
}

Answer ratios(const Request& request) {
  const auto most = request.whole("count", 1, 1'000'000'000);
  const auto digits = digits_wanted(request);
  constexpr std::int64_t at_once = 100'000;
  if (most.value_or(10) > at_once) {
    throw Undecided("ratios: " + std::to_string(*most) +
                    " rows are more than are answered at once; "
                    "at most --count " +
                    std::to_string(at_once));
  }
  Table table{ratios_columns(), {}};
  for (std::int64_t k = 1; k <= most.value_or(10); ++k) {
    Row row{whole_cell(k)};
    Row radicals;
    for (const std::string name : {"alpha_", "beta_"}) {
      Cell cell;
      with_bits(
          static_cast<int>(digits.value_or(17)),
          [&] {
            const Ball index(cln::cl_RA(static_cast<long long>(k)));
            const Ball ratio =
                evaluate(right_side("ratios." + name + "k"), {{kernel::integer("k"), index}});
            if (digits) {
              const auto text = decimal(ratio.low(), ratio.high(), static_cast<int>(*digits));
              cell = exact_cell(text.value_or(""));
              return text.has_value();
            }
            const auto value = nearest_double(ratio.low(), ratio.high());
            cell = real_cell(value.value_or(0));
            return value.has_value();
          },
          "ratios: too many digits");
      row.push_back(cell);
      const std::string id =
          (k == 1 && name == "alpha_" ? "ratios." : "radicals.") + name + std::to_string(k);
      radicals.push_back(derivation::the_book().has(id) ? text_cell(kernel::text(right_side(id)))
                                                        : missing_cell());
    }
    row.insert(row.end(), radicals.begin(), radicals.end());
    table.rows.push_back(row);
  }
  return {table, ""};
}

}  // namespace answers
