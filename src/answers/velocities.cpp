// SPDX-License-Identifier: GPL-2.0-or-later
#include "answers/velocities.hpp"

#include <sstream>

#include <cln/integer_io.h>

#include "answers/errors.hpp"
#include "answers/evaluate.hpp"
#include "answers/motion.hpp"
#include "answers/polynomial.hpp"
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
/// The digits that are asked for. Throws Undecided for more than are given at once.
std::optional<int> digits_wanted(const Request& request) {
  const auto digits = request.whole("digits", 1, INT64_MAX);
  if (digits.value_or(0) > most_digits) {
    throw Undecided("digits: " + std::to_string(*digits) +
                    " are more than are given at once; at most " + std::to_string(most_digits));
  }
  return digits ? std::optional(static_cast<int>(*digits)) : std::nullopt;
}

/// The tier that is asked for; "exact" where digits are.
std::string tier_of(const Request& request) {
  if (!request.has("tier")) return request.has("digits") ? "exact" : "accurate";
  const std::string tier = request.text("tier");
  if (request.has("digits") && tier != "exact")
    throw InvalidInput("--digits belongs to --tier exact, not to --tier " + tier);
  return tier;
}

/// The mass ratio, for fractions after so many cycles. Throws InvalidInput where it is none,
/// Undecided where they would be too long.
cln::cl_RA exact_ratio(const Alpha& alpha, const cln::cl_I& cycles) {
  constexpr int longest = 1 << 22;
  const auto fraction = fraction_of(alpha);
  if (!fraction)
    throw InvalidInput("alpha: velocities at " + notation::text(alpha) +
                       " are no fractions; add --digits D");
  const cln::cl_I bits = 2 * cycles * static_cast<long long>(Quadratic(*fraction).bits());
  if (bits > longest)
    throw Undecided("exact fractions after " + kernel::digits(cycles) + " cycles would have some " +
                    kernel::digits(bits) + " bits; add --digits D");
  return *fraction;
}
Row exact_cells(const std::vector<cln::cl_RA>& values) {
  Row row;
  for (const cln::cl_RA& value : values) row.push_back(exact_cell(kernel::digits(value)));
  return row;
}

/// What eval and terminal are asked.
struct Asked {
  explicit Asked(const Request& request)
      : alpha(alpha_of(request.text("alpha"))),
        tier(tier_of(request)),
        digits(digits_wanted(request)),
        counts(count_collisions(alpha)),
        wants_fractions(tier == "exact" && !digits),
        number(tier == "exact" ? nullptr : std::get_if<double>(&alpha)) {}
  Alpha alpha;
  std::string tier;
  std::optional<int> digits;
  LargeCounts counts;
  bool wants_fractions;
  const double* number;  // the double that tiers fast and accurate answer for
};
/// One row, the answer.
Answer answer(Names columns, std::initializer_list<Row> parts) {
  return {{std::move(columns), {concatenated(parts)}, false}, ""};
}

}  // namespace

Names eval_columns() { return {"alpha", "n", "tier", "a", "b", "c", "c_prime"}; }

Answer eval(const Request& request) {
  const Asked in(request);
  const std::int64_t n = *request.whole("n", 0, INT64_MAX);
  const cln::cl_I cycles = static_cast<long long>(n);
  if (cycles > in.counts.N_A) {
    throw InvalidInput("n: " + std::to_string(n) + " is beyond the last collision; allowed: 0 to " +
                       kernel::digits(in.counts.N_A) + " for this alpha");
  }
  Row four;
  if (in.wants_fractions) {
    const auto v = magicmass::generated::velocities_exact(exact_ratio(in.alpha, cycles), n);
    four = exact_cells({v.a, v.b, v.c, v.c_prime});
  } else if (in.number != nullptr) {
    const auto v = in.tier == "fast" ? magicmass::fast::velocities(*in.number, n)
                                     : magicmass::accurate::velocities(*in.number, n);
    four = real_cells({v.a, v.b, v.c, v.c_prime});
  } else {
    four = rounded([&] { return velocities(in.alpha, cycles); }, in.digits);
  }
  return answer(eval_columns(), {{alpha_cell(in.alpha), whole_cell(n), text_cell(in.tier)}, four});
}

Names count_columns() { return {"alpha", "N_A", "N_B"}; }

Answer count(const Request& request) {
  const Alpha alpha = alpha_of(request.text("alpha"));
  return answer(count_columns(), {{alpha_cell(alpha)}, count_cells(count_collisions(alpha))});
}

Names terminal_columns() { return {"alpha", "N_A", "N_B", "a_t", "b_t", "c_t", "rho"}; }

