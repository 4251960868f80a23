#include "magicmass/scenes/run.hpp"
#include "magicmass/scenes/trio.hpp"

namespace magicmass::scenes {
namespace {
using Balls = std::function<std::vector<Ball>()>;

/// The even one of two doubles side by side, where low and high, by far closer, enclose the middle.
std::optional<double> tie(const cln::cl_RA& low, const cln::cl_RA& high) {
  const auto below = nearest_double(low, low), above = nearest_double(high, high);
  if (!below || !above || std::nextafter(*below, *above) != *above) return {};
  const cln::cl_RA x = exact(*below), y = exact(*above), middle = (x + y) / 2;
  if ((high - low) * cln::ash(cln::cl_I(1), 300) > y - x) return {};
  return nearest_double(middle, middle);
}
/// Nearest doubles, ties to even as far as many bits tell; nothing where one is not certain. What
/// is too large is infinite, what is too small is subnormal: nothing for double_of().
std::optional<std::vector<double>> rounded(const Balls& balls) try {
  using Limits = std::numeric_limits<double>;
  const cln::cl_RA largest = exact(Limits::max());
  std::vector<double> all;
  for (const Ball& ball : balls()) {
    const cln::cl_RA low = ball.low(), high = ball.high();
    auto number = nearest_double(low, high);
    if (!number && Ball::bits > 1500) number = tie(low, high);
    if (low > largest || high < -largest) number = Limits::infinity();
    if (!number) return {};
    if (*number == 0 && (low > 0 || high < 0)) number = Limits::denorm_min();
    all.push_back(*number);
  }
  return all;
} catch (const NotCertain&) {
  return {};
}
std::vector<double> certain(const Balls& balls) {
  return with_bits(
      17, [&] { return rounded(balls); }, " to round the numbers of the answer");
}
double time_of(const Trios& trios, std::int64_t j) {
  return certain([&] { return std::vector{trios.collision(j).time}; })[0];
}
/// Where no precision tells, as for places at that very time, it is `either`, if that is given.
bool is_by(const Trios& trios, std::int64_t j, const Value& time, std::optional<bool> either = {}) {
  const auto exactly = [&](bool is_hard) -> std::optional<bool> {
    const auto at = trios.exact_time(j, is_hard);
    return at && time.exact() ? std::optional(!(*time.exact() < *at)) : std::nullopt;
  };
  auto is_early = exactly(j < 16);
  if (!is_early) try {
      is_early = trios.collision(j).time <= ball_of(time);
    } catch (const NotCertain&) {
      if (Ball::bits > 1500) is_early = either ? either : exactly(true);
      if (!is_early) throw;
    }
  return *is_early;
}
std::int64_t count_by(const Trios& trios, const Value& time, std::int64_t most) {
  return count_of(most, [&](std::int64_t j) { return is_by(trios, j, time); });
}
/// How many collisions are within the scene's limits; nothing: infinitely many, a collapse.
std::optional<std::int64_t> within(const Trios& trios, const Scene& scene) {
  auto N = trios.count();
  const bool collapses = !N && !trios.is_endless();
  if (scene.max_events || (!N && !collapses)) N = std::min(N.value_or(INT64_MAX), scene.limit());
  if (!scene.until) return N;
  const auto is_over = [&] { return trios.alone()->has_collapsed(*scene.until); };
  if (collapses && with_bits(17, is_over)) return N;
  const auto counted = [&] { return count_by(trios, *scene.until, N.value_or(scene.limit())); };
  const std::string until = scene.until->text;
  return with_bits(17, counted, " to tell whether a collision comes by the time " + until);
}
/// All but the plan after so many collisions, or after infinitely many.
Result after(const Scene& scene, const Trios& trios, std::optional<std::int64_t> collisions) {
  Result result;
  result.events = collisions.value_or(0);
  result.counts = trios.counts(result.events);
  const std::size_t bodies = trios.bodies(), last = trios.last();
  const std::vector<double> numbers = certain([&] {
    const Trio::Collision end = collisions ? Trio::Collision() : trios.collapse();
    const auto v = collisions ? trios.velocities(*collisions) : std::vector(bodies, end.v_left);
    std::vector<Ball> masses;
    std::map<std::string, Ball> known;  // a cradle has many of one ratio
    for (const Value& mass : scene.masses) {
      const auto [at, is_new] = known.try_emplace(mass.text);
      masses.push_back(is_new ? at->second = ball_of(mass) : at->second);
    }
    const Ball before = energy(masses, trios.velocities(0));
    std::vector<Ball> all{before, energy(masses, v),
                          energy<Ball>({masses[last]}, {v[last]}) / before, end.time, end.position};
    all.insert(all.end(), v.begin(), v.end());
    return all;
  });
  result.energy_before = numbers[0];
  result.energy = numbers[1];
  result.transmitted = numbers[2];
  result.terminal.assign(numbers.begin() + 5, numbers.end());
  if (collisions) return result;
  result.status = Status::collapse;
  result.collapse_time = result.known_until = numbers[3];
  result.collapse_position = numbers[4];
  return result;
}

}  // namespace

std::string at_limit(std::int64_t limit) {
  return "stopped after " + std::to_string(limit) + (limit == 1 ? " collision" : " collisions") +
         "; more with --max-events";
}

Found<Result> by_theorem(const Scene& scene, std::int64_t few) {
  const auto trios = Trios::of(scene);
  if (!trios) return trios.why;
  const bool is_open = trios->is_endless() || scene.until || scene.max_events;
  try {
    const auto events = within(*trios, scene);
    const bool is_few = events && *events <= few && has_exact_numbers(scene);
    Result result = is_few ? Result() : after(scene, *trios, events);
    result.plan = {trios->alone() ? "theorem" : "transfers", is_few,
                   !trios->alone()
                       ? "a cradle: each ball of a magic ratio hands on all to the next block"
                   : trios->bodies() == 3 ? "a ball between two blocks"
                                          : "a ball between a block and a wall"};
    if (is_few) {
      result.plan.reason += "; so few collisions are stepped exactly";
    } else if (!events) {
      result.why =
          "infinitely many collisions; a list has the first three, and more while doubles can tell "
          "their times apart";
    } else if (is_open && events != trios->count()) {
      const auto is_over = [&] { return scene.until && !is_by(*trios, *events, *scene.until); };
      const bool is_limit = events == scene.limit() && !with_bits(17, is_over);
      result.status = Status::limited;
      result.why = is_limit ? at_limit(*events) : at_until;
      result.known_until = is_limit ? time_of(*trios, *events) : scene.until->to_double();
    }
    return result;
  } catch (const Undecided& error) {
    if (!is_open) throw;
    return error.what();
  }
}

void stream_by_theorem(const Scene& scene, std::int64_t every, const Sink& sink) {
  const Trios trios = *Trios::of(scene);
  const auto collisions = within(trios, scene);
  const std::int64_t end = collisions.value_or(INT64_MAX);
  // Just where collisions begin to end, doubles tell some 10^8 of a collapse apart.
  for (std::int64_t j = 4; !collisions && time_of(trios, j - 1) != time_of(trios, j); j *= 2)
    if (j / every >= 1 << 16)
      throw Undecided(
          "a collapse of more than 65536 rows; possible: --max-events N, until, a larger every");
  double before = -1;
  for (std::int64_t j = every - 1; j < end; j += std::min(every, end - j)) {
    std::size_t gap = 0;
    const std::vector<double> n = certain([&] {
      const Trio::Collision c = trios.collision(j);
      gap = c.gap;
      return std::vector{c.time, c.position, c.v_left, c.v_right};
    });
    if (!collisions && j >= 3) {
      if (every > 1) before = time_of(trios, j - 1);
      if (n[0] == before) return;
    }
    before = n[0];
    sink({j + 1, gap, n[0], n[1], n[2], n[3]});
  }
}

std::vector<double> places_by_theorem(const Scene& scene, std::optional<std::int64_t> most,
                                      const std::optional<Value>& time) {
  const Trios trios = *Trios::of(scene);
  if (!time) return certain([&] { return trios.places(trios.collision(*most - 1).time, *most); });
  const auto told = [&]() -> std::optional<std::vector<double>> {
    const Ball at = ball_of(*time);
    if (!most) {
      const Trio::Collision end = trios.collapse();
      const Ball since = at - end.time;
      const bool is_tie = since.low() <= 0 && 0 <= since.high() && Ball::bits > 1500;
      if (is_tie || since >= 0)
        return rounded(
            [&] { return std::vector(trios.bodies(), end.position + end.v_left * since); });
    }
    const std::int64_t N = count_of(most.value_or(INT64_MAX / 4),
                                    [&](auto j) { return is_by(trios, j, *time, true); });
    return rounded([&] { return trios.places(at, N); });
  };
  return with_bits(17, told, " to tell where bodies are at the time " + time->text);
}

}  // namespace magicmass::scenes
