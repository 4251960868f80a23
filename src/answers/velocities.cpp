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
/// Not a ratio of the paper, which is exact.
bool is_fraction(const Alpha& number) { return value_of(number).exact() != nullptr; }
cln::cl_RA exact_of(const Alpha& number) { return value_of(number).exact()->rational_part(); }
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

/// The mass ratio as a fraction. Throws InvalidInput for one that is none, Undecided where
/// fractions after so many cycles would be too long.
cln::cl_RA fraction_of(const Alpha& alpha, const cln::cl_I& cycles) {
  constexpr int longest = 1 << 22;
  if (!is_fraction(alpha))
    throw InvalidInput("alpha: velocities at " + notation::text(alpha) +
                       " are no fractions; add --digits D");
  const auto length = static_cast<long long>(value_of(alpha).exact()->bits());
  const cln::cl_I bits = 2 * cycles * length;
  if (bits > longest)
    throw Undecided("exact fractions after " + kernel::digits(cycles) + " cycles would have some " +
                    kernel::digits(bits) + " bits; add --digits D");
  return exact_of(alpha);
}
Row exact_cells(const std::vector<cln::cl_RA>& values) {
  Row row;
  for (const cln::cl_RA& value : values) row.push_back(exact_cell(kernel::digits(value)));
  return row;
}

Row count_cells(const Alpha& alpha, const LargeCounts& counts) {
  return {alpha_cell(alpha), whole_cell(kernel::digits(counts.N_A)),
          whole_cell(kernel::digits(counts.N_B))};
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
Answer answer(std::vector<Column> columns, Row row, const Row& more = {}) {
  row.insert(row.end(), more.begin(), more.end());
  return {{std::move(columns), {std::move(row)}, false}, ""};
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
  const Asked in(request);
  const std::int64_t n = *request.whole("n", 0, INT64_MAX);
  const cln::cl_I cycles = static_cast<long long>(n);
  if (cycles > in.counts.N_A) {
    throw InvalidInput("n: " + std::to_string(n) + " is beyond the last collision; allowed: 0 to " +
                       kernel::digits(in.counts.N_A) + " for this alpha");
  }
  Row four;
  if (in.wants_fractions) {
    const auto v = magicmass::generated::velocities_exact(fraction_of(in.alpha, cycles), n);
    four = exact_cells({v.a, v.b, v.c, v.c_prime});
  } else if (in.number != nullptr) {
    const auto v = in.tier == "fast" ? magicmass::fast::velocities(*in.number, n)
                                     : magicmass::accurate::velocities(*in.number, n);
    four = real_cells({v.a, v.b, v.c, v.c_prime});
  } else {
    four = rounded([&] { return velocities(in.alpha, cycles); }, in.digits);
  }
  return answer(eval_columns(), {alpha_cell(in.alpha), whole_cell(n), text_cell(in.tier)}, four);
}

std::vector<Column> count_columns() {
  return {{"alpha", Type::exact, "1", "mass ratio"},
          {"N_A", Type::whole, "1", "collisions of A"},
          {"N_B", Type::whole, "1", "collisions of B"}};
}

Answer count(const Request& request) {
  const Alpha alpha = alpha_of(request.text("alpha"));
  return answer(count_columns(), count_cells(alpha, count_collisions(alpha)));
}

std::vector<Column> terminal_columns() {
  std::vector<Column> columns = count_columns();
  columns.insert(columns.end(), {{"a_t", Type::real, "V", "A's terminal velocity"},
                                 {"b_t", Type::real, "V", "B's terminal velocity"},
                                 {"c_t", Type::real, "V", "the ball's terminal velocity"},
                                 {"rho", Type::real, "1", "B's share of the energy"}});
  return columns;
}

std::vector<Column> inelastic_columns() {
  std::vector<Column> columns = terminal_columns();
  columns.insert(columns.begin() + 1, {"restitution", Type::exact, "1", "e"});
  columns.push_back({"collapse_time", Type::real, "L/V", "where the collisions never end"});
  return columns;
}

/// The restitution of a request, written as a mass ratio is.
Alpha restitution_of(const Request& request) {
  const std::string text = request.text("restitution");
  try {
    const Alpha e = alpha_of(text);
    if (is_fraction(e) && exact_of(e) <= 1) return e;
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
  const Trio trio = with_restitution(alpha, exact_of(e));
  Row row{alpha_cell(alpha), alpha_cell(e)};
  try {
    if (const auto N = trio.count()) {
      row.push_back(whole_cell((*N + 1) / 2));
      row.push_back(whole_cell(*N / 2));
      Answer all = answer(inelastic_columns(), row,
                          rounded([&] { return answers::terminal(trio, *N); }, digits));
      all.table.rows[0].push_back(missing_cell());
      return all;
    }
    row.resize(8, missing_cell());
    return answer(inelastic_columns(), row,
                  rounded([&] { return Balls{trio.collapse(trio.shape()).time}; }, digits));
  } catch (const std::domain_error&) {
    throw Undecided("terminal: the mass ratio or the restitution is too small for this version");
  }
}

Answer terminal(const Request& request) {
  if (request.has("restitution")) {
    const Alpha e = restitution_of(request);
    if (exact_of(e) != 1) return inelastic_terminal(request, e);
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
        fraction_of(in.alpha, N_A), cln::cl_I_to_long(N_A), cln::cl_I_to_long(N_B));
    four = exact_cells({v.a_t, v.b_t, v.c_t, v.rho});
  } else if (number) {
    four = real_cells({number->a_t, number->b_t, number->c_t, number->rho});
  } else {
    four = rounded([&] { return answers::terminal(in.alpha, in.counts); }, in.digits);
  }
  return answer(terminal_columns(), count_cells(in.alpha, in.counts), four);
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
  const bool has_polynomials = request.has("polynomials");
  const std::int64_t at_once = has_polynomials ? 200 : 100'000;
  if (most.value_or(10) > at_once) {
    throw Undecided("ratios: " + std::to_string(*most) +
                    " rows are more than are answered at once; "
                    "at most --count " +
                    std::to_string(at_once) + (has_polynomials ? " with polynomials" : ""));
  }
  Table table{ratios_columns(), {}};
  if (has_polynomials) {
    table.columns.push_back({"magic_polynomial", Type::text, "1", "whose root alpha_k is"});
    table.columns.push_back({"deficient_polynomial", Type::text, "1", "whose root beta_k is"});
  }
  for (std::int64_t k = 1; k <= most.value_or(10); ++k) {
    Row row{whole_cell(k)};
    Row radicals;
    for (const std::string name : {"alpha_", "beta_"}) {
      const auto ratio = [&] {
        const Ball index(cln::cl_RA(static_cast<long long>(k)));
        return Balls{evaluate(right_side("ratios." + name + "k"), {{kernel::integer("k"), index}})};
      };
      row.push_back(rounded(ratio, digits)[0]);
      const std::string id =
          (k == 1 && name == "alpha_" ? "ratios." : "radicals.") + name + std::to_string(k);
      radicals.push_back(derivation::the_book().has(id) ? text_cell(kernel::text(right_side(id)))
                                                        : missing_cell());
    }
    row.insert(row.end(), radicals.begin(), radicals.end());
    for (const bool is_magic : {true, false})
      if (has_polynomials)
        row.push_back(text_cell(text_of(polynomial_of_ratio(static_cast<int>(k), is_magic))));
    table.rows.push_back(row);
  }
  return {table, ""};
}

}  // namespace answers
