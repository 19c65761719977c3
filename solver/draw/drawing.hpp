#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "reports/figures/pictures.hpp"
#include "solver/io/output/run_folder.hpp"

namespace CLI {
class App;
}

namespace talus::app {

/// Picture options of all drawing commands.
struct PictureOptions {
  std::vector<std::string> formats{reports::default_formats()};
  std::string folder;  ///< empty: plots/ in the run's folder
  std::string name;    ///< file stem; empty: the command's default
  std::string title;   ///< empty: the run's title
  std::string colour;  ///< of discs: speed or force; empty: option not given
};

/// Adds --format.
void add_format_option(CLI::App& app, PictureOptions& options);

/// Adds --out, --name and --title.
void add_picture_options(CLI::App& app, PictureOptions& options);

/// Adds --colour, the quantity that colours discs.
void add_colour_option(CLI::App& app, PictureOptions& options);

/// Time given by an option, in the run's time unit, or as a bare number if the run has no units. Errors: InputError.
[[nodiscard]] double option_time(const std::string& option, const std::string& text, const RunFolder& run,
                                 bool positive = true);

/// The pictures to be drawn by a command.
struct DrawingRequest {
  reports::Pictures pictures;
  std::filesystem::path target;      ///< folder that receives the pictures
  std::vector<std::string> formats;  ///< of figures and pages
  std::vector<std::string> notes{};  ///< printed before drawing: curves that are omitted, times of states
  bool lists_files{true};            ///< print the names of the files
};

/// Receiver of the commands' requests: draw(), or a test.
using DrawingSink = std::function<void(DrawingRequest)>;

/// Prints the notes, draws the pictures, prints their names (lists_files). Errors: InputError for pictures that cannot
/// be drawn; IoError if gnuplot is missing or fails, or if a file cannot be written; no file is left partially written.
void draw(DrawingRequest request);

/// Removes the figures of an earlier command from a folder: SVG and PDF files whose names begin so. Errors: IoError.
void remove_figures(const std::filesystem::path& folder, const std::vector<std::string>& beginnings);

/// Makes the sheet of a run, or of a capacity, from the JSON file in its folder. Errors: IoError, which names the file
/// and the programs that are missing or failed; what can be made without them is made.
void draw_sheet(const std::filesystem::path& file);

/// Checks that the tools that draw_sheet() needs exist. Errors: IoError naming the missing tool.
void find_sheet_tools();

}  // namespace talus::app
