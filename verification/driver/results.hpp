#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "verification/check/record.hpp"
#include "verification/driver/provenance.hpp"

namespace talus::verification {

/// The sums of the first page.
struct Counts {
  std::size_t cases = 0;
  std::size_t passed = 0;
  std::size_t failed = 0;
  std::size_t checks = 0;
  std::size_t checks_failed = 0;
  std::size_t slack = 0;   ///< Checks whose bound was chosen and is fifty times the error.
  std::size_t exempt = 0;  ///< Exact and round-off checks: their bound was not chosen, it is never called slack.
  std::size_t controls = 0;
  std::size_t controls_failed = 0;
};

/// Everything that one run of the driver found.
struct Results {
  Provenance provenance;
  Tier tier = Tier::quick;
  std::vector<std::string> registered;  ///< Ids of all cases.
  std::vector<std::string> selected;    ///< Ids of those that were to run.
  std::vector<std::string> only{};      ///< Ids that --only named; empty: all of the tier.
  std::vector<Record> records;          ///< One for each selected case, in that order.
};

[[nodiscard]] Counts counts_of(const Results& results);

/// True if something was run, each selected case left one record, and each of these passed.
[[nodiscard]] bool holds(const Results& results);

/// The JSON text of results.json (schema 1).
[[nodiscard]] std::string text_of(const Results& results);

}  // namespace talus::verification
