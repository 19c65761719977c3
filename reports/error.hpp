/// What can go wrong in a report, by whose hands it must be mended.
#pragma once

#include <stdexcept>

namespace talus::reports {

/// A record, CSV file or option is not what the schema says; the words name file and field. Exit code 2.
class RecordError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A file cannot be read or written, or a tool (gnuplot, pandoc, pdflatex) is absent or failed. Exit code 4.
class OutputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace talus::reports
