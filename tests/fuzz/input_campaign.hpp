#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "tests/fuzz/readers.hpp"

namespace talus::fuzz {

/// Number of inputs for each reader, and limits of an input.
struct CampaignPlan {
  long inputs{1000};                  ///< per reader; a quarter of them for a slow one
  std::uint64_t seed{1};              ///< the same inputs for the same seed
  long cpu_seconds{20};               ///< limit of one input
  std::filesystem::path findings{};   ///< folder for inputs that were findings; empty: they are not saved
  bool messages{};                    ///< whether patterns of messages are collected
  std::size_t maximum_findings{200};  ///< per reader; after that it gets no more inputs
};

/// An input that crashed, hung or took too much memory, or was refused by an error that does not say where.
struct Finding {
  long input{};                ///< its number
  std::string what;            ///< one line
  std::filesystem::path file;  ///< where the input is saved; empty: another one had the same pattern
};

/// Results of the inputs of one reader.
struct Tally {
  std::string reader;
  long inputs{}, accepted{}, refused{}, cut_short{};
  double seconds{};
  std::vector<Finding> findings{};
  std::map<std::string, long> messages{};  ///< patterns of errors, and their counts
};

/// The input of this number: first the reader's valid files, then mutated ones.
[[nodiscard]] std::string input(const Reader& reader, long number, std::uint64_t seed);

/// Lets a reader read its inputs in child processes, so that a crash is a finding and the other inputs are still read.
/// A valid file that is refused is a finding, too. Errors: std::system_error if a process cannot be started.
[[nodiscard]] Tally run_inputs(const Reader& reader, const CampaignPlan& plan, const std::filesystem::path& scratch);

}  // namespace talus::fuzz
