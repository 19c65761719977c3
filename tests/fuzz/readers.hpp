#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <utility>
#include <vector>

/// The readers of Talus, each with valid files to mutate: whatever the bytes are, a reader must accept them or refuse
/// them with an error.
namespace talus::fuzz {

/// A function that reads one kind of file.
struct Reader {
  std::string name;
  std::string file;                                           ///< name under which it finds an input
  std::vector<std::string> corpus;                            ///< valid files
  std::vector<std::pair<std::string, std::string>> beside{};  ///< name and text of files that it needs in that folder
  bool slow{};                                                ///< gets a quarter of the inputs
  /// Reads a file. If it is a model, runs it; returns true if the run reached its end or its 100th step within its
  /// bounds of work. Throws as the reader does.
  std::function<bool(const std::filesystem::path&)> read;
  /// Makes a changed text plausible again: replaces a hash in it.
  std::function<void(std::string&)> seal{};
};

/// All readers. Runs in the folder `scratch` produce the files of the readers of run output; the folder must outlive
/// the readers. Errors: those of the readers of valid files.
[[nodiscard]] std::vector<Reader> all_readers(const std::filesystem::path& scratch);

/// How a reader ended with an input.
enum class Ending {
  accepted,
  refused,
  cut_short,  ///< accepted, but the model was larger, or its run longer, than the bounds of work
};

/// An ending, with its message or flaw.
struct Reading {
  Ending ending{};
  std::string message;  ///< error that refused the input
  std::string flaw;     ///< an error of another type, or one that does not name the file and a line or a field
};

/// Lets the reader read a file and judges how that ended.
[[nodiscard]] Reading read(const Reader& reader, const std::filesystem::path& file);

/// Writes an input, and the files beside it, where its reader expects it; returns its path.
std::filesystem::path put(const Reader& reader, const std::string& input, const std::filesystem::path& folder);

/// A message with names and numbers replaced by placeholders, so that equal mistakes have equal messages.
[[nodiscard]] std::string pattern_of(const std::string& message, const std::filesystem::path& file);

}  // namespace talus::fuzz
