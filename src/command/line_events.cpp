// SPDX-License-Identifier: GPL-2.0-or-later
#include "command/line_events.hpp"

#include <algorithm>
#include <utility>

#include "magicmass/reference/exact_work.hpp"
#include "magicmass/reference/rational.hpp"
#include "magicmass/simulator/stalled_clock.hpp"

namespace magicmass::command {
namespace {

using cln::cl_RA;
using reference::FieldNumber;

Cell cell(double value, bool /*fractions*/) { return number_cell(value); }
Cell cell(long double value, bool /*fractions*/) { return number_cell(value); }
/// As p/q where that was asked for; else, and where it is irrational, the nearest double: decisions were exact.
Cell cell(const cl_RA& value, bool fractions) {
  return fractions ? text_cell(reference::to_text(value))
                   : number_cell(reference::nearest<double>(value));
}
Cell cell(const FieldNumber& value, bool fractions) {
  if (value.is_rational()) return cell(value.rational(), fractions);
  return number_cell(reference::nearest_double(value));
}

template <class Scalar>
Scalar number(const FieldNumber& x) {
  if constexpr (std::floating_point<Scalar>) {
    return reference::nearest<Scalar>(x);
  } else if constexpr (std::same_as<Scalar, cl_RA>) {
    return x.rational();
  } else {
    return x;
  }
}

template <class Scalar>
class Stepping {
public:
  Stepping(const Scene& scene, const reference::ExactLine& line, Line<Scalar> start,
           std::int64_t limit, const LineListener& listener, LineResult& result)
      : scene_(scene),
        limit_(limit),
        degree_(line.common.field ? line.common.field->degree() : 1),
        listener_(listener),
        result_(result),
        audit_(start),
        motion_(std::move(start)),
        lists_points_(wants(scene, Output::trajectory) && scene.times.empty()) {
    for (const FieldNumber& time : line.times) times_.push_back(number<Scalar>(time));
    std::sort(times_.begin(), times_.end(), [](const auto& x, const auto& y) { return x < y; });
    if (line.until) until_ = number<Scalar>(*line.until);
  }

  void run() {
    if (lists_points_) all_at(Scalar(0));
    StalledClock<Scalar> clock;
    reference::ExactWork work(degree_, reference::most_exact_work);
    const bool inelastic = motion_.restitution() < Scalar(1);
    for (auto next = motion_.next(); next; next = motion_.next()) {
      if (until_ && !motion_.is_due_by(*until_)) {
        stop("limited", "the scene's time is over");
        break;
      }
      if (motion_.events() >= limit_) {
        stop("limited", "as many events as the limit allows");
        break;
      }
      times_before(*next);
      const LineEvent<Scalar> event = motion_.step();
      take(event);
      if (inelastic && clock.look(motion_.events(), motion_.now())) {
        stop("collapse", "1000 collisions within 2^-40 of the time so far");
        result_.collapse = {cell(motion_.now()), missing_cell()};
        break;
      }
      if (work.is_too_much(event)) {
        stop("limited", "the exact numbers have become too long");
        break;
      }
    }
    if (result_.status == "complete") say_what_was_lost();
    finish();
  }

private:
  const Scene& scene_;
  std::int64_t limit_;
  std::size_t degree_;  // of the field that numbers are in
  const LineListener& listener_;
  LineResult& result_;
  LineAudit<Scalar> audit_;
  LineMotion<Scalar> motion_;
  bool lists_points_;
  std::vector<Scalar> times_;
  std::size_t next_time_ = 0;
  std::optional<Scalar> until_;
  std::int64_t with_A_ = 0;  // contacts of the first two bodies

  Cell cell(const Scalar& value) const { return command::cell(value, result_.fractions); }

  void stop(const char* status, const char* why) {
    result_.status = status;
    result_.why = why;
  }

  /// No contact is due; but is that so in truth?
  void say_what_was_lost() {
    const Losses lost = motion_.losses();
    if (lost.time)
      stop("limited", "two bodies approach so slowly that when they meet does not fit the numbers");
    else if (lost.rebound)
      stop("limited", "two bodies parted more slowly than the numbers can tell");
  }

  void all_at(const Scalar& time) {
    for (std::size_t i = 0; i < motion_.bodies(); ++i)
      listener_.on_point({cell(time), name(i), cell(motion_.position(i, time))});
  }

  Cell name(std::size_t body) const { return text_cell(body_name(scene_, body)); }

  void times_before(const Scalar& next) {
    for (; next_time_ < times_.size() && !(next < times_[next_time_]); ++next_time_)
      all_at(times_[next_time_]);
  }

  void take(const LineEvent<Scalar>& event) {
    audit_.look(motion_, event);
    if (event.gap == 1) ++with_A_;
    if (event.number % scene_.every != 0) return;
    const bool wall_left = event.gap == 0, wall_right = event.gap == motion_.bodies();
    if (wants(scene_, Output::events))
      listener_.on_event({number_cell(event.number),
                          wall_left ? text_cell("wall") : name(event.gap - 1),
                          wall_right ? text_cell("wall") : name(event.gap), cell(event.time),
                          cell(event.position), cell(event.v_left), cell(event.v_right)});
    if (!lists_points_) return;
    if (!wall_left)
      listener_.on_point({cell(event.time), name(event.gap - 1), cell(event.position)});
    if (!wall_right) listener_.on_point({cell(event.time), name(event.gap), cell(event.position)});
  }

  void finish() {
    const bool over = result_.status == "complete";
    if (over || until_)
      for (; next_time_ < times_.size() && (!until_ || over || !(*until_ < times_[next_time_]));
           ++next_time_)
        all_at(times_[next_time_]);
    if (lists_points_) all_at(until_ && !over ? *until_ : motion_.now());
    audit_.look(motion_.line());
    result_.stepped = motion_.events();
    result_.contacts =
        result_.status == "collapse" ? missing_cell() : number_cell(motion_.events());
    if (scene_.kind != Kind::chain && result_.status != "collapse")
      result_.counts = {number_cell(with_A_), number_cell(motion_.events() - with_A_)};
    result_.near_ties = motion_.ties().near;
    result_.simultaneous = motion_.ties().simultaneous;
    for (std::size_t i = 0; i < std::min(motion_.bodies(), most_velocities); ++i)
      result_.velocities.push_back(cell(motion_.body(i).velocity));
    if (wants(scene_, Output::energy))
      result_.drift = {cell(audit_.largest().energy), cell(audit_.largest().momentum)};
  }
};

}  // namespace

template <Field Scalar>
void step_line(const Scene& scene, const reference::ExactLine& line, Line<Scalar> start,
               std::int64_t limit, const LineListener& listener, LineResult& result) {
  Stepping<Scalar>(scene, line, std::move(start), limit, listener, result).run();
}

template void step_line(const Scene&, const reference::ExactLine&, Line<double>, std::int64_t,
                        const LineListener&, LineResult&);
template void step_line(const Scene&, const reference::ExactLine&, Line<long double>, std::int64_t,
                        const LineListener&, LineResult&);
template void step_line(const Scene&, const reference::ExactLine&, Line<cl_RA>, std::int64_t,
                        const LineListener&, LineResult&);
template void step_line(const Scene&, const reference::ExactLine&, Line<FieldNumber>, std::int64_t,
                        const LineListener&, LineResult&);

template <class Float>
std::vector<Cell> drift_of(const Line<Float>& start, std::vector<Float> velocities) {
  LineAudit<Float> audit(start);
  Line<Float> last = start;
  last.velocities = std::move(velocities);
  audit.look(last);
  const bool walled = start.left_wall || start.right_wall;
  return {number_cell(audit.largest().energy),
          walled ? missing_cell() : number_cell(audit.largest().momentum)};
}
template std::vector<Cell> drift_of(const Line<double>&, std::vector<double>);
template std::vector<Cell> drift_of(const Line<long double>&, std::vector<long double>);

}  // namespace magicmass::command
