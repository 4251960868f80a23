// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <vector>

namespace magicmass::command {

struct CsvRow {
  unsigned line;  ///< from 1, the header's
  std::vector<std::string> fields;
};

struct CsvTable {
  std::string source;  ///< the file's name, fit to be shown
  std::string header;  ///< one of those allowed
  std::vector<CsvRow> rows;
};

/// Reads CSV whose first line must be one of `headers` ("alpha,n"). Fields may be quoted or have blanks around them;
/// lines end with LF or CRLF; empty lines may follow the last row; a byte-order mark is skipped. `source` is for
/// messages. Throws InvalidInput: source, line, column and what is allowed.
CsvTable parse_csv(const std::string& text, const std::string& source,
                   const std::vector<std::string>& headers);

/// The same from a file, or from stdin for "-".
CsvTable read_csv(const std::string& path, const std::vector<std::string>& headers);

}  // namespace magicmass::command
