// SPDX-License-Identifier: GPL-2.0-or-later
// What students may hand in, in earnest or not.
#include <chrono>
#include <filesystem>

#include <catch2/catch.hpp>
#include <sys/stat.h>

#include "learn_run.hpp"

using Catch::Contains;

namespace {

const std::string signature =
    "struct Velocities { double first, second; };\n"
    "Velocities collide(double M_1, double u_1, double M_2, double u_2)";

/// A function with this body, checked.
ProgramRun checked(const Student& student, const std::string& before, const std::string& body) {
  const TemporaryFolder folder;
  write_file(folder / "mine.cpp", before + signature + " {" + body + "}\n");
  ProgramRun run = student.learn({"check", "collide", folder / "mine.cpp"});
  CHECK(lines_of(run.output).size() < 20);
  return run;
}

}  // namespace

TEST_CASE("a right function is right, and a wrong one is told in physics", "[exam]") {
  const Student student;
  const ProgramRun right =
      checked(student, "",
              "const double v = 2 * (M_1*u_1 + M_2*u_2) / (M_1 + M_2); return {v - u_1, v - u_2};");
  CHECK(right.exit_code == 0);
  CHECK_THAT(right.output, Contains("Right in all 7 cases"));
  const ProgramRun wrong = checked(student, "", "return {-u_1, u_1};");
  CHECK(wrong.exit_code == 1);
  CHECK_THAT(unwrapped(wrong.output),
             Contains("your first body moves left, it should stand still"));
}

TEST_CASE("the collision that goes wrong is named", "[exam]") {
  const Student student;
  const TemporaryFolder folder;
  write_file(folder / "mine.cpp",
             "struct Velocities { double a, b, c; };\n"
             "Velocities after_collisions(double alpha, long j) {\n"
             "  double a = 1, b = 0, c = 0;\n"
             "  for (long i = 1; i <= j; ++i) {\n"
             "    double& block = i % 2 == 1 ? a : b;\n"
             "    const double v = (block + alpha * c) / (1 + alpha);\n"
             "    block = 2 * v - block;\n"
             "    c = i == 3 ? -(2 * v - c) : 2 * v - c;\n"
             "  }\n"
             "  return {a, b, c};\n"
             "}\n");
  const ProgramRun run = student.learn({"check", "collision_by_collision", folder / "mine.cpp"});
  CHECK(run.exit_code == 1);
  CHECK_THAT(run.output,
             Contains("Third collision, alpha = 1/8: your C moves left, it should move"));
}

TEST_CASE("what does not end, grows, writes or crashes is stopped, and the reason named",
          "[exam]") {
  const Student student;
  const TemporaryFolder folder;
  write_file(folder / "precious", "kept");
  const std::string precious = folder / "precious";
  struct Bad {
    std::string before, body, reason;
  };
  for (const Bad& bad : std::vector<Bad>{
           {"", "for (volatile int i = 0;;) i = i + 1;", "within 3 s"},
           {"#include <cstdlib>\n#include <new>\n",
            "for (;;) { volatile char* p = new char[100000000]; p[0] = 1; }",
            "more memory than the 512 MiB"},
           {"#include <fstream>\n", "std::ofstream(\"" + precious + "\") << 1; return {0, 0};",
            "write a file"},
           {"#include <cstdio>\n", "std::remove(\"" + precious + "\"); return {0, 0};",
            "write a file"},
           {"#include <unistd.h>\n", "fork(); return {0, 0};", "start another program"},
           {"#include <unistd.h>\n", "setsid(); return {0, 0};", "start another program"},
           {"#include <sys/syscall.h>\n#include <unistd.h>\n",
            "syscall(SYS_tkill, getppid(), 0); return {0, 0};", "disturb one"},
           {"#include <sys/resource.h>\n#include <unistd.h>\n",
            "rlimit now; prlimit(getppid(), RLIMIT_CPU, nullptr, &now); return {0, 0};",
            "disturb one"},
           {"#include <fcntl.h>\n#include <unistd.h>\n",
            "if (open(\"/dev/tty\", O_RDONLY) < 0) _exit(77); return {0, 0};", "exit code 77"},
           {"#include <sys/socket.h>\n", "socket(AF_INET, SOCK_STREAM, 0); return {0, 0};",
            "use the network"},
           {"", "*(volatile int*)8 = 1; return {0, 0};", "it crashed"},
           {"", "volatile int zero = 0; return {double(int(M_1 + 6) / zero), 0};",
            "divided a whole number by zero"},
           {"#include <cstdio>\n", "for (;;) std::puts(\"all work and no play\");",
            "1 MiB of output"},
           {"#include <cstdlib>\n", "std::exit(0);", "before all cases were done"}}) {
    INFO(bad.body);
    const ProgramRun run = checked(student, bad.before, bad.body);
    INFO(run.output << run.errors);
    CHECK(run.exit_code == 1);
    CHECK_THAT(unwrapped(run.output), Contains(bad.reason));
  }
  CHECK(read_file(precious) == "kept");
}

