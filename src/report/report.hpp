// Speed against error, as an answer; METHOD.md says how it is measured.
#pragma once

#include "answers/commands.hpp"
#include "report/measure.hpp"

namespace report {

/// The worst family of each evaluator, then each family: tables of 80 columns, or Markdown.
std::string document_of(const std::vector<Measurement>& measurements, bool is_markdown);

/// --quick, --only NAME; formats text, markdown, json, csv.
answers::Answer report(const answers::Request& request);

/// speed and error.
const std::vector<answers::Figure>& figures();

}  // namespace report
