// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "command/line_run.hpp"
#include "command/records.hpp"

namespace magicmass::command {

/// Runs a scene and writes it. csv and jsonl are written as events happen, in constant memory: csv holds the events, or
/// the trajectory where no events were asked for, or one line; jsonl one object a line, {"event": ...},
/// {"point": ...} and at last {"result": ...}. text and json keep what the event limit lets through.
void write_line_run(const Scene& scene, const reference::ExactLine& line,
                    const reference::SceneOptions& options, const OutputOptions& output);

}  // namespace magicmass::command