TEST_CASE("a loop without end is stopped within 10 s", "[time]") {
  const Student student;
  const auto start = std::chrono::steady_clock::now();
  CHECK(checked(student, "", "for (volatile int i = 0;;) i = i + 1;").exit_code == 1);
  CHECK(std::chrono::steady_clock::now() - start < std::chrono::seconds(10));
}

TEST_CASE("what does not compile gets the compiler's first words, and is no attempt", "[exam]") {
  const Student student;
  const ProgramRun run = checked(student, "", "return {u_1 u_2};");
  CHECK(run.exit_code == 2);
  CHECK_THAT(run.output, Contains("does not compile") && Contains("answer.cpp:2:"));
  CHECK_FALSE(std::filesystem::exists(student.file("progress.txt")));
}

TEST_CASE("without a compiler there is one clear line", "[exam]") {
  const TemporaryFolder folder;
  write_file(folder / "mine.cpp", signature + " { return {u_2, u_1}; }\n");
  const ProgramRun run =
      run_program({"learn", "check", "collide", folder / "mine.cpp", "--folder", folder / "mine"},
                  "", {"env", "PATH=/nowhere"});
  CHECK(run.exit_code == 2);
  CHECK_THAT(unwrapped(run.output), Contains("there is no C++ compiler called c++; install one"));
}

TEST_CASE("results cannot be faked by printing or by leaving early", "[exam]") {
  const Student student;
  const ProgramRun run =
      checked(student, "#include <unistd.h>\n#include <cstdio>\n",
              "std::puts(\"right right right\"); write(3, \"0x0p+0 0x1p+0 \\n\", 15); _exit(0);");
  CHECK(run.exit_code == 1);
}

TEST_CASE("hostile answers are bounded", "[exam]") {
  const Student student;
  for (const std::string& answer :
       {std::string("9^9^9^9"), std::string(100000, '('), std::string(5000, '1'),
        std::string("exp(exp(exp(exp(exp(alpha)))))"), std::string("\\frac{\\frac{\\frac{"),
        std::string("\xff\xfe"), std::string("(1+alpha)^9999"), std::string("[[[[[["),
        std::string(3000, '{'), std::string("1;;;;=;=;="), std::string("="), std::string(";"),
        std::string("=\n=="), std::string("alpha =; = n")}) {
    for (const char* id : {"half_angle", "gamma_matrix", "double_angle", "momentum_lines",
                           "count_them", "three_equal"}) {
      INFO(id << ": " << answer.substr(0, 40));
      const ProgramRun run = student.learn({"check", id, "-"}, answer);
      CHECK(run.exit_code >= 1);
      CHECK(run.exit_code <= 3);
      CHECK(lines_of(run.output + run.errors).size() < 40);
    }
  }
}

TEST_CASE("an answer that can be no file's name is refused in one line", "[exam]") {
  const Student student;
  for (const std::string& name : {std::string(300, 'x'), std::string(5000, 'x')}) {
    const ProgramRun run = student.learn({"check", "collide", name});
    CHECK(run.exit_code == 2);
    CHECK(lines_of(run.errors).size() == 1);
    CHECK_THAT(run.errors, Contains("File name too long"));
  }
}

TEST_CASE("a pipe in an answer's place is no text file, and nobody waits for it", "[exam]") {
  const Student student;
  const TemporaryFolder folder;
  REQUIRE(::mkfifo((folder / "pipe").c_str(), 0600) == 0);
  const ProgramRun run = student.learn({"check", "collide", folder / "pipe"});
  CHECK(run.exit_code == 2);
  CHECK_THAT(run.errors, Contains("a text file is expected"));
}

TEST_CASE("what a compiler says of a source that is not UTF-8 is valid JSON", "[exam]") {
  const Student student;
  const TemporaryFolder folder;
  write_file(folder / "mine.cpp", "#error caf\xe9\n");
  const ProgramRun run =
      student.learn({"check", "collide", folder / "mine.cpp", "--format", "json"});
  CHECK(nlohmann::json::accept(run.output));
  CHECK_THAT(run.output, Contains("error"));
}

TEST_CASE("a seed and a time to wait are numbers that make sense", "[exam]") {
  const Student student;
  for (const char* seed : {"-1", "18446744073709551616", "x"})
    CHECK(student.learn({"show", "half_angle", "--seed", seed}).exit_code == 2);
  for (const char* seconds : {"-1", "0"})
    CHECK(student.learn({"watch", "--seconds", seconds}).exit_code == 2);
}
