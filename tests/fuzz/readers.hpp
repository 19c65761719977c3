#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <utility>
#include <vector>

/// The readers of Talus, each with sound files to mutate: what it reads is refused by an error or accepted, whatever
/// the bytes are.
namespace talus::fuzz {

/// A function that reads one kind of file.
struct Reader {
  std::string name;
  std::string file;                                           ///< name under which it finds an input
  std::vector<std::string> corpus;                            ///< sound files
  std::vector<std::pair<std::string, std::string>> beside{};  ///< name and text of files that it needs in that folder
  bool slow{};                                                ///< gets a quarter of the inputs
  /// Reads a file. A model that is made of it is run; returns whether the run came to its end or to its 100th step
  /// within its bounds of work. Throws as the reader does.
  std::function<bool(const std::filesystem::path&)> read;
  /// Makes a changed text plausible again: replaces a hash in it.
  std::function<void(std::string&)> seal{};
};

/// All readers. Files that a run leaves are made by runs in the folder `scratch`, which has to last. Errors: those of
/// the readers of sound files.
[[nodiscard]] std::vector<Reader> all_readers(const std::filesystem::path& scratch);

/// How a reader ended with an input.
enum class Ending {
  accepted,
  refused,
  cut_short,  ///< accepted, but the model was larger, or its run longer, than the bounds of work
};

/// An ending with what is wrong about it; empty if nothing is.
struct Reading {
  Ending ending{};
  std::string message;  ///< of the error that refused it
  std::string flaw;     ///< an error of another type, or one that does not name the file and a line or a field
};

/// Lets the reader read a file and judges how that ended.
[[nodiscard]] Reading read(const Reader& reader, const std::filesystem::path& file);

/// Writes an input, and the files beside it, to where its reader finds it; returns its path.
std::filesystem::path put(const Reader& reader, const std::string& input, const std::filesystem::path& folder);

/// A message with names and numbers replaced by placeholders, so that equal mistakes have equal messages.
[[nodiscard]] std::string pattern_of(const std::string& message, const std::filesystem::path& file);

}  // namespace talus::fuzz
