// Programs of others: each attack ends with a line that says why, and leaves nothing behind.
#include <csignal>
#include <cstdlib>

#include <fcntl.h>
#include <linux/landlock.h>
#include <poll.h>
#include <seccomp.h>
#include <sys/prctl.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include "classroom/classroom.hpp"
#include "host/child.hpp"
#include "rows.hpp"

namespace {

const host::TemporaryFolder place("sandbox");
const bool is_set = ::setenv("TMPDIR", place.path.c_str(), 1) == 0;
bool is_empty() { return is_set && std::filesystem::is_empty(place.path); }

const learn::Exercise doubled{
    .id = "doubled",
    .kind = "code",
    .within = "1 ulp",
    .driver = "double f(double); void call(const double* in, double* out) { *out = f(*in); }",
    .inputs = {"x"},
    .cases = {{"1"}, {"3"}},
    .outputs = {"2*x"},
    .words = {"f"},
};
/// With the headers that attacks need, and a driver that asks for a struct where there is one.
learn::Judgement judged(const std::string& code) {
  learn::Exercise e = doubled;
  if (code.starts_with("struct P "))
    e.driver =
        "struct P { double x, y; }; P f(double); struct Own { double z; };"
        "void call(const double* in, double* out) { const Own own{f(*in).y}; *out = own.z; }";
  return judge(e,
               "#include <cstdio>\n#include <cstdlib>\n#include <vector>\n#include <fcntl.h>\n"
               "#include <signal.h>\n#include <sys/socket.h>\n#include <unistd.h>\n" +
                   code,
               classroom::run_code);
}

/// A pipe that the shell script of another program opens by name: who has it is alive.
struct Fifo {
  host::TemporaryFolder folder{"fifo"};
  std::string name = folder.path + "/fifo";
  bool is_made = ::mkfifo(name.c_str(), 0600) == 0;
  pollfd reader{::open(name.c_str(), O_RDONLY | O_NONBLOCK), 0, 0};
  ~Fifo() { ::close(reader.fd); }
  std::vector<std::string> script(const std::string& text) const {
    return {"sh", "-c", "exec 9>" + name + "; echo >&9; " + text};
  }
  bool is_left(int milliseconds) {
    reader.events = 0;
    return ::poll(&reader, 1, milliseconds) == 1 && (reader.revents & POLLHUP) != 0;
  }
};
}  // namespace

TEST_CASE("A program is judged by what its function returns, an attack ends; nothing is left") {
  const bool has_landlock =
      ::syscall(SYS_landlock_create_ruleset, nullptr, 0, LANDLOCK_CREATE_RULESET_VERSION) >= 1;
  auto rows = rows_of("src/classroom/attacks.tsv", 2);
  rows.push_back({"\x7f\x45\x4c\x46\x02\xff\xfe", "Not compiled: answer.cpp:8:1: error: stray"});
  for (learn::Texts& row : rows) {
    std::string& code = row[0];
    INFO(code);
    if (!has_landlock && code.find("incbin") != code.npos) continue;
    learn::replace_all(code, "\\n", "\n");
    if (code.starts_with('{')) code = "double f(double x) { " + code + " return 2 * x; }";
    const learn::Judgement said = judged(code);
    CHECK(said.mark == (said.feedback.starts_with("Not compiled: ") ? learn::Mark::unread
                        : said.feedback == "Right, in all cases."   ? learn::Mark::right
                                                                    : learn::Mark::wrong));
    CHECK_THAT(said.feedback, ContainsSubstring(row[1]));
    CHECK(said.feedback.find('\n') == std::string::npos);
    CHECK(said.feedback.find("magicmass-") == std::string::npos);
    CHECK(is_empty());
  }
}

TEST_CASE("Whoever ends this program ends all that it started") {
  Fifo fifo;
  const pid_t child = ::fork();
  if (child == 0) {
    host::end_of(fifo.script("sleep 100 & sleep 100"));
    ::_exit(0);
  }
  fifo.reader.events = POLLIN;
  REQUIRE(::poll(&fifo.reader, 1, 5000) == 1);  // it has begun
  CHECK(!fifo.is_left(200));
  ::kill(child, SIGKILL);
  ::waitpid(child, nullptr, 0);
  CHECK(fifo.is_left(5000));
}

TEST_CASE("What a program started ends with it, or when its time is up") {
  const rlim_t much = rlim_t{1} << 30U;
  Fifo fifo;
  CHECK(host::end_of(fifo.script("sleep 100 & exit 3")).code == 3);
  CHECK(fifo.is_left(1000));
  CHECK(host::end_of(fifo.script("sleep 100 & sleep 100"), "", {1, much, much}).is_late);
  CHECK(fifo.is_left(1000));
}

TEST_CASE("An answer that ends its judge is undecided, and leaves nothing") {
  const auto run = [](const learn::Exercise&, const std::string& code, const learn::Rows&) {
    if (code == "loop") {
      const host::TemporaryFolder folder("loop");
      for (;;) ::usleep(1000);
    }
    if (code == "abort") std::abort();
    if (code == "end") ::_exit(0);
    if (code == "memory") throw std::bad_alloc();
    if (code == "no compiler") throw answers::Undecided("there is no compiler");
    return learn::Ran{.rows = {{2}, {6}}};
  };
  const auto judged_file = [&](const std::string& code) {
    const host::TemporaryFolder folder("answer");
    std::ofstream(folder.path + "/doubled.cpp") << code;
    return classroom::judged_file(doubled, folder.path, run, 1).value();
  };
  CHECK(judged_file("right").mark == learn::Mark::right);
  for (const auto& [code, why] :
       std::map<std::string, std::string>{{"loop", "It was not judged within 1 s."},
                                          {"end", "Its judge ended before it said anything."},
                                          {"abort", "Judging it crashed: signal 6."},
                                          {"memory", "It does not fit into memory."},
                                          {"no compiler", "there is no compiler"}}) {
    const learn::Judgement said = judged_file(code);
    CHECK(said.mark == learn::Mark::undecided);
    CHECK(said.feedback == why);
  }
  for (int i = 0; i < 50 && !is_empty(); ++i) ::usleep(100000);
  CHECK(is_empty());
  CHECK_FALSE(classroom::judged_file(doubled, place.path, run));
}

TEST_CASE("Where the system has no filter, nothing is run") {
  const pid_t child = ::fork();
  if (child == 0) {
    const scmp_filter_ctx filter = seccomp_init(SCMP_ACT_ALLOW);
    seccomp_rule_add(filter, SCMP_ACT_ERRNO(EPERM), SCMP_SYS(seccomp), 0);
    const scmp_arg_cmp set{0, SCMP_CMP_EQ, PR_SET_SECCOMP, 0};
    seccomp_rule_add_array(filter, SCMP_ACT_ERRNO(EPERM), SCMP_SYS(prctl), 1, &set);
    if (seccomp_load(filter) != 0) ::_exit(2);
    try {
      classroom::run_code(doubled, "double f(double x) { return x; }", {{1}});
    } catch (const answers::Undecided&) {
      ::_exit(7);
    }
    ::_exit(3);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  CHECK(WEXITSTATUS(status) == 7);
}
