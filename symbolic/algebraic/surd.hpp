// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <vector>

#include <cln/rational.h>

namespace GiNaC {
class ex;
}

namespace magicmass::algebraic {

struct SurdTerm;

/// A rational number plus rational multiples of square roots of such numbers.
struct Surd {
  cln::cl_RA rational;
  std::vector<SurdTerm> terms;
};

struct SurdTerm {
  cln::cl_RA coefficient;
  Surd radicand;
};

/// As one writes it by hand: sqrt(6) - sqrt(2) - 1, 2/sqrt(3) - 1, sqrt(4 - 2*sqrt(2)).
std::string to_text(const Surd& surd);
GiNaC::ex expression(const Surd& surd);

Surd sum(Surd x, const Surd& y);
/// sign sqrt(radicand), written as shortly as taking square factors in or out of the root allows. radicand > 0.
Surd square_root(const Surd& radicand, int sign);

}  // namespace magicmass::algebraic
