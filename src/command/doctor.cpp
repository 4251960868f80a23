// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <sstream>

#include <unistd.h>

#include "command/commands.hpp"
#include "command/generated_tree.hpp"
#include "command/program.hpp"
#include "command/records.hpp"
#include "magicmass/batch/instruction_set.hpp"

namespace magicmass::command {
namespace {

namespace fs = std::filesystem;

struct Tool {
  const char* what;      ///< as a reader knows it
  const char* programs;  ///< any of these will do
  const char* needed_for;
  const char* package;  ///< of Debian
};

/// Nothing here is needed to derive, prove, evaluate or simulate.
constexpr std::array<Tool, 10> tools{{
    {"compiler", "c++", "learn's exercises in C++, report --function, generated headers", "g++"},
    {"cmake", "cmake", "building magicmass and what uses it", "cmake"},
    {"pkg-config", "pkg-config pkgconf", "compiling without CMake", "pkg-config"},
    {"gnuplot", "gnuplot", "figure, report --figures, reproduce, demo, animate --gif",
     "gnuplot-nox"},
    {"pandoc", "pandoc", "derive --format markdown as other documents", "pandoc"},
    {"pdflatex", "pdflatex", "derive --format latex as PDF", "texlive-latex-base"},
    {"doxygen", "doxygen", "the reference of the library's headers", "doxygen"},
    {"browser", "chromium chromium-browser google-chrome firefox", "looking at HTML pages",
     "chromium"},
    {"ginsh", "ginsh", "a contestant of report", "ginac-tools"},
    {"python", "python3", "report --peers, with SymPy and NumPy", "python3-sympy python3-numpy"},
}};

struct Finding {
  std::string name, kind;
  bool is_there = false;
  std::string where, needed_for, package;
};

/// The first of the programs in the first folder of PATH that has one; "" if none has.
std::string found_in_path(const char* programs) {
  const char* path = std::getenv("PATH");
  std::istringstream folders(path == nullptr ? "" : path);
  for (std::string folder; std::getline(folders, folder, ':');) {
    std::istringstream names(programs);
    for (std::string name; names >> name;) {
      const std::string file = (folder.empty() ? "." : folder) + "/" + name;
      std::error_code error;
      if (fs::is_regular_file(file, error) && ::access(file.c_str(), X_OK) == 0) return file;
    }
  }
  return "";
}

std::vector<Finding> look_around() {
  std::vector<Finding> findings;
  for (const Tool& tool : tools) {
    const std::string where = found_in_path(tool.programs);
    findings.push_back(
        {tool.what, "program", !where.empty(), where, tool.needed_for, tool.package});
  }
  for (const InstructionSet set : all_instruction_sets)
    findings.push_back({to_text(set), "instruction set", is_available(set),
                        set == best_instruction_set() ? "used" : "", "arrays at full speed", ""});
  const fs::path generated = source_generated_folder();
  std::error_code error;
  findings.push_back({"generated", "folder", fs::is_directory(generated, error), generated.string(),
                      "generate --check, demo", "magicmass"});
  return findings;
}

Cell text_or_missing(const std::string& text) {
  return text.empty() ? missing_cell() : text_cell(text);
}

std::string text_of(const std::vector<Finding>& findings) {
  std::string text;
  std::size_t missing = 0;
  for (const Finding& one : findings) {
    std::string line = (one.is_there ? "found    " : "missing  ") + one.name;
    line.resize(std::max<std::size_t>(line.size() + 1, 21), ' ');
    if (one.is_there) {
      line += one.where;
    } else {
      ++missing;
      line += "for " + one.needed_for;
      if (!one.package.empty()) line += " (Debian: " + one.package + ")";
    }
    line.erase(line.find_last_not_of(' ') + 1);
    text += line + "\n";
  }
  return "magicmass " MAGICMASS_VERSION "\n" + text +
         (missing == 0 ? "Nothing is missing.\n"
                       : "What is missing is needed for nothing else: all other commands work.\n");
}

void write_records(Destination& output, const std::string& format,
                   const std::vector<Finding>& findings) {
  RecordWriter writer(output, format, {"name", "kind", "found", "where", "needed_for", "package"},
                      false);
  for (const Finding& one : findings)
    writer.write({text_cell(one.name), text_cell(one.kind),
                  digits_cell(one.is_there ? "true" : "false"),
                  text_or_missing(one.is_there ? one.where : ""), text_cell(one.needed_for),
                  text_or_missing(one.package)});
  writer.finish();
}

}  // namespace

void add_doctor(Program& program) {
  const auto options = std::make_shared<OutputOptions>();
  CLI::App& command = add_command(
      program, "doctor", "What this machine has of what magicmass can use, and what it lacks",
      "magicmass doctor");
  add_output_options(command, *options);
  on_run(program, command, [options] {
    const std::vector<Finding> findings = look_around();
    Destination output(options->path);
    if (options->format == "text")
      output.write(text_of(findings));
    else
      write_records(output, options->format, findings);
    output.finish();
    return ExitCode::done;
  });
}

}  // namespace magicmass::command
