#include "command/command.hpp"

int main(int argc, char** argv) {
  return command::run_program(command::magicmass(), {argv + (argc > 0 ? 1 : 0), argv + argc});
}
