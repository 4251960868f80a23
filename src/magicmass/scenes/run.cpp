#include "magicmass/scenes/run.hpp"

#include <numeric>

#include "magicmass/exact/exact.hpp"

namespace magicmass::scenes {
namespace {

using simulator::Collision, simulator::Engine;

constexpr std::size_t most_exact_bits = 1U << 17U;
constexpr double most_work = 5e8;  // some five seconds where exact numbers are asked for
constexpr double some_work = 1e8;  // where they are only tried

const std::string close = "decisions are closer than doubles can tell";
const std::string too_slow = "bodies have become too slow for doubles";

/// Refuses numbers that grow too long; multiplying takes more than the length.
struct Lengths {
  double most;
  double comparisons;  ///< of times, in a tournament of all gaps
  double work = 0;

  /// Whether a little more would make numbers subnormal.
  bool is_too_slow(const Collision<double>& event) {
    if (!std::isfinite(event.v_right - event.v_left))
      throw Undecided("the velocities after collision " + std::to_string(event.number) +
                      " do not fit a double");
    const auto is_slow = [](double v) { return v != 0 && std::abs(v) < 0x1p-1000; };
    return is_slow(event.v_left) || is_slow(event.v_right);
  }
  bool is_too_slow(const Collision<Surd>& event) {
    const auto bits = std::max({event.time.bits(), event.v_left.bits(), event.v_right.bits()});
    const auto length = static_cast<double>(bits);
    work += comparisons * (2000 + length * (1 + length / 2000));
    if (bits <= most_exact_bits && work <= most) return false;
    throw Undecided("exact numbers become too long; possible with --max-events " +
                    std::to_string(event.number - 1));
  }
};

/// Exactly, of bodies in doubles too: it overflows where velocities do not.
template <class Scalar>
void set_energies(const Scene& scene, const simulator::Line<Scalar>& start, Result& result) {
  const std::vector<Surd> masses(start.masses.begin(), start.masses.end());
  const std::vector<Surd> at_first(start.velocities.begin(), start.velocities.end());
  std::vector<Surd> at_last;
  for (const Number& velocity : result.terminal) at_last.emplace_back(std::get<Scalar>(velocity));
  const Surd before = energy(masses, at_first);
  result.energy_before = before;
  result.energy = energy(masses, at_last);
  if (const auto last = scene.receiver())
    result.transmitted = energy<Surd>({masses[*last]}, {at_last[*last]}) / before;
}

template <class Scalar>
Result motion(const Scene& scene, std::int64_t limit, const Sink& sink = {},
              double work = most_work) {
  const auto line = line_of<Scalar>(scene);
  Engine<Scalar> engine(line);
  Lengths lengths{work, 1 + static_cast<double>(std::bit_width(scene.masses.size()) / 4)};
  Result result;
  result.counts.resize(scene.masses.size() + 1);
  const auto stop = [&](const std::string& why, const Scalar& time) {
    result.why = why;
    result.known_until = time;
  };
  std::optional<Scalar> until;
  if (scene.until) until = number_of<Scalar>(*scene.until);
  while (result.why.empty() && engine.next()) {
    if (until && !engine.is_due_by(*until)) {
      engine.end(until);
      stop(at_until, *until);
    } else if (result.events == limit) {
      engine.end({});
      stop(at_limit(limit), *engine.next());
    } else {
      const Collision<Scalar> event = engine.step();
      if (result.events + engine.waiting() >= limit) {  // a mirror tells the others
        engine.take_back();
        stop(at_limit(result.events), event.time);
        break;
      }
      if (lengths.is_too_slow(event)) stop(too_slow, event.time);
      ++result.events;
      ++result.counts[event.gap];
      if (sink)
        sink({event.number, event.gap, event.time, event.position, event.v_left, event.v_right});
    }
  }
  for (const auto& body : engine.bodies()) result.terminal.emplace_back(body.velocity);
  set_energies(scene, line, result);
  // Whether rounding decided where the motion ends, and whether more is to come.
  std::string doubt;
  if (result.why.empty() && std::floating_point<Scalar> && engine.has_lost()) doubt = too_slow;
  if (engine.ties().near > 0)
    doubt = "uncertain after collision " + std::to_string(engine.ties().first_near) + ": " + close;
  result.is_undecided = !doubt.empty();
  result.why += (doubt.empty() || result.why.empty() ? "" : "; ") + doubt;
  result.status = result.why.empty() ? Status::complete : Status::limited;
  if constexpr (std::floating_point<Scalar>)
    if (const auto e = engine.errors(); std::isfinite(e.position + e.velocity)) result.errors = e;
  return result;
}

/// Of a collapse, how many are told one by one.
std::int64_t told(const Scene& collapse) {
  std::int64_t rows = 0;
  stream_by_theorem(collapse, 1, [&](const Row&) { ++rows; });
  return rows;
}

/// What a collapse comes to in exact numbers, but for its time and place: momentum is kept.
Result exactly(const Scene& scene, Result result) {
  const auto line = line_of<Surd>(scene);
  const std::vector<Surd>&m = line.masses, &v = line.velocities;
  const Surd mass = std::accumulate(m.begin(), m.end(), Surd(0));
  const Surd momentum = std::inner_product(m.begin(), m.end(), v.begin(), Surd(0));
  result.terminal.assign(m.size(), m.size() == 2 ? Surd(0) : momentum / mass);  // 2: a wall
  set_energies(scene, line, result);
  if (scene.wants("events") || scene.wants("trajectory"))
    result.known_until = motion<Surd>(scene, told(scene)).known_until;
  const auto is_late = [&](const Value& time) {
    return result.known_until && time.to_double() > double_of(*result.known_until);
  };
  if (scene.wants("trajectory") && std::ranges::any_of(scene.times, is_late))
    throw Undecided(
        "no places near a collapse or after it in exact numbers; possible without --exact");
  result.plan.is_exact = true;
  return result;
}

/// What the paper's three bodies come to, or their mirror image, where no collision is asked for.
std::optional<Result> exactly_at_end(const Scene& scene, Result result) {
  const bool is_asked = scene.wants("events") || scene.wants("trajectory");
  if (is_asked || scene.masses.size() != 3 || result.status != Status::complete) return {};
  const auto line = line_of<Surd>(scene);
  const std::vector<Surd>&m = line.masses, &v = line.velocities;
  const std::size_t A = v[1] == v[2] ? 0 : 2, B = 2 - A;
  if (!(m[A] == m[B] && v[B] == v[1] && line.restitution == 1) || result.events < 2) return {};
  const Surd alpha = m[1] / m[A], V = v[A] - v[B];
  const std::int64_t N_A = (result.events + 1) / 2, N_B = result.events / 2;
  if (double(alpha.bits()) * double(N_A) > 0x1p20) return {};
  const auto end = generated::terminal_exact(alpha, N_A, N_B);
  result.terminal = {v[B] + V * end.a_t, v[B] + V * end.c_t, v[B] + V * end.b_t};
  if (A == 2) std::ranges::reverse(result.terminal);
  set_energies(scene, line, result);
  result.plan.is_exact = true;
  return result;
}

template <class Scalar>
void follow(const Scene& scene, const Result& result, const Points& sink) {
  simulator::Line<Scalar> line = line_of<Scalar>(scene);
  std::vector<Scalar> since(line.masses.size(), Scalar(0)), times;
  for (const Value& time : scene.times)  // no surd: where its double is
    times.push_back(time.exact() ? number_of<Scalar>(time) : Scalar(time.to_double()));
  std::sort(times.begin(), times.end());
  auto next = times.begin();
  const auto all_at = [&](const Scalar& time) {
    for (std::size_t i = 0; i < since.size(); ++i)
      sink({time, i, line.positions[i] + line.velocities[i] * (time - since[i])});
  };
  const bool has_corners = times.empty();
  Scalar last(0);
  if (has_corners) all_at(last);
  stream(scene, result.plan, [&](const Row& row) {
    last = std::get<Scalar>(row.time);
    for (; next != times.end() && *next < last; ++next) all_at(*next);
    const bool is_shown = has_corners && row.number % scene.every == 0;
    const auto meets = [&](std::size_t body, const Number& velocity) {
      since[body] = last;
      line.positions[body] = std::get<Scalar>(row.position);
      line.velocities[body] = std::get<Scalar>(velocity);
      if (is_shown) sink({row.time, body, row.position});
    };
    if (row.gap > 0) meets(row.gap - 1, row.v_left);
    if (row.gap < since.size()) meets(row.gap, row.v_right);
  });
  const auto end = result.known_until;
  for (; next != times.end() && !(end && std::get<Scalar>(*end) < *next); ++next) all_at(*next);
  if (has_corners) all_at(end ? std::get<Scalar>(*end) : last);
}

/// Without all collisions before them.
void follow_by_theorem(const Scene& scene, const Result& result, const Points& sink) {
  const auto show = [&](double time, const std::vector<double>& places) {
    for (std::size_t body = 0; body < places.size(); ++body) sink({time, body, places[body]});
  };
  const bool is_collapse = result.status == Status::collapse;
  const auto end = is_collapse ? std::nullopt : result.known_until;
  const auto most = is_collapse ? std::nullopt : std::optional(result.events);
  const auto show_at = [&](const Value& time) {
    show(time.to_double(), places_by_theorem(scene, most, time));
  };
  std::vector<Value> times = scene.times;
  std::ranges::stable_sort(times, {}, &Value::to_double);
  for (const Value& time : times) {
    if (end && time.to_double() > std::get<double>(*end)) return;
    show_at(time);
  }
  if (!times.empty()) return;
  const std::vector<double> first = line_of<double>(scene).positions;
  show(0, first);
  stream_by_theorem(scene, scene.every, [&](const Row& row) {
    for (const std::size_t body : {row.gap - 1, row.gap})
      if (body < first.size()) sink({row.time, body, row.position});
  });
  if (end) return show_at(value_of(std::get<double>(*end)));
  if (result.events == 0) return show(0, first);
  stream_by_theorem(scene, result.events, [&](const Row& row) {
    show(std::get<double>(row.time), places_by_theorem(scene, result.events));
  });
}

}  // namespace

std::optional<double> double_of(const Number& number) {
  const auto* value = std::get_if<double>(&number);
  if (value == nullptr) return std::get<Surd>(number).to_double();
  return *value == 0 || std::isnormal(*value) ? std::optional(*value) : std::nullopt;
}

std::string status_name(Status status) {
  return std::array{"complete", "limited", "collapse"}[static_cast<std::size_t>(status)];
}

Result run(const Scene& scene) {
  Scene timeless = scene;
  if (!scene.is_exact) timeless.times.clear();
  const bool has_exact = has_exact_numbers(timeless);
  const std::int64_t limit = scene.limit();
  if (scene.is_exact && !has_exact)
    throw InvalidInput(scene.source +
                       ": --exact: magic:k or deficient:k that no square roots give; "
                       "allowed: fractions and square roots");
  auto solved = by_theorem(scene);
  const auto because = [&](const std::string& in_doubles) {
    return (solved.why.empty() ? "" : solved.why + "; ") + in_doubles;
  };
  if (solved && !solved->plan.is_exact) {
    if (!scene.is_exact) return *solved;
    if (solved->status == Status::collapse) return exactly(scene, std::move(*solved));
    if (const auto end = exactly_at_end(scene, *solved)) return *end;
  }
  if (solved || scene.is_exact) try {
      Result result = motion<Surd>(scene, limit);
      result.plan = solved && solved->plan.is_exact
                        ? solved->plan
                        : Plan{"events", true, "exact numbers are asked for"};
      return result;
    } catch (const Undecided& error) {
      if (solved && !scene.is_exact) return *by_theorem(scene, -1);
      if (!solved || solved->plan.is_exact) throw;
      throw Undecided(std::to_string(solved->events) + " collisions by theorem, but " +
                      error.what() + ", or without --exact");
    }
  Result result;
  try {
    result = motion<double>(scene, limit);
  } catch (const Undecided& error) {
    throw Undecided(error.what() + std::string(has_exact ? "; --exact may do" : ""));
  }
  result.plan = {"events", false, because("no decision is closer than doubles can tell")};
  if (!result.is_undecided) return result;
  result.plan.reason = because(close + "; the scene has no exact numbers");
  if (!has_exact) return result;
  try {
    result = motion<Surd>(scene, limit, {}, some_work);
    result.plan = {"events", true, because(close + ", exact numbers decide")};
  } catch (const Undecided& error) {
    result.plan.reason = because(close + "; " + error.what());
  }
  return result;
}

void stream(const Scene& scene, const Plan& plan, const Sink& sink, std::int64_t every) {
  const bool is_stepped = plan.model == "events";
  if (!is_stepped && !plan.is_exact) return stream_by_theorem(scene, every, sink);
  const std::int64_t limit = !is_stepped && scene.is_exact ? told(scene) : scene.limit();
  const auto show = [&](const Row& row) {
    if (row.number % every == 0) sink(row);
  };
  (plan.is_exact ? motion<Surd> : motion<double>)(scene, limit, show, most_work);
}

void trajectory(const Scene& scene, const Result& result, const Points& sink) {
  if (result.plan.is_exact)
    follow<Surd>(scene, result, sink);
  else if (result.plan.model != "events" &&
           (result.status != Status::collapse || !scene.times.empty()))
    follow_by_theorem(scene, result, sink);
  else
    follow<double>(scene, result, sink);
}

}  // namespace magicmass::scenes
