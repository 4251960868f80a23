// Reading by bytes: what a file holds decides, not its locale.
#include <algorithm>
#include <cctype>
#include <cerrno>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

#include "answers/table.hpp"
#include "command/streams.hpp"
#include "magicmass/scenes/scene.hpp"

namespace command {
namespace {

using namespace answers;

constexpr std::size_t longest_line = std::size_t{1} << 16U;

bool is_blank(char c) { return c == ' ' || c == '\t'; }

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  return text;
}

}  // namespace

CsvReader::CsvReader(const std::string& path, const std::vector<std::string>& wanted,
                     const std::map<std::string, std::string>& refused)
    : source_(path == "-" ? "stdin" : shown_text(path, 200)),
      file_(path == "-" ? STDIN_FILENO : ::open(path.c_str(), O_RDONLY | O_CLOEXEC)) {
  if (file_ < 0) cannot_read();
  const std::string allowed = joined(wanted);
  next_line();
  if (line_.starts_with("\xEF\xBB\xBF")) line_.remove_prefix(3);
  std::vector<std::string> names;
  split_line(names);
  std::vector<std::string> absent = wanted;
  std::erase_if(absent, [&](const auto& name) { return std::ranges::count(names, name) != 0; });
  for (const std::string& name : names) {
    std::string small = name;
    for (char& c : small) c = char(std::tolower(static_cast<unsigned char>(c)));
    const std::string nearly = names.size() > 1 ? magicmass::scenes::meant(small, absent) : "";
    const bool is_wanted = std::count(wanted.begin(), wanted.end(), name) != 0;
    if (!is_wanted && (refused.contains(small) || !nearly.empty()))
      refuse(shown_text(name) + (refused.contains(small) ? refused.at(small) : nearly) +
             "; options that may be columns: " + allowed);
    if (std::count(columns_.begin(), columns_.end(), name) != 0)
      refuse(name + ": a column of that name was there before");
    places_.push_back(is_wanted ? columns_.size() : names.size());
    if (is_wanted) columns_.push_back(name);
  }
  if (columns_.empty())
    refuse("the first line must name a column, got " + shown_text(line_) + "; allowed: " + allowed);
}

void CsvReader::cannot_read() const {
  throw InvalidInput("cannot read " + source_ + ": " + std::generic_category().message(errno));
}

void CsvReader::refuse(const std::string& what) const { throw InvalidInput(position() + what); }

std::string CsvReader::position(std::size_t before) const {
  return source_ + ":" + std::to_string(number_ - static_cast<std::int64_t>(before)) + ": ";
}

bool CsvReader::next_line() {
  ++number_;
  std::size_t end = end_;
  while (end == std::string::npos && buffer_.size() - at_ <= longest_line + 1) {
    buffer_.erase(0, std::exchange(at_, 0));
    const std::size_t had = buffer_.size();
    buffer_.resize(had + longest_line);
    const ssize_t size = ::read(file_, buffer_.data() + had, longest_line);
    buffer_.resize(had + static_cast<std::size_t>(std::max<ssize_t>(size, 0)));
    has_zero_ = has_zero_ || buffer_.find('\0', had) != std::string::npos;
    if (size < 0 && errno == EINTR) continue;
    if (size < 0 && errno == EAGAIN) {  // a pipe that its other users made non-blocking
      pollfd empty{file_, POLLIN, 0};
      ::poll(&empty, 1, -1);
      continue;
    }
    if (size < 0) cannot_read();
    if (size == 0) break;
    end = buffer_.find('\n', had);
  }
  line_ = std::string_view(buffer_).substr(at_, end - at_);
  const bool is_there = end != std::string::npos || !line_.empty();
  at_ += line_.size() + (end == std::string::npos ? 0 : 1);
  end_ = buffer_.find('\n', at_);
  if (has_zero_ && line_.substr(0, longest_line + 1).find('\0') != line_.npos)
    refuse("a zero byte; allowed: text");
  if (line_.size() > longest_line)
    refuse("a line of more than " + std::to_string(longest_line) + " bytes");
  if (line_.ends_with('\r')) line_.remove_suffix(1);
  return is_there;
}

std::size_t CsvReader::split_line(std::vector<std::string>& row) {
  const auto after_blanks = [this](std::size_t at) {
    while (at < line_.size() && is_blank(line_[at])) ++at;
    return at;
  };
  for (std::size_t at = 0, size = 0;; ++at) {
    const std::size_t place = size++ < places_.size() ? places_[size - 1] : row.size();
    std::string& field = columns_.empty()     ? row.emplace_back()
                         : place < row.size() ? row[place]
                                              : skipped_;
    const std::size_t first = after_blanks(at);
    if (first == line_.size() || line_[first] != '"') {
      const std::size_t end = std::min(line_.find(',', at), line_.size());
      field = trimmed(line_.substr(at, end - at));
      at = end;
    } else {
      field.clear();
      for (at = first + 1; at < line_.size(); ++at) {
        if (line_[at] == '"' && line_.substr(at, 2) != "\"\"") break;
        at += line_[at] == '"' ? 1 : 0;
        field += line_[at];
      }
      if (at >= line_.size()) refuse("a quoted field has no closing quote in its line");
      at = after_blanks(at + 1);
      if (at < line_.size() && line_[at] != ',')
        refuse("something follows a quoted field; allowed: a comma or the line's end");
    }
    if (at >= line_.size()) return size;
  }
}

bool CsvReader::next(std::vector<std::string>& row) {
  bool is_there = next_line();
  const std::int64_t first = number_;
  const bool is_empty = trimmed(line_).empty();
  while (is_there && is_empty && trimmed(line_).empty()) is_there = next_line();
  number_ = is_there ? first : first - 1;
  if (!is_there) return false;
  if (is_empty) refuse("an empty line; allowed: at the end");
  row.resize(columns_.size());
  if (const std::size_t size = split_line(row); size != places_.size())
    refuse("fields: got " + std::to_string(size) +
           "; allowed: as many as the header names: " + std::to_string(places_.size()));
  for (std::size_t i = 0; i < row.size(); ++i)
    if (row[i].empty()) refuse(columns_[i] + ": empty; allowed: a value in every field");
  return true;
}

bool CsvReader::waits() const {
  if (end_ != std::string::npos) return false;
  pollfd input{file_, POLLIN, 0};
  return ::poll(&input, 1, 0) == 0;
}

bool CsvReader::read(std::vector<std::vector<std::string>>& rows, std::size_t most) {
  rows.resize(most);
  std::size_t size = 0;
  while (size < most && (size == 0 || !waits()) && next(rows[size])) ++size;
  rows.resize(size);
  return size != 0;
}

}  // namespace command
