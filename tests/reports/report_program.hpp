#pragma once

#include <map>
#include <string>
#include <vector>

#include "reports/base/process.hpp"

/// Runs talus_report.
inline talus::reports::Finished program(const std::vector<std::string>& arguments,
                                        const std::map<std::string, std::string>& environment = {}) {
  return talus::reports::run({TALUS_REPORT_PROGRAM, arguments, {}, environment});
}

/// True if `text` contains `part`.
inline bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }
