// SPDX-License-Identifier: GPL-2.0-or-later
// Animations: one page of each kind of scene, what it is told, and, where there is Chromium, driven by its keys.
#include <chrono>
#include <string>
#include <thread>
#include <vector>

#include <catch2/catch.hpp>

#include "browser.hpp"
#include "program_run.hpp"
#include "refusal.hpp"

namespace {

const std::string scenes = std::string(MAGICMASS_SOURCE_DIR) + "/tutorials/scenes/";

nlohmann::json motion_of(const std::string& page) {
  const std::string before = "id=\"motion\">";
  const std::size_t begin = page.find(before) + before.size();
  return nlohmann::json::parse(page.substr(begin, page.find("</script>", begin) - begin));
}

std::string animation(const std::string& scene) {
  const ProgramRun run = run_program({"animate", scenes + scene + ".toml"});
  INFO(run.errors);
  REQUIRE(run.exit_code == 0);
  return run.output;
}

/// What a person sees who drives the page by keys, or what is wrong with it; nothing if all is well.
std::string complaint(Browser& browser, const std::string& path) {
  const auto done = [&] { return browser.value("document.documentElement.dataset.done"); };
  const std::string time = "Number(document.documentElement.dataset.time)";
  const auto place = [&] {
    return browser.value("document.getElementById('body-1').getAttribute('transform')");
  };
  browser.open(path);
  if (done() != "0") return "does not begin before the first collision";
  const auto start = place();
  browser.press("ArrowRight");
  browser.press("ArrowRight");
  if (done() != "2") return "does not step forward";
  const auto second = place();
  browser.press("ArrowRight");
  browser.press("ArrowLeft");
  if (done() != "2" || place() != second) return "does not step back";
  browser.press("End");
  if (done() != "6" || place() == start) return "does not go to the end";
  browser.press("Home");
  if (done() != "0" || place() != start) return "does not go to the start";
  browser.press(" ");
  if (!browser.becomes_true(time + " > -0.9")) return "does not play";
  browser.press(" ");
  const double paused = browser.value(time);
  std::this_thread::sleep_for(std::chrono::milliseconds(200));
  if (browser.value(time) != paused) return "does not pause";
  browser.press("Tab");
  browser.press("Tab");
  if (browser.value("document.activeElement.textContent") != "Step back")
    return "has no buttons for Tab";
  if (browser.value("getComputedStyle(document.activeElement).outlineStyle") != "solid")
    return "does not show the focus";
  return "";
}

}  // namespace

