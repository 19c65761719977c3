#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "solver/app/sweep/sweep_file.hpp"
#include "solver/capacity/capacity_map.hpp"

namespace talus::app {

/// A rock that hits a fence; SI units.
struct Rock {
  double mass{};    ///< [kg]
  double speed{};   ///< at the start [m/s]
  double height{};  ///< of its centre above the ground, at the start [m]
  double spin{};    ///< counter-clockwise positive [rad/s]
  double along{};   ///< position along the fence, 0 at mid-span [m]

  double kinetic_energy() const { return 0.5 * mass * speed * speed; }
};

/// Small changes of the rock from trial to trial: each is uniform within plus and minus these values.
struct RockChanges {
  double speed{0.01};  ///< fraction of the speed
  double height{};     ///< [m]
  double angle{};      ///< [rad]
  double spin{};       ///< [rad/s]
  double along{};      ///< [m]
};

/// A random number: a fixed value, or a lognormal distribution through two of its percentiles.
struct RockNumber {
  double p95{}, p99{};  ///< equal: a fixed value

  /// The value whose logarithm lies `z` standard deviations above its mean.
  [[nodiscard]] double at(double z) const;
};

/// The rocks that are expected at the fence.
struct RockHazard {
  RockNumber mass, speed, height;  ///< independent; not with a table
  std::vector<Rock> table;         ///< equally probable rocks; empty: the distributions
  std::string table_name;          ///< of its file
  /// Ends between which they are uniform [rad/s], [m]; else those of the base's rock, or columns of the table.
  std::optional<std::array<double, 2>> spin, along;
  bool table_has_spin{}, table_has_along{};
  std::size_t runs{1000};
};

/// What a file asks about a fence.
struct CapacityFile {
  std::filesystem::path file;  ///< named in errors
  std::string title;
  std::filesystem::path base;                             ///< relative to the current folder
  std::vector<std::pair<std::string, TomlValue>> fields;  ///< of the base, set in all runs
  std::array<double, 2> mass{}, speed{};                  ///< ends of the maps [kg], [m/s]
  /// A map for each of their combinations [m], [rad/s], [m]; those of the base's rock where a list is empty.
  std::vector<double> heights, spins, positions;
  MapRules map;
  std::size_t audit{50};  ///< number of trials at nodes without any
  RockChanges changes;
  std::int64_t seed{1};
  std::optional<RockHazard> hazard;
  SweepLimits limits;
};

/// Reads such a file, TOML; `name` is the file named in errors, and files that it names are relative to its folder.
/// Errors: InputError with all errors, each with file, line and key; IoError for a table that cannot be read.
[[nodiscard]] CapacityFile read_capacity(std::string_view text, const std::filesystem::path& name);

}  // namespace talus::app
