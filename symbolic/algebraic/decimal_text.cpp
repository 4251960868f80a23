// SPDX-License-Identifier: GPL-2.0-or-later
#include "algebraic/decimal_text.hpp"

#include <sstream>

#include <cln/integer_io.h>

namespace magicmass::algebraic {

std::string decimal_text(const cln::cl_I& n, long digits) {
  std::ostringstream stream;
  stream << cln::abs(n);
  std::string text = stream.str();
  const auto places = static_cast<std::size_t>(digits);
  if (text.size() <= places) text.insert(0, places + 1 - text.size(), '0');
  if (places > 0) text.insert(text.size() - places, ".");
  return (cln::minusp(n) ? "-" : "") + text;
}

}  // namespace magicmass::algebraic
