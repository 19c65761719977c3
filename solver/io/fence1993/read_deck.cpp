#include "solver/io/fence1993/read_deck.hpp"

#include <fmt/format.h>

#include <cmath>
#include <map>

#include "solver/base/error.hpp"
#include "solver/io/fence1993/deck_records.hpp"
#include "solver/io/fence1993/fence_rules.hpp"
#include "solver/io/file/fortran.hpp"
#include "solver/io/file/list_directed.hpp"
#include "solver/io/file/quantity_text.hpp"
#include "solver/io/file/toml_document.hpp"
#include "solver/io/file/utf8.hpp"

namespace talus {
namespace {

using scenes::ElementType;
using scenes::Fence;

/// Maximum number of rocks, and of elements with histories, of a deck.
constexpr long most_items = 1000;

std::string words_for(Range range) {
  return range == Range::any ? "a number" : fmt::format("a number {}", words(range));
}

/// Reads the records that deck_records::pass visits.
class DeckReader {
  struct Place {
    int line{};
    std::string record{"title"};
  };

  [[noreturn]] void fail(const Place& place, std::string_view name, std::string_view words) const {
    const std::string record = name.substr(0, place.record.size()) == place.record ? "" : place.record + ": ";
    throw InputError{fmt::format("{}:{}: {}{}: {}", name_, place.line, record, name, words)};
  }

  /// Calls `action`; prepends the location to an InputError that it throws.
  template <class Action>
  auto placed(std::string_view name, Action&& action) {
    try {
      return action();
    } catch (const InputError& error) {
      fail({std::max(input_.line(), 1), place_.record}, name, error.what());
    }
  }

 public:
  DeckReader(std::string_view text, std::string_view name) : input_{text}, name_{name} {}

  std::string title() {
    place_.line = 1;
    const std::string title = as_utf8(placed("title", [&] { return input_.whole_line(); }));
    if (const std::string why = title_error(title); !why.empty()) fail(place_, "title", why);
    return title;
  }

  void element(std::size_t number) { element_ = number; }

  void record(std::string_view names) {
    input_.start_record();
    place_.record = element_ == 0 ? std::string{names} : fmt::format("element {}: {}", element_, names);
  }

  template <class T>
  void real(std::string_view name, T& owner, double T::*member) {
    const auto field = deck_records::field_of(T::fields(), member);
    owner.*member = number(name, field.name, field.dimension, field.range);
  }

  template <class T>
  void pair(std::string_view x, std::string_view y, T& owner, Vec2 T::*member) {
    const auto field = deck_records::field_of(T::vectors(), member);
    (owner.*member).x = number(x, field.name, field.dimension, Range::any);
    (owner.*member).y = number(y, field.name, field.dimension, Range::any);
    call(field.name, fmt::format("{}, {}", x, y));
  }

  template <class T, class Whole>
  void count(std::string_view name, T& owner, Whole T::*member) {
    const auto field = deck_records::field_of(T::counts(), member);
    owner.*member = static_cast<Whole>(whole(name, field.name, field.least, field.most));
  }

  template <class Enum>
  void code(std::string_view name, std::string_view field, Enum& value) {
    value = static_cast<Enum>(whole(name, field, 0, static_cast<long>(Names<Enum>::list.size()) - 1));
    if constexpr (std::is_same_v<Enum, ElementType>) check_type(value);
  }

  void held(std::array<bool, 3>& axes) {
    for (std::size_t i = 0; i < 3; ++i)
      axes[i] = whole(fmt::format("bc({})", i + 1), "held", 0, 1) == 1;
  }

  void rocks(Fence& fence) {
    elements_ = whole("nel", "rocks", 3, most_items + 2);
    fence.rocks.resize(static_cast<std::size_t>(elements_ - 2));
  }

  void list(std::string_view count, std::string_view item, std::string_view field, std::vector<int>& values) {
    record(count);
    const bool codes = field == "history_codes";
    const auto size = whole(count, field, 0, codes ? static_cast<long>(most_history_codes) : most_items);
    record(item);
    values.clear();
    for (long i = 1; i <= size; ++i)
      values.push_back(static_cast<int>(whole(fmt::format("{}({})", item, i), field, 1, 1'000'000)));
    call(field, item);
  }

  [[noreturn]] void fail(const FenceFault& fault) const {
    const auto& [place, name] = places_.at({fault.element, fault.field});
    fail(place, name, fault.words);
  }

 private:
  std::string_view value(std::string_view name, std::string_view field) {
    const std::string_view text = placed(name, [&] { return input_.value(); });
    place_.line = input_.line();
    places_[{element_, std::string{field}}] = {place_, std::string{name}};
    return text;
  }

  /// Names a member that consists of several numbers by all their names.
  void call(std::string_view field, std::string_view names) { places_[{element_, std::string{field}}].second = names; }

  double number(std::string_view name, std::string_view field, Dimension dimension, Range range) {
    const std::string_view text = value(name, field);
    double number = 0.0;
    const bool is_number = placed(name, [&] { return parse_fortran_real(text, number); });
    const double result = consistent(number, deck_unit(dimension), dimension, us);
    if (is_number && !std::isfinite(result)) fail(place_, name, found_text(text) + "; the number is too large");
    if (!is_number || !contains(range, result)) {
      fail(place_, name, fmt::format("{}; it must be {}", found_text(text), words_for(range)));
    }
    return result;
  }

  long whole(std::string_view name, std::string_view field, long least, long most) {
    const std::string_view text = value(name, field);
    double number = 0.0;
    const bool is_number = placed(name, [&] { return parse_fortran_real(text, number); });
    if (!is_number || number != std::floor(number) || number < static_cast<double>(least) ||
        number > static_cast<double>(most)) {
      fail(place_, name, fmt::format("{}; it must be {}", found_text(text), whole_words(least, most)));
    }
    return static_cast<long>(number);
  }

  static std::string whole_words(long least, long most) {
    return most - least == 1 ? fmt::format("{} or {}", least, most)
                             : fmt::format("a whole number between {} and {}", least, most);
  }

  /// Fails if the type of an element does not fit its position in the deck, which reveals a wrong count of elements.
  void check_type(ElementType type) const {
    const bool last = static_cast<long>(element_) == elements_;
    if (last == (type == ElementType::column)) return;
    const std::string_view due = last            ? "1, the column, since it is the last"
                                 : element_ == 1 ? "0, the ground, since it is the first"
                                                 : "0, a rock, since it is between the ground and the column";
    fail(place_, "type",
         fmt::format("found {}; with nel = {} this element must be {}; does nel count the elements below?",
                     static_cast<int>(type), elements_, due));
  }

  ListDirected input_;
  std::string name_;
  Place place_;
  std::size_t element_{0};
  long elements_{};
  /// Locations of the members of the fence (element 0) and of its elements (by their numbers).
  std::map<std::pair<std::size_t, std::string>, std::pair<Place, std::string>> places_;
};

}  // namespace

Fence read_deck(std::string_view text, std::string_view name) {
  DeckReader reader{text, name};
  Fence fence;
  fence.units = us;
  fence.title = reader.title();
  deck_records::pass(reader, fence);
  if (const auto found = faults(fence); !found.empty()) reader.fail(found.front());
  return fence;
}

Fence read_deck(const std::filesystem::path& file) { return read_deck(read_text(file), file.string()); }

}  // namespace talus
