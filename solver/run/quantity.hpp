#pragma once

#include <string>
#include <string_view>

#include "solver/base/fields.hpp"
#include "solver/run/history.hpp"

namespace talus {

/// Reductions of one column of a run to one number.
enum class Reduction {
  max,      ///< the largest
  min,      ///< the smallest
  abs_max,  ///< the largest absolute value
  end,      ///< the last
};

/// One number of a run: a reduced column of its history.
struct Quantity {
  std::string name;       ///< as given by the user
  std::size_t column{};   ///< index in a row of the history
  Dimension dimension{};  ///< of the column
  bool ledger{};          ///< the column belongs to the energy and momentum balance
  Reduction reduction{Reduction::end};

  /// The reduced value, from the minimum, the maximum and the last value of the column.
  [[nodiscard]] double of(double minimum, double maximum, double last) const;
};

/// The quantity with the given name: a column of the history ("top.tension", "rock.vx", "energy.kinetic"), optionally
/// with its kind as a prefix ("cable.top.tension", "body.rock.vx", "contact.impact.force"), followed by ".max", ".min",
/// ".abs_max" or ".end". Errors: InputError for an unknown column or reduction, with the nearest and all known names.
[[nodiscard]] Quantity quantity_named(const Model& model, std::string_view name);

template <>
struct Names<Reduction> {
  static constexpr std::array<std::string_view, 4> list{"max", "min", "abs_max", "end"};
};
}  // namespace talus
