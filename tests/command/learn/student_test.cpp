// SPDX-License-Identifier: GPL-2.0-or-later
#include <filesystem>
#include <thread>

#include <catch2/catch.hpp>

#include "learn_run.hpp"
#include "render/text_box.hpp"

using Catch::Contains;
using Catch::StartsWith;

namespace {

void require_80_columns(const std::string& output) {
  for (const std::string& line : lines_of(output)) {
    INFO(line);
    CHECK(magicmass::render::columns(line) <= 80);
  }
}

}  // namespace

TEST_CASE("a student's way: list, show, wrong, hint, right, next", "[exam]") {
  const Student student;
  const ProgramRun list = student.learn({"list"});
  CHECK(list.exit_code == 0);
  CHECK_THAT(list.output, Contains("[ ] half_angle") && Contains("0 of "));
  const ProgramRun show = student.learn({"show", "half_angle"});
  CHECK(show.exit_code == 0);
  CHECK_THAT(show.output,
             StartsWith("Half the angle of a cycle\n===") && Contains("Form asked for"));
  const ProgramRun wrong = student.learn({"check", "half_angle", "1+alpha"});
  CHECK(wrong.exit_code == 1);
  CHECK_THAT(wrong.output, StartsWith("Read as: ") && Contains("\nNot right.\n") &&
                               Contains("At alpha = 1 yours is 2, where it should be 1/2.") &&
                               Contains("\nA hint: "));
  const ProgramRun hint = student.learn({"hint", "half_angle"});
  CHECK_THAT(hint.output, StartsWith("Hint 1 of 3: "));
  const ProgramRun right = student.learn({"check", "half_angle", "1/(1+α)"});
  CHECK(right.exit_code == 0);
  CHECK_THAT(right.output, Contains("\nRight.") && Contains("Next: magicmass learn show"));
  CHECK_THAT(student.learn({"list"}).output, Contains("[x] half_angle") && Contains("1 of "));
  CHECK(read_file(student.file("progress.txt")) ==
        "# magicmass learn: exercise, verdict, attempts, hints, solution seen (0 or 1)\n"
        "seed 0\nhalf_angle right 2 1 0\n");
  for (const ProgramRun* run : {&list, &show, &wrong, &hint, &right}) {
    require_80_columns(run->output);
    CHECK(run->output.find('\x1b') == std::string::npos);  // a pipe is no terminal
    CHECK(run->errors.empty());
  }
}

TEST_CASE("how an answer was read comes first, then the verdict", "[exam]") {
  const Student student;
  CHECK_THAT(student.learn({"check", "half_angle", "\\frac{1}{1+\\alpha}", "--ascii"}).output,
             StartsWith("Read as: 1/(alpha + 1)\nRight."));
  CHECK_THAT(student.learn({"check", "half_angle", "(1-alpha)/(1-alpha^2)"}).output,
             Contains("Right, in another form than ours"));
  CHECK_THAT(student.learn({"check", "half_angle", "-1/(1+alpha)"}).output,
             Contains("Only the sign is wrong"));
  const ProgramRun form = student.learn({"check", "half_angle", "cos(psi/2)"});
  CHECK(form.exit_code == 1);
  CHECK_THAT(form.output, Contains("Equal to the answer, but a trigonometric function is left"));
}

TEST_CASE("a name that is not asked for is a misconception where one says so", "[exam]") {
  const Student student;
  CHECK(student.check("half_angle", "cos(theta/2)").at("misconception") == "theta for psi");
  CHECK(student.check("angle_of_cycle", "psi/2").at("verdict") == "wrong");
  CHECK(student.check("angle_of_cycle", "psi").at("verdict") == "unread");  // it says nothing
  CHECK(student.check("half_angle", "cos(phi/2)").at("verdict") == "unread");
}

TEST_CASE("a hint ends what is said of a wrong answer, misconception or not", "[exam]") {
  const Student student;
  for (const char* answer : {"cos(psi)", "1+alpha"})
    CHECK_THAT(student.learn({"check", "half_angle", answer}).output, Contains("\nA hint: "));
}

