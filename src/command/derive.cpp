// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>
#include <memory>

#include <fmt/format.h>

#include "command/commands.hpp"
#include "command/nearest_name.hpp"
#include "command/program.hpp"
#include "command/records.hpp"
#include "command/refusal.hpp"
#include "command/terminal_style.hpp"
#include "magicmass/errors.hpp"
#include "magicmass/scenes/shown_text.hpp"
#include "render/derivation_pages.hpp"
#include "render/step_names.hpp"
#include "render/steps.hpp"
#include "render/theorem_index.hpp"

namespace magicmass::command {
namespace {

using Steps = std::vector<proof::Step>;

struct DeriveOptions {
  std::vector<std::string> names;  // chapters and steps
  std::string from;
  bool list = false;
  bool summary = false;
  bool ascii = false;
  OutputOptions output;
};

void require_one_kind(const DeriveOptions& options) {
  const std::string& format = options.output.format;
  if (options.summary && format != "text")
    throw InvalidInput("--summary is text alone; allowed with it: --format text");
  if (options.list && format == "latex")
    throw InvalidInput(
        "--list has no LaTeX; allowed with it: --format text, markdown, html, json, csv");
  if (format == "csv" && !options.list) throw InvalidInput("--format csv is for --list alone");
  if (options.list + options.summary + !options.from.empty() + !options.names.empty() > 1)
    throw InvalidInput("chapters or steps, --from, --list and --summary exclude each other");
}

[[noreturn]] void refuse_name(const std::string& kind, const std::string& name,
                              const std::vector<std::string>& names) {
  throw InvalidInput(fmt::format("no {} is called \"{}\"; did you mean {}?", kind, shown_text(name),
                                 nearest_name(name, names)));
}

/// The chapters and steps that were named, in the derivation's order; all if none was. A refused step is always shown.
Steps asked_for(const std::vector<std::string>& names, const Steps& all) {
  if (names.empty()) return all;
  std::vector<std::string> known = derivation::chapter_names();
  for (const proof::Step& step : all) known.push_back(step.id);
  for (const std::string& name : names)
    if (std::find(known.begin(), known.end(), name) == known.end())
      refuse_name("chapter or step", name, known);
  Steps steps;
  std::copy_if(all.begin(), all.end(), std::back_inserter(steps), [&](const proof::Step& step) {
    const auto is_named = [&](const std::string& name) {
      return name == step.id || name == render::chapter_of(step);
    };
    return step.verdict == "refused" || std::any_of(names.begin(), names.end(), is_named);
  });
  return steps;
}

std::string tree_page(const DeriveOptions& options, const Steps& all,
                      const render::TextStyle& style) {
  const Steps roots = render::steps_called(options.from, all);
  if (roots.empty()) refuse_name("result", options.from, render::all_names(all));
  const auto tree = render::premise_tree(roots, all);
  const Steps steps = render::steps_of_tree(tree, all);
  const std::string& format = options.output.format;
  if (format == "json") return render::derivation_json(steps);
  if (format == "markdown") return render::derivation_markdown(steps, tree);
  if (format == "latex") return render::derivation_latex(steps, tree);
  if (format == "html") return render::derivation_html(steps, tree);
  return render::tree_text(tree, style);
}

std::string index_page(const std::string& format, const Steps& all,
                       const render::TextStyle& style) {
  const render::TheoremIndex index = render::theorem_index(all);
  if (format == "json") return render::index_json(index);
  if (format == "csv") return render::index_csv(index);
  if (format == "markdown") return render::index_markdown(index);
  if (format == "html") return render::index_html(index);
  return render::index_text(index, style);
}

std::string page(const DeriveOptions& options, const Steps& all, const render::TextStyle& style) {
  const std::string& format = options.output.format;
  if (options.list) return index_page(format, all, style);
  if (!options.from.empty()) return tree_page(options, all, style);
  if (options.summary) return render::derivation_summary(all, style);
  const Steps steps = asked_for(options.names, all);
  if (format == "json") return render::derivation_json(steps);
  if (format == "markdown") return render::derivation_markdown(steps);
  if (format == "latex") return render::derivation_latex(steps);
  if (format == "html") return render::derivation_html(steps);
  return render::derivation_text(steps, style);
}

/// As far as it takes for what was named; to the end where that is not seen from the names.
derivation::Derivation far_enough(const std::vector<std::string>& names) {
  const auto& chapters = derivation::chapter_names();
  auto last = chapters.begin();
  for (const std::string& name : names) {
    const auto found = std::find(chapters.begin(), chapters.end(), name.substr(0, name.find('.')));
    last = std::max(last, found);
  }
  if (names.empty() || last == chapters.end()) return derivation::derive();
  derivation::Derivation begun = derivation::derive_up_to(*last);
  const auto is_there = [&](const std::string& name) {
    return name.find('.') == std::string::npos ||
           std::any_of(begun.theorems.begin(), begun.theorems.end(),
                       [&](const proof::Theorem& theorem) { return theorem.id() == name; });
  };
  return std::all_of(names.begin(), names.end(), is_there) ? begun : derivation::derive();
}

ExitCode derive(const DeriveOptions& options) {
  require_one_kind(options);
  Destination output(options.output.path);
  const derivation::Derivation derivation = far_enough(options.names);
  output.write(page(options, render::steps_of(derivation), text_style(output, options.ascii)));
  output.finish();
  return say_if_refused(derivation);
}

}  // namespace

void add_derive(Program& program) {
  const auto options = std::make_shared<DeriveOptions>();
  CLI::App& command = add_command(program, "derive",
                                  "The derivation, from the conservation laws, proved line by line",
                                  "magicmass derive power counting");
  offer(*command.add_option("NAME", options->names, "chapters or steps (power.a); all without one")
             ->type_name(""),
        derivation::chapter_names());
  command.add_option("--from", options->from, "what that rests on: a_n, eq:a-final, power.a")
      ->type_name("RESULT")
      ->check([](const std::string& name) { return std::string(name.empty() ? "no name" : ""); });
  command.add_flag("--list", options->list, "the theorems, and where the paper has them");
  command.add_flag("--summary", options->summary, "the laws and the main theorems alone");
  command.add_flag("--ascii", options->ascii, "plain characters, whatever the locale");
  add_output_options(command, options->output,
                     {"text", "markdown", "latex", "html", "json", "csv"});
  on_run(program, command, [options] { return derive(*options); });
}

}  // namespace magicmass::command
