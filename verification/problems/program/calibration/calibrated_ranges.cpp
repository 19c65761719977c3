#include "verification/problems/program/calibration/calibrated_ranges.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <iterator>
#include <limits>
#include <map>
#include <numbers>
#include <numeric>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "verification/problems/program/calibration/impact_request.hpp"
#include "verification/problems/program/calibration/range_refusals.hpp"
#include "verification/problems/program/pictures/picture_script.hpp"
#include "verification/record/csv.hpp"
#include "verification/record/json_node.hpp"
#include "verification/study/findings/expectations.hpp"
#include "verification/study/program/program_run.hpp"

namespace talus::verification::problems::calibrated_laws {
namespace {

using records::Json;

constexpr double step_bound = 0.02;  ///< error of the restitution that a step may cause
constexpr double foot = 0.3048, pound = 4.4482216152605, slug = pound / foot, inch = foot / 12.0;

/// A column of the table with its unit in US units and the size of that unit in SI.
struct TableColumn {
  std::string name, unit;
  double size{};
};

/// A range of pairs: the options that request it, and each pair.
struct Range {
  ImpactRequest common;
  Options options;
  std::vector<ImpactRequest> pairs;
  std::vector<TableColumn> given;  ///< columns as given by the options
};

std::vector<double> spaced(double first, double last, int count) {
  std::vector<double> numbers;
  for (int i = 0; i < count; ++i)
    numbers.push_back(std::exp(std::lerp(std::log(first), std::log(last), i / (count - 1.0))));
  return numbers;
}

/// Options of the law without those that the pairs replace.
Options options_without(const ImpactRequest& common, const std::set<std::string>& replaced) {
  Options options = law_options(common);
  std::erase_if(options, [&](const Option& option) { return replaced.contains(option.first); });
  options.push_back({"--restitution", {fmt::format("{}", common.restitution)}});
  options.push_back({"--bound", {fmt::format("{}", step_bound)}});
  return options;
}

/// All pairs of two radii of equal spheres and three speeds.
Range range_of_spheres(const ImpactRequest& common, ImpactDraw& draw, const Setup& setup) {
  const double small = draw.decades(1e-3, 0.1), large = small * draw.between(2.0, 5.0), slow = draw.decades(0.05, 1.0),
               fast = slow * draw.between(3.0, 30.0), density = draw.between(900.0, 8000.0);
  Range range{common, options_without(common, {"--radius"}), {}, {}};
  range.options.push_back({"--radii", {fmt::format("{} m", small), fmt::format("{} m", large), "2"}});
  range.options.push_back({"--speeds", {fmt::format("{} m/s", slow), fmt::format("{} m/s", fast), "3"}});
  // A sphere against a wall has twice the effective mass.
  range.options.push_back({"--density", {fmt::format("{} kg/m^3", density * (setup.has("other_mass") ? 2.0 : 1.0))}});
  range.given = {{"sphere_radius", "ft", foot}, {"speed", "ft/s", foot}};
  for (const double radius : spaced(small, large, 2)) {
    for (const double speed : spaced(slow, fast, 3)) {
      ImpactRequest pair = common;
      const double mass = density * 4.0 / 3.0 * std::numbers::pi * std::pow(radius, 3.0);
      pair.masses = {mass, mass}, pair.speed = speed;
      if (pair.is_hertz()) pair.radius = 0.5 * radius;
      range.pairs.push_back(pair);
    }
  }
  return range;
}

/// Pairs of one effective mass that meet at four speeds.
Range range_of_speeds(const ImpactRequest& common, ImpactDraw& draw) {
  const double slow = draw.decades(0.05, 1.0), fast = slow * draw.between(3.0, 30.0);
  Range range{common, options_without(common, {}), {}, {{"speed", "ft/s", foot}}};
  range.options.push_back({"--speeds", {fmt::format("{} m/s", slow), fmt::format("{} m/s", fast), "4"}});
  std::vector<std::string> masses;
  for (const double mass : common.masses)
    masses.push_back(fmt::format("{} kg", mass));
  range.options.push_back({"--masses", masses});
  for (const double speed : spaced(slow, fast, 4)) {
    range.pairs.push_back(common);
    range.pairs.back().speed = speed;
  }
  return range;
}

/// Pairs of a body of four masses and a wall, with or without three speeds.
Range range_of_masses(const ImpactRequest& common, ImpactDraw& draw, const Setup& setup) {
  const double light = draw.decades(1e-3, 1.0), heavy = light * draw.between(3.0, 30.0), slow = draw.decades(0.05, 1.0),
               fast = slow * draw.between(3.0, 30.0);
  const bool has_speeds = draw.between(0.0, 1.0) < 0.5;
  Range range{common, options_without(common, {}), {}, {{"mass_2", "slug", slug}}};
  range.options.push_back({"--masses", {fmt::format("{} kg", light), fmt::format("{} kg", heavy), "4"}});
  if (has_speeds) {
    range.options.push_back({"--speeds", {fmt::format("{} m/s", slow), fmt::format("{} m/s", fast), "3"}});
    range.given.push_back({"speed", "ft/s", foot});
  } else {
    range.options.push_back({"--speed", {fmt::format("{} m/s", common.speed)}});
  }
  std::vector<double> masses = spaced(light, heavy, 4);
  if (setup.has("heavy_first")) std::ranges::reverse(masses);
  for (const double mass : masses) {
    for (const double speed : has_speeds ? spaced(slow, fast, 3) : std::vector{common.speed}) {
      range.pairs.push_back(common);
      range.pairs.back().masses = {mass}, range.pairs.back().speed = speed;
    }
  }
  return range;
}

/// Five pairs of a file, in grams, feet and inches: two bodies with speeds and parameters, or one body and a wall.
Range range_of_file(const ImpactRequest& common, ImpactDraw& draw, const Program& program, bool is_wall) {
  const std::string length = common.is_hertz() ? "radius" : "reference_overlap";
  const bool has_length = !is_wall && common.law != "linear_spring_dashpot";
  Range range{common,
              options_without(common, has_length ? std::set<std::string>{"--radius", "--reference-overlap"}
                                                 : std::set<std::string>{}),
              {},
              {}};
  range.options.push_back({"--pairs", {"pairs.csv"}});
  if (is_wall) range.options.push_back({"--speed", {fmt::format("{} m/s", common.speed)}});
  std::string text = is_wall ? "# a wall\nmass_2 [g]\n" : "mass_2 [g],speed [ft/s],mass_1 [kg]";
  if (has_length) text += "," + length + " [in]";
  if (!is_wall) text += "\n";
  range.given = {{"mass_2", "slug", slug}};
  if (!is_wall) range.given.insert(range.given.end(), {{"speed", "ft/s", foot}, {"mass_1", "slug", slug}});
  if (has_length) range.given.push_back({length, "ft", foot});
  for (int i = 0; i < 5; ++i) {
    ImpactRequest pair = common;
    const double mass = draw.decades(1.0, 30.0), speed = draw.decades(1.0, 30.0), other = draw.decades(0.001, 1.0),
                 size = draw.decades(0.1, 1.0);
    pair.masses = is_wall ? std::vector{1e-3 * mass} : std::vector{other, 1e-3 * mass};
    text += fmt::format("{}", mass);
    if (!is_wall) {
      pair.speed = speed * foot;
      text += fmt::format(",{},{}", speed, other);
    }
    if (has_length) {
      pair.radius = size * inch;
      text += fmt::format(",{}", size);
    }
    text += "\n";
    range.pairs.push_back(pair);
  }
  program.write("pairs.csv", text);
  return range;
}

double largest_deviation(const Range& range, double damping) {
  double worst = 0.0;
  for (const ImpactRequest& pair : range.pairs)
    keep_largest(worst, restitution_with(pair, damping) - range.common.restitution);
  return worst;
}

/// Width in ln(c) at which the search ends.
constexpr double resolution = 1e-4;

/// The smallest largest deviation by golden-section search, which knows only that it has one minimum.
double searched_deviation(const Range& range, double low, double high) {
  constexpr double golden = 0.6180339887498949;
  const auto deviation = [&](double log) { return largest_deviation(range, std::exp(log)); };
  double from = std::log(0.5 * low), to = std::log(2.0 * high);
  double left = to - golden * (to - from), right = from + golden * (to - from);
  double at_left = deviation(left), at_right = deviation(right);
  while (to - from > resolution) {
    if (at_left <= at_right) {
      to = right, right = left, at_right = at_left;
      left = to - golden * (to - from), at_left = deviation(left);
    } else {
      from = left, left = right, at_left = at_right;
      right = from + golden * (to - from), at_right = deviation(right);
    }
  }
  return std::min(at_left, at_right);
}

/// The numbers of one member of all pairs.
std::vector<double> member(const Json& json, const std::string& name) {
  std::vector<double> numbers;
  for (const Json& pair : json.at("pairs"))
    numbers.push_back(pair.at(name).get<double>());
  return numbers;
}

/// 0 for equal numbers, of which both may be zero.
double relative_error(double found, double exact) { return found == exact ? 0.0 : found / exact - 1.0; }

/// WorstRange errors over all ranges.
struct WorstRange {
  double mass{}, damping{}, restitution{}, deviation{}, undamped{}, minimax{}, search{}, given{}, printed{}, csv{},
      drawn{}, run{}, finer{}, coarser{1.0}, row{1.0};
};

std::vector<std::string> tokens_of(const std::string& line) {
  std::istringstream stream{line};
  std::vector<std::string> tokens;
  for (std::string word; stream >> word;)
    tokens.push_back(word);
  return tokens;
}

/// All columns of the table.
std::vector<TableColumn> columns_of(const Range& range) {
  std::vector<TableColumn> columns = range.given;
  const bool is_hysteresis = range.common.is_hunt_crossley();
  columns.insert(columns.end(), {{"effective_mass", "slug", slug},
                                 {"exact_" + range.common.parameter(), is_hysteresis ? "ft^-1 s" : "lbf s/ft",
                                  is_hysteresis ? 1.0 / foot : pound / foot},
                                 {"restitution", "1", 1.0},
                                 {"deviation", "1", 1.0},
                                 {"undamped_contact_time", "s", 1.0}});
  return columns;
}

/// Compares the members of the JSON output with the request and the references.
void compare_json(const Range& range, const Json& json, const Setup& setup, WorstRange& worst, Differences& differ) {
  const ImpactRequest& common = range.common;
  const std::string parameter = common.parameter();
  const std::size_t pairs = json.at("pairs").size();
  differ.compare("number of pairs", pairs, range.pairs.size());
  if (pairs != range.pairs.size()) return;
  const std::vector<double> exact = member(json, "exact_" + parameter), restitution = member(json, "restitution"),
                            deviation = member(json, "deviation"), masses = member(json, "effective_mass"),
                            undamped = member(json, "undamped_contact_time");
  const double used = json.at(parameter).get<double>(), wanted = common.restitution;
  std::vector<double> expected;
  double largest = 0.0;
  for (std::size_t i = 0; i < pairs; ++i) {
    const ImpactRequest& pair = range.pairs[i];
    expected.push_back(exact_of(pair).damping);
    keep_worst(worst.mass, masses[i] / pair.effective_mass() - 1.0);
    keep_worst(worst.damping, exact[i] / expected.back() - 1.0);
    keep_worst(worst.restitution, restitution[i] - restitution_with(pair, used));
    keep_worst(worst.deviation, deviation[i] - (restitution[i] - wanted));
    keep_largest(largest, restitution[i] - wanted);
    differ.compare("members of a pair", json.at("pairs").at(i).size(), range.given.size() + 5);
    keep_worst(worst.undamped, undamped[i] / undamped_time(pair) - 1.0);
  }
  keep_worst(worst.undamped,
             json.at("shortest_undamped_contact_time").get<double>() / std::ranges::min(undamped) - 1.0);
  differ.holds("error of the advised step", json.at("restitution_error").get<double>() > 0.0 &&
                                                json.at("restitution_error").get<double>() <= step_bound);
  keep_worst(worst.deviation, json.at("largest_deviation").get<double>() - largest);
  const auto [low, high] = std::ranges::minmax(expected);
  const double mean = std::accumulate(expected.begin(), expected.end(), 0.0) / static_cast<double>(pairs);
  const double minimax = setup.has("mean_dashpot") ? mean : json.at("minimax_" + parameter).get<double>();
  const double smallest = largest_deviation(range, minimax);
  keep_worst(worst.minimax, json.at("minimax_deviation").get<double>() - smallest);
  keep_worst(worst.search, smallest - searched_deviation(range, low, high));
  differ.compare("minimax dashpot used", used, json.at("minimax_" + parameter).get<double>());
  differ.compare("law", json.at("law").get<std::string>(), common.law);
  differ.compare("wanted_restitution", json.at("wanted_restitution").get<double>(), wanted);
  differ.compare("units", json.at("units").get<std::string>(), std::string{"SI"});
  const bool has_radius =
      std::ranges::any_of(range.options, [](const Option& each) { return each.first == "--radius"; });
  std::size_t members = 12;
  if (common.is_hertz()) {
    differ.compare("modulus", json.at("modulus").get<double>(), common.stiffness);
    differ.compare("dashpot", json.at("dashpot").get<std::string>(),
                   std::string{common.constant ? "constant" : "tsuji"});
    if (has_radius) differ.compare("radius", json.at("radius").get<double>(), common.radius);
    members += has_radius ? 3 : 2;
  } else {
    differ.compare("stiffness", json.at("stiffness").get<double>(), common.stiffness);
    members += 1;
  }
  if (common.is_hunt_crossley()) {
    const bool has_overlap =
        std::ranges::any_of(range.options, [](const Option& each) { return each.first == "--reference-overlap"; });
    differ.compare("exponent", json.at("exponent").get<double>(), common.exponent);
    if (has_overlap) differ.compare("reference_overlap", json.at("reference_overlap").get<double>(), common.radius);
    members += has_overlap ? 2 : 1;
  } else {
    differ.compare("end_rule", json.at("end_rule").get<std::string>(), name_of(common.rule));
    members += 1;
  }
  differ.compare("number of members", json.size(), members);
}

/// Compares the printed table and lines, in US units, with the JSON output.
void compare_text(const Range& range, const std::string& printed, const Json& json, WorstRange& worst,
                  Differences& differ) {
  const std::vector<TableColumn> columns = columns_of(range);
  std::vector<std::string> names, units;
  for (const TableColumn& column : columns) {
    names.push_back(column.name);
    for (const std::string& word : tokens_of(column.unit))
      units.push_back(word);
  }
  std::istringstream lines{printed};
  std::string line;
  std::getline(lines, line);
  const std::string parameter = range.common.parameter();
  differ.holds("printed heading",
               line.starts_with(fmt::format("one {} for a restitution of {} of {} pairs ({}", parameter,
                                            range.common.restitution, range.pairs.size(), range.common.law)));
  std::getline(lines, line);
  differ.compare("printed names of columns", tokens_of(line), names);
  std::getline(lines, line);
  differ.compare("printed units of columns", tokens_of(line), units);
  for (const Json& pair : json.at("pairs")) {
    std::getline(lines, line);
    const std::vector<std::string> cells = tokens_of(line);
    differ.compare("printed cells", cells.size(), columns.size());
    for (std::size_t i = 0; i < std::min(cells.size(), columns.size()); ++i) {
      const double value = pair.at(columns[i].name).get<double>() / columns[i].size;
      keep_worst(worst.printed, relative_error(std::strtod(cells[i].c_str(), nullptr), value));
    }
  }
  const double size = columns[range.given.size() + 1].size, used = json.at(parameter).get<double>();
  keep_worst(worst.printed, relative_error(number_after(printed, parameter + ", minimax ") * size, used));
  keep_worst(worst.printed,
             relative_error(number_after(printed, "deviate by at most "), json.at("largest_deviation").get<double>()));
  const double step = json.at("step").get<double>();
  keep_worst(worst.printed, relative_error(number_after(printed, "step for all pairs "), step));
  keep_worst(worst.printed, relative_error(number_after(printed, "step over shortest undamped contact time ") *
                                               json.at("shortest_undamped_contact_time").get<double>(),
                                           step));
  differ.holds(
      "printed method, row and bound",
      printed.find(fmt::format("with velocity_verlet; row {} requires it; ", json.at("step_row").get<int>())) !=
              std::string::npos &&
          printed.find(fmt::format("is at most {:.3g}, required {}\n", json.at("restitution_error").get<double>(),
                                   step_bound)) != std::string::npos);
  keep_worst(worst.printed, relative_error(number_after(printed, "\n  " + parameter + " = \"") * size, used));
  const std::string every = range.common.varies() ? " at one speed" : ", whatever the bodies and the speed";
  const std::string speed = range.common.varies() ? " and restitution_speed, that speed," : "";
  differ.contains("printed line for every impact", squeezed(printed),
                  fmt::format("for every impact{}: restitution = {}{} in place of {}\n", every,
                              range.common.restitution, speed, parameter));
}

/// The column in SI units.
TableColumn in_si(const TableColumn& column) {
  static const std::map<std::string, std::string> units{{"ft", "m"},    {"ft/s", "m/s"},       {"ft^-1 s", "m^-1 s"},
                                                        {"slug", "kg"}, {"lbf s/ft", "N s/m"}, {"s", "s"},
                                                        {"1", "1"}};
  return {column.name, units.at(column.unit), 1.0};
}

/// Compares the table of a folder, of these columns, with the JSON output.
void compare_csv(const std::vector<TableColumn>& columns, const records::Csv& csv, const Json& json, WorstRange& worst,
                 Differences& differ) {
  std::vector<std::string> heads;
  for (const TableColumn& column : columns)
    heads.push_back(fmt::format("{} [{}]", column.name, column.unit));
  differ.compare("heads of calibration.csv", csv.header(), heads);
  differ.compare("rows of calibration.csv", csv.rows(), json.at("pairs").size());
  if (csv.header() != heads || csv.rows() != json.at("pairs").size()) return;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const std::vector<double> values = member(json, columns[i].name);
    for (std::size_t row = 0; row < csv.rows(); ++row)
      keep_worst(worst.csv, relative_error(csv.number(row, i) * columns[i].size, values[row]));
  }
}

/// Compares the drawing with the JSON output: a panel for each column whose values differ.
void compare_drawing(const Range& range, const std::string& script, const Json& json, WorstRange& worst,
                     Differences& differ) {
  const picture_options::Picture picture = picture_options::read_picture(script);
  const std::vector<double> restitution = member(json, "restitution");
  std::size_t panel = 0;
  const std::vector<TableColumn> columns = columns_of(range);
  for (std::size_t i = 0; i <= range.given.size(); ++i) {
    const std::vector<double> values = member(json, columns[i].name);
    const auto [low, high] = std::ranges::minmax(values);
    if (!(low < high)) continue;
    differ.holds("drawn panel of " + columns[i].name, panel < picture.panels.size());
    if (panel >= picture.panels.size()) return;
    const picture_options::Panel& drawn = picture.panels[panel++];
    std::string label = columns[i].name;
    std::ranges::replace(label, '_', ' ');
    differ.contains("drawn abscissa", drawn.x_label, label);
    differ.contains("drawn ordinate", drawn.y_label, "restitution");
    std::vector<picture_options::Point> points;
    for (const picture_options::Curve& curve : drawn.curves)
      for (const auto& part : curve.lines)
        points.insert(points.end(), part.begin(), part.end());
    differ.compare("drawn points", points.size(), values.size());
    for (std::size_t row = 0; row < std::min(points.size(), values.size()); ++row) {
      keep_worst(worst.drawn, points[row][0] * columns[i].size / values[row] - 1.0);
      keep_worst(worst.drawn, points[row][1] - restitution[row]);
    }
  }
  differ.compare("number of drawn panels", picture.panels.size(), panel);
}

/// With a given dashpot: its restitutions beside the minimax dashpot.
void compare_given(const Range& range, const Program& program, const Environment& recorded, const Json& minimax,
                   WorstRange& worst, Differences& differ) {
  const std::string parameter = range.common.parameter();
  const double given = exact_of(range.pairs.front()).damping;
  Options options = range.options;
  options.push_back(
      {"--" + parameter, {fmt::format("{} {}", given, range.common.is_hunt_crossley() ? "s/m" : "N s/m")}});
  Options in_json = options;
  in_json.insert(in_json.end(), {{"--json", {}}, {"--out", {"given"}}});
  const Json json =
      Json::parse(talus_output(program.folder(), with_options({"calibrate"}, in_json, program.setup()), recorded));
  differ.compare("given dashpot", json.at(parameter).get<double>(), given);
  differ.compare("minimax beside a given dashpot", json.at("minimax_" + parameter), minimax.at("minimax_" + parameter));
  differ.compare("its deviation", json.at("minimax_deviation"), minimax.at("minimax_deviation"));
  keep_worst(worst.given, json.at("largest_deviation").get<double>() - largest_deviation(range, given));
  std::vector<TableColumn> columns;
  std::ranges::transform(columns_of(range), std::back_inserter(columns), in_si);
  compare_csv(columns, program.csv("given/calibration.csv"), json, worst, differ);
  differ.holds("picture beside JSON", program.has("given/calibration.pdf"));
  const std::string printed = program.run({"calibrate"}, options);
  keep_worst(worst.printed, number_after(printed, parameter + ", as given ") / given - 1.0);
  const auto deviation_on_line = [&](const std::string& start) {
    return number_after(printed.substr(printed.find(parameter + start)), "deviate by at most ");
  };
  keep_worst(worst.printed,
             relative_error(deviation_on_line(", as given "), json.at("largest_deviation").get<double>()));
  keep_worst(worst.printed,
             relative_error(deviation_on_line(", minimax "), json.at("minimax_deviation").get<double>()));
}

/// The lines for a scene of one pair, from the text of a range.
std::string lines_of_pair(const std::string& printed, const ImpactRequest& pair) {
  const std::size_t from = printed.find('\n', printed.find("in a scene, for all these pairs")) + 1;
  std::string lines = printed.substr(from, printed.find("for every impact", from) - from);
  const std::string radius = "  # radius: that of each pair";
  if (const std::size_t at = lines.find(radius); at != std::string::npos)
    lines.replace(at, radius.size(), fmt::format("  radius = \"{} m\"", pair.radius));
  return lines;
}

/// The step for all pairs: with it, runs of the pairs with the printed lines give the restitutions of the table; it is
/// as long as that of the pair that needs the shortest one when it is calibrated alone.
void compare_step(const Range& range, const Program& program, const std::string& text, const Json& json,
                  WorstRange& worst) {
  const std::string parameter = range.common.parameter();
  const double used = json.at(parameter).get<double>(), step = json.at("step").get<double>();
  const std::vector<double> restitution = member(json, "restitution");
  const std::string value = fmt::format("{} {}", used, range.common.is_hunt_crossley() ? "s/m" : "N s/m");
  const std::size_t row = json.at("step_row").get<std::size_t>() - 1;
  double shortest = std::numeric_limits<double>::infinity(), of_row = shortest;
  for (std::size_t i = 0; i < range.pairs.size(); ++i) {
    if (restitution[i] == 0.0) continue;  // no end
    const ImpactRequest& pair = range.pairs[i];
    Options alone = options_of(pair, step_bound);
    alone.push_back({"--" + parameter, {value}});
    const std::string printed = program.run({"calibrate"}, alone);
    const double step_alone = number_after(printed, "\n  step ");
    shortest = std::min(shortest, step_alone);
    if (i == row) of_row = step_alone;
    const ExactImpact exact{used, number_after(printed, "\n  contact time "),
                            number_after(printed, "largest overlap at that speed ")};
    keep_worst(worst.run, restitution_of_run(program, pair, lines_of_pair(text, pair), step, exact) - restitution[i]);
  }
  if (!std::isfinite(shortest)) return;
  keep_worst(worst.finer, std::max(0.0, shortest / step - 1.0));
  keep_largest(worst.coarser, step / shortest);
  keep_largest(worst.row, of_row / shortest);
}

/// A pair of nearly no restitution, accurate with few steps, and one of 0.4, whose contact is less than twice as long
/// but needs steps of a twentieth: the step of the range against that of the second pair alone.
void compare_dissimilar_pairs(const Program& program, WorstRange& worst) {
  const std::vector<std::string> impact{"calibrate",  "--stiffness",  "10000 N/m", "--end-rule",
                                        "attractive", "--integrator", "rk4",       "--bound",
                                        "0.003",      "--speed",      "1 m/s"};
  const Json json =
      program.json(impact, {{"--restitution", {"0.2"}}, {"--masses", {"1 kg", "10 kg", "2"}}, {"--json", {}}});
  const std::string alone = program.run(
      impact, {{"--damping", {fmt::format("{} N s/m", json.at("damping").get<double>())}}, {"--masses", {"10 kg"}}});
  keep_largest(worst.coarser, json.at("step").get<double>() / number_after(alone, "\n  step "));
}

/// Two speeds of a Hertzian contact with a constant dashpot: the fast impact requires the step, at which the slow one
/// has an estimated error that is larger by 5 %. The error of both is the larger of the two.
void compare_second_error(const Program& program, Differences& differ) {
  const auto calibrated = [&](const std::string& speeds) {
    program.write("pairs.csv", "mass_2 [kg],speed [m/s]\n" + speeds);
    return program.json({"calibrate",  "--law",        "hertz",           "--modulus", "1e8 Pa",
                         "--radius",   "0.05 m",       "--dashpot",       "constant",  "--end-rule",
                         "attractive", "--integrator", "velocity_verlet", "--bound",   "0.02",
                         "--damping",  "200 N s/m",    "--restitution",   "0.5",       "--pairs",
                         "pairs.csv",  "--json"});
  };
  const Json alone = calibrated("1,3\n"), both = calibrated("1,3\n1,1.5\n");
  differ.compare("step of the faster impact", both.at("step"), alone.at("step"));
  const double ratio = both.at("restitution_error").get<double>() / alone.at("restitution_error").get<double>();
  differ.holds("error of both above that of the faster one", ratio > 1.03 && ratio < 1.08);
}

}  // namespace

