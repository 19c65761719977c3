#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "solver/base/error.hpp"
#include "solver/io/fence1993/deck_records.hpp"
#include "solver/io/fence1993/fence_names.hpp"
#include "solver/io/fence1993/fence_rules.hpp"
#include "solver/io/fence1993/read_deck.hpp"
#include "solver/io/fence1993/write_deck.hpp"
#include "solver/io/file/quantity_text.hpp"

namespace talus {
namespace {

using scenes::Fence;

/// Writes the records that deck_records::pass visits.
class DeckWriter {
 public:
  explicit DeckWriter(const Fence& fence) : text_{fence.title}, units_{fence.units} {}

  void element(std::size_t number) { element_ = number; }

  void record(std::string_view names) {
    end_record();
    names_ = element_ == 0 ? std::string{names} : fmt::format("element {}: {}", element_, names);
  }

  template <class T>
  void real(std::string_view, const T& owner, double T::*member) {
    add(owner.*member, deck_records::field_of(T::fields(), member).dimension);
  }
  template <class T>
  void pair(std::string_view, std::string_view, const T& owner, Vec2 T::*member) {
    const Dimension dimension = deck_records::field_of(T::vectors(), member).dimension;
    add((owner.*member).x, dimension);
    add((owner.*member).y, dimension);
  }
  template <class T, class Whole>
  void count(std::string_view, const T& owner, Whole T::*member) {
    values_.push_back(fmt::format("{}", owner.*member));
  }
  template <class Enum>
  void code(std::string_view, std::string_view, Enum value) {
    values_.push_back(fmt::format("{}", static_cast<int>(value)));
  }
  void held(const std::array<bool, 3>& axes) {
    for (const bool axis : axes)
      values_.emplace_back(axis ? "1" : "0");
  }
  void rocks(const Fence& fence) { values_.push_back(fmt::format("{}", fence.rocks.size() + 2)); }

  void list(std::string_view count, std::string_view item, std::string_view field, const std::vector<int>& values) {
    record(count);
    values_.push_back(fmt::format("{}", values.size()));
    record(item);
    for (const int value : values)
      values_.push_back(fmt::format("{}", value));
    // The 1993 program reads hvmax codes, more than it stores; its sample deck ends the codes with an additional 0.
    if (field == "history_codes") values_.resize(maximum_history_codes + 1, "0");
  }

  std::string text() {
    end_record();
    return text_;
  }

 private:
  void add(double value, Dimension dimension) {
    values_.push_back(decimal(value, deck_unit(dimension), dimension, units_).text);
  }

  void end_record() {
    if (!names_.empty()) text_ += fmt::format("{}\t{}", fmt::join(values_, " "), names_);
    text_ += '\n';
    values_.clear();
  }

  std::string text_;
  UnitSystem units_;
  std::string names_;  ///< of the values of the current record
  std::size_t element_{0};
  std::vector<std::string> values_;
};

/// Each option as `name = value`, and whether the cables have a table.
std::vector<std::string> choices(const scenes::FenceOptions& options) {
  std::vector<std::string> result;
  for_each_choice(options, [&](std::string_view name, auto choice) {
    result.push_back(fmt::format("{} = \"{}\"", name, name_of(choice)));
  });
  for (const MonitorRules::Choice& choice : MonitorRules::choices())
    result.push_back(fmt::format("watch {} = \"{}\"", choice.name, name_of(options.watch.*choice.member)));
  result.push_back(fmt::format("integrator = \"{}\"", options.integrator));
  for (const auto& field : scenes::FenceOptions::fields())
    result.push_back(fmt::format("{} = {}", field.name, options.*field.member));
  result.push_back(options.table.empty() ? "no table" : "table");
  return result;
}

}  // namespace

std::string write_deck(const Fence& fence) {
  std::vector<std::string> beyond = choices(fence.options);
  const std::vector<std::string> of_1993 = choices({});
  std::erase_if(beyond, [&](const auto& choice) { return std::ranges::find(of_1993, choice) != of_1993.end(); });
  if (!beyond.empty()) {
    throw InputError{fmt::format("a deck has no record for the options of a fence; found {}; it must be {}",
                                 fmt::join(beyond, ", "), fmt::join(of_1993, ", "))};
  }
  if (!fence.ground_profile.empty()) throw InputError{"a deck has level ground; found a ground_profile"};
  if (!fence.stretched_cables.empty()) throw InputError{"a deck's cables are new; found a stretched_cable"};
  if (!fence.changed_columns.empty()) throw InputError{"a deck has one kind of column; found a changed_column"};
  const auto by_power = [](const scenes::FenceElement& e) { return e.outline == scenes::ElementOutline::by_power; };
  if (!std::ranges::all_of(fence.rocks, by_power) || !by_power(fence.column))
    throw InputError{"a deck gives outlines by power; found shape or exponent; give `power` instead"};
  for (std::size_t i = 0; i < fence.rocks.size(); ++i) {
    if (fence.rocks[i].along == 0.0) continue;
    throw InputError{fmt::format("a deck has no place along the fence; found along = {} at rock {}; it must be 0",
                                 fence.rocks[i].along, i + 1)};
  }
  DeckWriter writer{fence};
  deck_records::pass(writer, fence);
  return writer.text();
}

}  // namespace talus
