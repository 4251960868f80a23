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

/// An option of each row: its field, or what all share; `none` where that is no such number.
template <class Number>
std::vector<Number> option_of(const Rows& rows, const std::string& option,
                              std::optional<Number> (*read)(std::string_view), Number none) {
  const auto column = std::find(rows.columns.begin(), rows.columns.end(), option);
  const auto at = static_cast<std::size_t>(column - rows.columns.begin());
  std::vector<Number> all;
  for (const std::vector<std::string>& fields : rows.fields)
    all.push_back(read(at < fields.size() ? fields[at] : rows.shared.text(option)).value_or(none));
  return all;
}
Reals alphas_of(const Rows& rows) {
  return option_of(rows, "alpha", notation::read_double, std::numeric_limits<double>::quiet_NaN());
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
  const Reals alpha = alphas_of(rows);
  const Wholes n = option_of(rows, "n", read_whole, std::int64_t{-1});
  std::vector<Reals> v(4, Reals(alpha.size()));
  const magicmass::VelocityColumns columns{v[0], v[1], v[2], v[3]};
  const bool is_fast = rows.shared.text("tier") == "fast";
  if (is_fast)
    magicmass::fast::velocities(alpha, n, columns);
  else
    magicmass::accurate::velocities(alpha, n, columns);
  return {{alpha, n, text_cell(is_fast ? "fast" : "accurate"), v[0], v[1], v[2], v[3]}};
}

Block count_block(const Rows& rows) {
  const Reals alpha = alphas_of(rows);
  Wholes N_A(alpha.size()), N_B(alpha.size());
  magicmass::count_collisions(alpha, N_A, N_B);
  return {{alpha, N_A, N_B}};
}

Block terminal_block(const Rows& rows) {
  if (!is_of_arrays(rows)) return {};
  const Reals alpha = alphas_of(rows);
  Wholes N_A(alpha.size()), N_B(alpha.size());
  std::vector<Reals> v(4, Reals(alpha.size()));
  const magicmass::TerminalColumns columns{N_A, N_B, v[0], v[1], v[2], v[3]};
  if (rows.shared.text("tier") == "fast")
    magicmass::fast::terminal(alpha, columns);
  else
    magicmass::accurate::terminal(alpha, columns);
  return {{alpha, N_A, N_B, v[0], v[1], v[2], v[3]}};
}

}  // namespace answers
