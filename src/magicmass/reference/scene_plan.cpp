// SPDX-License-Identifier: GPL-2.0-or-later
#include "magicmass/reference/scene_plan.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

#include "magicmass/errors.hpp"
#include "magicmass/reference/count.hpp"
#include "magicmass/reference/decimal.hpp"
#include "magicmass/reference/exact_work.hpp"
#include "magicmass/reference/line_plan.hpp"
#include "magicmass/reference/rational.hpp"
#include "magicmass/reference/transfers.hpp"
#include "magicmass/simulator/line_motion.hpp"
#include "magicmass/simulator/stalled_clock.hpp"

namespace magicmass::reference {
namespace {

using cln::cl_I;

constexpr std::array<std::pair<Model, std::string_view>, 5> model_names = {{
    {Model::closed_form, "closed form"},
    {Model::velocity_stepping, "velocity stepping"},
    {Model::event_driven, "event-driven"},
    {Model::exact_events, "exact events"},
    {Model::transfers, "transfers"},
}};

std::string hyphenated(std::string name) {
  std::replace(name.begin(), name.end(), ' ', '-');
  return name;
}

/// What a run in doubles, without any output, comes to.
struct Rehearsal {
  std::int64_t events = 0;
  Ties ties;
};

Rehearsal rehearse(const ExactLine& line, std::int64_t limit) {
  LineMotion<double> motion(rounded(line));
  StalledClock<double> clock;
  const bool inelastic = motion.restitution() < 1.0;
  const std::optional<double> until =
      line.until ? std::optional(nearest_double(*line.until)) : std::nullopt;
  while (motion.next() && (!until || motion.is_due_by(*until)) && motion.events() < limit) {
    if (motion.ties().near == 0) motion.step();
    if (motion.ties().near > 0) break;
    if (inelastic && clock.look(motion.events(), motion.now())) break;
  }
  return {motion.events(), motion.ties()};
}

/// More of them are not stepped exactly unless that is asked for: a gigabyte would not do.
constexpr std::size_t most_exact_bodies = 200'000;

/// Whether exact numbers stay short: below 2^13 bits over the first 2000 events, or as many as may be looked at.
bool stays_short(const ExactLine& line, std::int64_t limit) {
  LineMotion<FieldNumber> motion(line.together());
  ExactWork work(line.common.field ? line.common.field->degree() : 1, most_rehearsed_work);
  for (auto next = motion.next(); next && motion.events() < std::min<std::int64_t>(limit, 2000);
       next = motion.next()) {
    if (line.until && *line.until < *next) break;
    const auto event = motion.step();
    if (std::max({event.time.bits(), event.v_left.bits(), event.v_right.bits()}) >= 1L << 13U)
      return false;
    if (work.is_too_much(event)) break;
  }
  return true;
}

bool lists_events(const Scene& scene) {
  return wants(scene, Output::events) || (wants(scene, Output::trajectory) && scene.times.empty());
}

/// What is in the way of a model, or nothing.
std::string why_not(Model model, const Scene& scene, const ExactLine& line, const LinePlan& known) {
  const bool theorem = known.end.has_value();
  switch (model) {
    case Model::closed_form:
      if (!theorem)
        return "theorems hold for one block moving towards a ball and a block, or a ball and a "
               "wall, that rest";
      if (line.until) return "a run until a given time has no last event of its own";
      if (lists_events(scene) && scene.every == 1) return "events or a trajectory are asked for";
      return "";
    case Model::velocity_stepping:
      if (!theorem) return "the order of contacts is known beforehand only where the theorems hold";
      if (line.until || lists_events(scene) || !scene.times.empty())
        return "it has neither places nor times";
      return "";
    case Model::exact_events:
      return line.one_field ? "" : "its numbers are in no common field of degree up to 12";
    case Model::transfers:
      if (lists_events(scene) || !scene.times.empty())
        return "it goes from transfer to transfer and has no single events";
      if (const auto why = why_no_cradle(line)) return *why;
      return !line.until || run_cradle(line, event_limit(scene, {})).is_whole
                 ? ""
                 : "the time given is in the middle of a transfer";
    case Model::event_driven:
      return "";
  }
  return "";
}

/// The paper's counts, exact at every size.
std::optional<cl_I> known_contacts(const Scene& scene, const ExactLine& line) {
  if (!scene.alpha || !(line.restitution == FieldNumber(1))) return {};
  const LargeCounts counts = count_collisions(*scene.alpha);
  return counts.N_A + counts.N_B;
}

/// The model that --model and --scalar ask for. Throws InvalidInput where the two do not go together.
Model asked_model(const Scene& scene, const ExactLine& line, const SceneOptions& options,
                  const LinePlan& known) {
  const bool exactly = options.scalars == Scalars::exact;
  if (options.model.empty()) {
    if (exactly) return Model::exact_events;
    const bool velocities = why_not(Model::velocity_stepping, scene, line, known).empty();
    return velocities ? Model::velocity_stepping : Model::event_driven;
  }
  const Model model = parse_model(options.model);
  if (options.scalars == Scalars::planned) return model;
  if (exactly && (model == Model::event_driven || model == Model::exact_events))
    return Model::exact_events;
  if (!exactly && (model == Model::event_driven || model == Model::velocity_stepping)) return model;
  throw InvalidInput("--scalar does not go with the model " + to_text(model) +
                     "; allowed: event-driven, or velocity-stepping but not with exact");
}

std::string exact_reason(const ExactLine& line) {
  return "a decision is closer than doubles can tell; exact numbers of " + line.field +
         " decide it";
}

void choose_among_events(const Scene& scene, const ExactLine& line, std::int64_t limit,
                         LinePlan& chosen) {
  const Rehearsal rehearsal = rehearse(line, limit);
  chosen.plan.events = rehearsal.events;
  const std::string needed =
      lists_events(scene) ? "events or a trajectory are asked for, which need places and times"
                          : "no theorem holds for this scene, so its events are stepped";
  if (rehearsal.ties.near == 0) {
    chosen.model = Model::event_driven;
    chosen.plan.reason = needed;
    return;
  }
  const bool exactly =
      line.one_field && line.bodies() <= most_exact_bodies && stays_short(line, limit);
  if (exactly) {
    chosen.model = Model::exact_events;
    chosen.plan.reason = needed + "; after event " + std::to_string(rehearsal.ties.first_near) +
                         " " + exact_reason(line);
    chosen.plan.events = limit;
    return;
  }
  chosen.model = Model::event_driven;
  chosen.plan.reason =
      needed + (line.one_field
                    ? "; near ties are marked: exact numbers would grow too long or too many"
                    : "; near ties are marked: no common field of degree up to 12 "
                      "decides them");
  chosen.plan.events = limit;
}

void choose(const Scene& scene, const ExactLine& line, const SceneOptions& options,
            LinePlan& chosen) {
  const std::int64_t limit = event_limit(scene, options);
  const auto can = [&](Model model) { return why_not(model, scene, line, chosen).empty(); };
  if (can(Model::closed_form)) {
    chosen.model = Model::closed_form;
    chosen.plan.reason =
        chosen.end->collapse() ? "a theorem says when and where infinitely many collisions end"
        : scene.times.empty() && scene.every == 1
            ? "only counts, terminal velocities or energy are asked for, so no event is stepped"
            : "theorems give single events and positions at given times, so no event is stepped";
  } else if (can(Model::transfers)) {
    chosen.model = Model::transfers;
    chosen.plan.reason =
        "each ball is magic and alone with its two blocks while it moves, so it hands on "
        "everything";
  } else {
    choose_among_events(scene, line, limit, chosen);
  }
}

}  // namespace

std::string to_text(Model model) {
  return std::string(std::find_if(model_names.begin(), model_names.end(), [&](const auto& entry) {
                       return entry.first == model;
                     })->second);
}

Model parse_model(const std::string& name) {
  std::string allowed;
  for (const auto& [model, text] : model_names) {
    if (hyphenated(std::string(text)) == hyphenated(name)) return model;
    allowed += (allowed.empty() ? "" : ", ") + hyphenated(std::string(text));
  }
  throw InvalidInput("--model: unknown model \"" + name + "\"; allowed: " + allowed);
}

std::int64_t event_limit(const Scene& scene, const SceneOptions& options) {
  return options.max_events.value_or(scene.max_events.value_or(usual_max_events));
}

void refuse_as_too_long(const Scene& scene, const cl_I& events, std::int64_t limit) {
  constexpr int few_digits = 6;
  cl_I every = 10;
  while (every * limit < events) every = every * 10;
  const bool can_be_every = every <= cl_I(std::numeric_limits<std::int64_t>::max());
  const std::string so_many = can_be_every ? to_text(events) : to_decimal(events, few_digits);
  refuse_key(scene, "outputs",
             "a list of all " + so_many + " events is over the limit of " + std::to_string(limit),
             (can_be_every ? "every = " + to_text(every) + " to print each so manieth, " : "") +
                 "times = [...] for positions at given times, or max_events to stop after so many");
}

LinePlan plan_line(const Scene& scene, const ExactLine& line, const SceneOptions& options) {
  LinePlan chosen{Model::event_driven, {}, {}};
  if (is_theorems_start(line)) chosen.end.emplace(line, known_contacts(scene, line));
  const bool collapses = chosen.end && chosen.end->collapse();
  const bool unlimited = !options.max_events && !scene.max_events && !line.until;
  if (chosen.end && !collapses && lists_events(scene) && unlimited &&
      chosen.end->contacts() > scene.every * cl_I(usual_max_events))
    refuse_as_too_long(scene, chosen.end->contacts(), usual_max_events);
  if (options.model.empty() && options.scalars == Scalars::planned) {
    choose(scene, line, options, chosen);
  } else {
    chosen.model = asked_model(scene, line, options, chosen);
    const std::string obstacle = why_not(chosen.model, scene, line, chosen);
    if (!obstacle.empty())
      throw InvalidInput(scene.source + ": model " + to_text(chosen.model) +
                         " cannot give what the scene asks for: " + obstacle +
                         "; allowed: another --model, or none for the cheapest");
    chosen.plan.reason = "asked for";
    chosen.plan.events = event_limit(scene, options);
  }
  chosen.plan.model = to_text(chosen.model);
  if (chosen.model == Model::closed_form || chosen.model == Model::transfers) {
    chosen.plan.events = 0;
  } else if (chosen.end && !collapses && !line.until) {
    chosen.plan.events = cln::min(chosen.end->contacts(), cl_I(event_limit(scene, options)));
  }
  return chosen;
}

bool is_papers_scene(const Scene& scene, const SceneOptions& options) {
  const bool has_doubles =
      std::holds_alternative<double>(scene.V) && std::holds_alternative<double>(scene.L);
  return scene.alpha && has_doubles && scene.times.empty() && scene.every == 1 && !scene.until &&
         options.model.empty() &&
         (options.scalars == Scalars::planned || options.scalars == Scalars::exact) &&
         scene.restitution == Value(1.0);
}

Plan plan_papers_scene(const Scene& scene, const SceneOptions& options) {
  if (!wants(scene, Output::events) && !wants(scene, Output::trajectory))
    return {"closed form",
            "only counts, terminal velocities or energy are asked for, so no event is stepped", 0};
  const LargeCounts counts = count_collisions(*scene.alpha);
  const cl_I events = counts.N_A + counts.N_B;
  const bool unlimited = !options.max_events && !scene.max_events;
  if (unlimited && events > cl_I(usual_max_events))
    refuse_as_too_long(scene, events, usual_max_events);
  return {"event-driven", "events or a trajectory are asked for, which need places and times",
          cln::min(events, cl_I(event_limit(scene, options)))};
}

Plan plan(const Scene& scene, const SceneOptions& options) {
  const ExactLine line = exact_line(scene);
  return is_papers_scene(scene, options) ? plan_papers_scene(scene, options)
                                         : plan_line(scene, line, options).plan;
}

}  // namespace magicmass::reference
