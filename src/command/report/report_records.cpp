// SPDX-License-Identifier: GPL-2.0-or-later
#include <cmath>
#include <map>
#include <string>

#include <fmt/format.h>

#include "command/records.hpp"
#include "command/report/report_tables.hpp"

namespace magicmass::command {
namespace {

const std::vector<std::string>& columns() {
  static const std::vector<std::string> names = {"evaluator",
                                                 "family",
                                                 "quantity",
                                                 "precision",
                                                 "member",
                                                 "samples",
                                                 "climbed",
                                                 "max_ulp",
                                                 "worst_alpha",
                                                 "worst_index",
                                                 "worst_e",
                                                 "ulp_999",
                                                 "ulp_median",
                                                 "correctly_rounded",
                                                 "wrong_signs",
                                                 "over_envelope",
                                                 "max_eps",
                                                 "wrong",
                                                 "promise_kept",
                                                 "reproducible",
                                                 "ns",
                                                 "ns_minimum",
                                                 "latency_ns",
                                                 "slowest_call_ns",
                                                 "slowest_alpha",
                                                 "slowest_index",
                                                 "slowest_e",
                                                 "cycles",
                                                 "ratio",
                                                 "ratio_low",
                                                 "ratio_high",
                                                 "steady",
                                                 "inputs",
                                                 "rounds",
                                                 "batches",
                                                 "scale",
                                                 "x",
                                                 "time_exponent",
                                                 "time_exponent_spread",
                                                 "error_exponent",
                                                 "error_exponent_spread",
                                                 "target",
                                                 "must",
                                                 "aim",
                                                 "seen",
                                                 "seen_low",
                                                 "seen_high",
                                                 "unit",
                                                 "where",
                                                 "verdict",
                                                 "version",
                                                 "machine",
                                                 "compiler",
                                                 "flags",
                                                 "libraries"};
  return names;
}

/// An error may be infinite, which is not the same as not measured; JSON has no number for it.
Cell error_cell(double value) { return std::isinf(value) ? text_cell("inf") : number_cell(value); }

Cell whole_cell(std::size_t value) { return number_cell(static_cast<std::int64_t>(value)); }
Cell truth_cell(bool value) { return digits_cell(value ? "true" : "false"); }

void set_input(Record& record, const std::string& name, const report::Input& input) {
  record[name + "_alpha"] = text_cell(fmt::format("{:a}", input.alpha));
  record[name + "_index"] = number_cell(input.index);
  record[name + "_e"] = text_cell(fmt::format("{:a}", input.e));
}

void set_error(Record& record, const report::ErrorRow& error) {
  record["member"] = text_cell(error.member);
  record["samples"] = whole_cell(error.samples);
  record["climbed"] = whole_cell(error.climbed);
  record["max_ulp"] = error_cell(error.max_ulp);
  set_input(record, "worst", error.worst);
  record["ulp_999"] = error_cell(error.ulp_999);
  record["ulp_median"] = error_cell(error.ulp_median);
  record["correctly_rounded"] = number_cell(error.correctly_rounded);
  record["wrong_signs"] = whole_cell(error.wrong_signs);
  record["over_envelope"] = error_cell(error.over_envelope);
  record["max_eps"] = error_cell(error.max_eps);
  record["wrong"] = whole_cell(error.wrong);
  record["promise_kept"] = truth_cell(error.promise_kept);
}

void set_time(Record& record, const report::TimeRow& time) {
  record["ns"] = number_cell(time.ns_median);
  record["ns_minimum"] = number_cell(time.ns_minimum);
  record["latency_ns"] = number_cell(time.latency_ns);
  record["slowest_call_ns"] = number_cell(time.slowest_call_ns);
  set_input(record, "slowest", time.slowest);
  if (time.cycles) record["cycles"] = number_cell(*time.cycles);
  record["ratio"] = number_cell(time.ratio);
  record["ratio_low"] = number_cell(time.ratio_low);
  record["ratio_high"] = number_cell(time.ratio_high);
  if (!std::isnan(time.ratio_low)) record["steady"] = truth_cell(time.is_steady);
  record["inputs"] = whole_cell(time.inputs);
  record["rounds"] = whole_cell(time.rounds);
  record["batches"] = whole_cell(time.batches);
}

void set_law(Record& record, const std::string& name, const std::optional<report::PowerLaw>& law) {
  if (!law) return;
  record[name] = number_cell(law->exponent);
  record[name + "_spread"] = number_cell(law->spread);
}

/// What every record begins with.
Record record_of(const Measurement& measurement, const std::string& evaluator,
                 const std::string& precision, const std::string& quantity,
                 const std::string& family, bool is_reproducible) {
  Record record;
  for (const auto& [name, value] : measurement.provenance) record[name] = text_cell(value);
  record["evaluator"] = text_cell(evaluator);
  record["precision"] = text_cell(precision);
  record["quantity"] = text_cell(quantity);
  record["family"] = text_cell(family);
  record["reproducible"] = truth_cell(is_reproducible);
  return record;
}

}  // namespace

std::vector<Record> report_records(const Measurement& measurement) {
  std::vector<Record> records;
  for (const MeasuredFamily& one : measurement.families)
    for (const Entry& entry : one.entries) {
      Record record = record_of(measurement, entry.evaluator, entry.precision, one.family.quantity,
                                one.family.name, entry.is_reproducible);
      if (entry.time) set_time(record, *entry.time);
      if (entry.errors.empty()) records.push_back(record);
      for (const report::ErrorRow& error : entry.errors) {
        set_error(record, error);
        records.push_back(record);
      }
    }
  for (Record& record : targets_records(measurement.targets)) {
    for (const auto& [name, value] : measurement.provenance) record[name] = text_cell(value);
    records.push_back(std::move(record));
  }
  for (const report::Growth& growth : measurement.growths) {
    Record record = record_of(measurement, growth.contestant, growth.precision, growth.quantity,
                              "against " + growth.words, growth.is_reproducible);
    record["scale"] = text_cell(growth.scale);
    set_law(record, "time_exponent", growth.time);
    set_law(record, "error_exponent", growth.error);
    for (const report::GrowthPoint& point : growth.points) {
      record["x"] = number_cell(point.x);
      record["ns"] = number_cell(point.ns);
      record["max_ulp"] = error_cell(point.max_ulp);
      record["over_envelope"] = error_cell(point.over_envelope);
      records.push_back(record);
    }
  }
  return records;
}

void write_report_records(Destination& output, const std::string& format,
                          const Measurement& measurement) {
  RecordWriter writer(output, format, columns(), false);
  for (const Record& record : report_records(measurement)) {
    std::vector<Cell> cells;
    for (const std::string& name : columns()) {
      const auto found = record.find(name);
      cells.push_back(found == record.end() ? missing_cell() : found->second);
    }
    writer.write(cells);
  }
  writer.finish();
}

}  // namespace magicmass::command
