#include <fmt/format.h>
#include <fmt/ranges.h>

#include "solver/io/fence1993/fence_names.hpp"
#include "solver/io/file/quantity_text.hpp"
#include "solver/io/scene/read_fence.hpp"
#include "solver/io/scene/write_fence.hpp"

namespace talus {
namespace {

using scenes::Fence;
using scenes::FenceElement;

/// A quantity in quotes, in the units of the deck if they preserve its bits, otherwise in consistent units; a pure
/// number is not quoted.
std::string quoted(double value, Dimension dimension, const UnitSystem& units) {
  if (dimension == dimension::number) {
    const std::string text = decimal(value, "", dimension, units).text;
    // A whole number would lose the sign of -0.
    return text.find_first_of(".e") == std::string::npos ? text + ".0" : text;
  }
  const std::string unit = units == us ? deck_unit(dimension) : symbol(units, dimension);
  const Decimal number = decimal(value, unit, dimension, units);
  if (number.exact) return fmt::format("\"{} {}\"", number.text, unit);
  const std::string own = symbol(units, dimension);
  return fmt::format("\"{} {}\"", decimal(value, own, dimension, units).text, own);
}

/// Text as a basic string of TOML.
std::string in_quotes(std::string_view text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') result += '\\';
    result += c;
  }
  return result + '"';
}

template <class T>
std::string number_lines(const T& value, const UnitSystem& units) {
  std::string text;
  for (const auto& field : T::counts()) {
    std::visit([&](auto member) { text += fmt::format("{} = {}\n", field.name, value.*member); }, field.member);
  }
  for (const auto& field : T::fields())
    text += fmt::format("{} = {}\n", field.name, quoted(value.*field.member, field.dimension, units));
  return text;
}

/// The lines of a text, each with its line end.
std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  for (std::size_t from = 0; from < text.size();) {
    const std::size_t end = text.find('\n', from) + 1;
    lines.push_back(text.substr(from, end - from));
    from = end;
  }
  return lines;
}

std::string element_lines(std::string_view head, const FenceElement& element, const UnitSystem& units) {
  std::string text = fmt::format("\n{}\nsolid = \"{}\"\n", head, name_of(element.solid));
  const bool by_power = element.outline == scenes::ElementOutline::by_power;
  for (const std::string& line : lines_of(number_lines(element, units))) {
    if (by_power || !line.starts_with("power = ")) text += line;
  }
  if (!by_power) text += fmt::format("shape = \"{}\"\n", name_of(element.outline));
  if (element.outline == scenes::ElementOutline::superquadric)
    text += fmt::format("exponent = {}\n", quoted(element.exponent, dimension::number, units));
  if (element.along != 0.0) text += fmt::format("along = {}\n", quoted(element.along, dimension::length, units));
  for (const auto& field : FenceElement::vectors()) {
    const Vec2 vector = element.*field.member;
    text += fmt::format("{} = [{}, {}]\n", field.name, quoted(vector.x, field.dimension, units),
                        quoted(vector.y, field.dimension, units));
  }
  std::vector<std::string> held;
  for (std::size_t i = 0; i < element.held.size(); ++i) {
    if (element.held[i]) held.push_back(in_quotes(held_axes[i]));
  }
  // The ground is held by default, so that its `held` is always written.
  const bool said = !held.empty() || head == "[fence.ground]";
  return said ? text + fmt::format("held = [{}]\n", fmt::join(held, ", ")) : text;
}

std::string option_lines(const scenes::FenceOptions& options, const UnitSystem& units) {
  std::string text = "\n[fence.options]\n";
  for_each_choice(options, [&](std::string_view name, auto choice) {
    text += fmt::format("{} = \"{}\"\n", name, name_of(choice));
  });
  std::vector<std::string> watched;
  for (const MonitorRules::Choice& choice : MonitorRules::choices())
    watched.push_back(fmt::format("{} = \"{}\"", choice.name, name_of(options.watch.*choice.member)));
  text += fmt::format("watch = {{ {} }}\n", fmt::join(watched, ", "));
  text += fmt::format("integrator = \"{}\"\n", options.integrator) + number_lines(options, units);
  if (options.table.empty()) return text;
  std::vector<std::string> points;
  for (const scenes::YieldMultiple& point : options.table)
    points.push_back(fmt::format("[{}, {}]", quoted(point.strain, dimension::number, units),
                                 quoted(point.multiple, dimension::number, units)));
  return text + fmt::format("table = [{}]\n", fmt::join(points, ", "));
}

}  // namespace

std::string write_fence(const Fence& fence) {
  std::string text = fence.title.empty() ? "" : fmt::format("title = {}\n", in_quotes(fence.title));
  text += fmt::format("units = \"{}\"\n\n[fence]\n", fence.units.name);
  const bool historical = fence.options == scenes::FenceOptions{};
  if (historical) text += fmt::format("rules = \"{}\"\n", fence_rules_1993);
  text += number_lines(fence, fence.units);
  text += fmt::format("history_elements = [{}]\n", fmt::join(fence.history_elements, ", "));
  text += fmt::format("history_codes = [{}]\n", fmt::join(fence.history_codes, ", "));
  if (!fence.ground_profile.empty()) {
    std::vector<std::string> points;
    for (const Vec2 p : fence.ground_profile)
      points.push_back(fmt::format("[{}, {}]", quoted(p.x, dimension::length, fence.units),
                                   quoted(p.y, dimension::length, fence.units)));
    text += fmt::format("ground_profile = [{}]\n", fmt::join(points, ", "));
  }
  text += element_lines("[fence.ground]", fence.ground, fence.units);
  for (const FenceElement& rock : fence.rocks)
    text += element_lines("[[fence.rock]]", rock, fence.units);
  text += element_lines("[fence.column]", fence.column, fence.units);
  for (const scenes::ChangedColumn& column : fence.changed_columns)
    text += "\n[[fence.changed_column]]\n" + number_lines(column, fence.units);
  for (const scenes::StretchedCable& cable : fence.stretched_cables)
    text += fmt::format("\n[[fence.stretched_cable]]\ncable = {}\n", in_quotes(cable.cable)) +
            number_lines(cable, fence.units);
  const bool usual = historical || fence.options == scenes::current_options();
  return usual ? text : text + option_lines(fence.options, fence.units);
}

}  // namespace talus
