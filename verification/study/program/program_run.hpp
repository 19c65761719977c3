#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "verification/record/csv.hpp"

/// Runs the built program `talus` as a user does, and reads its files. No solver code is called here: files are read by
/// the record library.
namespace talus::verification::problems {

/// A temporary folder, deleted with its contents by the destructor.
class TemporaryFolder {
 public:
  /// Throws std::filesystem::filesystem_error.
  TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  ~TemporaryFolder();

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  /// Writes a file into it, replacing an older one of that name. Throws records::FileError.
  void write(const std::string& name, const std::string& text) const;
  /// Text of a file in it. Throws records::FileError if it cannot be read.
  [[nodiscard]] std::string read(const std::string& name) const;

 private:
  std::filesystem::path path_;
};

/// Result of a run of the program.
struct ProgramEnd {
  int exit_code{};         ///< 128 + signal if a signal ended it
  std::string output{};    ///< standard output
  std::string messages{};  ///< standard error
};

/// Variables that a run of the program finds in its environment, besides those of this process or in place of them.
using Environment = std::map<std::string, std::string>;

/// Runs `talus` with these arguments in a folder: the built program, or that which the environment names in
/// TALUS_PROGRAM (tests/interface). Throws the errors of reports::run() if it cannot be started.
[[nodiscard]] ProgramEnd run_talus(const TemporaryFolder& folder, const std::vector<std::string>& arguments,
                                   const Environment& environment = {});

/// The same with the program `talus_vtkhdf`.
[[nodiscard]] ProgramEnd run_vtkhdf(const TemporaryFolder& folder, const std::vector<std::string>& arguments);

/// Standard output of a run that must succeed. Throws std::runtime_error with the arguments and the messages if the
/// exit status is not 0.
std::string talus_output(const TemporaryFolder& folder, const std::vector<std::string>& arguments,
                         const Environment& environment = {});

/// A state of the geometry, as written by the program for ParaView.
struct GeometryState {
  double time{};       ///< as given in the index [T]
  std::string text{};  ///< text of the VTK file
};
/// All states of the series whose index is OUT/NAME.pvd in the folder, in its order. Throws records::FileError.
[[nodiscard]] std::vector<GeometryState> geometry_states(const TemporaryFolder& folder, const std::string& out,
                                                         const std::string& name);
/// Numbers of a data array of a VTK file; empty if there is no array of that name.
[[nodiscard]] std::vector<double> data_array(const std::string& text, const std::string& name);
/// Values of the column "NAME [UNIT]" of a table, whatever its unit. Throws records::RecordError if there is none.
[[nodiscard]] std::vector<double> column(const records::Csv& table, const std::string& name);

}  // namespace talus::verification::problems
