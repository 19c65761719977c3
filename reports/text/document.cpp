#include "reports/text/document.hpp"

#include <fmt/format.h>

#include <cstdint>
#include <set>

#include "reports/base/error.hpp"
#include "reports/base/process.hpp"
#include "solver/threads/parallel_for.hpp"
#include "verification/record/json_node.hpp"
#include "verification/record/whole_file.hpp"

namespace talus::reports {
namespace {

/// Raw TeX and HTML are off: a record's text must look the same in every format. Citations are off: `@` is a character.
constexpr const char* dialect =
    "markdown-raw_tex-raw_html-raw_attribute-native_divs-native_spans-citations-example_lists"
    "-yaml_metadata_block-pandoc_title_block+gfm_auto_identifiers";

struct Letter {
  std::uint32_t code{};
  std::size_t length{};  ///< bytes; 0 when the bytes are not UTF-8
};

Letter letter_at(const std::string& text, std::size_t offset) {
  const auto byte = [&](std::size_t i) {
    return i < text.size() ? static_cast<std::uint32_t>(static_cast<unsigned char>(text[i])) : 0U;
  };
  const std::uint32_t first = byte(offset);
  if (first < 0x80U) return {first, 1};
  const std::size_t length = first >= 0xF0U ? 4 : first >= 0xE0U ? 3 : first >= 0xC0U ? 2 : 0;
  std::uint32_t code = length == 0 ? 0U : first & (0x7FU >> length);
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(offset + i) & 0xC0U) != 0x80U) return {first, 0};
    code = (code << 6U) | (byte(offset + i) & 0x3FU);
  }
  return {code, length};
}

std::set<std::uint32_t> declared_in(const std::string& header) {
  const std::string mark = "\\DeclareUnicodeCharacter{";
  std::set<std::uint32_t> codes;
  for (std::size_t offset = header.find(mark); offset != std::string::npos; offset = header.find(mark, offset + 1)) {
    codes.insert(static_cast<std::uint32_t>(std::stoul(header.substr(offset + mark.size(), 5), nullptr, 16)));
  }
  return codes;
}

/// LaTeX's inputenc supports Latin-1, most of Latin Extended-A, and typographic marks.
bool known_to_latex(std::uint32_t code) {
  static const std::set<std::uint32_t> marks{0x2013, 0x2014, 0x2018, 0x2019, 0x201C, 0x201D, 0x2026, 0x2022, 0x20AC};
  // A control character ends LaTeX with an error.
  if (code < 0x20U) return code == 0x09U || code == 0x0AU;
  return code < 0x7FU || (code >= 0xA0U && code <= 0x17EU && code != 0xB5U) || marks.count(code) > 0;
}

std::map<std::string, std::string> fixed_time(const Document& document) {
  return {{"SOURCE_DATE_EPOCH", fmt::format("{}", document.epoch)}, {"FORCE_SOURCE_DATE", "1"}, {"LC_ALL", "C.UTF-8"}};
}

/// Extracts the error from a log: TeX's error messages start with `!`.
std::string error_in_log(const std::string& log) {
  const std::size_t offset = log.find("\n!");
  return offset == std::string::npos ? log.substr(log.size() > 1500 ? log.size() - 1500 : 0)
                                     : log.substr(offset + 1, 900);
}

}  // namespace

std::string printable(const std::string& markdown, const std::string& header) {
  const std::set<std::uint32_t> declared = declared_in(header);
  std::string result;
  for (std::size_t offset = 0; offset < markdown.size();) {
    const Letter letter = letter_at(markdown, offset);
    const std::size_t length = letter.length == 0 ? 1 : letter.length;
    if (letter.length > 0 && (known_to_latex(letter.code) || declared.count(letter.code) > 0)) {
      result += markdown.substr(offset, length);
    } else {
      result += letter.length == 0 ? std::string("?") : fmt::format("U+{:04X}", letter.code);
    }
    offset += length;
  }
  return result;
}

std::string references_of(const std::string& bibliography, const Document& d) {
  const std::string file = d.stem + ".bibtex";
  records::write_whole(d.folder / file, bibliography);
  return run_or_throw({"pandoc",
                       {"--from=bibtex", std::string("--to=") + dialect, "--wrap=none", "--fail-if-warnings",
                        "--citeproc", "--csl=" + (d.resources / "references.csl").string(),
                        "--lua-filter=" + (d.resources / "references.lua").string(), file},
                       d.folder,
                       fixed_time(d)},
                      file)
      .output;
}

