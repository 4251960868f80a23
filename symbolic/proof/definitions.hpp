// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <map>
#include <memory>
#include <string>

#include "proof/statement.hpp"

namespace magicmass::proof {

/// New names and what they stand for. Two kinds behave differently inside cos and sin:
/// an angle (psi = 2 atan(...)) stays a name in n*psi, anything else is always written out.
class Definitions {
public:
  Definitions();
  Definitions(const Definitions&) = default;             ///< shares until one of them is added to
  Definitions(Definitions&&) = default;                  ///< moves
  Definitions& operator=(const Definitions&) = default;  ///< shares until one of them is added to
  Definitions& operator=(Definitions&&) = default;       ///< moves
  ~Definitions();

  /// Throws std::logic_error when the name is taken or its meaning names itself.
  void add(const std::string& name, const GiNaC::ex& meaning);
  /// Whether the name is taken.
  bool contains(const std::string& name) const;

  /// The meaning of an angle's name: a rational multiple of atan(t); nullptr for any other name.
  const GiNaC::ex* angle(const std::string& name) const;

  /// Whether words name this symbol, or a name with it in its meaning.
  bool speaks_of(const std::string& words, const std::string& name) const;

  /// An angle that is written as its definition has it, by its name.
  GiNaC::ex with_angle_names(const GiNaC::ex& e) const;

  GiNaC::ex expand_all(const GiNaC::ex& e) const;            ///< every defined name written out
  GiNaC::ex expand_except_angles(const GiNaC::ex& e) const;  ///< every other name written out

private:
  struct Data;
  std::shared_ptr<const Data>
      data_;  ///< copied on write: a theorem keeps the definitions it was proved under
};

}  // namespace magicmass::proof
