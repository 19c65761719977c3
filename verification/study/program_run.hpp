#pragma once

#include <filesystem>
#include <string>
#include <vector>

/// Runs of the built program `talus`, as a user starts it, and what it leaves. Nothing of the solver is called here:
/// files are read by the record library.
namespace talus::verification::problems {

/// A folder of temporary files, removed with all that it holds when this ends.
class TemporaryFolder {
 public:
  /// Errors: std::filesystem::filesystem_error.
  TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  ~TemporaryFolder();

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  /// Writes a file into it; an older one of that name is replaced. Errors: records::FileError.
  void write(const std::string& name, const std::string& text) const;
  /// The text of a file in it. Errors: records::FileError if it cannot be read.
  [[nodiscard]] std::string read(const std::string& name) const;

 private:
  std::filesystem::path path_;
};

/// How the program ended.
struct ProgramEnd {
  int exit_code{};         ///< 128 + signal if a signal ended it
  std::string output{};    ///< standard output
  std::string messages{};  ///< standard error
};

/// Runs `talus` with these arguments in a folder. Errors: what reports::run() throws if it cannot be started.
[[nodiscard]] ProgramEnd run_talus(const TemporaryFolder& folder, const std::vector<std::string>& arguments);

/// The same for a run that must succeed. Errors: std::runtime_error with the arguments and the messages if its exit
/// code is not 0.
[[nodiscard]] std::string talus_output(const TemporaryFolder& folder, const std::vector<std::string>& arguments);

/// A state of the geometry, as the program writes it for ParaView.
struct GeometryState {
  double time{};       ///< as the index has it [T]
  std::string text{};  ///< of the VTK file
};
/// All states of the series whose index is OUT/NAME.pvd in the folder, in its order. Errors: records::FileError.
[[nodiscard]] std::vector<GeometryState> geometry_states(const TemporaryFolder& folder, const std::string& out,
                                                         const std::string& name);
/// The numbers of a data array of a VTK file; none if there is no array of that name.
[[nodiscard]] std::vector<double> data_array(const std::string& text, const std::string& name);

}  // namespace talus::verification::problems
