// SPDX-License-Identifier: GPL-2.0-or-later
#include "command/model_option.hpp"

#include <cstdint>
#include <string>

#include "command/program.hpp"

namespace magicmass::command {

void add_model_option(CLI::App& command, reference::SceneOptions& options) {
  command.add_option("--model", options.model, "the model to use (plan tells which)")
      ->type_name("MODEL");
  command
      .add_option_function<std::string>(
          "--scalar",
          [&options](const std::string& name) {
            options.scalars = name == "double"        ? reference::Scalars::doubles
                              : name == "long-double" ? reference::Scalars::long_doubles
                                                      : reference::Scalars::exact;
          },
          "step events, in double, long-double or exact numbers")
      ->type_name("NAME")
      ->check(CLI::IsMember({"double", "long-double", "exact"}));
  command.add_option("--max-events", options.max_events, "stop after so many (1000000)")
      ->type_name("N")
      ->check(CLI::Range(std::int64_t{0}, std::int64_t{1} << 53U).description(""));
}

}  // namespace magicmass::command
