// What rows come from, and where an answer goes.
#pragma once

#include <cstdint>
#include <exception>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace command {

/// A header line names the columns. Fields may be quoted as in RFC 4180 (within their line) or have
/// blanks around them; lines end with LF or CRLF; a byte-order mark is skipped, and empty lines at
/// the end. Throws answers::InvalidInput, "FILE:LINE: what", for anything else.
class CsvReader {
public:
  /// Opens a file ("-": stdin) and reads its header; skips columns neither wanted, in capitals or
  /// not, nor nearly, nor, in small letters, refused, which says why.
  CsvReader(const std::string& path, const std::vector<std::string>& wanted,
            const std::map<std::string, std::string>& refused);

  /// The wanted columns that are there.
  const std::vector<std::string>& columns() const { return columns_; }
  /// Fields of the next rows, none empty: `most`, or fewer where the next waits(). False: no row.
  bool read(std::vector<std::vector<std::string>>& rows, std::size_t most);
  /// Whether the next line is still to be written by whoever writes into the pipe.
  bool waits() const;
  /// "FILE:LINE: " of the last row, or of one so many rows before.
  std::string position(std::size_t before = 0) const;

private:
  std::string source_;
  int file_;                                      // open till the program ends
  std::int64_t number_ = 0;                       // of the line
  std::string buffer_;                            // what was read
  std::size_t at_ = 0, end_ = std::string::npos;  // of the next line, if all of it is there
  bool has_zero_ = false;                         // somewhere
  std::string_view line_;
  std::vector<std::string> columns_;
  std::vector<std::size_t> places_;  // in a row; behind it where a column is not wanted
  std::string skipped_;              // a field that is not

  bool next_line();  // into line_
  bool next(std::vector<std::string>& row);
  /// How many fields there are; before there are columns, into a longer row.
  std::size_t split_line(std::vector<std::string>& row);
  [[noreturn]] void cannot_read() const;
  [[noreturn]] void refuse(const std::string& what) const;
};

/// The reader of stdout went away: nothing more to do, and not an error.
class ClosedPipe : public std::exception {};

/// Stdout, or a file that appears whole or not at all: it has no name until finish(), where the
/// file system allows that, and else one of its own. A symbolic link stays one, a file that is
/// replaced leaves its mode behind; devices, pipes and open descriptors (/dev/stdout) are written
/// directly. Throws answers::InvalidInput where the system refuses.
class Destination {
public:
  /// "" and "-" are stdout. Calls before_writing, once, before anything is seen on it.
  Destination(const std::string& path, std::function<void()> before_writing);
  Destination(const Destination&) = delete;
  Destination& operator=(const Destination&) = delete;
  ~Destination();

  /// Throws ClosedPipe, too.
  void write(std::string_view text);
  /// What was written goes on its way.
  void flush();
  /// Last call: what was written is there, under its name.
  void finish();

private:
  std::string shown_;   // for messages
  std::string target_;  // of an atomic file, behind links; else ""
  std::string name_;    // that the atomic file has for the time being; else ""
  int descriptor_;
  std::string buffer_;
  std::function<void()> before_writing_;

  [[noreturn]] void refuse(int error) const;
};

}  // namespace command
