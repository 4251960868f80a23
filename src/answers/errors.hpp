// What an answer throws instead: one line, fit to be shown. Words of others in messages of ours.
#pragma once

#include <functional>

#include "kernel/expr.hpp"
#include "magicmass/numbers/errors.hpp"

namespace answers {

using magicmass::InvalidInput;  ///< exit code 2
using magicmass::Undecided;     ///< exit code 3

/// What it gives; what it throws as Thrown is thrown as Instead, after `before`.
template <class Thrown, class Instead = Thrown>
auto with_place(const std::string& before, const auto& action) try {
  return action();
} catch (const std::bad_alloc&) {
  throw;  // no place is to blame
} catch (const Thrown& error) {
  throw Instead(before + error.what());
}
/// The same of what a user gave.
auto given_by_user(const std::string& before, const auto& action) {
  return with_place<kernel::Refused, InvalidInput>(before, action);
}

/// Printable ASCII, Greek letters and signs of formulas as they are, other bytes as \xHH, so that
/// no terminal obeys them; cut with "..." after so many bytes; "(nothing)" where there are none.
std::string shown_text(std::string_view text, std::size_t longest = 60);

/// A text of each: texts_of(figures, &Figure::name).
std::vector<std::string> texts_of(const auto& all, const auto& of) {
  std::vector<std::string> texts;
  for (const auto& one : all) texts.push_back(std::invoke(of, one));
  return texts;
}
std::string joined(const std::vector<std::string>& texts, std::string_view between = ", ");

}  // namespace answers
