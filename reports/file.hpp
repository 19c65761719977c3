/// Files that are whole or absent.
#pragma once

#include <filesystem>
#include <string>

namespace talus::reports {

/// A new folder beside the results-to-be, removed with all it holds at the end of its scope. What is finished is
/// moved out of it by publish(), so that a reader of the target never sees half a file.
class StagingFolder {
 public:
  /// Makes `target` (with its parents) and a fresh folder in it, and removes those that killed processes left there; throws
  /// OutputError when that cannot be.
  explicit StagingFolder(std::filesystem::path target);
  ~StagingFolder();
  StagingFolder(const StagingFolder&) = delete;
  StagingFolder& operator=(const StagingFolder&) = delete;

  [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }

  /// Moves a finished file or folder into the target, in the place of an older one of that name.
  void publish(const std::string& name) const;

 private:
  std::filesystem::path target_;
  std::filesystem::path folder_;
};

}  // namespace talus::reports
