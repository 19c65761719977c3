#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "reports/pictures.hpp"
#include "solver/io/output/run_folder.hpp"

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

/// Pictures that a command draws.
struct DrawingRequest {
  reports::Pictures pictures;
  std::filesystem::path target;      ///< folder that receives them
  std::vector<std::string> formats;  ///< of figures and pages
  std::vector<std::string> notes{};  ///< printed before: what is left out
};

/// Where commands send their requests: draw(), or a test.
using DrawingSink = std::function<void(DrawingRequest)>;

/// Prints the notes, draws the pictures and prints their files. Errors: InputError for what cannot be drawn; IoError if
/// gnuplot is missing or fails, or a file cannot be written; no file is then half written.
void draw(DrawingRequest request);

/// Makes sheet.pdf and sheet.html in the folder of a run from its sheet.json. Errors: IoError.
void draw_sheet(const std::filesystem::path& run);

/// Finds what draw_sheet() needs besides the run. Errors: IoError naming what is missing.
void find_sheet_tools();

}  // namespace talus::app