TEST_CASE("each kind of scene becomes one page that names nothing outside", "[exam]") {
  for (const char* scene :
       {"trajectory_a", "unequal_blocks", "wall", "chain", "cradle", "collapse"}) {
    INFO(scene);
    const std::string page = animation(scene);
    CHECK(page.size() < 300'000);
    for (const char* outside : {"http:", "https:", "src=", "href=", "@import", "url("})
      CHECK(page.find(outside) == std::string::npos);
    const auto motion = motion_of(page);
    CHECK(motion["contacts"].size() > 1);
    CHECK(motion["begin"] < motion["end"]);
  }
}

TEST_CASE("a page has the collisions of the event engine", "[exam]") {
  const auto events = json_of({"simulate", scenes + "trajectory_c.toml"})["events"];
  const auto contacts = motion_of(animation("trajectory_c"))["contacts"];
  REQUIRE(contacts.size() == events.size());
  REQUIRE(contacts.size() == 7);
  for (std::size_t i = 0; i < events.size(); ++i) {
    CHECK(contacts[i][0].get<double>() == Approx(events[i]["time"].get<double>()).epsilon(1e-13));
    CHECK(contacts[i][1].get<double>() ==
          Approx(events[i]["position"].get<double>()).epsilon(1e-13));
    CHECK(contacts[i][2] == (events[i]["body"] == "A" ? 1 : 2));
  }
}

TEST_CASE("a scene of too many collisions is cut, and one line says so", "[exam]") {
  const ProgramRun cut = run_program({"animate", scenes + "wall.toml", "--max-events", "10"});
  CHECK(cut.exit_code == 0);
  CHECK(lines_of(cut.errors).size() == 1);
  CHECK(cut.errors.find("ends after 10 collisions; --max-events N, up to 20000") !=
        std::string::npos);
  CHECK(motion_of(cut.output)["contacts"].size() == 10);
  const ProgramRun longest =
      run_program({"animate", scenes + "wall.toml", "--max-events", "20000"});
  CHECK(lines_of(longest.errors).size() == 1);
  CHECK(longest.errors.find("20000 collisions, the most that a page shows") != std::string::npos);
  CHECK(longest.output.size() < 3'000'000);
  CHECK(cut.output.find("Shown are the first 10 collisions") != std::string::npos);
}

TEST_CASE("a title is text in the page, whatever it holds", "[exam]") {
  const TemporaryFolder folder;
  write_file(folder / "scene.toml", "title = \"</title><script>alert(1)</script>\"\nalpha = 0.3\n");
  const std::string page = run_program({"animate", folder / "scene.toml"}).output;
  CHECK(page.find("<script>alert") == std::string::npos);
  CHECK(page.find("&lt;script&gt;alert") != std::string::npos);
}

TEST_CASE("what cannot be animated is one line, code 2 and no file", "[exam]") {
  const TemporaryFolder folder;
  const auto scene = [&](const std::string& name, const std::string& text) {
    write_file(folder / name, text);
    return folder / name;
  };
  const std::vector<std::pair<std::vector<std::string>, std::string>> refused = {
      {{"animate", folder / "none.toml"}, "none.toml"},
      {{"animate", scene("many", "kind = \"chain\"\nblocks = 5000\nballs = 1\n")}, "up to 200"},
      {{"animate",
        scene("rest",
              "kind = \"chain\"\nmasses = [1, 1]\npositions = [0, 1]\nvelocities = [0, 0]\n")},
       "nothing moves"},
      {{"animate", scene("touch", "kind = \"chain\"\nmasses = [1, 1]\npositions = [0, 0]\n")},
       "spans no time that a double can hold"},
      {{"animate", scene("key", "alpha = 1\nbetta = 2\n")}, "betta"},
      {{"animate", scenes + "wall.toml", "--max-events", "20001"}, "20000"},
      {{"animate", scenes + "wall.toml", "-o", folder / "none/page.html"}, "cannot write"},
      {{"animate"}, "SCENE"}};
  const std::vector<std::string> before = folder.names();
  for (const auto& [arguments, expected] : refused) {
    const ProgramRun run = run_program(arguments);
    check_refused(run, expected);
  }
  CHECK(folder.names() == before);
}

TEST_CASE("a GIF of 200 pictures, and without gnuplot one line and no file", "[exam]") {
  const TemporaryFolder folder;
  const ProgramRun without = run_program(
      {"animate", scenes + "trajectory_a.toml", "--gif", folder / "a.gif", "-o", folder / "a.html"},
      "", {"/usr/bin/env", "PATH=/nowhere"});
  CHECK(without.exit_code == 2);
  CHECK(lines_of(without.errors).size() == 1);
  CHECK(without.errors.find("needs gnuplot (Debian: gnuplot-nox)") != std::string::npos);
  CHECK(folder.names().empty());
  const ProgramRun run =
      run_program({"animate", scenes + "trajectory_a.toml", "--gif", folder / "a.gif"});
  if (run.exit_code == 2) {
    WARN("skipped: needs gnuplot");
    return;
  }
  CHECK(run.output.empty());
  const std::string gif = read_file(folder / "a.gif");
  CHECK(gif.starts_with("GIF89a"));
  std::size_t pictures = 0;  // each has a graphic control block
  for (std::size_t at = gif.find("\x21\xF9\x04"); at != std::string::npos;
       at = gif.find("\x21\xF9\x04", at + 1))
    ++pictures;
  CHECK(pictures >= 200);
}

TEST_CASE("a page obeys the keyboard in Chromium, and a spoiled one is found out", "[exam]") {
  if (!Browser::is_installed()) {
    WARN("skipped: needs chromium");
    return;
  }
  const TemporaryFolder folder;
  const std::string page = animation("trajectory_a");
  Browser browser;
  browser.prefer("prefers-reduced-motion", "no-preference");
  const auto complaint_about = [&](const std::string& text, const std::string& with) {
    std::string copy = page;
    const std::size_t at = copy.find(text);
    REQUIRE(at != std::string::npos);
    copy.replace(at, text.size(), with);
    write_file(folder / "page.html", copy);
    return complaint(browser, folder / "page.html");
  };
  CHECK(complaint_about("<main>", "<main>").empty());
  CHECK(complaint_about("ArrowRight: 'forward'", "ArrowUp: 'forward'") == "does not step forward");
  CHECK(complaint_about("goTo(contacts[done - 2][0], done - 1)", "forward()") ==
        "does not step back");
  CHECK(complaint_about("playing = false; show()", "show()") == "does not pause");
  CHECK(complaint_about(":focus-visible { outline: 3px solid",
                        ":focus-visible { outline: 0 none") == "does not show the focus");

  // Reduced motion: playing shows moments of collisions, and nothing between them
  write_file(folder / "page.html", page);
  browser.prefer("prefers-reduced-motion", "reduce");
  browser.open(folder / "page.html");
  CHECK(browser.value("document.getElementById('calm').hidden") == false);
  browser.value("document.getElementById('speed').value = '5'");
  browser.press(" ");
  CHECK(browser.becomes_true("document.documentElement.dataset.done === '2'"));
  browser.press(" ");
  const std::size_t done =
      std::stoul(browser.value("document.documentElement.dataset.done").get<std::string>());
  const std::string shown = browser.value("document.documentElement.dataset.time");
  CHECK(std::stod(shown) == motion_of(page)["contacts"].at(done - 1)[0].get<double>());

  // As narrow as a phone: nothing to scroll sideways
  browser.set_width(360);
  browser.open(folder / "page.html");
  CHECK(browser.value("document.documentElement.scrollWidth <= 360") == true);
}
