// SPDX-License-Identifier: GPL-2.0-or-later
// Answers of many, in files and over time: what is remembered, graded, watched.
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "answers/errors.hpp"
#include "catch.hpp"
#include "classroom/classroom.hpp"
#include "host/child.hpp"
#include "magicmass/scenes/keys.hpp"
#include "refusal.hpp"

using learn::Exercise;
using learn::Mark;

namespace {

const Exercise half{.source = "half.toml",
                    .id = "half",
                    .kind = "symbolic",
                    .symbols = {"alpha"},
                    .answer = "1/(1 + alpha)",
                    .misconceptions = {{"=upside down", {"1 + alpha"}, "=Upside down."}}};
const Exercise twice{.source = "twice.toml",
                     .id = "twice",
                     .kind = "code",
                     .within = "1 ulp",
                     .solution_code = "2 x",
                     .inputs = {"x"},
                     .cases = {{"1"}},
                     .outputs = {"2*x"},
                     .words = {"double"}};

/// Some answers do what programs of students do.
learn::Ran run(const Exercise&, const std::string& code, const learn::Rows&) {
  if (code == "loop") {
    const host::TemporaryFolder folder("loop");
    for (;;) ::usleep(1000);
  }
  if (code == "abort") std::abort();
  if (code == "end") ::_exit(0);
  if (code == "memory") throw std::bad_alloc();
  if (code == "no compiler") throw answers::Undecided("there is no compiler");
  return {.rows = {{code == "2 x" ? 2. : 0.}}};
}

void save(const std::filesystem::path& file, const std::string& text) {
  std::filesystem::create_directories(file.parent_path());
  std::ofstream(file, std::ios::binary) << text;
}

/// A place for the time of a test, and the memory in it.
struct Place : host::TemporaryFolder {
  Place() : TemporaryFolder("test") {
    ::setenv("XDG_STATE_HOME", (path + "/state").c_str(), 1);
    ::alarm(60);  // what waits for ever is ended
  }
  ~Place() { ::alarm(0); }
  std::string memory() const { return path + "/state/magicmass/answers.tsv"; }
};

learn::Texts lines_of(const std::string& file) {
  return learn::fields(magicmass::scenes::text_of(file, "lines"), '\n');
}

}  // namespace

TEST_CASE("Checks at once lose no line of the memory") {
  const Place place;
  std::vector<pid_t> children;
  for (int child = 0; child < 8; ++child)
    if (children.push_back(::fork()); children.back() == 0) {
      learn::Judgement said = judge(twice, "0", run);
      for (int i = 0; i < 25; ++i) classroom::remember(twice, said);
      ::_exit(0);
    }
  for (const pid_t child : children) ::waitpid(child, nullptr, 0);
  int answers = 0;
  for (const std::string& line : lines_of(place.memory()))
    answers += line.starts_with("twice\twrong\t") ? 1 : 0;
  CHECK(answers == 200);
  CHECK(classroom::attempts().at("twice").misses == 200);
}

