// SPDX-License-Identifier: GPL-2.0-or-later
#include "host/embedded.hpp"

namespace host {

const std::map<std::string, std::string>& embedded() {
  static const std::map<std::string, std::string> all{
#include "embedded_files.txt"
  };
  return all;
}

}  // namespace host
