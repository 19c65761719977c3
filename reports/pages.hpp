/// The report's text: records in, one Markdown document out.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>

#include "reports/record.hpp"
#include "reports/rounding.hpp"
#include "verification/record/mutants.hpp"

namespace talus::reports {

/// Width of the text on paper [cm].
inline constexpr double text_wide = 17.4;

/// Width of the figure on a case's page [cm]. Its caption stands beside it.
inline constexpr double page_figure_wide = 10.4;

/// What is known of the pictures when the text is written.
struct Drawn {
  std::string no_pictures;                     ///< why there are none at all; empty if there are
  std::map<std::string, std::string> undrawn;  ///< "case/figure" -> why there is no picture of it
  std::map<std::string, std::size_t> hidden;   ///< "case/figure" -> points that a log axis cannot show
};

/// The file stem of a figure's picture in the report's folder figures/.
[[nodiscard]] std::string picture_stem(const Record& record, const Figure& figure);

/// The page of one case, the chapter of that number (figures and tables are numbered within it): its text, its main
/// checks (of a case that marks none the failed ones and the first few) and its first figure.
[[nodiscard]] std::string case_page(const Record& record, std::size_t chapter, const Drawn& drawn,
                                    const std::filesystem::path& templates);

/// The rest of the case, for the appendix: all checks, controls, tables, further figures, notes.
[[nodiscard]] std::string case_details(const Record& record, std::size_t chapter, const Drawn& drawn,
                                       const std::filesystem::path& templates);

/// What is measured of the cases apart from the run that the report is about; absent if it was not.
struct Trials {
  std::optional<records::Mutants> mutants{};  ///< the cases with mutants
  RoundedResults rounded{};                   ///< the cases under other roundings
};

/// The whole report as Markdown, pictures linked as figures/<stem>.svg. `templates` is the folder of the Mustache
/// templates; `references` is the list of references as Markdown, empty if there are none; `tools` is a line naming the
/// tools' versions. Throws OutputError when a template is missing or wrong.
[[nodiscard]] std::string report_markdown(const Results& results, const Trials& trials, const Drawn& drawn,
                                          const std::filesystem::path& templates, const std::string& references,
                                          const std::string& tools);

}  // namespace talus::reports
