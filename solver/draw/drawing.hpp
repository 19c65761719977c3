#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "solver/io/output/run_folder.hpp"
#include "verification/record/plots.hpp"

namespace CLI {
class App;
}

namespace talus::app {

/// What all commands that draw ask of their pictures.
struct PictureOptions {
  std::vector<std::string> formats{"svg", "pdf", "png"};
  std::string folder;  ///< empty: plots/ in the run's folder
  std::string name;    ///< file stem; empty: the command's own
  std::string title;   ///< empty: the run's
  std::string colour;  ///< of discs: speed or force; empty: not asked for
};

/// Adds --format.
void add_format_option(CLI::App& app, PictureOptions& options);

/// Adds --out, --name and --title.
void add_picture_options(CLI::App& app, PictureOptions& options);

/// Adds --colour, what colours discs.
void add_colour_option(CLI::App& app, PictureOptions& options);

/// A time that an option gives, in the unit that the run named, or bare if it named none. Errors: InputError.
[[nodiscard]] double option_time(const std::string& option, const std::string& text, const RunFolder& run,
                                 bool positive = true);

/// Draws what the plot.json in `record` asks for into `target` by talus_report, which stands beside talus or in a
/// folder of PATH, and returns its exit code. Errors: IoError if it is not there or ends by a signal.
[[nodiscard]] int draw(const std::filesystem::path& record, const std::filesystem::path& target,
                       const std::vector<std::string>& formats);

/// A record that is drawn from and then removed.
class DrawingRecord {
 public:
  /// Makes `target` and the record's folder in it. Errors: IoError.
  explicit DrawingRecord(std::filesystem::path target);
  DrawingRecord(const DrawingRecord&) = delete;
  DrawingRecord& operator=(const DrawingRecord&) = delete;
  ~DrawingRecord();

  /// Adds a file. Errors: IoError.
  void add(const std::string& name, std::string_view text) const;
  /// Adds a file that stands elsewhere. Errors: IoError.
  void link(const std::string& name, const std::filesystem::path& file) const;
  /// Draws into the target what names the added files; the exit code of talus_report. Errors: IoError.
  [[nodiscard]] int draw(const records::Plots& plots, const std::vector<std::string>& formats) const;

 private:
  std::filesystem::path target_;
  std::filesystem::path folder_;
};

}  // namespace talus::app
