#pragma once

#include <string>
#include <string_view>

#include "solver/base/fields.hpp"
#include "solver/run/history.hpp"

namespace talus {

/// How a run's values of one column become one number.
enum class Reduction {
  max,      ///< the largest
  min,      ///< the least
  abs_max,  ///< the largest in magnitude, without its sign
  end,      ///< the last
};

/// One number of a run: a column of its history, reduced.
struct Quantity {
  std::string name;       ///< as it was asked for
  std::size_t column{};   ///< its place in a row of the history
  Dimension dimension{};  ///< of the column
  bool ledger{};          ///< the column is one of the accounts
  Reduction reduction{Reduction::end};

  /// From the least, the largest and the last value of the column.
  [[nodiscard]] double of(double least, double largest, double last) const;
};

/// The quantity of that name: a column of the history ("top.tension", "rock.vx", "energy.kinetic"), which may have its
/// kind in front ("cable.top.tension", "body.rock.vx", "contact.impact.force"), and ".max", ".min", ".abs_max" or
/// ".end". Errors: InputError for an unknown column or reduction, naming the nearest and those there are.
[[nodiscard]] Quantity quantity_named(const Model& model, std::string_view name);

template <>
struct Names<Reduction> {
  static constexpr std::array<std::string_view, 4> list{"max", "min", "abs_max", "end"};
};
}  // namespace talus
