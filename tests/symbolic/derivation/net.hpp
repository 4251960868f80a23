// SPDX-License-Identifier: GPL-2.0-or-later
// The second net: a formula's truth at a point, to 50 digits, from the law of one collision.
#pragma once
#include <string>
#include <vector>

#include <cln/real.h>

#include "derivation/book.hpp"

namespace net {
using cln::cl_R;
using kernel::Expr;
using Matrix = std::vector<std::vector<cl_R>>;

/// Thrown where a term has no value: 1/0, the root of a negative number, a count without speed.
struct Undefined {};

cl_R exact(const cl_R& x);
cl_R circle();
const cl_R& tiny();        ///< what is smaller than this is 0
int whole(const cl_R& x);  ///< x where it is an integer, else Undefined
/// What a function is worth at numbers. Everything about the motion comes from motion.cpp.
cl_R function(const std::string& name, const std::vector<cl_R>& x);
Matrix matrix_function(const std::string& name, const std::vector<cl_R>& x);

struct Tried {
  int points = 0;        ///< that satisfy the hypotheses
  std::string false_at;  ///< the first at which the conclusion is false or has no value; or empty
};
Tried tried(const kernel::Exprs& hypotheses, Expr conclusion, int wanted);
}  // namespace net
