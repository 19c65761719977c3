#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/solver/app/program.hpp"

BOOST_AUTO_TEST_SUITE(new_tests)

// `talus new`: its files are accepted without a warning and run unchanged; fences made from them by a few changes have
// the outcome of a converged run.

using nlohmann::json;

namespace {

const std::vector<std::string> kinds{"fence", "scene", "cell"};
const std::vector<std::string> systems{"SI", "US"};

std::string made(const std::string& kind, const std::string& units) {
  const Ended ended = talus_ran({"new", kind, "--units", units});
  BOOST_REQUIRE(ended.code == 0);
  BOOST_TEST(ended.err.empty());
  return ended.out;
}

bool is_accepted(const Ended& checked) {
  return checked.code == 0 && checked.err.empty() && !holds(checked.out, "warning") && !holds(checked.out, "TOO LONG");
}

/// The lines of a text.
std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in{text};
  for (std::string line; std::getline(in, line);)
    lines.push_back(line);
  return lines;
}

bool is_option(const std::string& line) {
  const std::size_t equals = line.find(" = ");
  return line.starts_with("# ") && equals != std::string::npos &&
         std::all_of(line.begin() + 2, line.begin() + static_cast<std::ptrdiff_t>(equals),
                     [](char c) { return (c >= 'a' && c <= 'z') || c == '_'; });
}

/// The text after removing the comment signs of `count` lines from `first` on.
std::string enabled(std::vector<std::string> lines, std::size_t first, std::size_t count) {
  for (std::size_t i = first; i < first + count; ++i)
    lines[i].erase(0, 2);
  return fmt::format("{}\n", fmt::join(lines, "\n"));
}

/// A changed number of the template.
struct Change {
  std::string table, key, value;
};

std::string changed(std::string text, const Change& change) {
  const std::size_t head = text.find(fmt::format("[{}]", change.table));
  const std::size_t key = text.find(fmt::format("\n{} = ", change.key), head) + 1;
  BOOST_REQUIRE(head != std::string::npos);
  BOOST_REQUIRE(key != 0U);
  return text.replace(key, text.find(" #", key) - key, fmt::format("{} = {}", change.key, change.value));
}

std::string rock_velocity(double vx, double vy) { return fmt::format("[\"{} m/s\", \"{} m/s\"]", vx, vy); }

/// Result of a fence's run.
struct Outcome {
  json summary;

  const json& extreme(const std::string& name) const {
    for (const json& item : summary.at("extremes"))
      if (item.at("name") == name) return item;
    throw std::runtime_error{name + " has no extremes"};
  }
  double largest(const std::string& name) const { return extreme(name).at("maximum").get<double>(); }
  /// True if at some time the rock's velocity along x was no longer forward.
  bool stopped() const { return largest("rock.vx") >= 0.0; }
  double peak_tension() const {
    double peak = 0.0;
    for (const json& item : summary.at("extremes"))
      if (item.at("name").get<std::string>().ends_with(".tension"))
        peak = std::max(peak, item.at("maximum").get<double>());
    return peak;
  }
  double balance_error() const {
    return summary.at("ledger").at("largest_energy_balance_error").get<double>() /
           summary.at("ledger").at("energy_scale").get<double>();
  }
  std::array<double, 2> rock() const {
    for (const json& body : summary.at("bodies"))
      if (body.at("name") == "rock") return body.at("position").get<std::array<double, 2>>();
    throw std::runtime_error{"no rock"};
  }
  /// Distance between the rock's last position and that of another run, relative to the width of its path.
  double rock_error(const Outcome& other) const {
    const auto one = rock(), two = other.rock();
    const double width = largest("rock.x") - extreme("rock.x").at("minimum").get<double>();
    return std::hypot(one[0] - two[0], one[1] - two[1]) / width;
  }
};

Outcome outcome(const std::string& file, const std::string& tolerance = "") {
  std::vector<std::string> arguments{"run", file, "--json"};
  if (!tolerance.empty()) arguments.insert(arguments.end(), {"--tolerance", tolerance});
  const Ended ended = talus_ran(arguments);
  BOOST_REQUIRE(ended.code == 0);
  BOOST_TEST(ended.err.empty());
  return {json::parse(ended.out)};
}

}  // namespace

BOOST_AUTO_TEST_CASE(new_files_are_accepted_and_run) {
  for (const std::string& kind : kinds) {
    for (const std::string& units : systems) {
      const Folder folder;
      const std::string file = folder.file("new.toml", made(kind, units)).string();
      BOOST_TEST(holds(made(kind, units), fmt::format("units = \"{}\"", units)));
      BOOST_TEST(is_accepted(talus_ran({"check", file})), kind << " " << units);
      const Ended run = talus_ran({kind == "cell" ? "cell" : "run", file, "--out", (folder.path / "out").string()});
      BOOST_TEST(run.code == 0);
      BOOST_TEST(run.err.empty(), run.err);
      BOOST_TEST(holds(run.out, "finished at t = "));
      for (const std::string& line : lines_of(made(kind, units)))
        BOOST_TEST(line.size() <= 130U, line);
    }
  }
  BOOST_TEST(talus_ran({"new", "fence"}).out == made("fence", "SI"));
}

