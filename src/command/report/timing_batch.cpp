// SPDX-License-Identifier: GPL-2.0-or-later
#include "command/report/timing_batch.hpp"

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <stdexcept>

#include <fmt/format.h>

#include "command/report/further_contestants.hpp"
#include "command/report/subprocess.hpp"
#include "report/batches.hpp"

namespace magicmass::command {
namespace {

using report::TimeRow;

constexpr const char* nothing = "-";

/// The words that make another process ask for the same.
std::vector<std::string> words_of(const ReportRequest& request, std::size_t batch) {
  std::vector<std::string> words = {"/proc/self/exe", "report",
                                    "--timing-batch", std::to_string(batch),
                                    "--rounds",       std::to_string(request.timing_rounds())};
  if (request.quick) words.emplace_back("--quick");
  if (request.peers) words.emplace_back("--peers");
  if (!request.function.empty()) words.push_back("--function=" + request.function);
  if (request.size) words.push_back("--size=" + std::to_string(*request.size));
  const auto add = [&](const std::string& option, const std::vector<std::string>& names) {
    if (!names.empty()) words.push_back(fmt::format("{}={}", option, fmt::join(names, ",")));
  };
  add("--families", request.families);
  add("--evaluators", request.evaluators);
  add("--quantities", request.quantities);
  return words;
}

/// Says ten times a second how far it is, which also shows whether anybody still wants to know.
class Heartbeat {
public:
  explicit Heartbeat(std::ostream& out) : out_(out) {}

  bool go_on(double done) {
    const auto now = std::chrono::steady_clock::now();
    if (now - last_ > std::chrono::milliseconds(100)) {
      last_ = now;
      out_ << "done " << done << std::endl;
    }
    return out_.good();
  }

private:
  std::ostream& out_;
  std::chrono::steady_clock::time_point last_{};
};

}  // namespace

std::string line_of(const TimeRow& row) {
  return fmt::format(
      "row\t{}\t{}\t{}\t{}\t{:a}\t{:a}\t{:a}\t{:a}\t{:a}\t{:a}\t{}\t{}\t{}\t{}\t{:a}",
      row.contestant, row.precision, row.quantity, row.family, row.ns_median, row.ns_minimum,
      row.latency_ns, row.ratio, row.slowest_call_ns, row.slowest.alpha, row.slowest.index,
      row.cycles ? fmt::format("{:a}", *row.cycles) : nothing, row.inputs, row.rounds,
      row.slowest.e);
}

std::optional<TimeRow> row_from_line(const std::string& line) {
  std::vector<std::string> fields;
  for (std::size_t from = 0; from <= line.size();) {
    const std::size_t tab = std::min(line.find('\t', from), line.size());
    fields.push_back(line.substr(from, tab - from));
    from = tab + 1;
  }
  if (fields.size() != 16 || fields[0] != "row") return std::nullopt;
  const auto real = [&](std::size_t i) { return std::strtod(fields[i].c_str(), nullptr); };
  const auto whole = [&](std::size_t i) { return std::strtoll(fields[i].c_str(), nullptr, 10); };
  TimeRow row;
  row.contestant = fields[1];
  row.precision = fields[2];
  row.quantity = fields[3];
  row.family = fields[4];
  row.ns_median = real(5);
  row.ns_minimum = real(6);
  row.latency_ns = real(7);
  row.ratio = real(8);
  row.ratio_low = row.ratio_high = std::numeric_limits<double>::quiet_NaN();
  row.slowest_call_ns = real(9);
  row.slowest = {real(10), whole(11), real(15)};
  if (fields[12] != nothing) row.cycles = real(12);
  row.inputs = static_cast<std::size_t>(whole(13));
  row.rounds = static_cast<std::size_t>(whole(14));
  return row;
}

void run_timing_batch(const ReportRequest& request, std::size_t batch, std::istream& in,
                      std::ostream& out) {
  std::signal(SIGINT, SIG_IGN);  // Ctrl-C is the parent's: it stops reading
  std::string formulas;
  std::getline(in, formulas);
  std::vector<std::string> remarks;  // the parent has them, too
  const std::vector<Task> tasks =
      report_tasks(request, further_contestants(formulas == nothing ? std::vector<DerivedForm>()
                                                                    : forms_from_line(formulas),
                                                request, remarks));
  report::TimingPlan plan = timing_plan(request);
  plan.rounds.rounds = report::batch_plan(request.timing_rounds()).rounds;
  plan.rounds.seed += batch;
  Heartbeat heartbeat(out);
  for (std::size_t i = 0; i < tasks.size(); ++i) {
    plan.rounds.go_on = [&](double done) {
      return heartbeat.go_on((static_cast<double>(i) + done) / static_cast<double>(tasks.size()));
    };
    std::vector<report::Contestant> contestants = tasks[i].contestants;
    for (const report::Contestant& one : tasks[i].contestants)
      if (is_baseline(one)) {
        contestants.push_back(one);
        contestants.back().name = twin;
        contestants.back().is_naive = false;
      }
    for (const TimeRow& row : report::time_families(contestants, tasks[i].families, plan))
      out << line_of(row) << '\n';
  }
  out << "finished" << std::endl;
}

std::optional<std::vector<TimeRow>> timing_batch(const ReportRequest& request,
                                                 const BatchCall& call, Progress& progress) {
  Subprocess child(words_of(request, call.batch));
  std::vector<TimeRow> rows;
  double done = 0.0;
  std::string line = child.ask(call.formulas.empty() ? nothing : call.formulas);
  for (;; line = child.ask("")) {
    if (line.starts_with("done ")) done = std::strtod(line.c_str() + 5, nullptr);
    if (!progress.step(
            fmt::format("times: batch {} of {}", call.batch + 1, call.batches),
            (static_cast<double>(call.batch) + done) / static_cast<double>(call.batches)))
      return std::nullopt;
    if (line == "finished") return rows;
    if (line.empty()) throw std::runtime_error("a timing batch has ended unexpectedly");
    if (std::optional<TimeRow> row = row_from_line(line)) rows.push_back(std::move(*row));
  }
}

}  // namespace magicmass::command
