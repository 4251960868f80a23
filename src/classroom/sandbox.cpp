// Programs of others, compiled and run where they can do nothing but compute.
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <random>
#include <sstream>
#include <tuple>

#include <fcntl.h>
#include <linux/landlock.h>
#include <seccomp.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <unistd.h>

#include "classroom/classroom.hpp"
#include "host/child.hpp"
#include "host/embedded.hpp"

namespace classroom {
namespace {

using host::End;

constexpr std::size_t mebibyte = std::size_t{1} << 20U;
constexpr unsigned compile_seconds = 10;
constexpr unsigned run_seconds = 3;

std::string first_line(const std::string& text) {
  return answers::shown_text(text.substr(0, text.find('\n')), 160);
}

std::string declared(const std::string& driver) {
  learn::Texts lines = learn::split(driver.substr(0, driver.find("void call(")), '\n');
  std::erase_if(lines, [](const std::string& line) { return line[0] == '#'; });
  return answers::joined(lines, " ");
}

/// Not a page of notes on templates, which teaches nobody.
std::string first_error(const End& compiled, const std::string& folder, const std::string& driver) {
  if (compiled.is_late) return "compiling took more than " + std::to_string(compile_seconds) + " s";
  if (compiled.errors.find("File size limit") != std::string::npos)
    return "the program would be larger than 64 MiB";
  for (std::string line : learn::fields(compiled.errors, '\n')) {
    const auto has = [&](const std::string& what) { return line.find(what) != line.npos; };
    if (!has("rror: ") && !has("undefined reference") && !has("multiple definition") &&
        !has("memory"))
      continue;
    const std::size_t name = line.rfind('`') + 1;  // undefined reference to `f(double)'
    const std::string call = " " + line.substr(name, line.find('(', name) + 1 - name);
    const std::string expected = declared(driver);
    if (has("rror: ") ? line.starts_with("called.cpp")
                      : has("undefined reference") && expected.find(call) != expected.npos)
      return "your file must define: " + answers::shown_text(expected, 200);
    if (has("multiple definition of `main'")) return "leave out main: the driver has one";
    learn::replace_all(line, folder + "/", "");
    return answers::shown_text(line, 200);
  }
  return first_line(compiled.errors);
}

std::string why_stopped(const End& end) {
  const bool had_no_memory = end.errors.find("bad_alloc") != end.errors.npos ||
                             end.errors.find("length_error") != end.errors.npos;
  if (end.is_late)
    return "it did not come to an end within " + std::to_string(run_seconds) +
           " s: are there too many steps, or a loop that never stops?";
  if (had_no_memory) return "it asked for more memory than the 512 MiB that it may have";
  const std::string crashed =
      "it crashed: it used memory that is not its own, or called itself without end";
  const std::map<int, std::string> reasons{
      {SIGXFSZ, "it wrote more than 1 MiB of output"},
      {SIGSYS,
       "it tried to use a file, another process or thread, or the network; an exercise may only "
       "compute"},
      {SIGSEGV, crashed},
      {SIGBUS, crashed},
      {SIGFPE, "it divided a whole number by zero"},
      {SIGABRT, "it gave up" + (end.errors.empty() ? "" : ": " + first_line(end.errors))}};
  const int signal = end.code - host::of_signal;
  if (reasons.contains(signal)) return reasons.at(signal);
  return end.code == 0 ? ""
         : signal > 0  ? "signal " + std::to_string(signal) + " ended it"
                       : "it ended with exit code " + std::to_string(end.code);
}

/// Lines behind the seal. Whoever finds it in memory gains no more than by a table of answers in
/// the function: the right results are never in the process.
learn::Ran read_results(const End& end, const std::string& seal) {
  learn::Ran ran{.stopped = why_stopped(end)};
  learn::Texts lines = learn::fields(end.results, '\n');
  const bool is_complete = !lines.empty() && lines.back() == seal + " end";
  if (is_complete) lines.pop_back();
  for (const std::string& line : lines) {
    if (!line.starts_with(seal + " ")) {
      ran.stopped = "it wrote to descriptor 3 by itself; what the function returns is its result";
      return ran;
    }
    learn::Numbers& row = ran.rows.emplace_back();
    for (const std::string& word : learn::split(line.substr(seal.size()), ' '))
      row.push_back(std::strtod(word.c_str(), nullptr));
  }
  if (ran.stopped.empty() && !is_complete)
    ran.stopped = "it ended the program before the last case was done";
  return ran;
}

/// From now on whatever a static program that computes does not ask for ends this process (SIGSYS).
/// It may set the limit `memory` and become `program`, by these pointers. False without a filter.
bool compute_only(const char* program, const rlimit* memory) {
  const scmp_filter_ctx filter = seccomp_init(SCMP_ACT_KILL_PROCESS);
  bool is_good = filter != nullptr;
  const auto rule = [&](const char* call, std::vector<scmp_arg_cmp> where = {},
                        std::uint32_t action = SCMP_ACT_ALLOW) {
    const int number = seccomp_syscall_resolve_name(call);
    is_good = is_good && seccomp_rule_add_array(filter, action, number, unsigned(where.size()),
                                                where.data()) == 0;
  };
  const auto equals = [](unsigned argument, std::uint64_t value) {
    return scmp_arg_cmp{argument, SCMP_CMP_EQ, value, 0};
  };
  for (const char* call : {"brk",           "mmap",         "munmap",          "mremap",
                           "mprotect",      "arch_prctl",   "set_tid_address", "set_robust_list",
                           "rseq",          "getrandom",    "futex",           "rt_sigprocmask",
                           "rt_sigaction",  "rt_sigreturn", "getpid",          "gettid",
                           "clock_gettime", "sysinfo",      "fstat",           "newfstatat",
                           "exit",          "exit_group"})
    rule(call);
  rule("read", {equals(0, STDIN_FILENO)});
  for (const auto* c : {"write", "writev"})
    rule(c, {{0, SCMP_CMP_LE, host::results_descriptor, 0}});
  rule("prlimit64", {equals(0, 0), equals(2, 0)});  // asks, sets nothing
  rule("prlimit64", {equals(0, 0), equals(1, RLIMIT_AS), equals(2, std::uint64_t(memory))});
  rule("tgkill", {equals(0, std::uint64_t(::getpid()))});  // abort()
  for (const char* call : {"readlink", "readlinkat"}) rule(call, {}, SCMP_ACT_ERRNO(ENOENT));
  rule("execve", {equals(0, std::uint64_t(program))});
  return is_good && seccomp_load(filter) == 0;  // the last call that we may make
}

/// From now on this process and what it starts read files of the system and of their folder alone:
/// an assembler reads whatever it is told to. Without Landlock in the kernel nothing is changed.
bool read_programs_only(const char*, const rlimit*) {
  constexpr std::uint64_t reading = LANDLOCK_ACCESS_FS_READ_FILE;
  landlock_ruleset_attr all{};
  all.handled_access_fs = reading;
  const auto rules = int(::syscall(SYS_landlock_create_ruleset, &all, sizeof all, 0));
  if (rules < 0) return true;
  for (const char* place : {"/usr", "/bin", "/lib", "/lib64", "/opt", "/dev/null", "."}) {
    const landlock_path_beneath_attr rule{reading, ::open(place, O_PATH | O_CLOEXEC)};
    if (rule.parent_fd >= 0)
      ::syscall(SYS_landlock_add_rule, rules, LANDLOCK_RULE_PATH_BENEATH, &rule, 0);
  }
  return ::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0 &&
         ::syscall(SYS_landlock_restrict_self, rules, 0) == 0;
}

learn::Ran compiled_and_run(const Exercise& e, const std::string& code, const learn::Rows& inputs) {
  const host::TemporaryFolder folder("learn");
  std::ofstream(folder.path + "/answer.cpp") << code;
  for (const auto& [name, text] : host::embedded())
    if (name.ends_with(".hpp"))
      std::ofstream(folder.path + "/" + name.substr(name.rfind('/') + 1)) << text;
  // In one file, lest a struct, or a function's type, differs; the driver declares functions again.
  const auto unused = [all = declared(e.driver)](const learn::Texts& part) {
    return all.find(part[1]) == all.rfind(part[1]) ? part[0] : "";  // the answer has its own
  };
  std::ofstream(folder.path + "/called.cpp")
      << "#include \"answer.cpp\"\n"
      << learn::replaced(e.driver, "struct (\\w+) \\{[^{}]*\\};", unused);
  const auto compile = [&](const std::string& how, auto confine) {
    const std::string flags = "-std=c++20 -O1 -ffp-contract=off -w -fmax-errors=1 ";
    return host::end_of(learn::split("env LC_ALL=C TMPDIR=. c++ " + flags + how, ' '), "",
                        {.seconds = compile_seconds,
                         .bytes = 1024 * mebibyte,
                         .file_bytes = 64 * mebibyte,
                         .folder = folder.path,
                         .confine = confine});
  };
  End made = compile("-c -MD -MF /dev/stdout called.cpp", read_programs_only);
  if (made.code == host::not_there)
    throw answers::Undecided("learn: code is compiled by c++, which is not here (Debian: g++)");
  std::istringstream names(made.code == 0 ? made.output : compile("-M called.cpp", nullptr).output);
  for (std::string name; names >> name;)  // beside an answer, or the system's
    if (name.find('/') != name.npos && (!name.starts_with("/usr/") || name.find("..") != name.npos))
      return {.unread = "it includes " + answers::shown_text(name) +
                        "; allowed: headers of the standard library"};
  static std::string ours;  // main(), compiled once for all answers
  std::ofstream(folder.path + "/main.o") << ours;
  if (made.code == 0 && ours.empty()) {
    made = compile("-c -x c++ exercise_driver.hpp -o main.o", nullptr);
    ours = {std::istreambuf_iterator(std::ifstream(folder.path + "/main.o").rdbuf()), {}};
  }
  if (made.code == 0) made = compile("called.o main.o -static -o program", read_programs_only);
  if (made.code != 0) return {.unread = first_error(made, folder.path, e.driver)};

  std::random_device random;
  std::string seal;
  for (int i = 0; i < 4; ++i) seal += std::to_string(random() % 1000000000);
  std::ostringstream text;
  text << std::hexfloat << seal << ' ' << e.outputs.size() << ' ' << e.inputs.size();
  for (const learn::Numbers& row : inputs)
    for (const double value : row) text << ' ' << value;
  const End end = host::end_of({"./program"}, text.str(),
                               {.seconds = run_seconds,
                                .bytes = 512 * mebibyte,
                                .file_bytes = mebibyte,
                                .folder = folder.path,
                                .confine = compute_only});
  if (!end.was_confined)
    throw answers::Undecided("learn: nothing is run where the system cannot confine it (seccomp)");
  return read_results(end, seal);
}

}  // namespace

learn::Ran run_code(const Exercise& e, const std::string& code, const learn::Rows& inputs) {
  static std::map<std::tuple<std::string, std::string, learn::Rows>, learn::Ran> known;
  const std::tuple key{e.driver, code, inputs};
  if (!known.contains(key)) known[key] = compiled_and_run(e, code, inputs);
  return known[key];
}

}  // namespace classroom
