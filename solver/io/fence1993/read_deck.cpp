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
#include "verification/record/utf8.hpp"

namespace talus {
namespace {

using scenes::ElementType;
using scenes::Fence;

/// Maximum number of rocks, and of elements with histories, of a deck.
constexpr long maximum_items = 1000;

std::string allowed_text(Range range) {
  return range == Range::any ? "a number" : fmt::format("a number {}", text_of(range));
}

/// Reads the records that deck_records::pass visits.
class DeckReader {
  struct Location {
    int line{};
    std::string record{"title"};
  };

  [[noreturn]] void fail(const Location& location, std::string_view name, std::string_view message) const {
    const std::string record = name.substr(0, location.record.size()) == location.record ? "" : location.record + ": ";
    throw InputError{fmt::format("{}:{}: {}{}: {}", name_, location.line, record, name, message)};
  }

  /// Calls `action`; prepends the location to an InputError that it throws.
  template <class Action>
  auto placed(std::string_view name, Action&& action) {
    try {
      return action();
    } catch (const InputError& error) {
      fail({std::max(input_.line(), 1), location_.record}, name, error.what());
    }
  }

 public:
  DeckReader(std::string_view text, std::string_view name) : input_{text}, name_{name} {}

  /// The fence as written, without checks of its records taken together.
  Fence fence() {
    Fence fence;
    fence.units = us;
    fence.title = title();
    deck_records::pass(*this, fence);
    return fence;
  }

  std::string title() {
    location_.line = 1;
    const std::string title = records::as_utf8(placed("title", [&] { return input_.whole_line(); }));
    if (const std::string why = title_error(title); !why.empty()) fail(location_, "title", why);
    return title;
  }

  void element(std::size_t number) { element_ = number; }

  void record(std::string_view names) {
    input_.start_record();
    location_.record = element_ == 0 ? std::string{names} : fmt::format("element {}: {}", element_, names);
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
    owner.*member = static_cast<Whole>(whole(name, field.name, field.minimum, field.maximum));
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
    elements_ = whole("nel", "rocks", 3, maximum_items + 2);
    fence.rocks.resize(static_cast<std::size_t>(elements_ - 2));
  }

  void list(std::string_view count, std::string_view item, std::string_view field, std::vector<int>& values) {
    record(count);
    const bool codes = field == "history_codes";
    const auto size = whole(count, field, 0, codes ? static_cast<long>(maximum_history_codes) : maximum_items);
    record(item);
    values.clear();
    for (long i = 1; i <= size; ++i)
      values.push_back(static_cast<int>(whole(fmt::format("{}({})", item, i), field, 1, 1'000'000)));
    call(field, item);
  }

  [[noreturn]] void fail(const FenceFault& fault) const {
    const auto found = locations_.find({fault.element, fault.field});
    // A field that a deck does not have.
    if (found == locations_.end()) throw InputError{fmt::format("{}: {}: {}", name_, fault.field, fault.message)};
    fail(found->second.first, found->second.second, fault.message);
  }

 private:
  std::string_view value(std::string_view name, std::string_view field) {
    const std::string_view text = placed(name, [&] { return input_.value(); });
    location_.line = input_.line();
    locations_[{element_, std::string{field}}] = {location_, std::string{name}};
    return text;
  }

  /// Names a member that consists of several numbers by all their names.
  void call(std::string_view field, std::string_view names) {
    locations_[{element_, std::string{field}}].second = names;
  }

  double number(std::string_view name, std::string_view field, Dimension dimension, Range range) {
    const std::string_view text = value(name, field);
    double number = 0.0;
    const bool is_number = placed(name, [&] { return parse_fortran_real(text, number); });
    const double result = consistent(number, deck_unit(dimension), dimension, us);
    if (is_number && !std::isfinite(result)) fail(location_, name, found_text(text) + "; the number is too large");
    if (!is_number || !contains(range, result)) {
      fail(location_, name, fmt::format("{}; it must be {}", found_text(text), allowed_text(range)));
    }
    return result;
  }

  long whole(std::string_view name, std::string_view field, long minimum, long maximum) {
    const std::string_view text = value(name, field);
    double number = 0.0;
    const bool is_number = placed(name, [&] { return parse_fortran_real(text, number); });
    if (!is_number || number != std::floor(number) || number < static_cast<double>(minimum) ||
        number > static_cast<double>(maximum)) {
      fail(location_, name, fmt::format("{}; it must be {}", found_text(text), allowed_whole_text(minimum, maximum)));
    }
    return static_cast<long>(number);
  }

  static std::string allowed_whole_text(long minimum, long maximum) {
    return maximum - minimum == 1 ? fmt::format("{} or {}", minimum, maximum)
                                  : fmt::format("a whole number between {} and {}", minimum, maximum);
  }

  /// Fails if the type of an element does not fit its position in the deck, which reveals a wrong count of elements.
  void check_type(ElementType type) const {
    const bool last = static_cast<long>(element_) == elements_;
    if (last == (type == ElementType::column)) return;
    const std::string_view due = last            ? "1, the column, since it is the last"
                                 : element_ == 1 ? "0, the ground, since it is the first"
                                                 : "0, a rock, since it is between the ground and the column";
    fail(location_, "type",
         fmt::format("found {}; with nel = {} this element must be {}; does nel count the elements below?",
                     static_cast<int>(type), elements_, due));
  }

  ListDirected input_;
  std::string name_;
  Location location_;
  std::size_t element_{0};
  long elements_{};
  /// Locations of the members of the fence (element 0) and of its elements (by their numbers).
  std::map<std::pair<std::size_t, std::string>, std::pair<Location, std::string>> locations_;
};

}  // namespace

Fence read_deck(std::string_view text, std::string_view name) {
  DeckReader reader{text, name};
  const Fence fence = reader.fence();
  if (const auto found = faults(fence); !found.empty()) reader.fail(found.front());
  return fence;
}

Fence read_deck(const std::filesystem::path& file) { return read_deck(read_text(file), file.string()); }

scenes::FenceScene deck_scene(const Fence& fence, std::string_view text, std::string_view name) {
  try {
    return scenes::fence_scene(fence);
  } catch (const scenes::FenceError& error) {
    DeckReader reader{text, name};
    static_cast<void>(reader.fence());
    reader.fail(error.fault());
  } catch (const InputError& error) {
    throw InputError{fmt::format("{}: {}", name, error.what())};
  }
}

}  // namespace talus
