// SPDX-License-Identifier: GPL-2.0-or-later
#include "browser.hpp"

#include <array>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <map>
#include <sstream>
#include <stdexcept>
#include <thread>

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

namespace {

constexpr int patience = 30'000;  // milliseconds
constexpr int pipe_in = 3;        // --remote-debugging-pipe reads here
constexpr int pipe_out = 4;       // and writes there

/// The ends that this process keeps are closed in its children.
std::array<int, 2> new_pipe() {
  std::array<int, 2> ends{};
  if (::pipe2(ends.data(), O_CLOEXEC) != 0) throw std::runtime_error("no pipe");
  for (int& end : ends) {  // clear of the numbers that the child wants
    const int moved = ::fcntl(end, F_DUPFD_CLOEXEC, 10);
    ::close(end);
    end = moved;
  }
  return ends;
}

}  // namespace

bool Browser::is_installed() {
  const char* path = std::getenv("PATH");
  std::istringstream folders(path == nullptr ? "" : path);
  for (std::string folder; std::getline(folders, folder, ':');)
    if (::access((folder + "/chromium").c_str(), X_OK) == 0) return true;
  return false;
}

Browser::Browser() {
  const auto commands = new_pipe(), answers = new_pipe();
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, commands[0], pipe_in);
  posix_spawn_file_actions_adddup2(&actions, answers[1], pipe_out);
  posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
  std::array<std::string, 7> words = {
      "chromium",
      "--headless",
      "--no-sandbox",  // of no use to a page of our own; roots and containers lack it
      "--disable-gpu",
      "--remote-debugging-pipe",
      "--user-data-dir=" + profile_.path().string(),
      "about:blank"};
  std::array<char*, 8> arguments{};
  for (std::size_t i = 0; i < words.size(); ++i) arguments[i] = words[i].data();
  posix_spawnattr_t own_group;  // of all its processes, so that none outlives it
  posix_spawnattr_init(&own_group);
  posix_spawnattr_setflags(&own_group, POSIX_SPAWN_SETPGROUP);
  const int error =
      ::posix_spawnp(&child_, "chromium", &actions, &own_group, arguments.data(), environ);
  posix_spawnattr_destroy(&own_group);
  posix_spawn_file_actions_destroy(&actions);
  ::close(commands[0]);
  ::close(answers[1]);
  to_ = commands[1];
  from_ = answers[0];
  if (error != 0) throw std::runtime_error("Chromium does not start");
  const auto target = call("Target.createTarget", {{"url", "about:blank"}})["targetId"];
  session_ = call("Target.attachToTarget", {{"targetId", target}, {"flatten", true}})["sessionId"];
}

Browser::~Browser() {
  ::close(to_);
  ::close(from_);
  ::kill(-child_, SIGKILL);
  ::waitpid(child_, nullptr, 0);
}

nlohmann::json Browser::next_message() {
  std::size_t end = unread_.find('\0');
  while (end == std::string::npos) {
    pollfd waiting{from_, POLLIN, 0};
    std::array<char, 4096> bytes{};
    const ssize_t got =
        ::poll(&waiting, 1, patience) == 1 ? ::read(from_, bytes.data(), bytes.size()) : 0;
    if (got <= 0) throw std::runtime_error("Chromium does not answer");
    unread_.append(bytes.data(), static_cast<std::size_t>(got));
    end = unread_.find('\0');
  }
  nlohmann::json message = nlohmann::json::parse(unread_.substr(0, end));
  unread_.erase(0, end + 1);
  return message;
}

nlohmann::json Browser::call(const std::string& method, nlohmann::json parameters) {
  nlohmann::json message = {{"id", ++last_id_}, {"method", method}};
  if (!parameters.is_null()) message["params"] = std::move(parameters);
  if (!session_.empty()) message["sessionId"] = session_;
  const std::string text = message.dump();
  if (::write(to_, text.c_str(), text.size() + 1) < 0)
    throw std::runtime_error("Chromium does not listen");
  for (;;) {
    nlohmann::json answer = next_message();
    if (answer.value("id", 0) != last_id_) continue;  // an event
    if (answer.contains("error")) throw std::runtime_error(method + ": " + answer["error"].dump());
    return answer["result"];
  }
}

void Browser::prefer(const std::string& feature, const std::string& value) {
  call("Emulation.setEmulatedMedia", {{"features", {{{"name", feature}, {"value", value}}}}});
}

void Browser::set_width(int pixels) {
  call("Emulation.setDeviceMetricsOverride",
       {{"width", pixels}, {"height", 800}, {"deviceScaleFactor", 1}, {"mobile", false}});
}

void Browser::open(const std::string& path) {
  call("Page.navigate", {{"url", "file://" + path}});
  if (!becomes_true("location.protocol === 'file:' && document.readyState === 'complete'"))
    throw std::runtime_error("Chromium does not open " + path);
}

void Browser::press(const std::string& key) {
  const std::map<std::string, int> codes = {{"Tab", 9},   {" ", 32},         {"End", 35},
                                            {"Home", 36}, {"ArrowLeft", 37}, {"ArrowRight", 39}};
  nlohmann::json event = {
      {"type", "keyDown"}, {"key", key}, {"windowsVirtualKeyCode", codes.at(key)}};
  if (key == " ") event["text"] = key;
  call("Input.dispatchKeyEvent", event);
  event["type"] = "keyUp";
  call("Input.dispatchKeyEvent", event);
}

nlohmann::json Browser::value(const std::string& expression) {
  return call("Runtime.evaluate", {{"expression", expression}, {"returnByValue", true}})["result"]
      .value("value", nlohmann::json());
}

bool Browser::becomes_true(const std::string& expression) {
  for (int tries = 0; tries < 500; ++tries) {
    if (value(expression) == true) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  return false;
}
