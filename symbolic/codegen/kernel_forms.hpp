// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace magicmass::codegen {

// A quantity computed in a number type of src/magicmass/arithmetic, one input at a time or block by block: the tiers
// `fast` and `accurate`. The table in kernel_forms.cpp is the whole list.
struct KernelForm {
  std::string name;         // "velocities": generated/magicmass/kernels/velocities.hpp
  std::string kernel;       // "VelocitiesKernel"
  std::string result = {};  // the struct in quantities.hpp; empty for a single number
  std::string summary;      // for its docstring
  std::string domain;
  std::vector<std::string> reals = {};                       // exact inputs: "alpha"
  std::vector<std::string> integers = {};                    // whole numbers below 2^51: "n"
  std::vector<std::string> numbers = {};                     // inputs in the number type: "decay"
  std::vector<std::pair<std::string, std::string>> outputs;  // member -> theorem id
  std::vector<std::string> bindings = {};                    // theorem ids
  // The same right sides for the other cases of an output, which is checked: member -> theorem ids.
  std::vector<std::pair<std::string, std::vector<std::string>>> other_cases = {};
  // From alpha = 1 on, where there are two collisions: the theorems of these, in the outputs' order. They are the outputs' right
  // sides with cot_half = 1/(1 + alpha), tan_quarter = alpha cot_half, and of the sine and cosine one is 1, the other cot_half: the
  // cosine where there is an index ("n" = 0 or 1; the sine is 0 at 0), else the sine. That is checked.
  std::vector<std::string> first = {};
  std::string first_index = {};
  // The theorem cos(psi/2) = 1/(1 + alpha): the one arctangent, psi/4, is half_arcsecant(alpha, its tangent), of which a number type
  // takes what suits it.
  std::string arcsecant = {};
  // Whole numbers that a block's caller finds from psi/4.
  bool is_counted = false;
  // r_t is not negative, say these theorems, one a case: without turn, which is 1 or -1, it is the magnitude of the rest.
  std::vector<std::string> not_negative = {};
  // In a number type that has types of its own for the root, for angles and for results, which it rounds: in lanes, if it is not for
  // one number at a time.
  bool rounds_results = false;
  // One number at a time: no block.
  bool is_single = false;
  // The angle of the sine and the cosine is a stage's last value, too: where it takes long to make, two loops wait less than one.
  bool cuts_turns = false;
  // The angle of the sine and the cosine is psi/4 at most, say these theorems, one a case.
  std::vector<std::string> small_angle = {};

  std::string first_sine() const;  // the two in C++
  std::string first_cosine() const;
};

const std::vector<KernelForm>& kernel_forms();

}  // namespace magicmass::codegen
