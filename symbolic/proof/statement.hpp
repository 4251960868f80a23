// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <memory>

namespace GiNaC {
class ex;
}

namespace magicmass::proof {

/// lhs ~ rhs: as alpha -> 0 the difference is smaller than the last term of the right side, an expansion.
enum class Relation { equal, not_equal, less_equal, greater, asymptotic };

/// Two expressions and how they are related; scalars or matrices of one shape.
/// A statement claims nothing by itself: only the kernel turns one into a Theorem.
class Statement {
public:
  Statement(const GiNaC::ex& lhs, const GiNaC::ex& rhs);  ///< lhs = rhs
  /// lhs relation rhs.
  Statement(const GiNaC::ex& lhs, Relation relation, const GiNaC::ex& rhs);

  const GiNaC::ex& lhs() const;  ///< left side
  const GiNaC::ex& rhs() const;  ///< right side
  Relation relation() const;     ///< how they are related

private:
  struct Data;
  std::shared_ptr<const Data> data_;
};

}  // namespace magicmass::proof
