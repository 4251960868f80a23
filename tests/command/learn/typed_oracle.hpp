// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <map>
#include <string>

/// Symbols and their values.
using Point = std::map<std::string, long double>;

/// The value of a typed expression ("2alpha/(1+alpha)", "V cos(n psi)"), in long double. An oracle: it shares nothing
/// with the program, and writes down by hand what psi, theta, V_CM and the velocities after one contact are.
/// Throws std::runtime_error for what it cannot read.
long double oracle_value(const std::string& typed, Point point);
