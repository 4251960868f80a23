// SPDX-License-Identifier: GPL-2.0-or-later
#include "arithmetic/every_width.hpp"

#include <bit>
#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <string>

#include <catch2/catch.hpp>

#include "arithmetic/primitives.hpp"
#include "batch/instruction_sets.hpp"
#include "magicmass/reference/rational.hpp"

namespace magicmass::testing {
namespace {

Columns run(const Primitive& primitive, Primitive::Run function, const Columns& inputs) {
  const std::size_t rows = inputs.at(0).size(), padded = (rows + 7) / 8 * 8;
  std::vector<double> in, out(primitive.outputs * padded);
  for (const auto& column : inputs) {
    in.insert(in.end(), column.begin(), column.end());
    in.insert(in.end(), padded - rows, column.back());
  }
  function(in.data(), out.data(), padded);
  Columns result;
  for (std::size_t k = 0; k < primitive.outputs; ++k) {
    const auto begin = out.begin() + static_cast<std::ptrdiff_t>(k * padded);
    result.emplace_back(begin, begin + static_cast<std::ptrdiff_t>(rows));
  }
  return result;
}

/// A fused product's error of 0 is +0, Dekker's may be -0: as a low part it makes no difference.
bool same(const Columns& x, const Columns& y, bool is_zero_signed) {
  for (std::size_t k = 0; k < x.size(); ++k)
    for (std::size_t i = 0; i < x[k].size(); ++i) {
      if (!is_zero_signed && x[k][i] == 0.0 && y[k][i] == 0.0) continue;
      if (std::bit_cast<std::uint64_t>(x[k][i]) == std::bit_cast<std::uint64_t>(y[k][i])) continue;
      if (std::isnan(x[k][i]) && std::isnan(y[k][i])) continue;
      UNSCOPED_INFO("row " << i << ", column " << k << ": " << x[k][i] << " and " << y[k][i]);
      return false;
    }
  return true;
}

}  // namespace

bool same_bits(const std::vector<double>& x, const std::vector<double>& y) {
  if (x.size() != y.size()) return false;
  for (std::size_t i = 0; i < x.size(); ++i)
    if (std::bit_cast<std::uint64_t>(x[i]) != std::bit_cast<std::uint64_t>(y[i])) return false;
  return true;
}

const Primitive& primitive(InstructionSet instruction_set, const char* name) {
  const Primitive* const table = instruction_set == InstructionSet::avx512 ? primitives::avx512
                                 : instruction_set == InstructionSet::avx2 ? primitives::avx2
                                                                           : primitives::baseline;
  for (std::size_t i = 0; i < primitive_count; ++i)
    if (std::string(table[i].name) == name) return table[i];
  throw std::logic_error(std::string("no primitive ") + name);
}

namespace {

/// All widths of a primitive on one instruction set.
void require_same(const char* name, InstructionSet set, const Columns& inputs,
                  const Results& results, bool is_zero_signed) {
  const Primitive& one = primitive(set, name);
  for (int width = 0; width < 4; ++width) {
    if (one.run[width] == nullptr) continue;
    INFO(name << " on " << to_text(set) << ", " << (1 << width) << " at once");
    REQUIRE(same(run(one, one.run[width], inputs), width == 0 ? results.single : results.lanes,
                 is_zero_signed));
  }
}

}  // namespace

Results at_every_width(const char* name, const Columns& inputs, bool is_zero_signed) {
  const Primitive& plain = primitive(InstructionSet::baseline, name);
  REQUIRE(inputs.size() == plain.inputs);
  const Results results{run(plain, plain.run[0], inputs), run(plain, plain.run[1], inputs)};
  for (const InstructionSet set : available_instruction_sets())
    require_same(name, set, inputs, results, is_zero_signed);
  return results;
}

Columns the_same_at_every_width(const char* name, const Columns& inputs, bool is_zero_signed) {
  const Results results = at_every_width(name, inputs, is_zero_signed);
  INFO(name);
  REQUIRE(same(results.single, results.lanes, is_zero_signed));
  return results.single;
}

std::vector<Columns> at_every_rounding(const std::string& name, const Columns& inputs) {
  if (!name.starts_with("fused_")) return {the_same_at_every_width(name.c_str(), inputs)};
  std::vector<Columns> results;
  for (const InstructionSet set : available_instruction_sets()) {
    const std::size_t fuses = set == InstructionSet::baseline ? 0 : 1;
    const Primitive& one = primitive(set, name.c_str());
    REQUIRE(inputs.size() == one.inputs);
    if (results.size() == fuses) results.push_back(run(one, one.run[0], inputs));
    require_same(name.c_str(), set, inputs, {results.at(fuses), results.at(fuses)}, false);
  }
  return results;
}

std::vector<Columns> at_each_width(const char* name, const Columns& inputs) {
  std::vector<Columns> results;
  for (const InstructionSet set : available_instruction_sets()) {
    const Primitive& one = primitive(set, name);
    REQUIRE(inputs.size() == one.inputs);
    for (const auto function : one.run)
      if (function != nullptr) results.push_back(run(one, function, inputs));
  }
  return results;
}

Columns of_single_doubles(const char* name, const Columns& inputs) {
  const auto single = [&](InstructionSet set) {
    return run(primitive(set, name), primitive(set, name).run[0], inputs);
  };
  const Columns results = single(InstructionSet::baseline);
  for (const InstructionSet set : available_instruction_sets()) {
    INFO(name << " on " << to_text(set));
    REQUIRE(same(single(set), results, false));
  }
  return results;
}

double any_double(Generator& generator, int low, int high) {
  std::uint64_t digits = generator() >> 11U;
  switch (whole(generator, 0, 3)) {
    case 0:
      digits &= generator() & generator() & generator() & generator();  // sparse
      break;
    case 1:
      digits |= generator() | generator() | generator() | generator();
      digits &= (std::uint64_t{1} << 53U) - 1;
      break;
    default:
      break;
  }
  digits |= std::uint64_t{1} << 52U;
  const double size =
      std::ldexp(static_cast<double>(digits), static_cast<int>(whole(generator, low, high)) - 52);
  return whole(generator, 0, 1) == 0 ? size : -size;
}

double any_low(Generator& generator, double high) {
  const double half_ulp = std::ldexp(1.0, std::ilogb(high) - 53);
  const auto kind = whole(generator, 0, 7);
  if (kind == 0) return 0.0;
  if (kind == 1) return half_ulp;
  if (kind == 2) return -half_ulp / 2;  // also below a power of two
  const double low = any_double(generator, -20, -1) * half_ulp;
  return std::fabs(high) == std::ldexp(1.0, std::ilogb(high)) ? low / 2 : low;
}

cln::cl_RA exact_pair(const Columns& columns, std::size_t first, std::size_t row) {
  return reference::exact(columns[first][row]) + reference::exact(columns[first + 1][row]);
}

}  // namespace magicmass::testing
