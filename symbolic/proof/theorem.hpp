// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "magicmass/errors.hpp"
#include "proof/domain.hpp"
#include "proof/statement.hpp"

namespace magicmass::proof {

/// One line of the derivation, as the tutorials print it, the code cites it and the tests replay it.
struct Step {
  std::string id;                       ///< "contact.Gamma": chapter, dot, name
  std::string rule;                     ///< the kernel's rule that made it
  std::string from;                     ///< left side, as it is shown
  std::string relation;                 ///< "=", "!=", "<=", ">"
  std::string to;                       ///< right side
  std::vector<std::string> conditions;  ///< sorted
  std::string label;                    ///< the paper's equation, if it has one
  std::string words;                    ///< what was done, for a reader
  std::string verdict;                  ///< "proved", "law", "definition" or "hypothesis"
  std::vector<std::string> premises;    ///< ids
  std::string statement = {};  ///< both sides as the kernel compared them, nothing abbreviated
};

class Kernel;

/// A statement that the kernel has accepted. Nothing else can make one, so a function that takes a
/// Theorem takes proved formulas only.
class Theorem {
public:
  /// The step's: "power.a".
  const std::string& id() const { return step().id; }
  /// How it was proved.
  const Step& step() const;
  /// What is proved.
  const Statement& statement() const;
  /// Left side.
  const GiNaC::ex& lhs() const { return statement().lhs(); }
  /// Right side.
  const GiNaC::ex& rhs() const { return statement().rhs(); }
  /// What the kernel may assume of symbols.
  const Domain& domain() const;
  /// Where it holds.
  const Conditions& conditions() const;

private:
  friend class Kernel;
  struct Data;
  explicit Theorem(std::shared_ptr<const Data> data) : data_(std::move(data)) {}
  std::shared_ptr<const Data> data_;
};

/// The kernel refused. The message shows both sides and, where one was found, a counterexample.
struct NotProved : Error {
  /// With what what() says.
  NotProved(Step refused, const std::string& reason);
  Step step;  ///< verdict "refused"
};

}  // namespace magicmass::proof
