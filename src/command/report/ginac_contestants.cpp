// SPDX-License-Identifier: GPL-2.0-or-later
#include "command/report/ginac_contestants.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <csignal>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

#include <cln/cln.h>
#include <fcntl.h>
#include <ginac/ginac.h>
#include <unistd.h>

#include "codegen/forms.hpp"
#include "command/report/exact_formulas.hpp"
#include "command/scratch_folder.hpp"
#include "magicmass/reference/rational.hpp"
#include "proof/names.hpp"

namespace magicmass::command {
namespace {

using report::Contestant;
using report::Input;

constexpr std::size_t most_outputs = 8;
using Outputs = std::array<double, most_outputs>;

/// The shell that compile_ex runs complains on stderr; the caller says it in one line.
class SilentErrors {
public:
  SilentErrors() : saved_(::dup(STDERR_FILENO)) {
    const int nowhere = ::open("/dev/null", O_WRONLY | O_CLOEXEC);
    ::dup2(nowhere, STDERR_FILENO);
    ::close(nowhere);
  }
  SilentErrors(const SilentErrors&) = delete;
  SilentErrors(SilentErrors&&) = delete;
  SilentErrors& operator=(const SilentErrors&) = delete;
  SilentErrors& operator=(SilentErrors&&) = delete;
  ~SilentErrors() {
    ::dup2(saved_, STDERR_FILENO);
    ::close(saved_);
  }

private:
  int saved_;
};

/// Ctrl-C waits until the object is gone, for the compiler too: else it would end the compiler and, while the shell runs,
/// be lost to us.
class InterruptLater {
public:
  InterruptLater() {
    sigset_t interrupt;
    ::sigemptyset(&interrupt);
    ::sigaddset(&interrupt, SIGINT);
    ::sigprocmask(SIG_BLOCK, &interrupt, &saved_);
  }
  InterruptLater(const InterruptLater&) = delete;
  InterruptLater(InterruptLater&&) = delete;
  InterruptLater& operator=(const InterruptLater&) = delete;
  InterruptLater& operator=(InterruptLater&&) = delete;
  ~InterruptLater() { ::sigprocmask(SIG_SETMASK, &saved_, nullptr); }

private:
  sigset_t saved_;
};

std::optional<GiNaC::FUNCP_CUBA> compiled(const std::vector<GiNaC::ex>& outputs,
                                          const std::vector<std::string>& inputs) {
  GiNaC::lst formulas;
  GiNaC::lst symbols;
  for (const GiNaC::ex& output : outputs) formulas.append(output);
  for (const std::string& name : inputs) symbols.append(proof::symbol(name));
  GiNaC::FUNCP_CUBA function = nullptr;
  const SilentErrors silence;
  const InterruptLater later;
  // ginac-excompiler hands them to gcc; GiNaC leaves pi in C as the name that it has for it.
  ::setenv("CXXFLAGS", "-O2 -ffp-contract=off -DPi=M_PI", 1);
  try {
    // GiNaC would leave its files where the user stands; what is loaded stays so without its file
    const ScratchFolder scratch;
    GiNaC::compile_ex(formulas, symbols, function, scratch.file("formulas"));
  } catch (const std::runtime_error&) {
    return std::nullopt;
  }
  return function;
}

/// input alone: the compiler is not to know that the mask is 0.
Input after(Input input, double previous) {
  std::uint64_t mask = 0;
  asm volatile("" : "+r"(mask));
  mask &= std::bit_cast<std::uint64_t>(previous);
  input.alpha = std::bit_cast<double>(std::bit_cast<std::uint64_t>(input.alpha) | mask);
  input.index = static_cast<std::int64_t>(static_cast<std::uint64_t>(input.index) | mask);
  return input;
}

template <class Call>
Contestant contestant(const codegen::Form& form, const std::string& how, const Call& call) {
  Contestant one;
  one.name = how + "_" + form.name;
  one.quantity = form.quantity;
  one.derived_form = form.name;
  one.form = how;
  one.precision = "double";
  one.is_reproducible = false;
  one.can = [](const Input&) { return true; };
  const std::size_t size = form.outputs.size();
  one.evaluate = [call, size](const Input& input, long double* members) {
    Outputs outputs{};
    call(input, outputs);
    for (std::size_t i = 0; i < size; ++i) members[i] = static_cast<long double>(outputs[i]);
  };
  one.evaluate_all = [call](std::span<const Input> inputs) {
    Outputs outputs{};
    for (const Input& input : inputs) {
      call(input, outputs);
      asm volatile("" : : "m"(outputs) : "memory");
    }
  };
  one.evaluate_chained = [call](std::span<const Input> inputs) {
    Outputs outputs{};
    for (const Input& input : inputs) call(after(input, outputs[0]), outputs);
    asm volatile("" : : "m"(outputs) : "memory");
  };
  return one;
}

Contestant compiled_contestant(const codegen::Form& form, GiNaC::FUNCP_CUBA function) {
  const int outputs_size = static_cast<int>(form.outputs.size());
  const std::vector<std::string> names = inputs_of(form);
  const auto takes = [&](const std::string& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
  };
  const bool takes_alpha = takes("alpha");
  const bool takes_e = takes("e");
  const bool takes_index = !form.index.empty();
  const auto call = [=](const Input& input, Outputs& outputs) {
    double x[3];
    int size = 0;
    if (takes_alpha) x[size++] = input.alpha;
    if (takes_e) x[size++] = input.e;
    if (takes_index) x[size++] = static_cast<double>(input.index);
    function(&size, x, &outputs_size, outputs.data());
  };
  return contestant(form, "compile_ex", call);
}

/// CLN's doubles know no subnormal numbers, its long floats have exponents enough.
GiNaC::numeric widened(double x) {
  const cln::float_format_t digits = cln::float_format(static_cast<unsigned>(GiNaC::Digits));
  return GiNaC::numeric(cln::cl_float(reference::exact(x), digits));
}

Contestant evalf_contestant(const codegen::Form& form,
                            const std::shared_ptr<const std::vector<GiNaC::ex>>& shared) {
  const auto call = [form, shared](const Input& input, Outputs& outputs) {
    outputs.fill(std::numeric_limits<double>::quiet_NaN());
    try {
      GiNaC::lst values;
      for (const std::string& name : inputs_of(form))
        values.append(proof::symbol(name) == (name == form.index
                                                  ? GiNaC::numeric(static_cast<long>(input.index))
                                                  : widened(input_named(name, input))));
      for (std::size_t i = 0; i < shared->size(); ++i) {
        const GiNaC::ex value = (*shared)[i].subs(values).evalf();
        if (GiNaC::is_a<GiNaC::numeric>(value) && value.info(GiNaC::info_flags::real))
          outputs[i] = cln::double_approx(
              cln::the<cln::cl_R>(GiNaC::ex_to<GiNaC::numeric>(value).to_cl_N()));
      }
    } catch (const std::exception&) {  // division by zero, 1/cos(Pi/2)
    }
  };
  Contestant one = contestant(form, "evalf", call);
  one.expected_ns = [size = form.outputs.size()](const Input&) {
    return 1e4 * static_cast<double>(size);
  };
  return one;
}

}  // namespace

std::vector<Contestant> ginac_contestants(const std::vector<DerivedForm>& forms,
                                          std::vector<std::string>& remarks) {
  std::vector<Contestant> all;
  bool has_compiler = true;
  for (const auto& [form, outputs] : forms) {
    if (form.outputs.size() > most_outputs) continue;
    if (form.name == "closed") all.push_back(evalf_contestant(form, outputs));
    if (!has_compiler) continue;
    if (const auto function = compiled(*outputs, inputs_of(form)))
      all.push_back(compiled_contestant(form, *function));
    else
      has_compiler = false;
  }
  if (!has_compiler)
    remarks.emplace_back(
        "skipped: GiNaC's compile_ex needs gcc and ginac-excompiler (Debian: ginac-tools)");
  return all;
}

}  // namespace magicmass::command
