// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>
#include <array>
#include <string_view>

#include <fmt/format.h>

#include "derivation/derivation.hpp"
#include "render/derivation_pages.hpp"
#include "render/steps.hpp"
#include "render/wrapping.hpp"

namespace magicmass::render {
namespace {

/// What each chapter is for, in order. A name that is not there is left out, not invented.
constexpr std::array<std::string_view, 21> main_theorems = {"contact.relative",
                                                            "contact.theta_paper",
                                                            "cycle.V_squared",
                                                            "rotation.cos_half_psi",
                                                            "rotation.psi_paper",
                                                            "power.a",
                                                            "power.b",
                                                            "power.c",
                                                            "power.c_prime",
                                                            "chebyshev.next",
                                                            "chebyshev.even",
                                                            "counting.N_A",
                                                            "counting.N_B",
                                                            "ratios.alpha_k_paper",
                                                            "ratios.beta_k_paper",
                                                            "ratios.magic_a",
                                                            "ratios.magic_b",
                                                            "times.t_P",
                                                            "times.t_Q",
                                                            "times.s_P",
                                                            "times.s_Q"};

bool is_main(const proof::Step& step) {
  return std::find(main_theorems.begin(), main_theorems.end(), step.id) != main_theorems.end();
}

/// The equation with its verdict at the right of the last line.
std::string line(const proof::Step& step, const TextStyle& style) {
  std::string text =
      wrapped(inline_text(equation(step.from, step.relation, step.to), style), "    ");
  text.pop_back();
  const std::string verdict = verdict_text(step.verdict, style.colourful);
  const std::size_t used = columns(text.substr(text.rfind('\n') + 1)) + step.verdict.size();
  if (used < page_width) return text + std::string(page_width - used, ' ') + verdict + "\n";
  return text + "\n" + std::string(page_width - step.verdict.size(), ' ') + verdict + "\n";
}

std::string counts(const std::vector<proof::Step>& steps) {
  std::string text;
  for (const char* verdict : {"proved", "definition", "hypothesis", "law", "refused"})
    if (const std::size_t count = count_verdict(steps, verdict); count > 0)
      text += fmt::format("{}{} {}", text.empty() ? "" : ", ", count, verdict);
  return text;
}

}  // namespace

std::string derivation_summary(const std::vector<proof::Step>& steps, const TextStyle& style) {
  std::string text = "laws\n";
  for (const proof::Step& step : steps)
    if (step.verdict == "law") text += line(step, style);
  for (const std::string& chapter : derivation::chapter_names()) {
    std::vector<proof::Step> inside;
    std::copy_if(steps.begin(), steps.end(), std::back_inserter(inside),
                 [&](const proof::Step& step) { return chapter_of(step) == chapter; });
    if (inside.empty()) continue;
    text += fmt::format("{}: {}\n", chapter, counts(inside));
    for (const proof::Step& step : inside)
      if (is_main(step) || step.verdict == "refused") text += line(step, style);
  }
  return text;
}

}  // namespace magicmass::render