TEST_CASE("a pass of the generator is told in physics, and a broken program by its node",
          "[exam]") {
  const Student student;
  const TemporaryFolder folder;
  const std::string starter = read_file(
      MAGICMASS_SOURCE_DIR "/tutorials/12_formula_to_code/exercises/drop_nodes/answer.cpp");
  const std::string line = "  return {before.nodes, {before.outputs[wanted]}};";
  const auto told = [&](const std::string& body) {
    std::string text = starter;
    text.replace(text.find(line), line.size(), body);
    write_file(folder / "mine.cpp", text);
    return unwrapped(student.learn({"check", "drop_nodes", folder / "mine.cpp"}).output);
  };
  CHECK_THAT(told("  return {before.nodes, {before.outputs[0]}};"),
             Contains("your B moves right at 0.77"));
  CHECK_THAT(told("  return {{before.nodes.rbegin(), before.nodes.rend()}, {0}};"),
             Contains("your program was stopped: it gave up: node 0 of your program uses node"));
  CHECK_THAT(told("  return {before.nodes, {}};"), Contains("has 0 outputs, 1 asked for"));
}

TEST_CASE("the verdict is in the exit code and in JSON", "[exam]") {
  const Student student;
  const nlohmann::json wrong = student.check("half_angle", "cos(psi)");
  CHECK(wrong.at("id") == "half_angle");
  CHECK(wrong.at("verdict") == "wrong");
  CHECK(wrong.at("misconception") == "the angle for half the angle");
  CHECK_THAT(wrong.at("feedback").get<std::string>(), Contains("This is cos(psi)"));
  CHECK(student.check("half_angle", "1/(1+alpha)").at("verdict") == "right");
  CHECK(student.learn({"check", "half_angle", "1/(1+"}).exit_code == 2);
  CHECK(student.check("half_angle", "1/(1+").at("verdict") == "unread");
  CHECK(student.check("half_angle", "1/(1+beta)").at("verdict") == "unread");
  CHECK(student.learn({"check", "half_angle", "-"}, "1/(1+alpha)\n").exit_code == 0);
  CHECK(student.learn({"check", "half_angle", "-alpha"}).exit_code == 1);
}

TEST_CASE("an answer without an id is for the exercise that show shows", "[exam]") {
  const Student student;
  const ProgramRun unread = student.learn({"check", "2V/(1+alpha)"});
  CHECK(unread.exit_code == 2);
  CHECK_THAT(unread.output, StartsWith("Exercise first_contact:\n"));
  const ProgramRun right = student.learn({"check", "u_1 - 2M_2/(M_1+M_2)*(u_1-u_2)"});
  CHECK(right.exit_code == 0);
  const ProgramRun next = student.learn({"check", "1/(1+"});
  CHECK_THAT(next.output, StartsWith("Exercise ") && !StartsWith("Exercise first_contact:"));
  CHECK_THAT(student.learn({"check", "half_angel"}).errors, Contains("did you mean half_angle?"));
}

TEST_CASE("the first wrong line of a derivation is named", "[exam]") {
  const Student student;
  const nlohmann::json chain = student.check(
      "double_angle", "2cos(psi/2)^2 - 1\n2/(1+alpha)^2 - 1\n(1-alpha^2)/(1+alpha)^2");
  CHECK(chain.at("verdict") == "wrong");
  CHECK_THAT(chain.at("feedback").get<std::string>(),
             StartsWith("Line 3 is the first that is not"));
  CHECK(chain.at("read_as").size() == 3);
  const nlohmann::json equations =
      student.check("momentum_lines", "u_1+v_1=u_2+v_2; M_1 u_1+M_2 u_2=M_1 v_1-M_2 v_2; v_1=u_2");
  CHECK_THAT(equations.at("feedback").get<std::string>(), StartsWith("Line 2 is the first"));
  CHECK(student.check("momentum_lines", "u_1+v_1=u_2+v_2").at("verdict") == "form");
}

TEST_CASE("the wrong entry of a matrix is named", "[exam]") {
  const Student student;
  const nlohmann::json verdict =
      student.check("gamma_matrix",
                    "[[(1-alpha)/(1+alpha), 2sqrt(alpha)/(1+alpha)], [2sqrt(alpha)/(1+alpha), 1]]");
  CHECK_THAT(verdict.at("feedback").get<std::string>(), Contains("Row 2, column 2: at alpha = "));
}

