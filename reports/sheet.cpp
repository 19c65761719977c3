#include <fmt/format.h>

#include <functional>
#include <kainjow/mustache.hpp>
#include <map>

#include "reports/base/error.hpp"
#include "reports/base/file.hpp"
#include "reports/base/process.hpp"
#include "reports/figures/drawing.hpp"
#include "reports/report.hpp"
#include "reports/sheet/sheet_drawing.hpp"
#include "reports/sheet/sheet_tables.hpp"
#include "reports/sheet/sheet_verdict.hpp"
#include "reports/text/document.hpp"
#include "verification/record/whole_file.hpp"

namespace talus::reports {
namespace fs = std::filesystem;
namespace {

namespace mustache = kainjow::mustache;

/// Escapes the characters that have a meaning in the output format.
using Escape = std::function<std::string(const std::string&)>;

std::string replaced_letters(const std::string& text, const std::map<char, std::string>& marks) {
  std::string made;
  for (const char c : text) {
    const auto mark = marks.find(c);
    if (mark == marks.end()) {
      made += c;
    } else {
      made += mark->second;
    }
  }
  return made;
}

std::string html_text(const std::string& text) {
  return replaced_letters(text, {{'&', "&amp;"}, {'<', "&lt;"}, {'>', "&gt;"}, {'"', "&quot;"}});
}

std::string latex_text(const std::string& text) {
  return replaced_letters(text, {{'\\', "\\textbackslash{}"},
                                 {'{', "\\{"},
                                 {'}', "\\}"},
                                 {'$', "\\$"},
                                 {'-', "-{}"},
                                 {'&', "\\&"},
                                 {'#', "\\#"},
                                 {'%', "\\%"},
                                 {'_', "\\_"},
                                 {'^', "\\textasciicircum{}"},
                                 {'~', "\\textasciitilde{}"},
                                 {'<', "\\textless{}"},
                                 {'>', "\\textgreater{}"}});
}

/// Groups of adjacent heads: name and number of columns.
std::vector<std::pair<std::string, int>> groups(const SheetTable& table) {
  std::vector<std::pair<std::string, int>> found;
  for (const SheetHead& head : table.heads) {
    if (!found.empty() && !head.group.empty() && found.back().first == head.group) {
      ++found.back().second;
    } else {
      found.emplace_back(head.group, 1);
    }
  }
  return found;
}

bool has_units(const SheetTable& table) {
  return std::any_of(table.heads.begin(), table.heads.end(), [](const SheetHead& head) { return !head.unit.empty(); });
}

std::string latex_row(const std::vector<std::string>& cells) {
  std::string line;
  for (const std::string& cell : cells)
    line += (&cell == &cells.front() ? "" : " & ") + cell;
  return line + " \\\\\n";
}

std::string latex_table(const SheetTable& table) {
  std::vector<std::string> tops, units;
  for (const auto& [group, count] : groups(table)) {
    tops.push_back(count == 1 ? latex_text(group)
                              : fmt::format("\\multicolumn{{{}}}{{c}}{{{}}}", count, latex_text(group)));
  }
  for (const SheetHead& head : table.heads)
    units.push_back(latex_text(head.unit));
  const bool any_group =
      std::any_of(table.heads.begin(), table.heads.end(), [](const SheetHead& head) { return !head.group.empty(); });
  std::string text = fmt::format("\\SheetTitle{{{}}}\n", latex_text(table.title));
  std::string columns;
  for (std::size_t i = 1; i < table.heads.size(); ++i)
    columns += table.heads[i].text ? 'l' : 'r';
  text += fmt::format("\\begin{{tabular*}}{{\\linewidth}}{{@{{}}l@{{\\extracolsep{{\\fill}}}}{}@{{}}}}\\toprule\n",
                      columns);
  if (any_group) {
    text += latex_row(tops);
    int column = 1;
    for (const auto& [group, count] : groups(table)) {
      if (count > 1) text += fmt::format("\\cmidrule(lr){{{}-{}}}", column, column + count - 1);
      column += count;
    }
    text += '\n';
  }
  if (has_units(table)) text += latex_row(units);
  text += "\\midrule\n";
  for (const std::vector<std::string>& row : table.rows) {
    std::vector<std::string> cells;
    for (const std::string& cell : row)
      cells.push_back(latex_text(cell));
    text += latex_row(cells);
  }
  text += "\\bottomrule\\end{tabular*}\n";
  if (!table.note.empty()) text += fmt::format("\\SheetNote{{{}}}\n", latex_text(table.note));
  return text + "\\par\\smallskip\n";
}

std::string html_table(const SheetTable& table) {
  // Names and other text left-aligned, numbers right-aligned, each head as its column.
  const auto side = [&](std::size_t column) {
    return column == 0 || table.heads.at(column).text ? " class=\"text\"" : "";
  };
  std::string text =
      fmt::format("<h3>{0}</h3>\n<div class=\"wide\"><table aria-label=\"{0}\"><thead><tr>", html_text(table.title));
  std::size_t column = 0;
  for (const auto& [group, count] : groups(table)) {
    text += fmt::format("<th colspan=\"{}\"{}>{}</th>", count, count == 1 ? side(column) : "", html_text(group));
    column += static_cast<std::size_t>(count);
  }
  text += "</tr>";
  if (has_units(table)) {
    text += "<tr>";
    for (std::size_t i = 0; i < table.heads.size(); ++i)
      text += fmt::format("<th{}>{}</th>", side(i), html_text(table.heads[i].unit));
    text += "</tr>";
  }
  text += "</thead><tbody>\n";
  for (const std::vector<std::string>& row : table.rows) {
    text += "<tr>";
    for (std::size_t i = 0; i < row.size(); ++i)
      text += fmt::format("<td{}>{}</td>", side(i), html_text(row[i]));
    text += "</tr>\n";
  }
  text += "</tbody></table></div>\n";
  if (!table.note.empty()) text += fmt::format("<p class=\"note\">{}</p>\n", html_text(table.note));
  return text;
}

/// The tables at one position, each written by `write`.
template <class Write>
std::string tables_at(SheetTable::Location location, const std::vector<SheetTable>& tables, Write&& write) {
  std::string text;
  for (const SheetTable& table : tables) {
    if (table.location == location) text += write(table);
  }
  return text;
}

/// A page from a template; `write` formats a table. `phone_picture` is for narrow screens.
template <class Write>
std::string rendered(const fs::path& page, const SheetRecord& record, const Escape& escape, Write&& write,
                     const std::string& picture, const std::string& phone_picture = "") {
  mustache::mustache frame{records::read_whole(page)};
  frame.set_custom_escape(escape);
  mustache::data data;
  data["title"] = record.title;
  data["run"] = fmt::format("{} at {:.6g} s; {} steps of {:.4g} s, {}", record.outcome, record.end, record.steps,
                            record.step, record.integrator);
  data["fence"] = fmt::format(
      "{} layer{} of {} columns{}; span {:.4g} m ({:.4g} ft), sag {:.3g} m ({:.3g} ft), columns "
      "{:.3g} m ({:.3g} ft) apart",
      record.layers, record.layers == 1 ? "" : "s", record.columns_of_layer, record.half_model ? " (half model)" : "",
      record.span, record.span / 0.3048, record.sag, record.sag / 0.3048, record.spacing, record.spacing / 0.3048);
  const std::vector<SheetTable> tables = fence_tables(record);
  const SheetVerdict verdict = sheet_verdict(record);
  const auto list = [](const std::vector<SheetFact>& facts) {
    mustache::data found{mustache::data::type::list};
    for (const SheetFact& fact : facts) {
      mustache::data item;
      item["name"] = fact.name;
      item["text"] = fact.text;
      found << item;
    }
    return found;
  };
  data["verdict"] = verdict.text;
  data["colour"] = verdict.colour;
  data["facts"] = list(verdict.facts);
  data["quality"] = verdict.quality;
  data["quality_colour"] = verdict.quality_colour;
  data["quality_facts"] = list(verdict.quality_facts);
  data["unusable"] = !record.quality.usable;
  data["rocks"] = write(rock_table(record));
  data["tables"] = tables_at(SheetTable::Location::page, tables, write);
  data["left"] = tables_at(SheetTable::Location::left, tables, write);
  data["right"] = tables_at(SheetTable::Location::right, tables, write);
  data["picture"] = picture;
  data["phone_picture"] = phone_picture;
  return frame.render(data);
}

}  // namespace

void demand_sheet_tools() {
  for (const char* tool : {"gnuplot", "pdflatex"})
    demand_program(tool);
}

Made make_sheet(const fs::path& run, const ToolPaths& tools) {
  const SheetRecord record = read_sheet(run / "sheet.json");
  const StagingFolder staging(run);
  const fs::path& folder = staging.folder();
  const auto drawing = [&](SheetMedium medium, const char* format, const char* stem) {
    const Canvas canvas{tools.resources / "gnuplot" / "preamble.gp", folder, {format}};
    return Drawing{"the sheet", sheet_script(record, canvas, stem, medium)};
  };
  Made made;
  const auto attempt = [&](auto&& make) {
    try {
      make();
      return true;
    } catch (const OutputError& wrong) {
      made.unmade += fmt::format("{}\n", wrong.what());
      return false;
    }
  };
  const bool drawn = attempt([&] {
    made.warnings = draw({drawing(SheetMedium::paper, "pdf", "drawing"), drawing(SheetMedium::screen, "svg", "drawing"),
                          drawing(SheetMedium::phone, "svg", "phone")},
                         folder, tools.jobs);
    // A run has no date: the same numbers give the same bytes.
    date_picture(folder / "drawing.pdf", 0);
  });
  const auto picture = [&](const char* name) { return drawn ? records::read_whole(folder / name) : std::string{}; };

  const fs::path templates = tools.resources / "templates";
  records::write_whole(folder / "sheet.html", rendered(templates / "sheet.html.mustache", record, html_text, html_table,
                                                       picture("drawing.svg"), picture("phone.svg")));
  const std::string latex = rendered(templates / "sheet.tex.mustache", record, latex_text, latex_table,
                                     drawn ? "\\includegraphics[width=\\linewidth]{drawing.pdf}" : "");
  records::write_whole(folder / "sheet.tex",
                       printable(latex, records::read_whole(tools.resources / "pandoc" / "header.tex")));
  const bool set = attempt([&] {
    make_pdf({.folder = folder,
              .stem = "sheet",
              .title = record.title,
              .resources = tools.resources,
              .epoch = 0,
              .has_contents = false});
  });
  fs::remove(run / "sheet.pdf");  // an earlier one, in case this one could not be made
  for (const char* name : {"sheet.html", "sheet.pdf"}) {
    if (!set && std::string{name} == "sheet.pdf") continue;
    staging.publish(name);
    made.files.push_back(run / name);
  }
  return made;
}

}  // namespace talus::reports
