#pragma once

#include <filesystem>

#include "solver/base/error.hpp"

namespace talus {

/// Another program, or another lock of this one, holds the folder.
class FolderInUse : public IoError {
 public:
  using IoError::IoError;
};

/// Lock of a folder for one run: two runs that write into it at the same time would leave an undetectable mixture of
/// their files. The lock writes no file and ends with the program, however that ends. On a file system without locks it
/// has no effect.
class FolderLock {
 public:
  /// The folder must exist. Errors: FolderInUse, naming the process if it is known; IoError if it cannot be opened.
  explicit FolderLock(const std::filesystem::path& folder);
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;
  ~FolderLock();

 private:
  int descriptor_;
};

}  // namespace talus
