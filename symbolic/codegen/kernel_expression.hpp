// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "codegen/ir.hpp"
#include "codegen/stages.hpp"

namespace magicmass::codegen {

// Prints a program in the operators of magicmass/arithmetic: constants and inputs but `number_inputs` are exact (Real), all
// else Number.
class KernelPrinter {
public:
  KernelPrinter(const Program& program, const Stages& stages,
                const std::vector<std::string>& number_inputs);

  // Whether a node's value is kept in a variable; its name.
  bool is_kept(int number) const;
  std::string name(int number) const;
  // From here on a product is multiplied by doubles before its other factors meet, which is where the number type
  // cares.
  void put_doubles_first() { are_doubles_first_ = true; }
  // From here on a kept node goes by another name.
  void rename(int number, const std::string& name);
  // Whether a node is exact: an input that is one or a constant.
  bool is_exact(int number) const;
  // The right side of a node that is kept or an output.
  std::string right_side(int number) const;
  std::string value(int number) const;  // its name if kept, else its right side
  // "x, y, scale" of an output that is not kept and is scale x y, scale plus or minus a power of two. Of three factors or more y is
  // the one that is known last, so that the others are multiplied while it is waited for.
  std::optional<std::string> as_product(int number) const;

private:
  std::string sum(const Node& node) const;
  std::string product(const Node& node) const;
  std::string factor(int number) const;
  std::string exact(int number) const;
  const Node& node(int number) const;
  bool is_number_input(int number) const;
  bool is_of_pi(int number) const;
  bool is_divisor(int number) const;

  const Program& program_;
  const std::vector<std::string>& number_inputs_;
  std::vector<std::string> names_;
  bool are_doubles_first_ = false;
};

}  // namespace magicmass::codegen
