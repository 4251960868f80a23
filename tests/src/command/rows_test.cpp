// SPDX-License-Identifier: GPL-2.0-or-later
// CSV as it is written, and as it should not be.
#include "command/rows.hpp"

#include <fstream>
#include <map>

#include "answers/errors.hpp"
#include "catch.hpp"
#include "host/child.hpp"
#include "refusal.hpp"

using command::CsvReader;
using Rows = std::vector<std::map<std::string, std::string>>;

namespace {

const host::TemporaryFolder folder("rows");
const std::string file = folder.path + "/rows.csv";

/// The rows of a text, two at once.
Rows rows_of(const std::string& text) {
  std::ofstream(file, std::ios::binary) << text;
  CsvReader reader(file, {"alpha", "n"}, {"tier"});
  Rows all;
  std::vector<std::vector<std::string>> block;
  while (reader.read(block, 2)) {
    for (const std::vector<std::string>& fields : block) {
      all.emplace_back();
      for (std::size_t i = 0; i < fields.size(); ++i) all.back()[reader.columns()[i]] = fields[i];
    }
  }
  return all;
}

}  // namespace

TEST_CASE("what is read", "[exam]") {
  const Rows two = {{{"alpha", "0.1"}, {"n", "2"}}, {{"alpha", "1/7"}, {"n", "3"}}};
  for (const char* const text : {
           "alpha,n\n0.1,2\n1/7,3\n",
           "alpha,n\n0.1,2\n1/7,3",
           "n,alpha\r\n2,0.1\r\n3,1/7\r\n\r\n",
           "\xEF\xBB\xBF"
           "alpha,n\n0.1,2\n1/7,3\n\n \n",
           " alpha , n \n\t0.1,2 \n 1/7 ,3\n",
           "\"alpha\",\"n\"\n\"0.1\" , \"2\"\n\"1/7\",3\n",
           "alpha,other,n\n0.1,,2\n1/7,\"a,\"\"b\"\"\",3\n",
       }) {
    CHECK(rows_of(text) == two);
  }
  CHECK(rows_of("alpha\n").empty());
  CHECK(rows_of("alpha\n\"a \"\"b\"\"\"\n") == Rows{{{"alpha", "a \"b\""}}});
}

TEST_CASE("what is refused, and where", "[exam]") {
  const auto refuses = [&](const std::string& text, const std::string& message) {
    CHECK(refusal<answers::InvalidInput>([&] { rows_of(text); }) == file + ":" + message);
  };
  refuses("", "1: the first line must name a column, got (nothing); allowed: alpha, n");
  refuses("beta\n1\n", "1: the first line must name a column, got beta; allowed: alpha, n");
  refuses("alpha,tier\n1,2\n",
          "1: tier: not a column but one option for all rows, --tier; options that may be columns: "
          "alpha, n");
  refuses("n,n\n1,2\n", "1: n: a column of that name was there before");
  refuses("alpha,n\n1,2\n3\n", "3: fields: got 1; allowed: as many as the header names: 2");
  refuses("alpha\n1,2\n", "2: fields: got 2; allowed: as many as the header names: 1");
  refuses("alpha,n\n1,\n", "2: n: empty; allowed: a value in every field");
  refuses("alpha\n1\n\n2\n", "3: an empty line; allowed: at the end");
  refuses("alpha\n\"1\n", "2: a quoted field has no closing quote in its line");
  refuses("alpha\n\"1\"2\n",
          "2: something follows a quoted field; allowed: a comma or the line's end");
  refuses(std::string("alpha\n1\0\n", 9), "2: a zero byte; allowed: text");
  refuses("alpha\n" + std::string(65537, '1') + "\n", "2: a line of more than 65536 bytes");
  CHECK(rows_of("alpha\n" + std::string(65536, '1') + "\n").size() == 1);
}
