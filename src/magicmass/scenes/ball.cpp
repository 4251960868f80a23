// SPDX-License-Identifier: GPL-2.0-or-later
#include "magicmass/scenes/ball.hpp"

#include "magicmass/numbers/errors.hpp"

namespace magicmass::scenes {

void until_certain(int digits, const std::function<bool()>& is_certain,
                   const std::string& otherwise) {
  const int wanted = 4 * digits;
  const int least = 128 + wanted;
  const int most = 8192 + 4 * wanted;  // a double near 2^-1074 with its count takes some 3,000
  for (int bits = least; bits <= most; bits *= 2) {
    Ball::set_bits(bits);
    try {
      if (is_certain()) return;
    } catch (const NotCertain&) {
    }
  }
  throw Undecided("more than " + std::to_string(most) + " bits would be needed" + otherwise);
}

}  // namespace magicmass::scenes
