// SPDX-License-Identifier: GPL-2.0-or-later
// One case of a plain form: its lines.
#pragma once

#include <string>
#include <vector>

#include "codegen/doubling.hpp"
#include "codegen/plain_printer.hpp"

namespace codegen {
struct PlainForm;

/// Constructed, it has all lines, and the C++ of each output.
class PlainBranch {
public:
  std::string lines;
  std::vector<std::string> results;
  kernel::Theorems used;
  PlainPrinter printer;
  Domain domain;

  PlainBranch(const PlainForm& f, const Case& c, const kernel::Theorems& outputs);
  PlainBranch(const PlainBranch&) = delete;  // its domain asks its printer

private:
  const PlainForm& form;
  std::set<kernel::Expr> seen, shared;
  int count = 0;

  void find_shared(kernel::Expr e);
  Printed line(const std::string& name, kernel::Expr e);
  void define(const kernel::Theorem& t);
  std::string output(const kernel::Theorem& t);
};
}  // namespace codegen