std::string make_site(const std::vector<SitePage>& pages, const std::string& navigation, const Document& d,
                      unsigned jobs) {
  const auto pandoc = [&](std::vector<std::string> arguments, const std::string& purpose) {
    arguments.insert(arguments.begin(), {std::string("--from=") + dialect, "--to=html5", "--no-highlight"});
    return run_or_throw({"pandoc", std::move(arguments), d.folder, fixed_time(d)}, purpose);
  };
  for (const char* file : {"site.css", "site.js"})
    std::filesystem::copy_file(d.resources / file, d.folder / file);
  records::write_whole(d.folder / "navigation.md", navigation);
  const std::string list = pandoc({"navigation.md"}, "navigation.md").output;
  records::write_whole(d.folder / "before.html",
                       "<header id=\"site\"><button id=\"menu\" type=\"button\">Contents</button>\n<nav "
                       "id=\"contents\">\n<input id=\"search\" type=\"search\" placeholder=\"Search\" "
                       "aria-label=\"Search\">\n<ul id=\"found\"></ul>\n" +
                           list + "</nav></header>\n<main>\n");
  records::write_whole(d.folder / "after.html",
                       "</main>\n<script src=\"search.js\"></script>\n<script src=\"site.js\"></script>\n");
  records::Json index = records::Json::array();
  for (const SitePage& page : pages)
    index.push_back({page.name, page.title, page.search_text});
  // As a script, because a page opened from a disk may not fetch a file.
  records::write_whole(
      d.folder / "search.js",
      "const talusPages = " + index.dump(-1, ' ', true, records::Json::error_handler_t::replace) + ";\n");
  std::vector<std::string> warnings(pages.size());
  parallel_for(pages.size(), jobs, [&](std::size_t i) {
    const SitePage& page = pages[i];
    records::write_whole(d.folder / (page.name + ".md"), page.text);
    warnings[i] =
        pandoc({"--standalone", "--mathml", "--columns=40", "--metadata=pagetitle:" + page.title + " - " + d.title,
                "--metadata=lang:en", "--css=site.css", "--include-before-body=before.html",
                "--include-after-body=after.html", "--output=" + page.name + ".html", page.name + ".md"},
               page.name + ".html")
            .messages;
    std::filesystem::remove(d.folder / (page.name + ".md"));
  });
  for (const char* file : {"navigation.md", "before.html", "after.html"})
    std::filesystem::remove(d.folder / file);
  std::string all;
  for (const std::string& each : warnings)
    all += each;
  return all;
}

std::string make_latex(const Document& d) {
  const std::filesystem::path header = d.resources / "header.tex";
  const std::string copy = d.stem + ".printable.md";
  records::write_whole(d.folder / copy,
                       printable(records::read_whole(d.folder / (d.stem + ".md")), records::read_whole(header)));
  return run_or_throw({"pandoc",
                       {std::string("--from=") + dialect,
                        "--to=latex",
                        "--standalone",
                        "--no-highlight",
                        "--columns=40",
                        "--include-in-header=" + header.string(),
                        "--lua-filter=" + (d.resources / "pdf.lua").string(),
                        "--variable=documentclass:article",
                        "--variable=classoption:a4paper",
                        "--variable=fontsize:10pt",
                        "--variable=geometry:top=14mm,bottom=12mm,left=18mm,right=18mm,headsep=4mm,footskip=7mm",
                        "--variable=title-meta:" + d.title,
                        "--variable=author-meta:The Talus project",
                        "--variable=subject:Verification of the discrete-element code Talus",
                        "--variable=keywords:discrete element method, verification, rockfall fence, sheared cell, time "
                        "integration",
                        "--variable=colorlinks:true",
                        "--variable=linkcolor:TalusLink",
                        "--variable=urlcolor:TalusLink",
                        "--output=" + d.stem + ".tex",
                        copy},
                       d.folder,
                       fixed_time(d)},
                      d.stem + ".tex")
      .messages;
}

/// A table of contents file with a blank line for each section of a LaTeX document.
std::string blank_contents(const std::string& latex) {
  std::string contents;
  for (std::size_t at = latex.find("\\section{"); at != std::string::npos; at = latex.find("\\section{", at + 1))
    contents += "\\contentsline {section}{.}{1}{}%\n";
  return contents;
}

void make_pdf(const Document& d) {
  Command latex{"pdflatex",
                {"-interaction=nonstopmode", "-halt-on-error", "-no-shell-escape", d.stem + ".tex"},
                d.folder,
                fixed_time(d)};
  latex.environment["max_print_line"] = "1000";
  const auto pass = [&](const Command& command) {
    const Finished finished = run(command);
    if (finished.status != 0) {
      throw OutputError(fmt::format("pdflatex failed on {}.tex (exit status {}):\n{}", d.stem, finished.status,
                                    error_in_log(finished.output)));
    }
    return finished.output;
  };
  if (d.has_contents) {
    // With a table of contents of its final length the first pass finds the page numbers; it need not write pictures.
    records::write_whole(d.folder / (d.stem + ".toc"),
                         blank_contents(records::read_whole(d.folder / (d.stem + ".tex"))));
    Command draft = latex;
    draft.arguments.insert(draft.arguments.begin(), "-draftmode");
    pass(draft);
    // Chapters that this pass found too long are shorter in the next, which moves the pages of the others.
    if (records::read_whole(d.folder / (d.stem + ".aux")).find("\\TalusTight") != std::string::npos) pass(draft);
  }
  if (pass(latex).find("Rerun to get") != std::string::npos) pass(latex);
}

}  // namespace talus::reports
