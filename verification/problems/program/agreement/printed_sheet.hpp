#pragma once

#include <string>
#include <vector>

#include "verification/record/json_node.hpp"

/// The page of the engineer's sheet, without its drawing.
namespace talus::verification::problems::agreeing_files {

/// The lines of sheet.html that follow from sheet.json, of a usable run of two rocks in US units that both touch a half
/// fence, in their order: the lines above the tables, and the heads, rows and note of each table. Cells, names and
/// texts end with a bar.
[[nodiscard]] std::vector<std::string> expected_page(const records::Json& sheet);

/// The same lines of sheet.html, without tags.
[[nodiscard]] std::vector<std::string> lines_of_page(const std::string& html);

}  // namespace talus::verification::problems::agreeing_files
