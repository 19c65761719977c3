/// The records that a verification run or a simulation leaves, as values. Reading them is the only input of a report.
///
/// Schema version 1. Texts are of two sorts: *Markdown* (`page`, `notes`), taken as it is, and *words* (everything
/// else), plain text in which only `$maths$` and `` `code` `` spans mean anything. Unknown keys are passed over: a
/// later writer may add some within one schema version.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace talus::reports {

/// One comparison of a number with its reference.
struct Check {
  std::string name;
  std::string unit;
  double measured{};  ///< may be NaN or infinite; such a check has failed
  double reference{};
  double error{};
  double bound{};
  double margin{};  ///< error/bound; 0 when both are 0, infinite when only the bound is 0
  bool relative{};  ///< error and bound are relative
  bool pass{};
  bool slack{};      ///< error/bound below 1/50: the bound may be too wide
  bool main{};       ///< belongs to the table of main checks
  bool order{};      ///< measured is an order of convergence
  std::string kind;  ///< exact, round_off, truncation, model or interval
  std::string why;
  std::string text_measured;  ///< shown in place of the number when not empty
};

/// A planted fault and the check it must turn red.
struct Control {
  std::string name;
  std::string what;
  std::string turns_red;
  std::string expected;
  std::string observed;
  bool pass{};
  double measured{};  ///< of the check it turns red, with the fault; this and the next three are NaN if not made
  double reference{};
  double error{};
  double bound{};
};

/// One axis of a figure; min and max override the limits found from the data.
struct Axis {
  std::string label;
  std::string unit;
  bool log{};
  std::optional<double> min;
  std::optional<double> max;
  int divisions{};  ///< equal parts that the grid makes of a linear axis; 0: round numbers
};

/// How shapes and circles are drawn. Shapes are poly lines, each as far as the column `line` of the CSV file holds the
/// same number.
struct Look {
  std::string colour;  ///< of the lines, "#rrggbb"; empty: none, or by `value`
  std::string fill;    ///< of closed ones, "#rrggbb"; empty: none, or of circles by `value`
  std::string value;   ///< column whose values the page's scale turns into colours; empty: none
  double width{1.0};   ///< of the lines
  bool dashed{};
  std::string radius{};  ///< column of the radii of circles, in units of the abscissa
};

/// Whether a style is drawn as its Look says, and explained in the page's key, not in the panel's own.
[[nodiscard]] inline bool has_look(const std::string& style) { return style == "shapes" || style == "circles"; }

/// One curve: columns of the figure's CSV file, and how they are drawn.
struct Series {
  std::string label;
  std::string x;
  std::string y;
  std::string style;   ///< points, lines, linespoints, errorbars, crosses, outlines (closed lines one after another),
                       ///< heat (a regular grid, coloured by `look.value`), shapes or circles: see Look
  std::string y_low;   ///< column of the lower end of the error bar
  std::string y_high;  ///< column of its upper end
  std::string where;   ///< when not empty: only the rows whose column `series` holds this
  Look look{};         ///< of shapes and circles; of heat its value
  int panel{};         ///< the one that shows it, of a figure that has panels
};

/// A power law y ~ x^order through (x, y), drawn in a log-log figure to compare with.
struct Slope {
  double order{};
  double x{};
  double y{};
  std::string label;
};

/// A straight line at a fixed x or y: a limit, a published value.
struct LimitLine {
  char axis{};  ///< 'x' or 'y': the coordinate that `at` is a value of
  double at{};
  std::string label;
};

/// Words at a place of a figure.
struct Mark {
  double x{};
  double y{};
  std::string words;
};

/// Colours for values: from min to max, pale to dark, or from one hue over white to another; one bar for all panels of
/// a page.
struct Scale {
  std::string label;
  std::string unit;
  double min{};
  double max{1.0};
  bool two_hues{};
};

/// What a figure shows, without how it is drawn.
struct Figure {
  std::string name;  ///< file stem
  std::string title;
  std::string caption;
  Axis x;
  Axis y;
  std::string csv;  ///< file beside the record
  std::vector<Series> series;
  std::vector<Slope> slopes;
  std::vector<LimitLine> lines;
  std::vector<Mark> marks;
  bool grid{true};
  bool equal{};                       ///< a unit is as long on both axes; both must then have their limits
  std::vector<std::string> panels{};  ///< titles of panels with the same axes; empty: one figure
  int columns{1};                     ///< panels in a row
  std::optional<Scale> scale{};       ///< of heat maps
};

