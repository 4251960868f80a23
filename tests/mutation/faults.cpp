// SPDX-License-Identifier: GPL-2.0-or-later
// Small faults that could be in C++ source: one token changed. Which come first is decided by a seed and by the lines
// themselves, so that a fault stays the same while other files change.
//   faults list SEED FILE ...                    a line each: file, line, column, before, after, parted by tabs
//   faults plant FILE LINE COLUMN BEFORE AFTER   writes the file with that one change
#include <algorithm>
#include <array>
#include <cctype>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <map>
#include <string>
#include <vector>

namespace {

constexpr int most_in_a_file = 4;

struct Fault {
  std::string file;
  std::size_t line, column;  // from 1
  std::string before, after;
  std::uint64_t rank;
};

bool is_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

/// FNV-1a.
std::uint64_t hash(std::uint64_t seed, const std::string& text) {
  std::uint64_t value = 14695981039346656037ULL ^ (seed * 0x9e3779b97f4a7c15ULL);
  for (const char c : text) value = (value ^ static_cast<unsigned char>(c)) * 1099511628211ULL;
  value ^= value >> 32U;
  value *= 0xd6e8feb86659fd93ULL;
  return value ^ (value >> 32U);
}

/// The line with everything that is no code as blanks: comments, texts, characters.
class CodeOnly {
public:
  std::string operator()(const std::string& line) {
    std::string code(line.size(), ' ');
    for (std::size_t i = 0; i < line.size(); ++i) {
      if (in_comment_) {
        if (line.compare(i, 2, "*/") == 0) in_comment_ = false, ++i;
      } else if (in_raw_) {
        if (const std::size_t end = line.find(raw_end_, i); end == std::string::npos)
          break;
        else
          i = end + raw_end_.size() - 1, in_raw_ = false;
      } else if (line.compare(i, 2, "//") == 0) {
        break;
      } else if (line.compare(i, 2, "/*") == 0) {
        in_comment_ = true;
      } else if (line.compare(i, 2, "R\"") == 0) {
        const std::size_t open = line.find('(', i);
        raw_end_ = ")" + line.substr(i + 2, open - i - 2) + "\"";
        in_raw_ = true;
        i = open;
      } else if (line[i] == '"' || (line[i] == '\'' && (i == 0 || !is_word(line[i - 1])))) {
        const char quote = line[i];
        for (++i; i < line.size() && line[i] != quote; ++i)
          if (line[i] == '\\') ++i;
      } else {
        code[i] = line[i];
      }
    }
    return code;
  }

private:
  bool in_comment_ = false, in_raw_ = false;
  std::string raw_end_;
};

constexpr std::array<std::array<const char*, 2>, 17> exchanges{{{" + ", " - "},
                                                                {" - ", " + "},
                                                                {" * ", " / "},
                                                                {" / ", " * "},
                                                                {" < ", " <= "},
                                                                {" <= ", " < "},
                                                                {" > ", " >= "},
                                                                {" >= ", " > "},
                                                                {" == ", " != "},
                                                                {" != ", " == "},
                                                                {" && ", " || "},
                                                                {" || ", " && "},
                                                                {"true", "false"},
                                                                {"false", "true"},
                                                                {"std::min(", "std::max("},
                                                                {"std::max(", "std::min("},
                                                                {" += ", " -= "}}};

bool declares(const std::string& code) {
  const std::size_t first = code.find_first_not_of(' ');
  if (first == std::string::npos || code[first] == '#') return true;
  for (const char* word :
       {"template", "using ", "namespace", "static_assert", "friend ", "requires"})
    if (code.compare(first, std::string(word).size(), word) == 0) return true;
  return code.find("operator") != std::string::npos ||
         code.find("= default") != std::string::npos || code.find("= delete") != std::string::npos;
}

/// "if (x < 1)" is never taken.
void add_dropped_condition(const std::string& code, const auto& add) {
  const std::size_t begin = code.find("if (");
  if (begin == std::string::npos || (begin > 0 && is_word(code[begin - 1]))) return;
  int depth = 0;
  for (std::size_t i = begin + 3; i < code.size(); ++i) {
    depth += code[i] == '(' ? 1 : code[i] == ')' ? -1 : 0;
    if (depth == 0) return add(begin, code.substr(begin, i + 1 - begin), "if (false)");
  }
}

/// An integer is one more, a sign or a negation is gone.
void add_at(const std::string& code, std::size_t i, const auto& add) {
  const char previous = i == 0 ? ' ' : code[i - 1];
  const char next = i + 1 < code.size() ? code[i + 1] : ' ';
  if (std::isdigit(static_cast<unsigned char>(code[i])) != 0 && !is_word(previous) &&
      std::string(".'").find(previous) == std::string::npos) {
    std::size_t end = i;
    while (end < code.size() && std::isdigit(static_cast<unsigned char>(code[end])) != 0) ++end;
    const bool is_whole =
        end == code.size() || (!is_word(code[end]) && code[end] != '.' && code[end] != '\'');
    const std::string number = code.substr(i, end - i);
    if (is_whole && number.size() < 10) add(i, number, std::to_string(std::stoll(number) + 1));
  }
  if (code[i] == '-' && (is_word(next) || next == '(') &&
      (std::string("(,=?:{[").find(previous) != std::string::npos ||
       (previous == ' ' && i > 1 &&
        std::string("(,=?:{[n").find(code[i - 2]) != std::string::npos)))
    add(i, std::string("-") + next, std::string(1, next));
  if (code[i] == '!' && is_word(next)) add(i, std::string("!") + next, std::string(1, next));
}

std::vector<Fault> faults_of(const std::string& file, std::uint64_t seed) {
  std::ifstream stream(file, std::ios::binary);
  std::vector<Fault> all;
  CodeOnly code_only;
  std::string line;
  for (std::size_t number = 1; std::getline(stream, line); ++number) {
    const std::string code = code_only(line);
    if (declares(code)) continue;
    std::vector<Fault> here;
    const auto add = [&](std::size_t at, const std::string& before, const std::string& after) {
      const std::string key = file + "\n" + line + "\n" + std::to_string(at) + after;
      here.push_back(
          {file, number, at + 1, line.substr(at, before.size()), after, hash(seed, key)});
    };
    for (const auto& [before, after] : exchanges)
      for (std::size_t at = code.find(before); at != std::string::npos;
           at = code.find(before, at + 1)) {
        const std::size_t end = at + std::string(before).size();
        const bool is_part = is_word(before[0]) &&
                             ((at > 0 && is_word(code[at - 1])) ||
                              (end < code.size() && is_word(code[end - 1]) && is_word(code[end])));
        const bool is_text =
            line[at == 0 ? 0 : at - 1] == '"' || (end < line.size() && line[end] == '"');
        if (!is_part && !is_text) add(at, before, after);
      }
    for (std::size_t i = 0; i < code.size(); ++i) add_at(code, i, add);
    add_dropped_condition(code, add);
    const auto by_rank = [](const Fault& l, const Fault& r) { return l.rank < r.rank; };
    if (!here.empty()) all.push_back(*std::min_element(here.begin(), here.end(), by_rank));
  }
  return all;
}

int list(std::uint64_t seed, const std::vector<std::string>& files) {
  std::vector<Fault> all;
  for (const std::string& file : files)
    for (Fault& fault : faults_of(file, seed)) all.push_back(std::move(fault));
  std::sort(all.begin(), all.end(), [](const Fault& l, const Fault& r) { return l.rank < r.rank; });
  std::map<std::string, int> in_file;
  for (const Fault& fault : all)
    if (++in_file[fault.file] <= most_in_a_file)
      std::printf("%s\t%zu\t%zu\t%s\t%s\n", fault.file.c_str(), fault.line, fault.column,
                  fault.before.c_str(), fault.after.c_str());
  return all.empty() ? 1 : 0;
}

int plant(const std::string& file, std::size_t line, std::size_t column, const std::string& before,
          const std::string& after) {
  std::ifstream stream(file, std::ios::binary);
  std::string text, read;
  bool planted = false;
  for (std::size_t number = 1; std::getline(stream, read); ++number) {
    if (number == line && read.compare(column - 1, before.size(), before) == 0) {
      read.replace(column - 1, before.size(), after);
      planted = true;
    }
    text += read + "\n";
  }
  if (!planted) return 1;
  stream.close();
  std::ofstream(file, std::ios::binary) << text;
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  const std::vector<std::string> words(argv + 1, argv + argc);
  if (words.size() > 2 && words[0] == "list")
    return list(std::stoull(words[1]), {words.begin() + 2, words.end()});
  if (words.size() == 6 && words[0] == "plant")
    return plant(words[1], std::stoull(words[2]), std::stoull(words[3]), words[4], words[5]);
  std::fputs("usage: faults list SEED FILE ...; faults plant FILE LINE COLUMN BEFORE AFTER\n",
             stderr);
  return 2;
}
