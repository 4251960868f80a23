// SPDX-License-Identifier: GPL-2.0-or-later
// The derivation for Coq: written as files, or checked by coqc.
#pragma once

#include "answers/request.hpp"

namespace command {

/// answers::derive, and format coq: a folder of files, written to --output. Throws InvalidInput
/// where a folder is missing or chapters are chosen.
answers::Answer derive(const answers::Request& request);
/// answers::verify, and --with coq: then coqc checks each step, too. Throws InvalidInput where
/// there is no coqc.
answers::Answer verify(const answers::Request& request);

}  // namespace command
