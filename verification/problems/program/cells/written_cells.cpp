#include "verification/problems/program/cells/written_cells.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>
#include <vector>

#include "verification/problems/program/cells/reference_cell.hpp"
#include "verification/record/csv.hpp"

namespace talus::verification::problems::cell_files {

using records::Json;
using records::Node;

TomlValue number_of(double value) { return {"", value, ""}; }
TomlValue text_of(const std::string& text) { return {"", {}, text}; }

double wrong_texts(const Node& numbers, const std::map<std::string, std::string>& units, const std::string& printed) {
  double wrong = 0.0;
  for (const auto& [name, number] : numbers.members()) {
    const std::string meaning = number.at("meaning").text();
    const std::size_t line = printed.find("\n  " + name + " "), next = printed.find('\n', line + 1);
    const std::string row = line == std::string::npos ? "" : printed.substr(line, next - line);
    const std::string unsteady = "; not steady";
    wrong += row.ends_with("  " + meaning) || row.find("  " + meaning + unsteady) != std::string::npos ? 0.0 : 1.0;
    const auto unit = units.find(name);
    const std::string expected = unit == units.end() ? "" : unit->second;
    wrong += (number.has("unit") ? number.at("unit").text() : "") == expected ? 0.0 : 1.0;
  }
  return wrong;
}

double wrong_warnings(const Node& summary, const ProgramEnd& ended) {
  double wrong = 0.0;
  const std::vector<Node> warnings = summary.at("warnings").list();
  for (const Node& warning : warnings)
    wrong += ended.messages.find(warning.text() + "\n") == std::string::npos ? 1.0 : 0.0;
  double printed = 0.0;
  for (std::size_t at = ended.messages.find("warning: "); at != std::string::npos;
       at = ended.messages.find("warning: ", at + 1))
    printed += 1.0;
  return wrong + std::abs(printed - static_cast<double>(warnings.size()));
}

double wrong_members(const Node& found, const Members& expected) {
  double wrong = std::abs(static_cast<double>(found.members().size()) - static_cast<double>(expected.size()));
  for (const auto& [name, member] : found.members()) {
    const auto value = expected.find(name);
    if (value == expected.end()) {
      wrong += 1.0;
    } else if (member.json().is_number()) {
      // A number written in decimals, or two of them divided.
      const double exact = value->second.number.value_or(0.0);
      wrong += std::abs(member.number() - exact) <= 5e-16 * std::abs(exact) ? 0.0 : 1.0;
    } else {
      const std::string text = member.json().is_boolean() ? (member.flag() ? "on" : "off") : member.text();
      wrong += text == value->second.text ? 0.0 : 1.0;
    }
  }
  return wrong;
}

namespace {

/// Cells whose files set every field, and what follows from them.
struct WrittenCell {
  std::string text;
  Members derived;  ///< parameters that the scene does not give
};
std::vector<WrittenCell> written_cells(const Setup& setup) {
  const std::string discs = R"(diameter = "0.001 m"
mass = "7.2e-7 kg"
gravity = "9.81 m/s^2"
block_speed = "5 m/s"
rows = 3
columns = 4
wall_discs = 5
seed = 3
)";
  const auto plan = [](const char* integrator, double time, const char* switches) {
    return fmt::format("[run]\nintegrator = \"{}\"\nstep = \"{} s\"\nevery = \"2e-5 s\"\nend = \"1.1e-4 s\"\n{}",
                       integrator, time, switches);
  };
  constexpr double block = 9e-3, load = 3500.0, wall = 5e-6;  // [kg], [Pa], area of the block [m^2]
  const Members of_block{{"overburden", number_of(block * gravity / wall)}},
      of_load{{"block_mass", number_of(load * wall / gravity)}};
  const std::string head = "units = \"SI\"\n[cell]\n" + discs, heavy = fmt::format("block_mass = \"{} kg\"\n", block),
                    stiff = "stiffness = \"17000 N/m\"\n";
  std::vector<WrittenCell> cells{
      {"title = \"Latching springs\"\n" + head + heavy + stiff +
           "law = \"latching_spring\"\nunloading_stiffness = \"31000 N/m\"\ngrowth = \"1.5 1/m\"\nfriction = 0.5\n"
           "shear_stiffness = \"11000 N/m\"\n" +
           plan("euler_cromer", 2e-7,
                "jump = \"off\"\nimages = \"virtual\"\nhistorical = \"off\"\npictures = \"on\"\n"),
       of_block},
      {"title = \"Dashpots\"\n" + head + stiff +
           fmt::format("overburden = \"{} N/m^2\"\nlaw = \"linear_spring_dashpot\"\ndamping = \"0.02 N s/m\"\n"
                       "end_rule = \"attractive\"\n",
                       load) +
           plan("velocity_verlet", 2e-7,
                "jump = \"on\"\nimages = \"nearest\"\nhistorical = \"off\"\npictures = \"off\"\n"),
       of_load},
      {"title = \"As in 1989\"\n" + head + heavy + stiff +
           "law = \"latching_spring\"\ngrowth = \"0 1/m\"\nunloading_stiffness = \"" +
           fmt::format("{}", 17000.0 / 0.45) + " N/m\"\n" +
           plan("euler", 1e-7, "jump = \"off\"\nimages = \"virtual\"\nhistorical = \"on\"\npictures = \"on\"\n"),
       of_block}};
  cells.push_back({"title = \"Hertz\"\n" + head + heavy +
                       "law = \"hertz\"\nmodulus = \"6.5e8 N/m^2\"\nradius = \"0.0003 m\"\ndamping = \"0.03 N s/m\"\n"
                       "end_rule = \"attractive\"\ndashpot = \"constant\"\nimpact_speed = \"0.7 m/s\"\n" +
                       plan("velocity_verlet", 2e-7,
                            "jump = \"off\"\nimages = \"nearest\"\nhistorical = \"off\"\npictures = \"on\"\n"),
                   of_block});
  Members of_block_to_the_left = of_block;
  of_block_to_the_left["impact_speed"] = number_of(5.0 / 4.0);
  Members of_rows = of_load;  // the speed of rows past each other: 3 rows between base and block
  of_rows["impact_speed"] = number_of(5.0 / 4.0);
  cells.push_back({"title = \"Spheres\"\n" + head +
                       fmt::format("overburden = \"{} N/m^2\"\nlaw = \"hertz\"\nmodulus = \"6.5e8 N/m^2\"\n"
                                   "radius = \"0.00025 m\"\ndamping = \"0.03 N s/m\"\nend_rule = \"clamped\"\n"
                                   "dashpot = \"tsuji\"\nfriction = 0.5\nshear_law = \"mindlin\"\n"
                                   "shear_modulus = \"1.3e8 N/m^2\"\n",
                                   load) +
                       plan("central_difference", 2e-7,
                            "jump = \"off\"\nimages = \"nearest\"\nhistorical = \"off\"\npictures = \"on\"\n"),
                   of_rows});
  std::string to_the_left = head;  // for the speed of impacts, the direction of the block does not count
  to_the_left.replace(to_the_left.find("\"5 m/s"), 6, "\"-5 m/s");
  cells.push_back({"title = \"To the left\"\n" + to_the_left + heavy +
                       "law = \"hertz\"\nmodulus = \"6.5e8 N/m^2\"\nradius = \"0.0003 m\"\ndamping = \"0.03 N s/m\"\n"
                       "end_rule = \"clamped\"\ndashpot = \"constant\"\n" +
                       plan("velocity_verlet", 2e-7,
                            "jump = \"off\"\nimages = \"nearest\"\nhistorical = \"off\"\npictures = \"off\"\n"),
                   of_block_to_the_left});
  cells.push_back({"title = \"Hunt and Crossley\"\n" + head + stiff +
                       fmt::format("overburden = \"{} N/m^2\"\nlaw = \"hunt_crossley\"\n"
                                   "reference_overlap = \"4e-6 m\"\nexponent = 1.5\nhysteresis = \"0.4 s/m\"\n",
                                   load) +
                       plan("euler_cromer", 2e-7,
                            "jump = \"on\"\nimages = \"nearest\"\nhistorical = \"off\"\npictures = \"off\"\n"),
                   of_rows});
  if (setup.has("another_seed")) cells.front().derived["seed"] = number_of(4.0);
  return cells;
}

/// Members of plot.json that differ from the files, the scene's title and the meanings of the summary.
double wrong_plot(const TemporaryFolder& folder, const std::string& out, const Node& summary, double period) {
  const Json json = records::read_json(folder.path() / out / "plot.json");
  const Node plot{json, "plot.json"};
  const std::string title = summary.at("title").text();
  double wrong = 0.0;
  const auto expect = [&](bool right) { wrong += right ? 0.0 : 1.0; };
  expect(plot.at("schema").integer() == 1 && plot.at("units").text() == "SI" && plot.at("title").text() == title);
  expect(plot.at("histories").texts() == std::vector<std::string>{"history.csv"});
  if (plot.has("geometry")) {
    const Node geometry = plot.at("geometry");
    expect(std::filesystem::exists(folder.path() / out / geometry.at("index").text()));
    expect(std::abs(geometry.at("period").number() / period - 1.0) < 1e-15);
  }
  std::set<std::string> meanings;
  for (const auto& [name, result] : summary.at("results").members())
    meanings.insert(result.at("meaning").text());
  const std::set<std::string> names{"stresses",     "stress_ratio",          "depth",
                                    "fractions",    "coordination",          "spin",
                                    "sliding",      "velocity_profile",      "temperature_profile",
                                    "spin_profile", "solid_fraction_profile"},
      axes{"time",
           "stress",
           "S/N on the block",
           "depth",
           "fraction",
           "coordination",
           "velocity along x",
           "height y",
           "energy of a disc's motion about the mean",
           "solid fraction",
           "spin"};
  for (const Node& figure : plot.at("figures").list()) {
    const std::string csv = figure.at("csv").text(),
                      when = csv == "profile.csv" ? ", mean after the start-up." : ", means over each LOOP.";
    expect(names.contains(figure.at("name").text()));
    expect(figure.at("caption").text() == title + ": " + figure.at("title").text() + when);
    const std::vector<std::string> header = records::read_csv(folder.path() / out / csv).header();
    for (const char* const axis : {"x", "y"}) {
      const Node of = figure.at(axis);
      expect(!of.at("log").flag() && axes.contains(of.at("label").text()));
      const std::string unit = of.at("unit").text() == "1" ? "" : " [" + of.at("unit").text() + "]";
      for (const Node& series : figure.at("series").list()) {
        const std::string column = series.at(axis).text(), label = series.at("label").text();
        std::string text = column;
        std::ranges::replace(text, '_', ' ');
        expect(std::ranges::count(header, column) == 1 && series.at("style").text() == "linespoints");
        expect(unit.empty() ? column.find('[') == std::string::npos : column.ends_with(unit));
        expect(label.empty() || label == text || meanings.contains(label) || axis == std::string{"x"});
      }
    }
  }
  return wrong;
}

/// Numbers other than zero in the columns of spin and sliding: nothing has touched yet.
double nonzero_spins(const records::Csv& csv) {
  double count_of = 0.0;
  for (std::size_t column = 0; column < csv.header().size(); ++column) {
    if (!csv.header()[column].starts_with("spin") && csv.header()[column] != "sliding_fraction") continue;
    for (std::size_t row = 0; row < csv.rows(); ++row)
      count_of += csv.number(row, column) == 0.0 ? 0.0 : 1.0;
  }
  return count_of;
}

}  // namespace

