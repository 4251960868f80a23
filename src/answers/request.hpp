// What is asked: words as they were typed, or as a row of CSV has them.
#pragma once

#include <optional>

#include "answers/table.hpp"

namespace answers {

/// A whole number in decimal digits, or nothing for another text.
std::optional<std::int64_t> read_whole(std::string_view digits);

struct Request {
  std::map<std::string, std::string> options;  ///< by name without dashes; a flag has the value ""
  std::vector<std::string> words;              ///< what no option takes
  std::string format = "text";

  bool has(const std::string& option) const { return options.count(option) != 0; }
  /// The option's value, "" where it was not given.
  std::string text(const std::string& option) const;
  /// From least to most, or nothing where it was not given. Throws InvalidInput for all else.
  std::optional<std::int64_t> whole(const std::string& option, std::int64_t least,
                                    std::int64_t most) const;
  /// The same of an option that was given; throws Undecided for a larger one.
  std::int64_t size(const std::string& option, std::int64_t least, std::int64_t most,
                    const std::string& of = "") const;
};

/// Requests that differ in some options: fields[row] has theirs, in the order of `columns`.
struct Rows {
  Request shared;
  std::vector<std::string> columns;
  std::vector<std::vector<std::string>> fields = {};

  Request request(std::size_t row) const;
};

/// A table, or a document that is printed as it is (a derivation, a figure).
struct Answer {
  Table table;
  std::string document = {};  ///< instead of the table where it is not empty
  bool check_failed = false;  ///< not proved, stale: exit code 1
  bool is_undecided = false;  ///< exit code 3, with what is known
  std::string note = {};      ///< for stderr, where the format has no place for it
  /// Instead of both: hands on what is printed, piece by piece; an empty one has it seen at once.
  std::function<void(const std::function<void(std::string_view)>&)> stream = {};
};

}  // namespace answers
