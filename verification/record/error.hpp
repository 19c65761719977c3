#pragma once

#include <stdexcept>

namespace talus::records {

/// The content of a record or CSV file is wrong. The message names the file, the place in it (JSON path or line), what
/// was found and what is allowed.
class RecordError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A file cannot be read or written. The message names the file and the system's reason.
class FileError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace talus::records