void check_written_cells(const TemporaryFolder& folder, Findings& findings, const Setup& setup) {
  double parameters = 0.0, others = 0.0;
  for (const WrittenCell& cell : written_cells(setup)) {
    folder.write("written.toml", cell.text);
    std::filesystem::remove_all(folder.path() / "written");
    const ProgramEnd ended = run_talus(folder, {"cell", "written.toml", "--out", "written"});
    const std::string& printed = ended.output;
    others += ended.exit_code == 0 ? 0.0 : 1.0;
    const Json json = records::read_json(folder.path() / "written/summary.json");
    const Node summary{json, "summary.json"};
    Members exact = cell.derived;
    bool pictures = false;
    for (const TomlValue& value : toml_values(cell.text)) {
      const std::string name = value.key.substr(value.key.find('.') + 1);
      if (name == "pictures") pictures = value.text == "on";
      if (name == "title") others += summary.at("title").text() == value.text ? 0.0 : 1.0;
      if (name == value.key || name == "pictures") continue;
      exact.emplace(name, value.number ? number_of(*value.number) : value);
    }
    parameters += wrong_members(summary.at("parameters"), exact);
    others += std::filesystem::exists(folder.path() / "written/cell.pvd") == pictures ? 0.0 : 1.0;
    others += records::read_csv(folder.path() / "written/history.csv").rows() == 6 ? 0.0 : 1.0;
    others += wrong_warnings(summary, ended);
    const Node outcome = summary.at("outcome");
    others += outcome.at("kind").text() == "finished" && std::abs(outcome.at("time").number() - 1.1e-4) < 1e-15 &&
                      summary.at("schema").integer() == 2
                  ? 0.0
                  : 1.0;
    others += wrong_plot(folder, "written", summary, 0.005);
    for (const char* const file : {"written/history.csv", "written/profile.csv"})
      others += nonzero_spins(records::read_csv(folder.path() / file));
    if (pictures) {
      for (const GeometryState& state : geometry_states(folder, "written", "cell"))
        for (const double spin : data_array(state.text, "spin"))
          others += spin == 0.0 ? 0.0 : 1.0;
    }
    const Node groups = summary.at("groups"), results = summary.at("results");
    others += wrong_texts(groups, {}, printed);
    others += wrong_texts(results,
                          {{"top_shear", "N/m^2"},
                           {"top_normal", "N/m^2"},
                           {"bottom_shear", "N/m^2"},
                           {"bottom_normal", "N/m^2"},
                           {"depth", "m"},
                           {"depth_deviation", "m"},
                           {"spin", "rad/s"}},
                          printed);
    if (!groups.has("friction")) continue;
    others += groups.at("friction").at("value").number() == 0.5 ? 0.0 : 1.0;
    // Of spheres: 8 G a over 4/3 E a.
    const bool spheres = summary.at("parameters").has("shear_modulus");
    const double ratio = spheres ? 6.0 * 1.3e8 / 6.5e8 : 11000.0 / 17000.0;
    others +=
        std::abs(groups.at("shear_over_normal_stiffness").at("value").number() / ratio - 1.0) <= (spheres ? 1e-14 : 0.0)
            ? 0.0
            : 1.0;
    others += results.at("spin").at("value").number() == 0.0 ? 0.0 : 1.0;  // nothing touches yet
    others += summary.at("energy").at("friction_work").number() == 0.0 ? 0.0 : 1.0;
  }
  // The shear stiffness of discs that latch is by default that of their loading.
  std::string shorter = written_cells(setup).front().text;
  const std::size_t line = shorter.find("shear_stiffness");
  folder.write("default.toml", shorter.erase(line, shorter.find('\n', line) + 1 - line));
  const Json summary = Json::parse(talus_output(folder, {"cell", "default.toml", "--json", "--out", "default"}));
  others += summary == records::read_json(folder.path() / "default/summary.json") ? 0.0 : 1.0;
  parameters += summary.at("parameters").at("shear_stiffness").get<double>() == 17000.0 ? 0.0 : 1.0;
  findings.expect("parameters of cells that differ from their scenes", parameters, 0.0,
                  Tolerance::exact("every field of a cell, with all bits or to the last bits of a quotient"));
  findings.expect("titles, files, rows, figures, units and meanings of these cells that differ", others, 0.0,
                  Tolerance::exact("texts, files and counts"));
}

}  // namespace talus::verification::problems::cell_files
