#pragma once

#include <CLI/CLI.hpp>
#include <algorithm>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "solver/app/command.hpp"
#include "tests/solver/app/program.hpp"

/// The request of a drawing command, without drawing it. Throws as the command does.
struct Requested {
  talus::app::DrawingRequest request;

  explicit Requested(std::vector<std::string> arguments) {
    using namespace talus::app;
    CLI::App talus{"", "talus"};
    const DrawingSink keep = [this](DrawingRequest sent) { request = std::move(sent); };
    const std::vector<Command> commands{add_plot(talus, keep), add_snapshot(talus, keep), add_animate(talus, keep),
                                        add_calibrate(talus, keep)};
    std::reverse(arguments.begin(), arguments.end());  // CLI11 takes them from the end
    talus.parse(std::move(arguments));
    for (const Command& command : commands)
      if (command.app->parsed()) BOOST_REQUIRE(command.work() == ok);
  }
  const std::vector<talus::reports::Page>& pages() const { return request.pictures.pages; }
  const talus::reports::Page& page() const { return pages().at(0); }
  const talus::records::Figure& panel(std::size_t number) const { return page().panels.at(number); }
  const talus::records::Figure& figure(const std::string& name) const {
    const auto& figures = request.pictures.figures;
    const auto found =
        std::find_if(figures.begin(), figures.end(), [&](const auto& each) { return each.name == name; });
    BOOST_REQUIRE(found != figures.end());
    return *found;
  }
};

/// Kind of object that a series of shapes or circles shows, identified by its look.
inline std::string kind_of(const talus::records::Series& series) {
  const talus::records::Look& look = series.look;
  if (series.style == talus::records::Style::circles) return series.values.empty() ? "wall" : "disc";
  if (!series.values.empty()) return "taut";
  static const std::map<std::pair<std::string, std::string>, std::string> kinds{
      {{"#6b6257", ""}, "ground"},      {{"#5b4a32", "#dcc9a3"}, "column"}, {{"#33475b", "#bfd3e6"}, "body"},
      {{"#2b2b2b", "#a3a3a3"}, "rock"}, {{"#5b4a32", ""}, "hanger"},        {{"#4b9ad6", ""}, "slack"},
      {{"#0072b2", ""}, "border"},      {{"#ffffff", "#ffffff"}, "edge"},   {{"#000000", "#000000"}, "contact"}};
  return kinds.at({look.colour, look.fill});
}

/// A point of a series, with 0 for missing values.
struct Row {
  double line, x, y, radius, value;
  friend auto operator<=>(const Row&, const Row&) = default;
};

/// The points of a figure by kind, collected from all its series of that kind.
inline std::map<std::string, std::vector<Row>> rows(const talus::records::Figure& figure) {
  std::map<std::string, std::vector<Row>> made;
  for (const talus::records::Series& series : figure.series) {
    const auto at = [](const std::vector<double>& numbers, std::size_t i) {
      return numbers.empty() ? 0.0 : numbers.at(i);
    };
    for (std::size_t i = 0; i < series.x.size(); ++i)
      made[kind_of(series)].push_back(
          {at(series.line, i), series.x[i], series.y.at(i), at(series.radius, i), at(series.values, i)});
  }
  return made;
}
