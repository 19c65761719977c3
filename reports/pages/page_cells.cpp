#include "reports/pages/page_cells.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "reports/base/error.hpp"
#include "reports/text/markdown.hpp"
#include "verification/record/whole_file.hpp"

namespace talus::reports {

namespace mustache = kainjow::mustache;
using markdown::cell;

std::string filled(const std::filesystem::path& file, const mustache::data& values) {
  mustache::mustache page(records::read_whole(file));
  page.set_custom_escape([](const std::string& text) { return markdown::text(text); });
  const std::string text = page.render(values);
  if (!page.is_valid()) throw OutputError(fmt::format("{}: {}", file.string(), page.error_message()));
  return text;
}

std::string case_heading(const Record& record) {
  return record.title.empty() ? record.id : record.id + ": " + record.title;
}

std::string case_link(const Record& record) {
  return fmt::format("[{}](page:{})", markdown::text(record.id), record.id);
}

std::string link_of(const Results& results, const std::string& id) {
  for (const Record& record : results.records) {
    if (record.id == id) return case_link(record);
  }
  return cell(id);
}

std::string joined_links(const Results& results, const std::vector<std::string>& ids) {
  std::string text;
  for (const std::string& id : ids)
    text += (text.empty() ? "" : ", ") + link_of(results, id);
  return text;
}

std::string status_word(const Record& record) {
  const std::string name = name_of(record.status);
  return record.status == Status::pass ? name : "**" + name + "**";
}

std::string margin_text(const Check& check) {
  if (!check.pass) return "**" + records::margin_text(check.margin, false, 3) + "**";
  return records::margin_text(check.margin, true, 2) + (check.slack ? " (slack)" : "");
}

std::string measured_text(const Check& check, int maximum_digits) {
  if (!check.text_measured.empty()) return cell(check.text_measured);
  const int digits = markdown::digits_to_tell(check.measured, check.reference);
  return markdown::number(check.measured, std::min(digits, maximum_digits));
}

std::string reference_text(const Check& check, int maximum_digits) {
  const int digits = markdown::digits_to_tell(check.measured, check.reference);
  return markdown::number(check.reference, std::min(digits, maximum_digits));
}

std::string name_with_unit(const Check& check) {
  const bool bare = check.unit.empty() || check.unit == "1" || check.unit == "-";
  return cell(check.name + (bare ? "" : " [" + check.unit + "]"));
}

std::string kind_text(const Check& check) { return check.kind == Kind::round_off ? "round-off" : name_of(check.kind); }

std::string reason(const Check& check) { return fmt::format("*{}.* {}", kind_text(check), cell(check.why)); }

std::string error_text(const Check& check) {
  return markdown::number(check.error, 2) + (check.relative ? " rel." : "");
}

}  // namespace talus::reports
