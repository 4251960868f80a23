// SPDX-License-Identifier: GPL-2.0-or-later
// One function a command, each in a file of its name.
#pragma once

#include <string>
#include <vector>

namespace magicmass::command {

struct Program;

void add_derive(Program& program);
void add_verify(Program& program);
void add_generate(Program& program);
void add_eval(Program& program);
void add_count(Program& program);
void add_terminal(Program& program);
void add_ratios(Program& program);
void add_simulate(Program& program);
void add_plan(Program& program);
void add_equal(Program& program);
/// The words of a command line, where -x/2 after "equal" or "learn check ID" is an expression and no option.
std::vector<std::string> with_expressions_marked(int argc, char** argv);
void add_report(Program& program);
void add_demo(Program& program);
void add_figure(Program& program);
void add_animate(Program& program);
void add_reproduce(Program& program);
void add_learn(Program& program);
void add_doctor(Program& program);
void add_manual(Program& program);

}  // namespace magicmass::command
