// SPDX-License-Identifier: MIT
#include "magicmass/batch/columns.hpp"

#include <functional>
#include <string>

#include "magicmass/errors.hpp"

namespace magicmass::batch {
namespace {

bool overlap(const Column& x, const Column& y) {
  // pointers into different arrays have no order but that of std::less
  const std::less<> is_before;
  return x.size > 0 && y.size > 0 && is_before(x.begin, y.end) && is_before(y.begin, x.end);
}

}  // namespace

void require_separate_columns(std::initializer_list<Column> columns) {
  const Column& first = *columns.begin();
  for (const Column& column : columns) {
    if (column.size != first.size) {
      throw InvalidInput("all spans must have the same size, but " + std::string(column.name) +
                         " has " + std::to_string(column.size) + " elements and " + first.name +
                         " has " + std::to_string(first.size));
    }
  }
  for (const Column* x = columns.begin(); x != columns.end(); ++x) {
    for (const Column* y = columns.begin(); y != x; ++y) {
      if ((x->is_output || y->is_output) && overlap(*x, *y)) {
        throw InvalidInput("an output must not overlap another span, but " + std::string(y->name) +
                           " and " + x->name + " share elements");
      }
    }
  }
}

}  // namespace magicmass::batch
