#include "reports/sheet/sheet_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <kainjow/mustache.hpp>
#include <map>

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

/// A page from a template; `write` formats a table.
template <class Write>
std::string rendered(const fs::path& file, const SheetPage& page, const Escape& escape, Write&& write,
                     const std::string& picture, const std::string& phone_picture) {
  mustache::mustache frame{records::read_whole(file)};
  frame.set_custom_escape(escape);
  mustache::data data;
  data["title"] = page.title;
  mustache::data lines{mustache::data::type::list};
  for (const std::string& line : page.lines) {
    mustache::data item;
    item["line"] = line;
    lines << item;
  }
  data.set("lines", lines);
  for (std::size_t i = 0; i < page.boxes.size(); ++i) {
    const SheetBox& box = page.boxes[i];
    const std::string of = i == 0 ? "left_" : "right_";
    data[of + "heading"] = box.heading;
    data[of + "colour"] = box.colour;
    mustache::data facts{mustache::data::type::list};
    for (const SheetFact& fact : box.facts) {
      mustache::data item;
      item["name"] = fact.name;
      item["text"] = fact.text;
      facts << item;
    }
    data.set(of + "facts", facts);
  }
  data["unusable"] = page.is_unusable;
  data["top"] = tables_at(SheetTable::Location::top, page.tables, write);
  data["tables"] = tables_at(SheetTable::Location::page, page.tables, write);
  data["left"] = tables_at(SheetTable::Location::left, page.tables, write);
  data["right"] = tables_at(SheetTable::Location::right, page.tables, write);
  data["picture"] = picture;
  data["phone_picture"] = phone_picture;
  return frame.render(data);
}

}  // namespace

SheetHead head(std::string group, bool us_first, const SheetUnits& units) {
  return {std::move(group), unit_names(us_first, units)};
}

void cut(SheetTable& table, std::size_t maximum, const char* file) {
  if (table.rows.size() <= maximum) return;
  table.note += fmt::format("{}{} more are in {}. ", table.note.empty() ? "" : " ", table.rows.size() - maximum, file);
  table.rows.resize(maximum);
}

std::string sheet_html(const SheetPage& page, const SheetPictures& pictures, const fs::path& templates) {
  return rendered(templates / "sheet.html.mustache", page, html_text, html_table, pictures.html, pictures.phone_html);
}

std::string sheet_latex(const SheetPage& page, const SheetPictures& pictures, const fs::path& templates) {
  return rendered(templates / "sheet.tex.mustache", page, latex_text, latex_table, pictures.latex, "");
}

}  // namespace talus::reports
