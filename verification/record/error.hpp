#pragma once

#include <stdexcept>

namespace talus::records {

/// Invalid content of a record or CSV file. The message names the file, the position in it (JSON path or line), what
/// was found and what is allowed.
class RecordError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A file that cannot be read or written. The message names the file and the system's reason.
class FileError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace talus::records
