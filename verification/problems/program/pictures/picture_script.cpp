#include "verification/problems/program/pictures/picture_script.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <iterator>
#include <sstream>

namespace talus::verification::problems::picture_options {
namespace {

/// The numbers in a text, whatever separates them.
std::vector<double> numbers(std::string text) {
  for (char& letter : text)
    if (letter == ',' || letter == ':' || letter == '[' || letter == ']') letter = ' ';
  std::istringstream tokens{text};
  return {std::istream_iterator<double>{tokens}, {}};
}

Curve read_curve(std::istream& lines) {
  Curve curve;
  bool begins = true;
  for (std::string line; std::getline(lines, line) && line != "END";) {
    const std::vector<double> row = numbers(line);
    if (row.size() < 2) {
      begins = true;
      continue;
    }
    if (begins) curve.lines.emplace_back();
    begins = false;
    curve.lines.back().push_back({row[0], row[1]});
    if (row.size() == 4) curve.bars.push_back({row[2], row[3]});
  }
  return curve;
}

/// Labels of the curves of a plot command, in order: "... title 'LABEL', ... notitle".
void label(std::vector<Curve>& curves, const std::string& command) {
  std::size_t at = 0;
  for (Curve& curve : curves) {
    at = command.find("title", at);
    if (at == std::string::npos) return;
    const std::string rest = command.substr(at);
    if (rest.starts_with("title '")) curve.label = between(rest, "'", "'");
    at += 5;
  }
}

}  // namespace

double ColourBar::value_at(double position) const {
  if (numbers.size() < 2) return std::nan("");
  const Point &first = numbers.front(), &last = numbers.back();
  return first[1] + (position - first[0]) * (last[1] - first[1]) / (last[0] - first[0]);
}

std::map<std::string, std::string> recorded_pictures() {
  // In the build tree, where programs can be executed; the folder of temporary files may be mounted without that.
  const char* const path = std::getenv("PATH");
  return {{"PATH", fmt::format("{}:{}", TALUS_RECORDER, path != nullptr ? path : "")}};
}

std::string between(const std::string& text, const std::string& before, const std::string& after) {
  const std::size_t from = text.find(before);
  if (from == std::string::npos) return {};
  const std::size_t begin = from + before.size(), end = text.find(after, begin);
  return end == std::string::npos ? "" : text.substr(begin, end - begin);
}

Picture read_picture(const std::string& script) {
  Picture picture;
  Panel panel;
  std::istringstream lines{script};
  for (std::string line; std::getline(lines, line);) {
    const auto setting = [&](const std::string& name) { return line.starts_with("set " + name + " "); };
    const std::string quoted = between(line, "'", "'"), value = line.substr(line.find(' ', 4) + 1);
    if (line.starts_with("load ")) panel = {};
    if (line.starts_with("$")) {
      panel.curves.push_back(read_curve(lines));
      panel.curves.back().name = line.substr(0, line.find(' '));
    }
    if (setting("terminal")) picture.terminal = value.substr(0, value.find(' '));
    if (line.starts_with("set object rect ")) {
      const std::vector<double> from = numbers(between(line, " screen ", ",")),
                                to = numbers(between(line, " to screen ", ","));
      if (from.size() == 1 && to.size() == 1)
        picture.bar.parts.push_back({from[0], to[0], std::stol(line.substr(line.rfind(' ') + 1))});
    }
    if (setting("title")) panel.title = quoted;
    if (setting("xlabel")) panel.x_label = quoted;
    if (setting("ylabel")) panel.y_label = quoted;
    if (setting("xrange")) panel.x_range = numbers(value);
    if (setting("yrange")) panel.y_range = numbers(value);
    if (setting("xtics")) panel.x_tics = numbers(value);
    if (setting("ytics")) panel.y_tics = numbers(value);
    if (line == "unset grid") panel.grid = false;
    if (setting("lmargin")) panel.left = std::stod(line.substr(line.rfind(' ')));
    if (setting("label")) {
      const std::vector<double> position = numbers(between(line, " at ", " center"));
      if (position.size() == 2) panel.marks[quoted] = {position[0], position[1]};
      const std::vector<double> screen = numbers(between(line, " at screen ", ",")), number = numbers(quoted);
      if (screen.size() == 1 && number.size() == 1 && !picture.bar.parts.empty()) {
        picture.bar.numbers.push_back({screen[0], number[0]});
      } else if (!screen.empty()) {
        picture.texts.insert(quoted);
      }
    }
    if (line.starts_with("plot $")) {
      label(panel.curves, line);
      picture.panels.push_back(panel);
    }
  }
  return picture;
}

std::vector<std::string> pages(const std::string& script) {
  std::vector<std::string> found;
  for (std::size_t at = script.find("\nset multiplot"); at != std::string::npos;
       at = script.find("\nset multiplot", at + 1))
    found.push_back(script.substr(at, script.find("unset multiplot", at) - at));
  return found;
}

std::string drawn_content(const std::string& script) {
  const std::size_t terminal = script.find("\nset terminal ");
  return terminal == std::string::npos ? script : script.substr(script.find('\n', terminal + 1));
}

}  // namespace talus::verification::problems::picture_options
