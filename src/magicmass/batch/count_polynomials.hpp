// SPDX-License-Identifier: MIT
// Written by coefficients.sollya; do not edit.
// Minimax polynomials, from the constant coefficient up, on 0 <= x <= highest_alpha; P(x) = pi sqrt(x)/h, cos h = 1/(1+x).
#pragma once

namespace magicmass::batch {

inline constexpr float highest_alpha = 0x1.008p0F;

// P(x) (1 - 7.5 2^-24)/2: off by less than 59/100 of 2^-24 of itself.
inline constexpr float single_coefficients[] = {
    0x1.1c582ap0F,  0x1.d9e764p-2F, -0x1.b08de8p-4F, 0x1.9d16dap-5F,
    -0x1.dcfacp-6F, 0x1.010f0ap-6F, -0x1.8cfc38p-8F, 0x1.2b131ep-10F,
};

// P(x): off by less than 691/100 of 2^-53 of itself.
inline constexpr double double_coefficients[] = {
    0x1.1c5831add62e8p1,    0x1.d9e852cc62c91p-1, -0x1.b0d5e53589538p-3,  0x1.a1ddb5a4b970cp-4,
    -0x1.039a032bd4aa7p-4,  0x1.6e4a91671eec8p-5, -0x1.166fd351e19fbp-5,  0x1.bba91c4fe44cep-6,
    -0x1.6af258d426dfap-6,  0x1.29264f139aa05p-6, -0x1.d3c7ecb914b37p-7,  0x1.4ebb8bfa0b667p-7,
    -0x1.97ac6dbb6438p-8,   0x1.88d92700a8c61p-9, -0x1.127b583be05aap-10, 0x1.e75e91b9ffb7ep-13,
    -0x1.990067e3a1db6p-16,
};

}  // namespace magicmass::batch
