// SPDX-License-Identifier: GPL-2.0-or-later
#include "command/gnuplot.hpp"

#include <stdexcept>

#include "answers/errors.hpp"
#include "answers/shown_text.hpp"
#include "host/child.hpp"

namespace command {

std::string drawn(const std::string& script) {
  const auto said = host::said_by({"gnuplot", "-d", "-"}, script);
  if (!said) {
    throw answers::InvalidInput(
        "figure: drawing needs gnuplot (Debian: gnuplot-nox); allowed without it: --format csv");
  }
  if (!said->is_done) {
    throw std::runtime_error("figure: gnuplot could not draw: " +
                             answers::shown_text(said->errors, 200));
  }
  return said->output;
}

}  // namespace command
