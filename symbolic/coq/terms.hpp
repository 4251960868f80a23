// SPDX-License-Identifier: GPL-2.0-or-later
// The kernel's terms in Coq's words. Coq's names that are made here have a ' inside, which no name
// of the kernel has.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "kernel/expr.hpp"

namespace coq {
using Names = std::vector<std::string>;
/// Trees that are printed as a name of Coq.
using Atoms = std::map<kernel::Expr, std::string>;

/// A name of the kernel; those that Coq or the prelude uses get a mark.
std::string name(const std::string& kernel_name);
/// `bound`: what the variables of the quantifiers around e are called, outermost first.
std::string text(kernel::Expr e, const Names& bound = {}, const Atoms& atoms = {});
/// Names for the indices of e that lead out of it.
Names loose_names(kernel::Expr e);
/// "" or " name name".
std::string spaced(const Names& names);
Names names_of(const kernel::Exprs& variables);
/// The free variables of all of them, in order of creation.
kernel::Exprs variables_of(const kernel::Exprs& es);
/// The functions in e that have a name of their own, each as its name.
void visit_functions(kernel::Expr e, const std::function<void(const std::string&)>& visit);
}  // namespace coq
