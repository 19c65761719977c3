/// Elements shared by several tables and pages of the report. All results are Markdown.
#pragma once

#include <filesystem>
#include <kainjow/mustache.hpp>
#include <string>

#include "reports/base/record.hpp"

namespace talus::reports {

/// The template file filled with the values; `{{x}}` is escaped as text, `{{{x}}}` is inserted literally. Throws
/// OutputError when the template is missing or invalid.
[[nodiscard]] std::string filled(const std::filesystem::path& file, const kainjow::mustache::data& values);

/// Heading of a case's page, as plain text: "id: title".
[[nodiscard]] std::string case_heading(const Record& record);

/// The case's id, linked to its page.
[[nodiscard]] std::string case_link(const Record& record);

/// Link to the page of the case with that id; the bare id if it has no record.
[[nodiscard]] std::string link_of(const Results& results, const std::string& id);

/// Links to several cases, separated by commas.
[[nodiscard]] std::string joined_links(const Results& results, const std::vector<std::string>& ids);

/// The case's status, bold unless it passed.
[[nodiscard]] std::string status_word(const Record& record);

// Cells of a check's row. Enough digits to distinguish measured and reference, up to a limit (the error is beside).
[[nodiscard]] std::string name_with_unit(const Check& check);
[[nodiscard]] std::string measured_text(const Check& check, int maximum_digits = 8);
[[nodiscard]] std::string reference_text(const Check& check, int maximum_digits = 8);
[[nodiscard]] std::string error_text(const Check& check);
[[nodiscard]] std::string margin_text(const Check& check);
[[nodiscard]] std::string kind_text(const Check& check);
[[nodiscard]] std::string reason(const Check& check);  ///< kind, and justification of the bound

}  // namespace talus::reports
