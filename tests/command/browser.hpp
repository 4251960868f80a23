// SPDX-License-Identifier: GPL-2.0-or-later
// A page in headless Chromium, driven over its debugging pipe: real keys, as a person presses them.
#pragma once

#include <optional>
#include <string>

#include <nlohmann/json.hpp>
#include <sys/types.h>

#include "program_run.hpp"

class Browser {
public:
  /// False where there is no Chromium; the test is then to be skipped.
  static bool is_installed();

  /// Throws std::runtime_error where it does not start or does not answer within half a minute.
  Browser();
  Browser(const Browser&) = delete;
  Browser(Browser&&) = delete;
  Browser& operator=(const Browser&) = delete;
  Browser& operator=(Browser&&) = delete;
  ~Browser();

  /// A media feature, e.g. prefers-reduced-motion, for the pages opened afterwards.
  void prefer(const std::string& feature, const std::string& value);
  void set_width(int pixels);
  /// Opens a file and waits for its scripts.
  void open(const std::string& path);
  /// " ", "ArrowLeft", "Tab", ...: down and up.
  void press(const std::string& key);
  /// The value of a JavaScript expression.
  nlohmann::json value(const std::string& expression);
  /// Until it is true, or false after ten seconds.
  bool becomes_true(const std::string& expression);

private:
  TemporaryFolder profile_;
  int to_ = -1;
  int from_ = -1;
  pid_t child_ = 0;
  int last_id_ = 0;
  std::string session_;
  std::string unread_;

  nlohmann::json call(const std::string& method, nlohmann::json parameters = {});
  nlohmann::json next_message();
};
