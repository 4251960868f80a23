// SPDX-License-Identifier: MIT
// Written by coefficients.sollya; do not edit.
// Minimax polynomials, from the constant coefficient up.
#pragma once

namespace magicmass::arithmetic {

// z (atan(t)/t - 1)/z for z = t^2 <= 1/3: off by less than 18/1000 of 2^-53.
inline constexpr double arctangent_coefficients[] = {
    -0x1.5555555555555p-2,
    0x1.99999999997ecp-3,
    -0x1.2492492481003p-3,
    0x1.c71c71bd73a8p-4,
    -0x1.745d15cebd683p-4,
    0x1.3b138e67fbe86p-4,
    -0x1.110ef0b75adafp-4,
    0x1.e1b42a4068727p-5,
    -0x1.adcd02f2e84cap-5,
    0x1.7eb1d8971bf5dp-5,
    -0x1.470e83bc25123p-5,
    0x1.ea7017f5e1c8ap-6,
    -0x1.10b3423904662p-6,
    0x1.3f1d9a64f7cbp-8,
};

// z (sin(r)/r - 1)/z for z = r^2, |r| <= pi/4 + 1/64: off by less than 144/1000 of 2^-53.
inline constexpr double sine_coefficients[] = {
    -0x1.5555555555554p-3,
    0x1.11111111109cp-7,
    -0x1.a01a019e234fep-13,
    0x1.71de372671f13p-19,
    -0x1.ae5f9e621b809p-26,
    0x1.5de60e8961addp-33,
};

// z^2 (cos(r) - 1 + z/2)/z^2 for z = r^2, |r| <= pi/4 + 1/64: off by less than 6/1000 of 2^-53.
inline constexpr double cosine_coefficients[] = {
    0x1.5555555555555p-5,
    -0x1.6c16c16c1686ep-10,
    0x1.a01a019f1e8cap-16,
    -0x1.27e4f9dfd519dp-22,
    0x1.1eeb329c69348p-29,
    -0x1.9058989032b9p-37,
};


}  // namespace magicmass::arithmetic
