#include <fmt/format.h>

#include <algorithm>

#include "reports/pages/page_cells.hpp"
#include "reports/pages/pages.hpp"
#include "reports/pages/sketch.hpp"
#include "reports/text/markdown.hpp"

namespace talus::reports {
namespace {

namespace mustache = kainjow::mustache;
using markdown::cell;
using markdown::Column;
using Rows = std::vector<std::vector<std::string>>;

/// Main checks of a case for the first pages: those marked by the case, else the failed ones and the first few.
std::vector<Check> main_checks(const Record& record) {
  std::vector<Check> chosen;
  const auto marked = [](const Check& check) { return check.main; };
  const bool any = std::any_of(record.checks.begin(), record.checks.end(), marked);
  for (std::size_t i = 0; i < record.checks.size(); ++i) {
    const Check& check = record.checks[i];
    if (!check.pass || (any ? check.main : i < 5)) chosen.push_back(check);
  }
  return chosen;
}

std::string main_check_table(const Record& record) {
  Rows rows;
  for (const Check& check : main_checks(record))
    rows.push_back({name_with_unit(check), measured_text(check, 7), reference_text(check, 7), margin_text(check),
                    check.pass ? "pass" : "**fail**"});
  return markdown::table({{"main check"}, {"measured", true}, {"reference", true}, {"error/bound", true}, {"result"}},
                         rows, "");
}

/// The checks of a case, and below them the justifications of their bounds; equal justifications are listed once.
std::string check_table(const Record& record) {
  Rows rows;
  std::vector<std::string> arguments;
  for (const Check& check : record.checks) {
    const auto known = std::find(arguments.begin(), arguments.end(), check.why);
    const auto number = known - arguments.begin() + 1;
    if (known == arguments.end()) arguments.push_back(check.why);
    rows.push_back({name_with_unit(check) + (check.pass ? "" : " **FAIL**"), measured_text(check),
                    reference_text(check), error_text(check), markdown::number(check.bound, 2), margin_text(check),
                    kind_text(check), fmt::format("{}", number)});
  }
  std::string text = markdown::table({{"check"},
                                      {"measured", true},
                                      {"reference", true},
                                      {"error", true},
                                      {"bound", true},
                                      {"error/bound", true},
                                      {"kind"},
                                      {"why", true}},
                                     rows, "");
  text += "\n**Why the bounds hold.**\n\n";
  for (std::size_t i = 0; i < arguments.size(); ++i)
    text += fmt::format("{}. {}\n", i + 1, markdown::text(arguments[i]));
  return text;
}

std::string control_margin(const Control& control) {
  if (control.bound == 0.0 && control.error == 0.0) return "0";
  return records::margin_text(control.error / control.bound, control.observed == Colour::green, 2);
}

/// The planted faults, and the result of the check that each must turn red.
std::string control_table(const Record& record) {
  Rows rows;
  for (const Control& control : record.controls) {
    const bool made = control.observed != Colour::missing;
    const int digits = markdown::digits_to_tell(control.measured, control.reference);
    const std::string observed = name_of(control.observed);
    rows.push_back({cell(control.name), cell(control.what), cell(control.turns_red),
                    made ? markdown::number(control.measured, digits) : "",
                    made ? markdown::number(control.reference, digits) : "", made ? control_margin(control) : "",
                    control.pass() ? observed : "**" + observed + "**"});
  }
  return markdown::table({{"control"},
                          {"the planted fault"},
                          {"check that must turn red"},
                          {"measured", true},
                          {"reference", true},
                          {"error/bound", true},
                          {"observed"}},
                         rows, "");
}

/// Alternative text of a picture: its title as plain text, without maths.
std::string alternative_text(const Figure& figure) {
  std::string text = figure.title + ": " + figure.y.label + " against " + figure.x.label;
  const auto mark = [](char letter) { return std::string("$`\"\\{}").find(letter) != std::string::npos; };
  text.erase(std::remove_if(text.begin(), text.end(), mark), text.end());
  return text;
}

/// Position of a figure: above its caption, as wide as the text, or to the left of it, in the small size of the pages.
enum class FigureLayout { over_caption, beside_caption };

/// Figures from `first` up to, but not including, `last`.
std::string figures(const Record& record, std::size_t chapter, const Drawn& drawn, std::size_t first, std::size_t last,
                    FigureLayout layout) {
  std::string text;
  for (std::size_t i = first; i < std::min(last, record.figures.size()); ++i) {
    const Figure& figure = record.figures[i];
    const std::string key = record.id + "/" + figure.name;
    if (const auto why = drawn.undrawn.find(key); why != drawn.undrawn.end()) {
      text += fmt::format("Figure {}.{} ({}) is not drawn: {}\n\n", chapter, i + 1, markdown::text(figure.title),
                          markdown::text(why->second));
      continue;
    }
    std::string caption = fmt::format("**Figure {}.{}. {}.** {}", chapter, i + 1, markdown::text(figure.title),
                                      markdown::text(figure.caption));
    if (const auto hidden = drawn.hidden.find(key); hidden != drawn.hidden.end() && hidden->second > 0) {
      caption += fmt::format(" ({} points at or below zero are not on the log axis.)", hidden->second);
    }
    if (!figure.csv.empty()) caption += fmt::format(" [Data]({})", data_file(record, figure).string());
    const bool beside = layout == FigureLayout::beside_caption;
    text += fmt::format("![{}](figures/{}.svg){{{}alt=\"{}\" width={:.0f}%}}\n\n", caption,
                        picture_stem(record, figure), beside ? ".beside " : "", alternative_text(figure),
                        beside ? 100.0 * page_figure_wide / text_wide : 100.0);
  }
  return text;
}

/// What the volume of details has of the case: "38 checks, 2 controls, 1 table". Without what it has none of.
std::string inventory(const Record& record) {
  std::string text;
  const auto add = [&](std::size_t count, const char* one) {
    if (count == 0) return;
    text += fmt::format("{}{} {}{}", text.empty() ? "" : ", ", count, one, count == 1 ? "" : "s");
  };
  add(record.checks.size(), "check");
  add(record.controls.size(), "control");
  add(record.tables.size(), "table");
  add(record.figures.empty() ? 0 : record.figures.size() - 1, "further figure");
  return text;
}

std::string tables(const Record& record, std::size_t chapter) {
  std::string text;
  for (std::size_t i = 0; i < record.tables.size(); ++i) {
    const Table& table = record.tables[i];
    std::vector<Column> columns;
    for (const std::string& heading : table.columns)
      columns.push_back({cell(heading), false});
    Rows rows = table.rows;
    for (auto& row : rows) {
      for (std::string& entry : row)
        entry = cell(entry);
    }
    const std::string caption = fmt::format("**Table {}.{}.** {}", chapter, i + 1, markdown::text(table.caption));
    text += markdown::table(columns, rows, caption) + "\n";
  }
  return text;
}

/// Heading of the case's section in the appendix.
std::string details_heading(const Record& record) { return "Details of " + record.id; }

}  // namespace

std::string picture_stem(const Record& record, const Figure& figure) { return record.id + "-" + figure.name; }

std::filesystem::path data_file(const Record& record, const Figure& figure) {
  return std::filesystem::path("data") / record.id / figure.csv;
}

std::string case_page(const Record& record, std::size_t chapter, const Drawn& drawn,
                      const std::filesystem::path& templates) {
  const bool drawable = drawn.no_pictures.empty();
  const std::string page = drawable ? with_sketch_pictures(record.page, record.id) : record.page;
  mustache::data values;
  values.set("heading", case_heading(record));
  values.set("status", status_word(record));
  values.set("message", record.message);
  values.set("seconds", fmt::format("{:.2f}", record.seconds));
  values.set("tier", name_of(record.tier));
  values.set("page", markdown::with_headings_below(page, 2));
  values.set("main_checks", record.checks.empty() ? "No check ran.\n" : main_check_table(record));
  const bool panels = !record.figures.empty() && !record.figures.front().panels.empty();
  values.set("figure",
             figures(record, chapter, drawn, 0, 1, panels ? FigureLayout::over_caption : FigureLayout::beside_caption));
  const std::string rest = inventory(record);
  values.set("rest", rest.empty() ? "" : fmt::format("[Details](details:{}): {}.", record.id, rest));
  values.set("has_message", !record.message.empty());
  return filled(templates / "case.mustache", values);
}

std::string case_details(const Record& record, std::size_t chapter, const Drawn& drawn,
                         const std::filesystem::path& templates, const std::string& bugs) {
  mustache::data values;
  values.set("heading", details_heading(record));
  values.set("source", record.source);
  std::string requirements;
  for (const records::Trace& trace : record.requirements)
    requirements += (requirements.empty() ? "" : "; ") + trace.requirement;
  values.set("requirements", requirements);
  values.set("checks", record.checks.empty() ? "No check ran.\n" : check_table(record));
  values.set("controls", record.controls.empty() ? "" : control_table(record));
  values.set("figures", figures(record, chapter, drawn, 1, record.figures.size(), FigureLayout::over_caption));
  values.set("tables", tables(record, chapter));
  std::string notes;
  for (const std::string& note : record.notes)
    notes += markdown::with_headings_below(note, 4) + "\n";
  values.set("notes", notes);
  values.set("bugs", bugs);
  for (const char* part : {"source", "requirements", "controls", "figures", "tables", "notes", "bugs"})
    values.set(std::string("has_") + part, !values.get(part)->string_value().empty());
  return filled(templates / "details.mustache", values);
}

}  // namespace talus::reports
