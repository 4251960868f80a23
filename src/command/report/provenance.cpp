// SPDX-License-Identifier: GPL-2.0-or-later
#include "command/report/provenance.hpp"

#include <fstream>
#include <thread>

#include <cln/version.h>
#include <fmt/format.h>
#include <ginac/version.h>
#include <gnu/libc-version.h>
#include <sys/utsname.h>

namespace magicmass::command {
namespace {

std::string compiler() {
#if defined(__clang__)
  return "clang " __clang_version__;
#elif defined(__GNUC__)
  return "g++ " __VERSION__;
#else
  return "unknown";
#endif
}

}  // namespace

std::string processor_name() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);)
    if (line.starts_with("model name") && line.find(": ") != std::string::npos)
      return line.substr(line.find(": ") + 2);
  return "unknown processor";
}

Provenance provenance() {
  struct utsname system {};
  ::uname(&system);
  std::string flags = MAGICMASS_FLAGS;
  while (flags.ends_with(' ')) flags.pop_back();
  return {
      {"version", "magicmass " MAGICMASS_VERSION},
      {"machine", fmt::format("{}, {} processors, {} {}", processor_name(),
                              std::thread::hardware_concurrency(), system.sysname, system.machine)},
      {"compiler", compiler()},
      {"flags", flags},
      {"libraries",
       fmt::format("glibc {}, GiNaC {}.{}.{}, CLN {}.{}.{}", gnu_get_libc_version(),
                   GINACLIB_MAJOR_VERSION, GINACLIB_MINOR_VERSION, GINACLIB_MICRO_VERSION,
                   CL_VERSION_MAJOR, CL_VERSION_MINOR, CL_VERSION_PATCHLEVEL)},
  };
}

}  // namespace magicmass::command
