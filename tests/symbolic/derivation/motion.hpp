// The second net: a formula's truth at a point, to 50 digits, from the law of one collision.
#pragma once
#include <string>
#include <vector>

#include <Eigen/Geometry>
#include <cln/complex.h>
#include <cln/real.h>

namespace net {
using cln::cl_R;
using Matrix = Eigen::Matrix<cl_R, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor, 3, 3>;

/// Thrown where a term has no value: 1/0, the root of a negative number, a count without speed.
struct Undefined {};
struct Unseen : Undefined {};  ///< losses left too little of a velocity for its sign

cl_R exact(const cl_R& x);
cl_R circle();
const cl_R& tiny();        ///< what is smaller than this is 0
int whole(const cl_R& x);  ///< x where it is an integer, else Undefined
cl_R binomial(const cl_R& n, int k);
/// What a function is worth at numbers. Everything about the motion comes from motion.cpp.
cl_R function(const std::string& name, const std::vector<cl_R>& x);
/// Nothing for a matrix of given entries.
Matrix matrix_function(const std::string& name, const std::vector<cl_R>& x);
}  // namespace net