TEST_CASE("A class is graded, whatever its files are") {
  const Place place;
  const std::string room = place.path + "/class/";
  save(room + "anna/half.txt", "1/(1 + alpha)\n");
  save(room + "anna/twice.cpp", "2 x");
  save(room + "=bob/half.txt", "1 + alpha");
  save(room + "=bob/twice.cpp", "abort");
  save(room + "Zo\xC3\xAB/half.txt", "1 + alpha");
  save(room + "c\x1b[2J/twice.cpp", "memory");
  save(room + "d\xE2\x80\xAE/twice.cpp", "no compiler");
  save(room + "e\xC3/half.txt", std::string(70000, '1'));
  save(room + "f/half.txt", std::string("1\0", 2));
  save(room + "g/half.txt/x", "a folder");
  save(room + "h/twice.txt", "2 x");
  save(room + "h/half.txt", "\xFF");
  save(room + "i/half.txt", "");
  save(room + "i/HALF.docx", "x");
  save(room + "i/notes.docx", "x");
  std::filesystem::create_directories(room + "n;=1");
  save(room + "not a student", "x");
  save(room + ".hidden/half.txt", "x");
  std::filesystem::create_directories(room + "j");
  std::filesystem::create_symlink(room + "anna/half.txt", room + "j/half.txt");
  std::filesystem::create_symlink("/dev/zero", room + "j/twice.cpp");
  std::filesystem::create_symlink(room + "anna", room + "k");
  std::filesystem::create_symlink(room + "l", room + "l");
  std::filesystem::create_directories(room + "m");
  ::mkfifo((room + "m/half.txt").c_str(), 0600);
  const auto graded = [&](std::map<std::string, std::string> options, const std::string& format) {
    const answers::Request request{std::move(options), {"grade", room}, format};
    return answers::written(classroom::grade(request, {half, twice}, run).table,
                            format == "csv" ? answers::Format::csv : answers::Format::json_lines);
  };
  CHECK(graded({}, "csv") ==
        "student,half,twice\n'=bob,wrong,undecided\nZo\xC3\xAB,wrong,missing\nanna,right,right\n"
        "c\\x1b[2J,missing,undecided\nd\\xe2\\x80\\xae,missing,undecided\ne\\xc3,unread,missing\n"
        "f,unread,missing\ng,unread,missing\nh,unread,missing\ni,unread,missing\n"
        "j,unread,unread\nk,unread,unread\nm,unread,missing\n\"n,=1\",missing,missing\n");
  CHECK(graded({{"only", "twice"}}, "json").starts_with("{\"student\": \"=bob\", \"twice\": "));
  CHECK(graded({{"summary", ""}}, "csv") == "id,misconception,students\nhalf,'=upside down,2\n");
  const std::string why = graded({{"why", ""}}, "csv");
  for (const char* line :
       {"\n'=bob,half,wrong,'=Upside down.,'=upside down\n",
        "\n'=bob,twice,undecided,Judging it crashed: signal 6.,\n",
        "\nc\\x1b[2J,twice,undecided,It does not fit into memory.,\n",
        "\nd\\xe2\\x80\\xae,twice,undecided,there is no compiler,\n",
        ",half,unread,Not read: more than 64 KiB.,\n", "\ng,half,unread,Not read: not a file with",
        "\nf,half,unread,\"Not read: it has a zero byte", "\ni,half,unread,The answer is empty.,\n",
        "\ni,HALF.docx,unread,\"no exercise has this file, is half.txt meant?\",\n",
        "\nj,twice,unread,Not read: a link.,\n", "\nk,half,unread,Not read: a link.,\n"})
    CHECK_THAT(why, ContainsSubstring(line));
  CHECK(why.find("missing") == std::string::npos);
  CHECK(why.find("notes") == std::string::npos);
  CHECK_FALSE(std::filesystem::exists(place.memory()));
}

TEST_CASE("An answer that never ends is undecided, one that ends the judge too") {
  const Place place;
  save(place.path + "/twice.cpp", "loop");
  ::setenv("TMPDIR", place.path.c_str(), 1);
  const auto late = classroom::judged_file(twice, place.path, run, 1).value();
  ::unsetenv("TMPDIR");
  const auto files = [&] {
    return std::distance(std::filesystem::directory_iterator(place.path), {});
  };
  for (int i = 0; i < 50 && files() > 1; ++i) ::usleep(100000);
  CHECK(files() == 1);  // the answer's folder is gone
  CHECK(late.mark == Mark::undecided);
  CHECK(late.feedback == "It was not judged within 1 s.");
  save(place.path + "/twice.cpp", "end");
  CHECK(classroom::judged_file(twice, place.path, run).value().feedback ==
        "Its judge ended before it said anything.");
  CHECK_FALSE(classroom::judged_file(half, place.path, run));
}

TEST_CASE("A saved answer is judged, once, however it was saved") {
  const Place place;
  const std::string file = place.path + "/half.txt";
  save(place.path + "/twice.cpp", "there before");
  save(place.path + "/hlaf.txt", "x");
  save(place.path + "/notes.md", "x");
  const std::vector<std::pair<std::string, std::function<void()>>> steps{
      {"hlaf.txt: no exercise has this file; is half.txt meant?\n", [] {}},
      {"Watching " + place.path,
       [&] {
         save(file, "");  // for a moment
         ::usleep(400000);
         save(file, "1 + alpha");
       }},
      {"wrong\nfeedback  =Upside down.",
       [&] {
         save(place.path + "/new", "1/(1 + alpha)");
         std::filesystem::rename(place.path + "/new", file);
       }},
      {"right\nfeedback  Right.", [&] { save(place.path + "/twice.cpp", "0"); }},
      {"wrong\nfeedback  At x = 1: your double is 0", [] { throw std::out_of_range("seen"); }}};
  std::string all;
  std::size_t step = 0;
  CHECK_THROWS_AS(classroom::watch({half, twice}, place.path, run,
                                   [&](std::string_view text) {
                                     all += text;
                                     if (!text.empty()) return;
                                     CHECK_THAT(all, ContainsSubstring(steps.at(step).first));
                                     all.clear();
                                     steps.at(step++).second();
                                   }),
                  std::out_of_range);
  CHECK(step == steps.size());
  CHECK(lines_of(place.memory()).size() == 3);
  CHECK_THAT(refusal<answers::InvalidInput>(
                 [&] { classroom::watch({half}, place.path + "/no", run, {}); }),
             ContainsSubstring("cannot read the folder"));
}
