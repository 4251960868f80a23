// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <istream>
#include <ostream>
#include <string>
#include <vector>

#include "report/contestant.hpp"
#include "report/family.hpp"
#include "report/rows.hpp"

namespace magicmass::report {

/// A worst input ever seen, for one member of one contestant: by one figure.
struct WorstInput {
  std::string contestant, precision, quantity, member;
  std::string
      figure;  ///< "ulp", "envelope" or "eps": max_ulp, over_envelope, max_promise_eps of ErrorRow
  Input input;
  double error = 0;  ///< that figure there, when it was found
};

/// CSV with a header line, alpha and e as hexadecimal floats; throws InvalidInput, with the line, where it is something else.
std::vector<WorstInput> read_worst_inputs(std::istream& file);
/// The same back, one line each, sorted: the file's differences are the changes.
void write_worst_inputs(std::ostream& file, std::vector<WorstInput> inputs);

/// The worse of what was known and what these rows found, one for each contestant, precision, member and figure, and
/// another where alpha is subnormal in that precision.
/// Infinite errors are kept like any other; an exact answer throughout has no worst input.
std::vector<WorstInput> merged(std::vector<WorstInput> known, const std::vector<ErrorRow>& rows);

/// The worst inputs of a quantity as a family of its own, whichever contestant they were found with.
Family worst_inputs_family(const std::string& quantity, const std::vector<WorstInput>& inputs);

}  // namespace magicmass::report
