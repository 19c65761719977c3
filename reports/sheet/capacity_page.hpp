/// The page of a fence's capacity, from capacity.json and the figures that `talus capacity` has drawn. All in SI.
#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "reports/sheet/sheet_page.hpp"

namespace talus::reports {

/// Ends of an interval; one that is not known is missing.
using CapacityInterval = std::array<std::optional<double>, 2>;

/// Median and 95th percentile of a number of runs, with the interval of the latter.
struct CapacityOutput {
  double median{}, p95{};
  CapacityInterval p95_interval;
};

/// Numbers of runs by their end, and their outputs by name.
struct CapacityRuns {
  std::vector<std::pair<std::string, std::size_t>> ends;
  std::vector<std::pair<std::string, CapacityOutput>> outputs;
  std::vector<std::string> without_limit;  ///< margins of forces that have no limit

  std::size_t count() const;
};

struct CapacityLine {
  double mass{};
  CapacityInterval speed, energy;
  CapacityRuns stopped, passed;  ///< with the first of these speeds, and with the second
};

struct CapacityMapRecord {
  double height{}, spin{}, along{}, energy_factor{};
  std::size_t full_grid{}, contradictions{};
  CapacityRuns runs, audit;
  std::vector<CapacityLine> boundary;
};

/// The rocks that are expected: rows of a table, if it has a name, and numbers by name.
struct CapacityRocks {
  /// A fixed value (low = high), the ends of a uniform distribution, or percentiles of 95 and 99 %.
  struct Number {
    double low{}, high{};
    bool is_uniform{};
  };
  std::string table;
  std::size_t rows{};
  std::vector<std::pair<std::string, Number>> numbers;
};

struct CapacityRecord {
  std::string title, base;
  bool us_units{}, is_full{};  ///< is_full: all of the fence is modelled, and not one half
  std::array<double, 2> mass{}, speed{};
  std::vector<std::pair<std::string, double>> changes;
  long long seed{};
  std::vector<CapacityMapRecord> maps;
  std::optional<CapacityRuns> hazard;
  CapacityRocks expected;    ///< of the hazard
  CapacityInterval failure;  ///< of the hazard's probability of failure
};

/// Throws RecordError with file and member.
[[nodiscard]] CapacityRecord read_capacity_record(const std::filesystem::path& file);

[[nodiscard]] SheetPage capacity_page(const CapacityRecord& record);

/// Copies the figures that the page shows from `plots` to `staging`: of one map all, of several their envelopes, at
/// most four. A figure of several maps that is missing throws OutputError; one of a single map is left out.
[[nodiscard]] SheetPictures capacity_pictures(const CapacityRecord& record, const std::filesystem::path& plots,
                                              const std::filesystem::path& staging);

}  // namespace talus::reports
