/// A sheet: one page to print, and the same as HTML.
#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <vector>

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

/// The page as HTML and as LaTeX, from templates/sheet.html.mustache and sheet.tex.mustache. Throws FileError.
[[nodiscard]] std::string sheet_html(const SheetPage& page, const SheetPictures& pictures,
                                     const std::filesystem::path& templates);
[[nodiscard]] std::string sheet_latex(const SheetPage& page, const SheetPictures& pictures,
                                      const std::filesystem::path& templates);

}  // namespace talus::reports