/// The restitution of a request, written as a mass ratio is.
Alpha restitution_of(const Request& request) {
  const std::string text = request.text("restitution");
  try {
    const Alpha e = alpha_of(text);
    const auto fraction = fraction_of(e);
    if (fraction && *fraction <= 1) return e;
  } catch (const InvalidInput&) {
  }
  throw InvalidInput("restitution must be a number or a fraction above 0 and at most 1, got " +
                     shown_text(text));
}

/// With restitution below 1; of every tier the nearest doubles, or with digits.
Answer inelastic_terminal(const Request& request, const Alpha& e) {
  tier_of(request);  // refuses what does not go together
  const Alpha alpha = alpha_of(request.text("alpha"));
  const auto digits = digits_wanted(request);
  const Names columns{"alpha", "restitution", "N_A", "N_B",          "a_t",
                      "b_t",   "c_t",         "rho", "collapse_time"};
  const Row asked{alpha_cell(alpha), alpha_cell(e)};
  const Trio trio = Trio::equal_blocks(value_of(alpha), *fraction_of(e));
  try {
    if (const auto N = trio.count()) {
      const Row four = rounded([&] { return answers::terminal(trio, *N); }, digits);
      return answer(columns, {asked, count_cells({(*N + 1) / 2, *N / 2}), four, {missing_cell()}});
    }
    const Row end = rounded([&] { return Balls{trio.collapse(trio.shape()).time}; }, digits);
    return answer(columns, {asked, Row(6, missing_cell()), end});
  } catch (const std::domain_error&) {
    throw Undecided("terminal: the mass ratio or the restitution is too small for this version");
  }
}

Answer terminal(const Request& request) {
  if (request.has("restitution")) {
    const Alpha e = restitution_of(request);
    if (*fraction_of(e) != 1) return inelastic_terminal(request, e);
  }
  const Asked in(request);
  const auto& [N_A, N_B] = in.counts;
  // Counts that do not fit 64 bits are for balls.
  const auto number = in.number == nullptr ? std::nullopt
                      : in.tier == "fast"  ? magicmass::fast::terminal(*in.number)
                                           : magicmass::accurate::terminal(*in.number);
  Row four;
  if (in.wants_fractions) {
    const auto v = magicmass::generated::terminal_exact(
        exact_ratio(in.alpha, N_A), cln::cl_I_to_long(N_A), cln::cl_I_to_long(N_B));
    four = exact_cells({v.a_t, v.b_t, v.c_t, v.rho});
  } else if (number) {
    four = real_cells({number->a_t, number->b_t, number->c_t, number->rho});
  } else {
    four = rounded([&] { return answers::terminal(in.alpha, in.counts); }, in.digits);
  }
  return answer(terminal_columns(), {{alpha_cell(in.alpha)}, count_cells(in.counts), four});
}

Answer ratios(const Request& request) {
  const auto most = request.whole("count", 1, 1'000'000'000);
  const auto digits = digits_wanted(request);
  const bool has_polynomials = request.has("polynomials");
  const std::int64_t at_once = has_polynomials ? 200 : 100'000;
  if (most.value_or(10) > at_once) {
    throw Undecided("ratios: " + std::to_string(*most) +
                    " rows are more than are answered at once; "
                    "at most --count " +
                    std::to_string(at_once) + (has_polynomials ? " with polynomials" : ""));
  }
  Table table{{"k", "magic", "deficient", "magic_radicals", "deficient_radicals"}, {}};
  if (has_polynomials)
    table.columns.insert(table.columns.end(), {"magic_polynomial", "deficient_polynomial"});
  for (int k = 1; k <= most.value_or(10); ++k) {
    Row numbers, radicals, polynomials;
    for (const Alpha& ratio : {Alpha(notation::Magic{k}), Alpha(notation::Deficient{k})}) {
      const bool is_magic = std::holds_alternative<notation::Magic>(ratio);
      numbers.push_back(rounded([&] { return Balls{ball_of(ratio)}; }, digits)[0]);
      const std::string name = (is_magic ? "alpha_" : "beta_") + std::to_string(k);
      const std::string id = (name == "alpha_1" ? "ratios." : "radicals.") + name;
      radicals.push_back(derivation::is_shown(id) ? text_cell(kernel::text(right_side(id)))
                                                  : missing_cell());
      if (has_polynomials)
        polynomials.push_back(text_cell(text_of(polynomial_of_ratio(k, is_magic))));
    }
    table.rows.push_back(concatenated({{whole_cell(k)}, numbers, radicals, polynomials}));
  }
  return {table, ""};
}

}  // namespace answers
