#pragma once

#include <filesystem>

namespace talus {

/// Keeps a folder for one run: two that write into it at once leave a mixture that no file tells of. Nothing is written
/// for it, and it ends with the program, however that ends. Where the file system knows no locks there is none.
class FolderLock {
 public:
  /// The folder must be there. Errors: IoError, which names the process where it is known, if another program, or
  /// another lock of this one, has it.
  explicit FolderLock(const std::filesystem::path& folder);
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;
  ~FolderLock();

 private:
  int descriptor_;
};

}  // namespace talus