/// Figures side by side, row by row, under one title. Shapes with a label are explained once, below all panels.
struct Page {
  std::string name;  ///< file stem
  std::string title;
  int columns{1};
  std::vector<Figure> panels;
  std::optional<Scale> scale;
  std::optional<double> panel_high{};  ///< [cm]; chosen from the width if absent
};

/// Pages one after the other as one picture that moves.
struct Film {
  std::string name;  ///< file stem
  double delay{};    ///< from page to page [s] > 0
  std::vector<Page> pages;
};

/// A page for a browser that plays a run; what it plays stands in a file beside the record.
struct Player {
  std::string name;  ///< file stem
  std::string title;
  std::string data;  ///< JSON file
};

struct Table {
  std::string name;
  std::string caption;
  std::vector<std::string> columns;
  std::vector<std::vector<std::string>> rows;  ///< as many cells as columns
};

/// One verification case as it ran.
struct CaseRecord {
  std::string id;
  std::string title;
  std::string family;  ///< one of Results::families, or empty
  std::vector<std::string> requirements;
  std::string source;
  std::string page;
  std::string status;  ///< pass, fail, error, timeout or missing
  std::string message;
  std::string tier;
  double seconds{};
  std::vector<Check> checks;
  std::vector<Control> controls;
  std::vector<Figure> figures;
  std::vector<Table> tables;
  std::vector<std::string> notes;
};

struct Provenance {
  std::string revision, compiler, flags, build_type, cpu, os, date;
  bool dirty{};
  int cores{};
  std::map<std::string, std::string> libraries;  ///< name -> version
};

struct Counts {
  int cases{}, passed{}, failed{}, checks{}, checks_failed{}, slack{}, controls{}, controls_failed{};
  int exempt{};  ///< exact and round-off checks: their bounds are not chosen, so they are never called slack
};

/// The checks of one case that touch a requirement.
struct ShownBy {
  std::string case_id;
  std::vector<std::string> checks;
};

struct Requirement {
  std::string id;
  std::string group;
  std::string text;
  std::vector<std::string> cases;
  int checks{};
  std::vector<ShownBy> shown_by;
  int order{};  ///< that an integrator declares; 0 for all else
};

/// A check that another code or benchmark set makes, and the cases that show the same.
struct Peer {
  std::string suite, id, what, form, remark;
  std::vector<std::string> problems;  ///< ids of requirements
  std::vector<std::string> cases;
};

struct Erratum {
  std::string id, where, printed, corrected, evidence, case_id;
};

struct Reference {
  std::string key, text;
};

/// All that a verification report is made from.
struct Results {
  Provenance provenance;
  std::vector<std::string> registered;  ///< every case there is
  std::vector<std::string> selected;    ///< the cases asked for; all that are registered unless the record says else
  Counts counts;
  std::string tier;  ///< of the run: quick or full; may be empty
  std::string verdict;
  std::vector<Requirement> requirements;
  std::vector<std::string> families;  ///< of cases, in the order of the summary
  std::vector<CaseRecord> cases;
  std::vector<Erratum> errata;
  std::vector<Peer> peers;
  std::vector<Reference> references;
};

/// A run's wish to be drawn (`plot.json`).
struct Plots {
  std::string title;
  std::vector<Figure> figures;
  std::vector<Page> pages;
  std::vector<Film> films;
  std::vector<Player> players;
};

/// Reads results.json. Throws OutputError when the file cannot be read, RecordError (file and field) when it is not
/// what the schema says or contradicts itself: counts, verdict, and every selected case has exactly one record.
[[nodiscard]] Results read_results(const std::filesystem::path& file);

/// Reads plot.json; throws as read_results() does.
[[nodiscard]] Plots read_plots(const std::filesystem::path& file);

/// Seconds since 1970 of an ISO date such as 2026-03-01T12:00:00Z (UTC; the time may be left out).
/// Throws RecordError when it is none.
[[nodiscard]] long long epoch_seconds(const std::string& iso_date);

}  // namespace talus::reports