// An optional field that requires another one precedes it.
BOOST_AUTO_TEST_CASE(optional_fields_of_new_files_are_accepted) {
  for (const std::string& kind : kinds) {
    for (const std::string& units : systems) {
      const Folder folder;
      const std::vector<std::string> lines = lines_of(made(kind, units));
      const auto accepted = [&](std::size_t first, std::size_t count) {
        const std::string file = folder.file("new.toml", enabled(lines, first, count)).string();
        return is_accepted(talus_ran({"check", file}));
      };
      int options = 0;
      for (std::size_t i = 0; i < lines.size(); ++i) {
        if (lines[i].starts_with("# [[")) {
          std::size_t last = i + 1;
          while (is_option(lines[last]))
            ++last;
          BOOST_TEST(accepted(i, last - i), lines[i]);
          i = last;
        } else if (is_option(lines[i])) {
          ++options;
          BOOST_TEST((accepted(i, 1) || (is_option(lines[i + 1]) && accepted(i, 2))), lines[i]);
        }
      }
      BOOST_TEST(options >= 5);
    }
  }
}

BOOST_AUTO_TEST_CASE(the_rock_of_the_new_fence_is_stopped) {
  for (const std::string& units : systems) {
    const Folder folder;
    const Outcome end = outcome(folder.file("new.toml", made("fence", units)).string());
    BOOST_TEST(end.stopped());
    BOOST_TEST(end.summary.at("failures").size() >= 2U);  // cables that yield
  }
}

// Twenty fences with three changed numbers each, none of which moves chaotically. The default tolerance, 1e-10, causes
// an error of at most 1e-4 of the rock's path; 1 % is what an engineer may notice.
BOOST_AUTO_TEST_CASE(fences_made_from_the_new_one_end_as_converged_runs) {
  const std::string rock = "fence.rock", column = "fence.column", fence = "fence";
  struct Fence {
    double vx, vy;
    std::array<Change, 2> changes;
  };
  const std::vector<Fence> fences{
      {-12, 0, {{{rock, "mass", "\"300 kg\""}, {fence, "columns", "11"}}}},
      {-6, 0, {{{rock, "mass", "\"1500 kg\""}, {fence, "sag", "\"2 m\""}}}},
      {-20, 0, {{{rock, "mass", "\"400 kg\""}, {fence, "span", "\"14 m\""}}}},
      {-25, 0, {{{rock, "mass", "\"1000 kg\""}, {fence, "area_top", "\"600 mm^2\""}}}},
      {-15, 0, {{{fence, "columns", "9"}, {column, "density", "\"300 kg/m^3\""}}}},
      {-8, -2, {{{fence, "columns", "17"}, {fence, "restitution", "0.6"}}}},
      {-30, 5, {{{fence, "young", "\"60 GPa\""}, {fence, "friction", "0.1"}}}},
      {-9, 1, {{{fence, "span", "\"20 m\""}, {fence, "columns", "19"}}}},
      {-11, 0, {{{fence, "young", "\"160 GPa\""}, {fence, "limit_bottom", "\"200 kN\""}}}},
      {-14, 0, {{{fence, "limit_top", "\"800 kN\""}, {fence, "area_bottom", "\"300 mm^2\""}}}},
      {-10, 2, {{{fence, "columns", "14"}, {fence, "spacing", "\"0.9 m\""}}}},
      {-10, 0, {{{fence, "columns", "8"}, {fence, "y_bottom", "\"-0.5 m\""}}}},
      {-7, 0, {{{fence, "columns", "7"}, {fence, "sag", "\"1 m\""}}}},
      {-10, 0.5, {{{fence, "restitution", "0.3"}, {fence, "penetration", "0.03"}}}},
      {-10, 0, {{{fence, "restitution", "0.8"}, {fence, "friction", "0.6"}}}},
      {-13, 0, {{{column, "b", "\"1 m\""}, {fence, "y_top", "\"1.2 m\""}}}},
      {-12, 3, {{{column, "density", "\"120 kg/m^3\""}, {fence, "sag", "\"0.8 m\""}}}},
      {-10, -1, {{{column, "density", "\"500 kg/m^3\""}, {rock, "mass", "\"2500 kg\""}}}},
      {-18, 0, {{{rock, "mass", "\"250 kg\""}, {fence, "duration", "\"0.5 s\""}}}},
      {-16, 0, {{{rock, "a", "\"0.45 m\""}, {rock, "b", "\"0.45 m\""}}}}};
  BOOST_TEST(fences.size() == 20U);
  const std::string plain = made("fence", "SI");
  std::size_t stopped = 0;
  for (std::size_t i = 0; i < fences.size(); ++i) {
    const Fence& made = fences[i];
    const auto text = [&](double vx) {
      std::string changed_text = changed(plain, {rock, "velocity", rock_velocity(vx, made.vy)});
      for (const Change& change : made.changes)
        changed_text = changed(changed_text, change);
      return changed_text;
    };
    const Folder folder;
    const std::string file = folder.file("fence.toml", text(made.vx)).string();
    BOOST_TEST_CONTEXT("fence " << i) {
      BOOST_TEST(is_accepted(talus_ran({"check", file})));
      const Outcome usual = outcome(file), converged = outcome(file, "1e-12");
      BOOST_TEST(usual.balance_error() <= 0.005);
      BOOST_TEST(usual.stopped() == converged.stopped());
      BOOST_TEST(std::abs(usual.peak_tension() / converged.peak_tension() - 1.0) <= 0.01);
      stopped += converged.stopped() ? 1 : 0;
      BOOST_TEST(usual.rock_error(converged) <= 0.01);
      // A rock that is 3 % faster must be detected.
      if (i == 0) {
        const Outcome faster = outcome(folder.file("faster.toml", text(1.03 * made.vx)).string());
        BOOST_TEST(faster.rock_error(converged) > 0.01);
      }
    }
  }
  // Both outcomes occur.
  BOOST_TEST(stopped >= 5U);
  BOOST_TEST(stopped <= 15U);
}

BOOST_AUTO_TEST_SUITE_END()
