/// Files that are either complete or absent.
#pragma once

#include <filesystem>
#include <string>

namespace talus::reports {

/// A temporary folder inside the target folder, deleted with its contents at the end of its scope. Finished files are
/// moved out of it by publish(), so that a reader of the target never sees an incomplete file.
class StagingFolder {
 public:
  /// Creates `target` (with its parents) and a new folder in it, and removes those left there by killed processes;
  /// throws OutputError if that fails.
  explicit StagingFolder(std::filesystem::path target);
  ~StagingFolder();
  StagingFolder(const StagingFolder&) = delete;
  StagingFolder& operator=(const StagingFolder&) = delete;

  [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }

  /// Moves a finished file or folder into the target, replacing an older one of that name.
  void publish(const std::string& name) const;

 private:
  std::filesystem::path target_;
  std::filesystem::path folder_;
};

}  // namespace talus::reports
