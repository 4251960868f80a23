// SPDX-License-Identifier: GPL-2.0-or-later
#include "command/report/ginac_contestants.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <limits>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <system_error>
#include <utility>

#include <cln/cln.h>
#include <fcntl.h>
#include <ginac/ginac.h>
#include <unistd.h>

#include "codegen/forms.hpp"
#include "command/report/derived_formulas.hpp"
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

/// A folder of our own, gone with the object: GiNaC would leave its files where the user stands when interrupted.
class ScratchFolder {
public:
  ScratchFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "magicmass-XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr) throw std::runtime_error("no folder for scratch files");
    path_ = name;
  }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder(ScratchFolder&&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  ScratchFolder& operator=(ScratchFolder&&) = delete;
  ~ScratchFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  std::string file(const char* name) const { return (path_ / name).string(); }

private:
  std::filesystem::path path_;
};

std::optional<GiNaC::FUNCP_CUBA> compiled(const std::vector<GiNaC::ex>& outputs,
                                          const std::vector<std::string>& inputs) {
  GiNaC::lst formulas;
  GiNaC::lst symbols;
  for (const GiNaC::ex& output : outputs) formulas.append(output);
  for (const std::string& name : inputs) symbols.append(proof::symbol(name));
  GiNaC::FUNCP_CUBA function = nullptr;
  const SilentErrors silence;
  // ginac-excompiler hands them to gcc; GiNaC leaves pi in C as the name that it has for it.
  ::setenv("CXXFLAGS", "-O2 -ffp-contract=off -DPi=M_PI", 1);
  try {
    const ScratchFolder scratch;  // what is loaded stays so without its file
    GiNaC::compile_ex(formulas, symbols, function, scratch.file("formulas"));
  } catch (const std::runtime_error&) {
    return std::nullopt;
  }
  return function;
}

/// x alone: the compiler is not to know that the mask is 0.
double after(double x, double previous) {
  std::uint64_t mask = 0;
  asm volatile("" : "+r"(mask));
  return std::bit_cast<double>(std::bit_cast<std::uint64_t>(x) |
                               (std::bit_cast<std::uint64_t>(previous) & mask));
}

bool is_among(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

template <class Call>
Contestant contestant(const codegen::Form& form, const std::string& how, const Call& call) {
  Contestant one;
  one.name = how + "_" + form.name;
  one.quantity = form.quantity;
  one.form = how;
  one.precision = "double";
  one.is_reproducible = false;
  one.can = [](const Input&) { return true; };
  const std::size_t size = form.outputs.size();
  one.evaluate = [call, size](const Input& input, long double* members) {
    Outputs outputs{};
    call(input.alpha, static_cast<double>(input.index), input.index, outputs);
    for (std::size_t i = 0; i < size; ++i) members[i] = static_cast<long double>(outputs[i]);
  };
  one.evaluate_all = [call](std::span<const Input> inputs) {
    Outputs outputs{};
    for (const Input& input : inputs) {
      call(input.alpha, static_cast<double>(input.index), input.index, outputs);
      asm volatile("" : : "m"(outputs) : "memory");
    }
  };
  one.evaluate_chained = [call](std::span<const Input> inputs) {
    Outputs outputs{};
    for (const Input& input : inputs)
      call(after(input.alpha, outputs[0]), after(static_cast<double>(input.index), outputs[0]),
           input.index, outputs);
    asm volatile("" : : "m"(outputs) : "memory");
  };
  return one;
}

Contestant compiled_contestant(const codegen::Form& form, GiNaC::FUNCP_CUBA function) {
  const int outputs_size = static_cast<int>(form.outputs.size());
  const bool takes_alpha = !form.real_inputs.empty();
  const bool takes_index = !form.indices.empty();
  const auto call = [=](double alpha, double index, std::int64_t, Outputs& outputs) {
    double x[2];
    int size = 0;
    if (takes_alpha) x[size++] = alpha;
    if (takes_index) x[size++] = index;
    function(&size, x, &outputs_size, outputs.data());
  };
  return contestant(form, "compile_ex", call);
}

/// CLN's doubles know no subnormal numbers, its long floats have exponents enough.
GiNaC::numeric widened(double x) {
  const cln::float_format_t digits = cln::float_format(static_cast<unsigned>(GiNaC::Digits));
  return GiNaC::numeric(cln::cl_float(reference::exact(x), digits));
}

Contestant evalf_contestant(const codegen::Form& form, const std::vector<GiNaC::ex>& formulas) {
  const auto shared = std::make_shared<const std::vector<GiNaC::ex>>(formulas);
  const auto call = [form, shared](double alpha, double, std::int64_t index, Outputs& outputs) {
    outputs.fill(std::numeric_limits<double>::quiet_NaN());
    try {
      GiNaC::lst values;
      for (const std::string& name : form.real_inputs)
        values.append(proof::symbol(name) == widened(alpha));
      for (const std::string& name : form.indices)
        values.append(proof::symbol(name) == GiNaC::numeric(static_cast<long>(index)));
      for (std::size_t i = 0; i < shared->size(); ++i) {
        const GiNaC::ex value = (*shared)[i].subs(values).evalf();
        if (GiNaC::is_a<GiNaC::numeric>(value))
          outputs[i] = cln::double_approx(
              cln::the<cln::cl_R>(GiNaC::ex_to<GiNaC::numeric>(value).to_cl_N()));
      }
    } catch (const std::exception&) {  // division by zero, 1/cos(Pi/2)
    }
  };
  return contestant(form, "evalf", call);
}

}  // namespace

std::vector<Contestant> ginac_contestants(const std::vector<proof::Theorem>& theorems,
                                          const std::vector<std::string>& quantities,
                                          std::vector<std::string>& remarks) {
  std::vector<Contestant> all;
  bool has_compiler = true;
  for (const codegen::Form& form : codegen::forms()) {
    if (form.exact || form.outputs.size() > most_outputs || !is_among(quantities, form.quantity))
      continue;
    const std::vector<GiNaC::ex> formulas = derived_outputs(form, theorems);
    if (form.name == "closed") all.push_back(evalf_contestant(form, formulas));
    if (!has_compiler) continue;
    if (const auto function = compiled(formulas, inputs_of(form)))
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
