// SPDX-License-Identifier: GPL-2.0-or-later
// A CSV file, its cells read as mass ratios and restitutions are.
#include "command/csv_table.hpp"
#include "fuzz_target.hpp"
#include "magicmass/errors.hpp"
#include "magicmass/scenes/mass_ratio.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace magicmass;
  try {
    const command::CsvTable table =
        command::parse_csv(fuzz::text_of(data, size), "table.csv", {"alpha", "alpha,n"});
    const std::size_t columns = table.header == "alpha" ? 1 : 2;
    unsigned line = 1;
    for (const command::CsvRow& row : table.rows) {
      fuzz::require(row.line == ++line, "a row has another line's number");
      fuzz::require(row.fields.size() == columns, "a row has another number of fields");
      const MassRatio alpha = parse_mass_ratio(row.fields.front());
      fuzz::require(parse_mass_ratio(to_text(alpha)) == alpha, "a ratio is not read back");
    }
  } catch (const InvalidInput& refusal) {
    fuzz::require_one_line(refusal);
  }
  return 0;
}
