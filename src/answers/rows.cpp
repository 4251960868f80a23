// SPDX-License-Identifier: GPL-2.0-or-later
// What does not read as a number becomes one that the array functions have no answer for.
#include "answers/rows.hpp"

#include <algorithm>
#include <limits>

#include "magicmass/numbers/accurate.hpp"
#include "magicmass/numbers/counts.hpp"
#include "magicmass/numbers/fast.hpp"
#include "notation/alpha.hpp"

namespace answers {
namespace {

using Reals = std::vector<double>;
using Wholes = std::vector<std::int64_t>;

/// NaN where it is no double.
double alpha_of_row(std::string_view text) {
  return notation::read_double(text).value_or(std::numeric_limits<double>::quiet_NaN());
}

/// -1 where it is none.
std::int64_t cycles_of_row(std::string_view digits) { return read_whole(digits).value_or(-1); }

/// An option of each row: its field, or what all share.
template <class Number>
std::vector<Number> option_of(const Rows& rows, const std::string& option,
                              Number (*read)(std::string_view)) {
  const auto column = std::find(rows.columns.begin(), rows.columns.end(), option);
  const auto at = static_cast<std::size_t>(column - rows.columns.begin());
  std::vector<Number> all;
  for (const std::vector<std::string>& fields : rows.fields)
    all.push_back(read(at < fields.size() ? fields[at] : rows.shared.text(option)));
  return all;
}

/// Whether the array functions answer for them.
bool is_of_arrays(const Rows& rows) {
  return !rows.shared.has("digits") && rows.shared.text("tier") != "exact" &&
         !rows.shared.has("restitution") && std::ranges::count(rows.columns, "restitution") == 0;
}

}  // namespace

Request Rows::request(std::size_t row) const {
  Request all = shared;
  for (std::size_t i = 0; i < columns.size(); ++i) all.options[columns[i]] = fields[row][i];
  return all;
}

Block eval_block(const Rows& rows) {
  if (!is_of_arrays(rows)) return {};
  const Reals alpha = option_of(rows, "alpha", alpha_of_row);
  const Wholes n = option_of(rows, "n", cycles_of_row);
  const std::size_t size = alpha.size();
  Reals a(size), b(size), c(size), c_prime(size);
  const bool is_fast = rows.shared.text("tier") == "fast";
  const magicmass::VelocityColumns columns{a, b, c, c_prime};
  if (is_fast)
    magicmass::fast::velocities(alpha, n, columns);
  else
    magicmass::accurate::velocities(alpha, n, columns);
  return {{alpha, n, text_cell(is_fast ? "fast" : "accurate"), std::move(a), std::move(b),
           std::move(c), std::move(c_prime)}};
}

Block count_block(const Rows& rows) {
  const Reals alpha = option_of(rows, "alpha", alpha_of_row);
  const std::size_t size = alpha.size();
  Wholes N_A(size), N_B(size);
  magicmass::count_collisions(alpha, N_A, N_B);
  return {{alpha, std::move(N_A), std::move(N_B)}};
}

Block terminal_block(const Rows& rows) {
  if (!is_of_arrays(rows)) return {};
  Block block = count_block(rows);
  const Reals& alpha = std::get<Reals>(block.columns[0]);
  const std::size_t size = alpha.size();
  Reals a_t(size), b_t(size), c_t(size), rho(size);
  const magicmass::TerminalColumns columns{{}, {}, a_t, b_t, c_t, rho};
  if (rows.shared.text("tier") == "fast")
    magicmass::fast::terminal(alpha, columns);
  else
    magicmass::accurate::terminal(alpha, columns);
  for (Reals* column : {&a_t, &b_t, &c_t, &rho}) block.columns.emplace_back(std::move(*column));
  return block;
}

}  // namespace answers
