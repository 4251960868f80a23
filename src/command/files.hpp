// Commands that write files or start programs, so that they are no pure answers.
#pragma once

#include "answers/request.hpp"
#include "generate/quantities.hpp"

namespace command {

/// All files or none; a folder that was not there goes again where there is none. Throws
/// InvalidInput, after `option` ("generate: --out"), where the system refuses; says how many.
answers::Answer write_folder(const std::string& option, const std::string& folder,
                             const std::function<generate::Texts()>& texts);

/// Writes what the theorems give to a folder, all of it or nothing; with "check" compares instead,
/// and a difference is a failed check. With "quantity" or "scene" one header.
answers::Answer generate_files(const answers::Request& request);
/// answers::derive, and format coq: a folder of files, written to --output. Throws InvalidInput
/// where a folder is missing or chapters are chosen.
answers::Answer derive(const answers::Request& request);
/// answers::verify; with coq: coqc checks each step, too. Throws InvalidInput where there is none.
answers::Answer verify(const answers::Request& request);
/// One of the paper or of the report by its name, in svg, png, pdf or csv: the same bytes from
/// every run, PDF but for the date where cairo compresses it. With list: all names.
answers::Answer figure(const answers::Request& request);
/// Every number of the paper beside ours. With out: its figures and the tables in a folder, too.
answers::Answer reproduce(const answers::Request& request);

/// The rows of paper_numbers.csv, each with our answer to its question, the verdict (agrees:
/// decimals to the digits printed, all else exactly; explained: for a reason that holds; differs)
/// and what is said of it. Throws std::runtime_error, naming the row, for one that has no meaning.
answers::Table comparisons(std::string_view paper_numbers);

/// In text and markdown a table for each label. The check has failed where a number differs.
answers::Answer page_of(const answers::Table& comparisons, const std::string& format);

}  // namespace command
