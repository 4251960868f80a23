// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <ginac/ginac.h>

/// The real root.
inline GiNaC::ex root(const GiNaC::ex& radicand, long index = 2) {
  return GiNaC::pow(radicand, GiNaC::numeric(1, index));
}
