// SPDX-License-Identifier: MIT
// Written by coefficients.sollya; do not edit.
// Minimax polynomials, from the constant coefficient up.
#pragma once

namespace magicmass::arithmetic {

// z^2 (atan(t)/t - 1 + z/3)/z^2 for z = t^2 <= 1/3: off by less than 86/1000 of 2^-53.
inline constexpr double arctangent_coefficients[] = {
    0x1.9999999999997p-3,
    -0x1.24924924918b4p-3,
    0x1.c71c71c617c5ap-4,
    -0x1.745d170055d16p-4,
    0x1.3b13a7a056ec7p-4,
    -0x1.11104671145dcp-4,
    0x1.e1cc587bf934cp-5,
    -0x1.ae627aad6a57p-5,
    0x1.812a48446f6bcp-5,
    -0x1.4e183455b1ce3p-5,
    0x1.021f0ba338452p-5,
    -0x1.2c30b7c3be3c9p-6,
    0x1.72d6adfe2bd68p-8,
};

// z^2 (sin(r)/r - 1 + z/6)/z^2 for z = r^2, |r| <= pi/4 + 1/64: off by less than 1/1000 of 2^-53.
inline constexpr double sine_coefficients[] = {
    0x1.1111111111111p-7,
    -0x1.a01a01a019e78p-13,
    0x1.71de3a54f92a4p-19,
    -0x1.ae645504e830bp-26,
    0x1.61222c618f25ap-33,
    -0x1.ab73851c2d258p-41,
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

// S(x) = (sec(pi y) - 1)(1/y^2 - 4), x = y^2: S(0) as the sum of two doubles
inline constexpr double secant_at_0[] = {0x1.3bd3cc9be45dep2, 0x1.692b71366cc04p-52,};

// x (S(x) - S(0))/x for x <= 1/9: off by less than 2/1000 of 2^-53.
inline constexpr double secant_coefficients[] = {
    0x1.1bd400c7d72c9p-1,
    0x1.1b6de2fb58487p-2,
    0x1.07cc32d34c77fp-3,
    0x1.dd54477175195p-5,
    0x1.ab1c10dcfb581p-6,
    0x1.7c933210b3199p-7,
    0x1.52b86cbc8a028p-8,
    0x1.2b2f2f93ee14bp-9,
    0x1.194304f8f982p-10,
    0x1.bd03ad5588cc7p-12,
};

// z (1 - z/4 - atan(t)/t)/z for z = t^2 <= 1/3, a quotient: off by less than 5/1000 of 2^-53.
inline constexpr double rough_arctangent_numerator[] = {
    0x1.5555555555555p-4,
    -0x1.c087850655a86p-11,
    -0x1.5b644c8e2701cp-3,
    -0x1.c942bad244d0dp-4,
    -0x1.1e1c0ea97d9cfp-6,
    -0x1.3703a7600718fp-16,
};
inline constexpr double rough_arctangent_denominator[] = {
    0x1p0,
    0x1.31e2cd8f6e607p1,
    0x1.fc4ec6f13bca9p0,
    0x1.53262adfa86dap-1,
    0x1.25f305170cee6p-4,
};

// z (sin(r)/r - 1 + z/8)/z for z = r^2, |r| <= pi/4 + 1/64: off by less than 1/1000 of 2^-53.
inline constexpr double rough_sine_coefficients[] = {
    -0x1.5555555555555p-5,
    0x1.11111111110d6p-7,
    -0x1.a01a01a00e3e7p-13,
    0x1.71de3a4530ba6p-19,
    -0x1.ae644047f8a15p-26,
    0x1.61151ce475fe3p-33,
    -0x1.a521d2f85bb7bp-41,
};

// z (sin(r)/r - 1)/z for z = r^2, |r| <= pi/6 + 2^-20: off by less than 2/1000 of 2^-53.
inline constexpr double small_sine_coefficients[] = {
    -0x1.5555555555555p-3,
    0x1.1111111110f7bp-7,
    -0x1.a01a019f902b8p-13,
    0x1.71de39196b7ebp-19,
    -0x1.ae61ad4d0fb71p-26,
    0x1.5e8fb94e3335ep-33,
};

// z^2 (cos(r) - 1 + z/2)/z^2 for z = r^2, |r| <= pi/6 + 2^-20: off by less than 24/1000 of 2^-53.
inline constexpr double small_cosine_coefficients[] = {
    0x1.555555555555p-5,
    -0x1.6c16c16c0f853p-10,
    0x1.a01a016bd6f24p-16,
    -0x1.27e4769036649p-22,
    0x1.1dd909e6aaa7fp-29,
};


}  // namespace magicmass::arithmetic
