// SPDX-License-Identifier: GPL-2.0-or-later
// A block of rows says what each row alone does, or leaves it open.
#include "answers/rows.hpp"

#include "answers/velocities.hpp"
#include "catch.hpp"

using namespace answers;

namespace {

Rows rows_of(std::vector<std::vector<std::string>> fields, const std::string& tier) {
  Request shared;
  shared.options["tier"] = tier;
  return {shared, {"n", "alpha"}, std::move(fields)};
}

/// How many rows the block answers; each as alone.
std::size_t checked(const Rows& rows, Block (*run_block)(const Rows&),
                    Answer (*run)(const Request&), const Names& columns) {
  const Block block = run_block(rows);
  std::size_t count = 0;
  for (std::size_t row = 0; row < rows.fields.size(); ++row) {
    if (!block.answers(row)) continue;
    std::string text;
    Writer(Format::csv, columns, true).append(text, block, row);
    CHECK(text == written(run(rows.request(row)).table, Format::csv));
    ++count;
  }
  return count;
}

}  // namespace

TEST_CASE("rows at once and alone", "[exam]") {
  std::vector<std::vector<std::string>> fields;
  for (int k = 0; k < 257; ++k)
    fields.push_back({std::to_string(k % 2), "1." + std::to_string(k) + "e-" + std::to_string(k)});
  for (const std::string tier : {"fast", "accurate"}) {
    const Rows rows = rows_of(fields, tier);
    CHECK(checked(rows, eval_block, eval, eval_columns(rows.shared)) == 257);
    CHECK(checked(rows, count_block, count, count_columns(rows.shared)) ==
          38);  // others leave 64 bits
    CHECK(checked(rows, terminal_block, terminal, terminal_columns(rows.shared)) == 38);
  }
}
