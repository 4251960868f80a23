// SPDX-License-Identifier: GPL-2.0-or-later
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>

#include "long_run/plan.hpp"

namespace magicmass::long_run {
namespace {

/// Which chunk of which row is next, and what was found; CLN, which draws and knows, is for one thread at a time.
class Work {
public:
  Work(const Plan& plan, std::vector<Row>& rows) : plan_(plan), rows_(rows) {}

  void do_until_none_is_left() {
    try {
      for (;;) {
        Row* row = nullptr;
        Inputs inputs;
        Tally found;
        {
          const std::lock_guard lock(mutex_);
          if (failure_ || row_ == rows_.size()) return;
          row = &rows_[row_];
          inputs = chunk(*row, chunk_);
          if (inputs.empty()) {
            ++row_;
            chunk_ = 0;
            continue;
          }
          ++chunk_;
          found = against_oracle(row->quantity, inputs, plan_.oracle_every);
        }
        found += checked(row->quantity, inputs);
        const std::lock_guard lock(mutex_);
        row->tally += found;
      }
    } catch (...) {
      const std::lock_guard lock(mutex_);
      failure_ = std::current_exception();
    }
  }
  void rethrow() const {
    if (failure_) std::rethrow_exception(failure_);
  }

private:
  const Plan& plan_;
  std::vector<Row>& rows_;
  std::mutex mutex_;
  std::size_t row_ = 0;
  std::int64_t chunk_ = 0;
  std::exception_ptr failure_;
};

}  // namespace

void run(const Plan& plan, std::vector<Row>& rows) {
  Work work(plan, rows);
  const unsigned threads =
      plan.threads > 0 ? plan.threads : std::max(1U, std::thread::hardware_concurrency());
  std::vector<std::jthread> others;
  for (unsigned i = 1; i < threads; ++i)
    others.emplace_back([&work] { work.do_until_none_is_left(); });
  work.do_until_none_is_left();
  others.clear();
  work.rethrow();
}

}  // namespace magicmass::long_run
