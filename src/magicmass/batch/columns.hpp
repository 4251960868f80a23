// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <initializer_list>
#include <span>

namespace magicmass::batch {

/// One span of a batch call, for its checks and messages.
struct Column {
  const char* name;
  const std::byte* begin;
  const std::byte* end;
  std::size_t size;
  bool is_output;
};

template <class Value>
Column input(const char* name, std::span<const Value> values) {
  const auto bytes = std::as_bytes(values);
  return {name, bytes.data(), bytes.data() + bytes.size(), values.size(), false};
}

template <class Value>
Column output(const char* name, std::span<Value> values) {
  const auto bytes = std::as_bytes(values);
  return {name, bytes.data(), bytes.data() + bytes.size(), values.size(), true};
}

/// Throws InvalidInput unless all have the same size and no output overlaps another column.
void require_separate_columns(std::initializer_list<Column> columns);

}  // namespace magicmass::batch
