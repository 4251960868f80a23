// SPDX-License-Identifier: GPL-2.0-or-later
#include "command/report/sympy_contestants.hpp"

#include <cstdlib>
#include <limits>
#include <memory>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "command/report/exact_formulas.hpp"
#include "command/report/subprocess.hpp"

namespace magicmass::command {
namespace {

using report::Contestant;
using report::Input;

/// Answers a line with a line. Doubles travel as hex floats.
constexpr const char* script = R"(
import signal, sys, time
signal.signal(signal.SIGINT, signal.SIG_IGN)
try:
    import numpy, sympy
except ImportError:
    print("missing", flush=True)
    sys.exit()
numpy.seterr(all="ignore")
print("ready", sympy.__version__, numpy.__version__, flush=True)
functions, arrays = [], []
def call(which):
    return functions[which](*arrays[:functions[which].__code__.co_argcount])
for line in sys.stdin:
    words = line.split()
    if words[0] == "define":
        names = words[1].split(",")
        symbols = [sympy.Symbol(name, positive=True) for name in names]
        meaning = {"Pi": sympy.pi, **dict(zip(names, symbols))}
        outputs = [sympy.sympify(text, meaning) for text in line.split(None, 2)[2].split(";")]
        if not all(one.free_symbols <= set(symbols) for one in outputs):
            break
        functions.append(sympy.lambdify(symbols, outputs, "numpy"))
        print("ok", flush=True)
    elif words[0] == "load":
        columns = [[float.fromhex(word) for word in column.split(",")] for column in words[1:]]
        arrays = [numpy.array(column) for column in columns]
        print("ok", flush=True)
    elif words[0] == "values":
        results = [numpy.broadcast_to(one, arrays[0].shape) for one in call(int(words[1]))]
        print(" ".join(float(one[0]).hex() for one in results), flush=True)
    elif words[0] == "time":
        which, repetitions = int(words[1]), range(int(words[2]))
        start = time.perf_counter_ns()
        for _ in repetitions:
            call(which)
        print(time.perf_counter_ns() - start, flush=True)
)";

/// The process and what it has been given last.
class Peer {
public:
  Peer() : process_({"python3", "-c", script}) {}

  std::string ask(const std::string& line) { return process_.ask(line); }

  /// A process that has ended is no error of SymPy's.
  std::string answer(const std::string& line) {
    std::string answer = ask(line);
    if (answer.empty()) throw std::runtime_error("the peers' python3 has ended unexpectedly");
    return answer;
  }

  void load(std::span<const Input> inputs, const std::vector<std::string>& names) {
    std::string line = "load";
    for (const std::string& name : names)
      for (std::size_t i = 0; i < inputs.size(); ++i)
        line += fmt::format("{}{:a}", i == 0 ? " " : ",", input_named(name, inputs[i]));
    if (line == loaded_) return;
    answer(line);
    loaded_ = std::move(line);
  }

private:
  Subprocess process_;
  std::string loaded_;
};

Contestant contestant(const codegen::Form& form, const std::shared_ptr<Peer>& peer,
                      std::size_t number) {
  Contestant one;
  one.name = "sympy_" + form.name;
  one.quantity = form.quantity;
  one.derived_form = form.name;
  one.form = "sympy";
  one.precision = "double";
  one.can = [](const Input&) { return true; };
  const std::vector<std::string> names = inputs_of(form);
  const std::size_t size = form.outputs.size();
  one.evaluate = [=](const Input& input, long double* members) {
    peer->load({&input, 1}, names);
    std::istringstream answer(peer->answer(fmt::format("values {}", number)));
    for (std::size_t i = 0; i < size; ++i) {
      std::string word;
      members[i] = answer >> word ? static_cast<long double>(std::strtod(word.c_str(), nullptr))
                                  : std::numeric_limits<long double>::quiet_NaN();
    }
  };
  one.own_clock = [=](std::span<const Input> inputs, std::size_t repetitions) {
    peer->load(inputs, names);
    const std::string answer = peer->answer(fmt::format("time {} {}", number, repetitions));
    return std::strtod(answer.c_str(), nullptr);
  };
  one.evaluate_all = [clock = one.own_clock](std::span<const Input> inputs) { clock(inputs, 1); };
  return one;
}

}  // namespace

std::vector<Contestant> sympy_contestants(const std::vector<DerivedForm>& forms,
                                          std::vector<std::string>& remarks) {
  const auto peer = std::make_shared<Peer>();
  const std::string greeting = peer->ask("");
  if (!greeting.starts_with("ready")) {
    remarks.emplace_back(
        "skipped: SymPy on NumPy needs python3 with both (Debian: python3-sympy, python3-numpy)");
    return {};
  }
  std::vector<Contestant> all;
  for (const DerivedForm& derived : forms) {
    const codegen::Form& form = derived.form;
    const std::string line = fmt::format("define {} {}", fmt::join(inputs_of(form), ","),
                                         fmt::join(outputs_in_python(derived), ";"));
    if (peer->ask(line) == "ok") {
      all.push_back(contestant(form, peer, all.size()));
    } else {
      remarks.push_back("skipped: SymPy could not read " + form.function());
      return all;  // the process has ended
    }
  }
  std::string versions = greeting.substr(greeting.find(' ') + 1);
  remarks.push_back("peers: SymPy and NumPy " + versions);
  return all;
}

}  // namespace magicmass::command
