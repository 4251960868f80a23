// SPDX-License-Identifier: GPL-2.0-or-later
// Data typed from the paper: Ee & Lee, Table II (label table:akbk), all digits as printed. Nothing is computed here.
#pragma once

#include <array>
#include <string_view>

namespace magicmass::command {

struct PaperRatios {
  int k;
  std::string_view magic;
  std::string_view deficient;
};

inline constexpr std::array<PaperRatios, 10> paper_table_two = {{
    {1, "1", "0.414214"},
    {2, "0.236068", "0.154701"},
    {3, "0.109916", "0.082392"},
    {4, "0.064178", "0.051462"},
    {5, "0.042217", "0.035276"},
    {6, "0.029927", "0.025717"},
    {7, "0.022341", "0.019591"},
    {8, "0.017321", "0.015427"},
    {9, "0.013827", "0.012465"},
    {10, "0.011295", "0.010283"},
}};

}  // namespace magicmass::command
