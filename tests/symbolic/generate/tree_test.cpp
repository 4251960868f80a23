// SPDX-License-Identifier: GPL-2.0-or-later
// generated/ is what the theorems give; what differs is named; a folder is written whole or not.
#include "generate/tree.hpp"

#include <filesystem>
#include <fstream>

#include <unistd.h>

#include "catch.hpp"
#include "generate/quantities.hpp"

namespace fs = std::filesystem;
using Lines = std::vector<std::string>;

namespace {
struct Scratch {
  fs::path folder;
  Scratch() : folder(fs::temp_directory_path() / ("magicmass-tree-" + std::to_string(::getpid()))) {
    fs::create_directories(folder);
  }
  ~Scratch() { fs::remove_all(folder); }
};
}  // namespace

TEST_CASE("the committed files are what the theorems give, and a second time the same") {
  const generate::Texts texts = generate::generated();
  CHECK(generate::differences(GENERATED, texts).empty());
  CHECK(generate::generated() == texts);
}
TEST_CASE("what differs is named") {
  const Scratch scratch;
  const generate::Texts texts{{"a.hpp", "1\n"}, {"deep/b.hpp", "2\n"}};
  generate::write(scratch.folder, texts);
  CHECK(generate::differences(scratch.folder, texts).empty());
  std::ofstream(scratch.folder / "a.hpp") << "3\n";
  std::ofstream(scratch.folder / "more.hpp") << "4\n";
  fs::remove(scratch.folder / "deep/b.hpp");
  CHECK(generate::differences(scratch.folder, texts) ==
        Lines{"a.hpp: differs", "deep/b.hpp: is not there", "more.hpp: is not generated"});
}
TEST_CASE("a folder is written whole or not at all, and nobody's file is taken") {
  const Scratch scratch;
  std::ofstream(scratch.folder / "a.hpp") << "old\n";
  std::ofstream(scratch.folder / "a.hpp.new-0") << "somebody's\n";
  std::ofstream(scratch.folder / "deep") << "a file, no folder\n";
  CHECK_THROWS_WITH(generate::write(scratch.folder, {{"a.hpp", "new\n"}, {"deep/b.hpp", "2\n"}}),
                    ContainsSubstring("deep"));
  CHECK(generate::differences(
            scratch.folder,
            {{"a.hpp", "old\n"}, {"a.hpp.new-0", "somebody's\n"}, {"deep", "a file, no folder\n"}})
            .empty());
}
