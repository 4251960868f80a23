// SPDX-License-Identifier: GPL-2.0-or-later
// How the targets are measured: each from its quantity, evaluators and `other`. Nothing where no row tells.
#pragma once

#include "report/targets.hpp"

namespace magicmass::report::measures {

/// Time over that of `other` on the easiest family, or how many times as fast if is_at_least: the median of the batches, each
/// paired round by round.
std::optional<Seen> relative_time(const Target& target, const Figures& figures);
/// The largest ratio to naive of all families.
std::optional<Seen> slowest_family(const Target& target, const Figures& figures);
/// In per cent of the inputs of the easiest family.
std::optional<Seen> fallback_share(const Target& target, const Figures& figures);
/// In milliseconds, of all families.
std::optional<Seen> slowest_call(const Target& target, const Figures& figures);
/// Over the median time of the same evaluator on the easiest family.
std::optional<Seen> slowest_over_median(const Target& target, const Figures& figures);
/// Answers, those of the climb included.
std::optional<Seen> misrounded(const Target& target, const Figures& figures);
std::optional<Seen> wrong_counts(const Target& target, const Figures& figures);
std::optional<Seen> over_envelope(const Target& target, const Figures& figures);
/// The simulator's figure of the target's name.
std::optional<Seen> event_figure(const Target& target, const Figures& figures);

}  // namespace magicmass::report::measures
