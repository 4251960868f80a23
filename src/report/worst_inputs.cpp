// SPDX-License-Identifier: GPL-2.0-or-later
#include "report/worst_inputs.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cstdint>
#include <limits>
#include <map>
#include <set>
#include <string_view>
#include <tuple>
#include <utility>

#include "magicmass/errors.hpp"

namespace magicmass::report {
namespace {

constexpr std::string_view header =
    "quantity,contestant,precision,member,figure,alpha,index,e,error";
constexpr std::size_t columns = 9;

/// Subnormal numbers are a place of their own: what is lost there would hide everything else.
bool is_subnormal(const WorstInput& one) {
  const double least = one.precision == "float"
                           ? static_cast<double>(std::numeric_limits<float>::min())
                           : std::numeric_limits<double>::min();
  return one.input.alpha > 0 && one.input.alpha < least;
}

using Place = std::tuple<std::string, std::string, std::string, std::string, std::string, bool>;
Place place(const WorstInput& one) {
  return {one.quantity, one.contestant, one.precision, one.member, one.figure, is_subnormal(one)};
}

template <class Number, class... Format>
std::string text(Number number, Format... format) {
  std::array<char, 64> buffer{};
  const auto end =
      std::to_chars(buffer.data(), buffer.data() + buffer.size(), number, format...).ptr;
  return {buffer.data(), end};
}

template <class Number, class... Format>
Number number(std::string_view field, const std::string& line, Format... format) {
  Number value{};
  const auto [end, error] =
      std::from_chars(field.data(), field.data() + field.size(), value, format...);
  if (error != std::errc{} || end != field.data() + field.size())
    throw InvalidInput("not a number in the worst inputs: \"" + std::string(field) + "\" in " +
                       line);
  return value;
}

std::array<std::string, columns> fields(const std::string& line) {
  std::array<std::string, columns> found;
  std::size_t column = 0;
  for (const char letter : line) {
    if (letter != ',')
      found[column] += letter;
    else if (++column == columns)
      break;
  }
  if (column != columns - 1) throw InvalidInput("the worst inputs have 9 columns, not so: " + line);
  return found;
}

}  // namespace

std::vector<WorstInput> read_worst_inputs(std::istream& file) {
  std::string line;
  if (!std::getline(file, line) || line != header)
    throw InvalidInput("the worst inputs begin with the line " + std::string(header));
  std::vector<WorstInput> all;
  while (std::getline(file, line)) {
    const auto field = fields(line);
    WorstInput one;
    one.quantity = field[0];
    one.contestant = field[1];
    one.precision = field[2];
    one.member = field[3];
    one.figure = field[4];
    one.input.alpha = number<double>(field[5], line, std::chars_format::hex);
    one.input.index = number<std::int64_t>(field[6], line);
    one.input.e = number<double>(field[7], line, std::chars_format::hex);
    one.error = number<double>(field[8], line);
    all.push_back(std::move(one));
  }
  return all;
}

void write_worst_inputs(std::ostream& file, std::vector<WorstInput> inputs) {
  std::sort(inputs.begin(), inputs.end(),
            [](const WorstInput& x, const WorstInput& y) { return place(x) < place(y); });
  file << header << '\n';
  for (const WorstInput& one : inputs)
    file << one.quantity << ',' << one.contestant << ',' << one.precision << ',' << one.member
         << ',' << one.figure << ',' << text(one.input.alpha, std::chars_format::hex) << ','
         << one.input.index << ',' << text(one.input.e, std::chars_format::hex) << ','
         << text(one.error) << '\n';
}

std::vector<WorstInput> merged(std::vector<WorstInput> known, const std::vector<ErrorRow>& rows) {
  std::map<Place, WorstInput> worst;
  const auto offer = [&](const WorstInput& one) {
    if (!(one.error > 0)) return;
    const auto [found, is_new] = worst.try_emplace(place(one), one);
    if (!is_new && one.error > found->second.error) found->second = one;
  };
  for (const WorstInput& one : known) offer(one);
  for (const ErrorRow& row : rows) {
    const WorstInput by_ulp{row.contestant, row.precision, row.quantity, row.member,
                            "ulp",          row.worst,     row.max_ulp};
    offer(by_ulp);
    WorstInput other = by_ulp;
    other.figure = "envelope";
    other.input = row.worst_over_envelope;
    other.error = row.over_envelope;
    offer(other);
    other.figure = "eps";
    other.input = row.worst_eps;
    other.error = row.max_promise_eps;
    offer(other);
  }
  known.clear();
  for (const auto& [where, one] : worst) known.push_back(one);
  return known;
}

Family worst_inputs_family(const std::string& quantity, const std::vector<WorstInput>& inputs) {
  Family family{
      "worst ever seen", "the inputs at which some evaluator was worst so far", quantity, {}};
  std::set<std::tuple<std::uint64_t, std::int64_t, std::uint64_t>> seen;
  for (const WorstInput& one : inputs)
    if (one.quantity == quantity &&
        seen.emplace(std::bit_cast<std::uint64_t>(one.input.alpha), one.input.index,
                     std::bit_cast<std::uint64_t>(one.input.e))
            .second)
      family.inputs.push_back(one.input);
  return family;
}

}  // namespace magicmass::report
