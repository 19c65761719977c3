/// Errors in making a report, by cause. Exit statuses of talus_report: 2 for RecordError, 4 for FileError and
/// OutputError.
#pragma once

#include <stdexcept>

#include "verification/record/error.hpp"

namespace talus::reports {

using records::FileError;
using records::RecordError;

/// A folder cannot be created, or a tool (gnuplot, pandoc, pdflatex) is absent or failed.
class OutputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace talus::reports
