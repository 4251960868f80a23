// Numbers as scenes write them; scenes from text to their end: in doubles, exactly, by theorem.
#include <random>

#include "magicmass/scenes/files.hpp"
#include "rows.hpp"
#include "runs.hpp"

using namespace magicmass::scenes;

namespace {

/// A chain of fractions: where only_halves, with many ties.
std::string random_chain(std::uint64_t seed, bool only_halves) {
  std::mt19937_64 random(seed);
  const int below = only_halves ? 2 : 89;
  const auto draw = [&](int n) { return int(random() % std::uint64_t(n)); };
  std::vector<std::string> masses, velocities, positions;
  int place = 0;
  const auto fraction = [&](int above) {
    return "'" + std::to_string(above) + "/" + std::to_string(below) + "'";
  };
  for (int bodies = 2 + draw(4); bodies > 0; --bodies) {
    place += draw(3 * below);
    masses.push_back(fraction(1 + draw(2 * below)));
    positions.push_back(fraction(place));
    velocities.push_back(fraction(draw(4 * below) - 2 * below));
  }
  return "kind = 'chain'\nmasses = " + list(masses) + "positions = " + list(positions) +
         "velocities = " + list(velocities) + (random() % 2 == 0 ? "left_wall = -1\n" : "") +
         (random() % 3 == 0 ? "restitution = 0.9\n" : "") + "max_events = 12\n";
}

std::string random_cradle(std::mt19937_64& random) {
  const std::size_t bodies = 3 + 2 * (random() % 4);
  const auto fraction = [](std::int64_t above) { return "'" + std::to_string(above) + "/7'"; };
  std::vector<std::string> masses, positions, velocities;
  std::int64_t place = -5, L = 0;
  for (std::size_t i = 0; i < bodies; ++i) {
    positions.push_back(fraction(place));
    velocities.push_back(i == 0 ? "'3/2'" : "0");
    const bool is_second = random() % 2 == 0;
    masses.push_back(i % 2 == 0 || !is_second ? "1" : "'sqrt(5)-2'");
    const std::int64_t step = (is_second ? 9 * L / 14 + 1 : 1) + std::int64_t(random() % 9);
    if (i % 2 == 1) L = step;
    place += step;
  }
  const bool has_left = random() % 2 == 0, has_right = random() % 2 == 0;
  const auto cut = random() % 3 == 0 ? "until = '" + std::to_string(random() % 9000) + "/97'\n"
                                     : "max_events = " + std::to_string(1 + random() % 200) + "\n";
  return "kind = 'chain'\nmasses = " + list(masses) + "positions = " + list(positions) +
         "velocities = " + list(velocities) + (has_left ? "left_wall = '-38/7'\n" : "") +
         (has_right ? "right_wall = " + fraction(place + 9) + "\n" : "") + cut;
}

}  // namespace

TEST_CASE("values are kept as what they are, what is none is refused", "[exam]") {
  for (const auto& row : rows_of("src/magicmass/scenes/values.tsv", 3, 47)) {
    INFO(row[0]);
    if (row[2].empty()) {
      CHECK_THROWS_WITH(read_value(row[0]).to_double(), ContainsSubstring(row[1]));
      continue;
    }
    const Value value = read_value(row[0]);
    CHECK(value.text == row[0]);
    CHECK((value.exact() ? value.exact()->text() : "no surd") == row[1]);
    CHECK(value.to_double() == std::stod(row[2]));
  }
  CHECK_THROWS_WITH(read_value(std::string(5000, '1')), "5000 characters, at most 4096");
}

TEST_CASE("doubles and exact numbers have the same collisions", "[check]") {
  int in_doubles = 0;
  for (std::uint64_t seed = 0; seed < 500; ++seed) {
    INFO(seed);
    const std::string text = random_chain(seed, seed % 4 == 0);
    const auto off = result_of(text).errors.value_or(magicmass::simulator::Errors<double>());
    const Numbers most{0, off.time, off.position, off.velocity, off.velocity};
    std::vector<Row> rows = rows_of(scene_of(text));
    std::vector<Row> expected = rows_of(scene_of(text, true));
    REQUIRE(rows.size() == expected.size());
    // What is far apart may be told in any order, if it is at once.
    for (auto* all : {&rows, &expected}) std::ranges::stable_sort(*all, {}, &Row::gap);
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const Numbers got = numbers(rows[i]), exact = numbers(expected[i]);
      for (std::size_t k = 0; k < got.size(); ++k)
        CHECK_THAT(got[k], WithinAbs(exact[k], most[k] + 2e-16 * std::abs(exact[k])));
    }
    in_doubles += !rows.empty() && std::holds_alternative<double>(rows[0].time) ? 1 : 0;
  }
  CHECK((in_doubles > 250 && in_doubles < 450));
}

