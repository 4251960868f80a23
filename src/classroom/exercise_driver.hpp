// The program in which an exercise's driver and an answer in code run: it reads the cases before
// any other code runs, hands each to call(), and writes results to descriptor 3 behind a seal.
#include <cstdio>
#include <cstdlib>

#include <unistd.h>

/// The exercise's driver: calls the student's function with a case's inputs.
void call(const double* inputs, double* outputs);

namespace {

char text[1 << 16];  // SEAL OUTPUTS INPUTS, and the inputs of each case

void read_cases() {
  std::size_t size = 0;
  for (ssize_t count = 1; count > 0 && size + 1 < sizeof text; size += std::size_t(count))
    count = read(0, text + size, sizeof text - 1 - size);
}
[[gnu::section(".preinit_array"), gnu::used]] void (*const first)() = read_cases;

}  // namespace

int main() {
  char seal[40];
  int outputs = 0, inputs = 0, length = 0;
  std::sscanf(text, "%39s %d %d%n", seal, &outputs, &inputs, &length);
  char* at = text + length;
  for (;;) {
    double given[16], results[16] = {};
    char line[1024];
    char* end = at;
    for (int i = 0; i < inputs; ++i) {
      given[i] = std::strtod(at, &end);
      if (end == at)  // the last case was the one before
        _exit(write(3, line, std::size_t(std::snprintf(line, sizeof line, "%s end\n", seal))) < 0);
      at = end;
    }
    call(given, results);
    int size = std::snprintf(line, sizeof line, "%s", seal);
    for (int i = 0; i < outputs; ++i)
      size += std::snprintf(line + size, sizeof line - std::size_t(size), " %a", results[i]);
    line[size] = '\n';
    if (write(3, line, std::size_t(size) + 1) < 0) _exit(1);
  }
}
