#pragma once

#include <string>
#include <utility>
#include <vector>

namespace talus::verification {

/// Where results come from: enough to make them again.
struct Provenance {
  std::string revision;                                        ///< Git commit of the sources, or "unknown".
  bool dirty = false;                                          ///< The sources differ from that commit.
  std::string compiler;                                        ///< Name and version.
  std::string flags;                                           ///< Options that the code was compiled with.
  std::string build_type;                                      ///< "Release", "Debug", ...
  std::string cpu;                                             ///< Model name.
  unsigned cores = 0;                                          ///< Processors that this process may use.
  std::string os;                                              ///< Distribution and kernel.
  std::vector<std::pair<std::string, std::string>> libraries;  ///< Name and version.
  std::string date;  ///< UTC, ISO 8601; from SOURCE_DATE_EPOCH if set, so that a report can be made again.
};

/// That of this executable on this machine, now.
[[nodiscard]] Provenance provenance();

/// Processor, compiler and options of that, in words.
[[nodiscard]] std::string machine_words();

}  // namespace talus::verification
