#pragma once

#include <set>
#include <string>
#include <vector>

#include "verification/check/case.hpp"
#include "verification/problems/program/pictures/picture_script.hpp"
#include "verification/study/program/program_options.hpp"
#include "verification/study/program/program_run.hpp"

/// A run of thrown discs whose states are closed forms, and the pictures of it; part of the case `picture_options`.
namespace talus::verification::problems::picture_options {

inline constexpr int discs = 10;
inline constexpr double radius = 0.2, step = 0.05;                ///< of a disc [m]; of the run and its rows [s]
inline constexpr int steps = 20, steps_shown = 10;                ///< of the run, and up to the time of --until
inline constexpr double rope_y = 9.0, near_z = 0.5, far_z = 1.0;  ///< of the ends of the cable [m]

/// Discs count from 1.
[[nodiscard]] std::string name_of(int disc);

/// A quantity (x, y [m], vx, vy [m/s]) of a disc at time t [s].
[[nodiscard]] double exact(const std::string& quantity, int disc, double t);

/// The scene: discs in free fall for 1 s, the first on a slack cable, with steps and rows of this length [s].
[[nodiscard]] std::string scene_text(double each = step);

using Names = std::set<std::string>;
using Numbers = std::vector<double>;

/// The program in a folder with a run of the discs in `out`.
class Pictures {
 public:
  explicit Pictures(const Setup& setup);

  /// Runs a command with options (program_options.hpp), and returns what it prints.
  std::string run(const std::vector<std::string>& command, const Options& options) const;
  /// A picture of a figure or of one page.
  Picture picture(const std::string& file) const { return read_picture(text(file)); }
  /// The recorded commands; empty without this file.
  std::string text(const std::string& file) const;
  /// Names of the files of a folder.
  Names files(const std::string& folder) const;
  const TemporaryFolder& folder() const { return folder_; }

 private:
  TemporaryFolder folder_;
  const Setup* setup_;
  Environment environment_;
};

/// The pictures of one stem: each drawn by the terminal of its format, all with the same content, and dated 1970.
void check_formats(const Pictures& program, const std::string& stem, const std::vector<std::string>& formats,
                   Differences& differ);

}  // namespace talus::verification::problems::picture_options
