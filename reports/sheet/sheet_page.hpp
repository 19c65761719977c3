/// A sheet: one page to print, and the same as HTML.
#pragma once

#include <array>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "reports/report.hpp"
#include "reports/sheet/sheet_units.hpp"

namespace talus::reports {

/// Head of a column: its unit or name below its group; adjacent columns of the same group share one head.
struct SheetHead {
  std::string group;
  std::string unit{};
  bool text{};  ///< left-aligned, as the first column is; numbers are right-aligned
};

struct SheetTable {
  /// Above the pictures; or below them, over the full page width or in one of two columns.
  enum class Location { top, page, left, right };

  std::string title;
  Location location{Location::page};
  std::vector<SheetHead> heads;
  std::vector<std::vector<std::string>> rows;
  std::string note{};  ///< printed below the table; may be empty
};

/// Head of a column of quantities in both unit systems.
[[nodiscard]] SheetHead head(std::string group, bool us_first, const SheetUnits& units);

/// Keeps the first `maximum` rows; the note then says how many more `file` has.
void cut(SheetTable& table, std::size_t maximum, const char* file);

/// A fact with its label.
struct SheetFact {
  std::string name, text;
};

/// A frame at the top of the page.
struct SheetBox {
  std::string heading;
  std::string colour;  ///< "green", "amber" or "red"
  std::vector<SheetFact> facts;
};

struct SheetPage {
  std::string title;
  std::array<std::string, 2> lines;  ///< below the title
  std::array<SheetBox, 2> boxes;
  std::vector<SheetTable> tables;
  bool is_unusable{};  ///< printed across the page
};

/// Pictures of a sheet: text of LaTeX and of HTML that shows them.
struct SheetPictures {
  std::string latex, html, phone_html;  ///< the last one for narrow screens
};

/// Makes `name`.pdf and `name`.html in a folder; without pdflatex the HTML alone. `draw` makes the pictures in a
/// staging folder and returns them; if it throws OutputError, the sheet has no pictures. Throws FileError, OutputError.
Made make_page(const std::filesystem::path& folder, const std::string& name, const SheetPage& page,
               const std::function<SheetPictures(const std::filesystem::path& staging, Made& made)>& draw,
               const ToolPaths& tools);

}  // namespace talus::reports