TEST_CASE("the solution is shown after an attempt, or on request", "[exam]") {
  const Student student;
  const ProgramRun refused = student.learn({"solution", "golden_ball"});
  CHECK(refused.exit_code == 2);
  CHECK_THAT(refused.errors, Contains("after an attempt, or with --reveal"));
  CHECK_THAT(student.learn({"solution", "golden_ball", "--reveal"}).output,
             StartsWith("sqrt(5) - 2"));
  CHECK_THAT(student.learn({"solution", "digits_of_pi", "--reveal"}).output,
             StartsWith("31\n\n31: the digits"));
  CHECK_THAT(student.learn({"solution", "three_equal", "--reveal"}).output,
             StartsWith("b) B moves on"));
  student.learn({"check", "golden_ball", "1/4"});
  CHECK(student.learn({"solution", "golden_ball"}).exit_code == 0);
  CHECK_THAT(read_file(student.file("progress.txt")), Contains("golden_ball wrong 1 0 1"));
  CHECK(student.learn({"reset", "golden_ball"}).exit_code == 0);
  CHECK(student.learn({"solution", "golden_ball"}).exit_code == 2);
  CHECK(student.learn({"reset"}).exit_code == 2);
}

TEST_CASE("answers come from the student's file, and stay there", "[exam]") {
  const Student student;
  CHECK(student.learn({"check", "golden_ball"}).exit_code == 2);  // nothing there yet
  student.learn({"show", "golden_ball"});
  const std::string file = student.file("06_magic_ratios/golden_ball/answer.txt");
  CHECK(std::filesystem::exists(student.file("06_magic_ratios/golden_ball/prompt.txt")));
  CHECK_THAT(student.learn({"check", "golden_ball"}).output, Contains("There is no answer yet"));
  write_file(file, "# mine\nsqrt(5) - 2\n");
  CHECK(student.learn({"check", "golden_ball"}).exit_code == 0);
  student.learn({"check", "golden_ball", "√5 − 2"});
  CHECK(read_file(file) == "√5 − 2\n");
  student.learn({"check", "golden_ball", "1/4"});  // a wrong one does not take its place
  CHECK(read_file(file) == "√5 − 2\n");
}

TEST_CASE("seeds choose variants, and are kept", "[exam]") {
  const Student student;
  CHECK_THAT(student.learn({"show", "exact_speeds", "--seed", "1"}).output, Contains("1/5"));
  CHECK_THAT(student.learn({"show", "exact_speeds"}).output, Contains("1/5"));
  CHECK(student.check("exact_speeds", "147/64").at("verdict") == "wrong");  // that is for 1/7
}

TEST_CASE("a prediction is followed by what happens", "[exam]") {
  const Student student;
  const ProgramRun right = student.learn({"check", "three_equal", "b"});
  CHECK(right.exit_code == 0);
  CHECK_THAT(right.output, Contains("N_A") && Contains("first magic mass ratio"));
  const ProgramRun wrong = student.learn({"check", "three_equal", "a"});
  CHECK(wrong.exit_code == 1);
  CHECK(wrong.output.find("N_A") == std::string::npos);
  CHECK(student.learn({"check", "three_equal", "z"}).exit_code == 2);
}

TEST_CASE("watch checks what is saved and goes on", "[exam]") {
  const Student student;
  student.learn({"show", "half_angle"});
  std::thread writer([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(1500));
    write_file(student.file("03_axis_and_angle/half_angle/answer.txt"), "1/(1+alpha)\n");
  });
  const ProgramRun run = student.learn({"watch", "half_angle", "--seconds", "4"});
  writer.join();
  CHECK(run.exit_code == 0);
  CHECK_THAT(run.output,
             Contains("Watching") && Contains("Right.") && Contains("The angle of a cycle\n==="));
  CHECK(run.output.find('\x1b') == std::string::npos);
}

TEST_CASE("a spoiled progress file is named with its line", "[exam]") {
  const Student student;
  student.learn({"show", "half_angle"});
  write_file(student.file("progress.txt"), "seed 0\nhalf_angle perfect 1 0 0\n");
  const ProgramRun run = student.learn({"list"});
  CHECK(run.exit_code == 2);
  CHECK(lines_of(run.errors).size() == 1);
  CHECK_THAT(run.errors, Contains("progress.txt: line 2: ") && Contains("allowed: "));
}

TEST_CASE("misspelt exercises and folders that cannot be made get one line", "[exam]") {
  const ProgramRun run = run_program({"learn", "show", "half_angel"});
  CHECK(run.exit_code == 2);
  CHECK_THAT(run.errors, Contains("did you mean half_angle?"));
  for (const std::vector<std::string>& bad : std::vector<std::vector<std::string>>{
           {"learn"},
           {"learn", "shwo"},
           {"learn", "check"},  // neither an exercise nor an answer
           {"learn", "show", "half_angle", "--folder", "/dev/null/x"},
           {"learn", "list", "--content", "/nowhere"}}) {
    const ProgramRun refused = run_program(bad);
    CHECK(refused.exit_code == 2);
    CHECK(lines_of(refused.errors).size() == 1);
  }
}
