/// The report's text: records in, Markdown out.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "reports/base/record.hpp"
#include "verification/record/audits.hpp"

namespace talus::reports {

/// Width of the text on paper [cm].
inline constexpr double text_wide = 17.4;

/// Width of each of the four figures of the first page [cm].
inline constexpr double front_figure_wide = 8.4;

/// Width of the figure on a case's page [cm]. The caption is beside it.
inline constexpr double page_figure_wide = 10.4;

/// State of the pictures when the text is written.
struct Drawn {
  std::string no_pictures;                     ///< reason why there are no pictures; empty if there are
  std::map<std::string, std::string> undrawn;  ///< "case/figure" -> reason why it is not drawn
  std::map<std::string, std::size_t> hidden;   ///< "case/figure" -> number of points that a log axis cannot show
};

/// File stem of a figure's picture in the report's folder figures/.
[[nodiscard]] std::string picture_stem(const Record& record, const Figure& figure);

/// The file with a figure's points, within the report's folder.
[[nodiscard]] std::filesystem::path data_file(const Record& record, const Figure& figure);

/// The page of one case, as chapter number `chapter` (figures and tables are numbered within it): its text, its main
/// checks (for a case that marks none, the failed ones and the first few) and its first figure.
[[nodiscard]] std::string case_page(const Record& record, std::size_t chapter, const Drawn& drawn,
                                    const std::filesystem::path& templates);

/// Details of the case for the appendix: all checks, controls, tables, further figures, `bugs` (Markdown), notes.
[[nodiscard]] std::string case_details(const Record& record, std::size_t chapter, const Drawn& drawn,
                                       const std::filesystem::path& templates, const std::string& bugs);

/// A page of the report: of a case, or of a chapter. On paper its two texts are in two volumes, in the site they follow
/// each other. Links to other pages are written `](page:NAME)` and `](details:NAME)`; see resolved().
struct ReportPage {
  std::string name;       ///< file stem in the site, unique
  std::string title;      ///< plain text
  std::string family;     ///< of a case; empty for chapters
  std::string main{};     ///< Markdown for the main volume; may be empty
  std::string details{};  ///< Markdown for the volume of details; may be empty
};

/// All pages in the order of the report, the first page first; pictures are linked as figures/<stem>.svg. `templates`
/// is the folder of the Mustache templates; `references` is the list of references as Markdown, empty if there are
/// none; `tools` is a line naming the tools' versions. Throws OutputError when a template is missing or wrong,
/// RecordError when a finding or highlight names what its case does not have.
[[nodiscard]] std::vector<ReportPage> report_pages(const Results& results, const records::Audits& audits,
                                                   const Drawn& drawn, const std::filesystem::path& templates,
                                                   const std::string& references, const std::string& tools);

/// The two documents on paper, each a Markdown file and what is made from it.
enum class Volume { main, details };
[[nodiscard]] std::string stem_of(Volume volume);

/// The text of a volume, its links resolved: within the volume to headings, else to the Markdown file of the other.
[[nodiscard]] std::string volume_text(const std::vector<ReportPage>& pages, Volume volume);

/// The text of a page of the site, its links resolved: to NAME.html, to pictures in ../figures and to numbers in
/// ../data.
[[nodiscard]] std::string site_text(const std::vector<ReportPage>& pages, const ReportPage& page);

}  // namespace talus::reports