TEST_CASE("a scene with a few wrong bytes is a scene or is refused", "[check]") {
  const std::string good =
      "kind = 'chain' # a comment\nmasses = [2, '1/3', 0x3, \"sqrt(5)-2\"]\npositions = [0, '1/2',"
      " 1.25, 'sqrt(5)']\nvelocities = [1, 0, '-1/4', 0]\nright_wall = 4\nrestitution = 1\n"
      "outputs = ['counts', 'events']\nuntil = 3\nmax_events = 5\n";
  std::mt19937_64 random(9);
  int refused = 0;
  for (int i = 0; i < 3000; ++i) {
    std::string text = good;
    for (std::uint64_t n = 1 + random() % 3; n > 0; --n)
      text[random() % text.size()] =
          random() % 2 == 0 ? good[random() % good.size()] : static_cast<char>(random() % 256);
    try {
      result_of(text);
    } catch (const magicmass::InvalidInput& error) {
      ++refused;
      CHECK(std::string(error.what()).find('\n') == std::string::npos);
      CHECK_THAT(error.what(), ContainsSubstring("; allowed: "));
    } catch (const magicmass::Undecided&) {
    }
  }
  CHECK((refused > 1000 && refused < 3000));
}

TEST_CASE("random cradles by theorem, in exact numbers, and in a mirror", "[check]") {
  std::mt19937_64 random(17);
  int cradles = 0, limited = 0;
  std::size_t longest = 0;
  for (int i = 0; i < 80; ++i) {
    const std::string text = random_cradle(random);
    INFO(text);
    // A time that is no surd has the theorem asked for few collisions, too.
    const Scene scene = scene_of(text + "outputs = ['trajectory']\ntimes = ['magic:3']\n"),
                exact_scene = scene_of(text, true);
    const Result result = run(scene);
    if (result.plan.model != "transfers") continue;
    ++cradles;
    REQUIRE_FALSE(result.plan.is_exact);
    const Result exact = run(exact_scene), image = run(mirrored(scene));
    for (const Plan& plan : {result_of(text).plan, image.plan}) REQUIRE(plan.model == "transfers");
    check_mirrored(result, image);
    check_mirrored(image, exact);
    for (const Result& other : {exact, image}) {
      REQUIRE(other.why == result.why);
      REQUIRE(other.known_until.has_value() == result.known_until.has_value());
      if (result.known_until) REQUIRE(number(*other.known_until) == number(*result.known_until));
    }
    REQUIRE(number(exact.transmitted) == number(result.transmitted));
    std::vector<Numbers> rows = numbers_of(scene);
    REQUIRE(rows == numbers_of(exact_scene));
    for (auto& [gap, time, place, v_left, v_right] : rows) {
      gap = double(scene.masses.size()) - gap;
      place = -place;
      v_left = -std::exchange(v_right, -v_left);
    }
    REQUIRE(rows == numbers_of(mirrored(scene)));
    limited += result.status == Status::limited ? 1 : 0;
    longest = std::max(longest, rows.size());
  }
  CHECK((limited > 20 && limited < cradles && cradles > 50 && longest > 150));
}

TEST_CASE("a cradle of larger numbers moves as doubles do", "[check]") {
  const Scene scene = scene_of(
      "kind = 'chain'\nblocks = 5\nballs = ['magic:3', 'magic:7', 'magic:20', "
      "'magic:4']\nV = 2\nL = '3/2'\ngap = 2\n");
  magicmass::simulator::Engine<double> engine(line_of<double>(scene));
  for (const Numbers& row : numbers_of(scene)) {
    REQUIRE(engine.next());
    const Numbers stepped = numbers(engine.step());
    for (std::size_t i = 0; i < row.size(); ++i) REQUIRE_THAT(stepped[i], WithinAbs(row[i], 1e-10));
  }
}

TEST_CASE("places at given times are those of the engine", "[check]") {
  std::string times;
  for (int n = 0; n < 300; ++n) times += "'" + std::to_string(n) + "/5',";
  for (const std::string name : {"cradle", "chain", "wall", "drifting"}) {
    const std::string folder = MAGICMASS_SOURCE "/tests/src/magicmass/scenes/places/",
                      text = text_of(folder + name + ".toml", "a scene");
    for (const bool exact : {true, false}) {
      const Scene scene =
          scene_of(text + "outputs = ['trajectory']\ntimes = [" + times + "]\n", exact);
      magicmass::simulator::Engine<Surd> engine(line_of<Surd>(scene));
      std::size_t points = 0;
      trajectory(scene, run(scene), [&](const Point& point) {
        const Surd time(cln::cl_RA(static_cast<int>(points / scene.masses.size())) / 5);
        while (engine.next() && !(time < *engine.next())) engine.step();
        const Surd place = engine.position(point.body, time);
        REQUIRE(point.body == points++ % scene.masses.size());
        if (exact) {
          REQUIRE(std::get<Surd>(point.time) == time);
          REQUIRE(std::get<Surd>(point.position) == place);
        }
        REQUIRE_THAT(number(point.position), WithinAbs(place.to_double().value(), 1e-11));
      });
      CHECK(points == 300 * scene.masses.size());
    }
  }
}
