// SPDX-License-Identifier: GPL-2.0-or-later
#include "command/report/own_function.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <sstream>

#include <dlfcn.h>
#include <fmt/format.h>

#include "command/learn/confined_process.hpp"
#include "command/scratch_folder.hpp"
#include "magicmass/errors.hpp"
#include "magicmass/scenes/shown_text.hpp"

namespace magicmass::command {
namespace {

using report::Input;

using Function = void (*)(double alpha, long n, double* members);
using Members = std::array<double, 4>;

std::string first_error(const std::string& output) {
  std::istringstream lines(output);
  for (std::string line; std::getline(lines, line);)
    if (line.find("error") != std::string::npos || line.find("undefined") != std::string::npos)
      return line;
  return output;
}

Function compiled(const std::string& file) {
  const std::filesystem::path path = std::filesystem::absolute(file);
  if (!std::filesystem::is_regular_file(path))
    throw InvalidInput("cannot read " + shown_text(file, 200));
  const ScratchFolder scratch;
  std::filesystem::copy_file(path, scratch.path() / "yours.cpp");
  std::ofstream(scratch.path() / "called.cpp")
      << "#include \"yours.cpp\"\n"
         "extern \"C\" void magicmass_own_velocities(double alpha, long n, double* members) {\n"
         "  const auto v = velocities(alpha, n);\n"
         "  members[0] = v.a, members[1] = v.b, members[2] = v.c, members[3] = v.c_prime;\n"
         "}\n";
  ProcessLimits limits;
  limits.time = std::chrono::seconds(30);
  limits.memory = std::size_t{2} << 30U;
  limits.is_computing_only = false;
  const ProcessEnd end = run_confined(
      {"env", "LC_ALL=C", "TMPDIR=" + scratch.path().string(), "c++", "-std=c++20", "-O2",
       "-ffp-contract=off", "-w", "-fPIC", "-shared", "-o", "yours.so", "called.cpp"},
      "", scratch.path(), limits);
  if (!end.is_good())
    throw InvalidInput(
        fmt::format("{} does not compile: {}; asked for: a function Velocities velocities(double "
                    "alpha, long n) with members a, b, c, c_prime",
                    shown_text(file, 200), shown_text(first_error(end.output), 300)));
  // Stays loaded for good; its file is not needed any more.
  void* const library = ::dlopen(scratch.file("yours.so").c_str(), RTLD_NOW | RTLD_LOCAL);
  if (library == nullptr) throw InvalidInput(shown_text(file, 200) + " cannot be loaded");
  return reinterpret_cast<Function>(::dlsym(library, "magicmass_own_velocities"));
}

/// How many of the entries are better, and one more.
template <class Measure>
long place(const std::vector<const Entry*>& entries, const Entry& own, const Measure& measure) {
  return 1 + std::count_if(entries.begin(), entries.end(),
                           [&](const Entry* one) { return measure(*one) < measure(own); });
}

}  // namespace

report::Contestant own_function(const std::string& file) {
  const Function function = compiled(file);
  report::Contestant one;
  one.name = own_name;
  one.quantity = "velocities";
  one.form = own_name;
  one.precision = "double";
  one.can = [](const Input&) { return true; };
  one.evaluate = [function](const Input& input, long double* members) {
    Members values{};
    function(input.alpha, static_cast<long>(input.index), values.data());
    std::copy(values.begin(), values.end(), members);
  };
  one.evaluate_all = [function](std::span<const Input> inputs) {
    Members values{};
    for (const Input& input : inputs) {
      function(input.alpha, static_cast<long>(input.index), values.data());
      asm volatile("" : : "m"(values) : "memory");
    }
  };
  return one;
}

std::vector<std::string> own_places(const Measurement& measurement) {
  std::vector<std::string> lines;
  for (const MeasuredFamily& one : measurement.families) {
    std::vector<const Entry*> entries;
    const Entry* own = nullptr;
    for (const Entry& entry : one.entries) {
      if (one.family.quantity != "velocities" || entry.precision != "double" ||
          entry.errors.empty() || !entry.time)
        continue;
      entries.push_back(&entry);
      if (entry.evaluator == own_name) own = &entry;
    }
    if (own == nullptr) continue;
    lines.push_back(
        fmt::format("{}: {}: place {} of {} by error, {} of {} by time", own_name, one.family.name,
                    place(entries, *own, [](const Entry& entry) { return entry.worst().max_ulp; }),
                    entries.size(),
                    place(entries, *own, [](const Entry& entry) { return entry.time->ns_median; }),
                    entries.size()));
  }
  return lines;
}

}  // namespace magicmass::command