void check_ranges(const Program& program, Findings& findings) {
  const Setup& setup = program.setup();
  Differences differ;
  WorstRange worst;
  ImpactDraw draw;
  const Environment recorded = picture_options::recorded_pictures();
  const std::size_t count = setup.tier == Tier::full ? 30 : setup.coarse ? 5 : 20;
  const bool is_of_text = setup.needs("outputs that differ");  // most controls are of the numbers of JSON alone
  for (std::size_t number = 0; number < count; ++number) {
    const ImpactRequest common = draw.request(number);
    const std::size_t kind = setup.coarse ? number : number / 4 % 5;
    const Range range = kind == 0   ? range_of_spheres(common, draw, setup)
                        : kind == 1 ? range_of_speeds(common, draw)
                        : kind == 2 ? range_of_masses(common, draw, setup)
                                    : range_of_file(common, draw, program, kind == 4);
    Options in_json = range.options, in_feet = range.options;
    in_json.push_back({"--json", {}});
    const Json json = program.json({"calibrate"}, in_json);
    compare_json(range, json, setup, worst, differ);
    if (!is_of_text) continue;
    const std::string out = fmt::format("out{}", number);
    in_feet.insert(in_feet.end(), {{"--units", {"US"}}, {"--out", {out}}, {"--format", {"svg"}}});
    const std::string printed = talus_output(program.folder(), with_options({"calibrate"}, in_feet, setup), recorded);
    compare_text(range, printed, json, worst, differ);
    differ.contains("names of files", printed, fmt::format("{0}/calibration.csv\n{0}/calibration.svg\n", out));
    compare_csv(columns_of(range), program.csv(out + "/calibration.csv"), json, worst, differ);
    compare_drawing(range, program.read(out + "/calibration.svg"), json, worst, differ);
    // Two calls for each pair: in the quick tier of spheres for some laws, of masses for the others.
    const bool is_of_tier = setup.tier == Tier::full || (kind == 0) == (number % 2 == 0);
    if ((kind == 0 || kind == 2) && is_of_tier) compare_step(range, program, printed, json, worst);
    if (kind == 0) compare_given(range, program, recorded, json, worst, differ);
  }
  if (setup.needs("ranges: step")) compare_dissimilar_pairs(program, worst);
  if (is_of_text) compare_range_refusals(program, differ), compare_second_error(program, differ);
  findings.expect("ranges: effective masses over the exact ones, largest deviation from 1", worst.mass, 0.0,
                  Tolerance::round_off(6e-15,
                                       "some ten operations on both sides; radii are spaced by powers here, by "
                                       "exponentials there"));
  findings.expect("ranges: dashpots of the pairs over the exact ones, largest deviation from 1", worst.damping, 0.0,
                  Tolerance::model(4e-13, "as for a single pair"));
  findings.expect("ranges: restitutions with the common dashpot, largest error", worst.restitution, 0.0,
                  Tolerance::model(1e-13, "both sides integrate to 1e-14"));
  findings.expect("ranges: deviations from the restitutions, largest error", worst.deviation, 0.0,
                  Tolerance::round_off(2.3e-16, "one subtraction of numbers below 1"));
  findings.expect("ranges: undamped contact times over the exact ones, largest deviation from 1", worst.undamped, 0.0,
                  Tolerance::model(1e-13, "both sides integrate to 1e-14"));
  findings.expect("ranges: restitutions of runs at the advised step, largest difference from the table", worst.run, 0.0,
                  Tolerance::truncation(step_bound, 1.0, "the error that the step may cause"));
  findings.expect("ranges: step below that of the pair that needs the shortest one alone, largest ratio less 1",
                  worst.finer, 0.0, Tolerance::model(5.1e-9, "nine digits are printed"));
  findings.expect_between("ranges: step over that of the pair that needs the shortest one alone, largest ratio",
                          worst.coarser, 1.0 - 1e-8, 2.1,
                          "alone, steps are tried in powers of two; in a range a pair has any number of steps");
  findings.expect("ranges: step alone of the row named for the step over the shortest of all, largest ratio", worst.row,
                  1.0,
                  Tolerance::model(5.1e-9, "the pair of the shortest contact requires it; nine digits are printed"));
  findings.expect("ranges: smallest largest deviation, largest error", worst.minimax, 0.0,
                  Tolerance::model(1e-13, "as the restitutions"));
  findings.expect_between("ranges: largest deviation with the minimax dashpot less that by a search", worst.search,
                          -resolution, 1e-13,
                          "no dashpot of the search may be better beyond round-off; its last one differs by up to 1e-4 "
                          "in ln(c), and e changes by at most 1 for each unit of ln(c)");
  findings.expect("ranges: largest deviation with a given dashpot, largest error", worst.given, 0.0,
                  Tolerance::model(1e-13, "as the restitutions"));
  findings.expect("ranges: printed numbers over those of JSON, largest deviation from 1", worst.printed, 0.0,
                  Tolerance::model(5.1e-6, "six digits are printed: half a unit of the last one"));
  findings.expect("ranges: numbers of calibration.csv over those of JSON, largest deviation from 1", worst.csv, 0.0,
                  Tolerance::round_off(2e-15, "units of up to two rounded factors, one division and one product"));
  findings.expect("ranges: drawn points less those of JSON, largest deviation", worst.drawn, 0.0,
                  Tolerance::model(5.1e-9, "nine digits are written: half a unit of the last one"));
  differ.expect_none(findings, "ranges: outputs that differ from the request", "numbers, texts, files and refusals");
}

}  // namespace talus::verification::problems::calibrated_laws
