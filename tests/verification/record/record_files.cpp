#include "verification/record/record_files.hpp"

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "tests/verification/record/fields.hpp"
#include "verification/record/case_fields.hpp"
#include "verification/record/whole_file.hpp"

BOOST_AUTO_TEST_SUITE(record_files_tests)

using namespace talus::records;

namespace {

const double not_a_number = std::numeric_limits<double>::quiet_NaN();
const double infinity = std::numeric_limits<double>::infinity();

Check check(const std::string& name, double measured, double reference, double bound, Kind kind) {
  Check made{.name = name, .unit = "m", .measured = measured, .reference = reference, .bound = bound, .kind = kind};
  made.error = std::isfinite(measured) ? std::abs(measured - reference) : not_a_number;
  made.margin = margin_of(made.error, bound);
  made.pass = made.error <= bound;
  made.slack = made.pass && !exempt_from_slack(kind) && made.margin < slack_margin;
  made.why = "argued \"here\": $x^2$";
  return made;
}

/// A record in which no field has its default value.
Record full_record() {
  Record record;
  record.id = "example";
  record.title = "An example, of 1° < 2°";
  record.family = "founding problems";
  record.requirements = {{"Eq. 21", {"third", "order"}, "gone"}, {"Eq. 22", {}}};
  record.main_checks = {"third"};
  record.source = "A source, p. 1";
  record.page = "# Page\n\n$x^2$";
  record.tier = Tier::full;
  record.status = Status::fail;
  record.message = "a check failed";
  record.seconds = 0.25;
  record.evaluations = 1234567890123;
  record.checks = {check("third", 1.0 / 3.0, 0.3333, 1e-4, Kind::model),
                   check("lost", not_a_number, 1.0, 0.0, Kind::exact),
                   check("endless", -infinity, 1.0, 1.0, Kind::round_off),
                   check("unequal", 1.0, 2.0, 0.0, Kind::truncation), check("order", 2.1, 2.1, 0.25, Kind::interval)};
  record.checks[1].message = "the measured value is not finite";
  record.checks[3].text_measured = "false";
  record.checks[4].order = true;
  record.checks.push_back(check("relative", 1.5, -2.0, 2.0, Kind::model));
  record.checks.back().relative = true;
  record.checks.back().error = 1.75;
  record.checks.back().margin = 0.875;
  record.checks.back().pass = true;
  mark_main_checks(record);
  record.controls = {{"mass_halved", "m/2", "third", Colour::red, Colour::green, 1.0, 2.0, infinity, 0.5, "late"},
                     {"unseen", "nothing", "gone", Colour::missing, Colour::missing, 0, 0, 0, 0, "not made"}};
  Figure error{.name = "error",
               .title = "Error",
               .caption = "It falls.",
               .x = {.label = "step", .unit = "s", .log = true, .min = 1e-3, .max = 1.0},
               .y = {.label = "error", .log = true},
               .series = {{"a", {0.1, 0.2}, {1.0, 2.0}}, {"b", {0.1}, {1.0}, Style::errorbars, {0.5}, {1.5}}},
               .slopes = {{2.0, 0.1, 1.0, "h^2"}},
               .lines = {{'x', 0.15, "limit"}}};
  name_columns(error);
  Figure map{.name = "map",
             .title = "Map",
             .caption = "Two panels.",
             .x = {.label = "x", .min = 0.0, .max = 1.0, .divisions = 4},
             .y = {.label = "y", .min = 0.0, .max = 1.0},
             .series = {{.label = "m", .x = {0.0}, .y = {1.0}, .style = Style::heat, .values = {0.5}, .panel = 1},
                        {.label = "l", .x = {0.0}, .y = {1.0}, .style = Style::lines}},
             .panels = {"left", "right"},
             .columns = 2,
             .scale = Scale{"growth", -2.0, 3.0, "m"},
             .marks = {{0.5, 0.25, "here"}},
             .grid = false,
             .equal = true};
  map.series[1].look = {.colour = "#102030", .fill = "#a0b0c0", .width = 2.0, .dashed = true};
  name_columns(map);
  record.figures = {error, map};
  record.tables = {{"values", "A table.", {"x", "y"}, {{"1", "2"}, {"3", "4"}}}};
  record.data = {{"tidy", {"method", "error"}, {{"a, b", "1e-3"}, {"c", ""}}}};
  record.notes = {"A note with $\\theta$."};
  return record;
}

/// Error message of read_record() for the folder.
std::string refused(const Folder& folder) {
  return error_message([&] { (void)read_record(folder.path); });
}

/// The error message after `from` was replaced by `to` in record.json.
std::string refused_edited(const std::string& from, const std::string& to) {
  const Folder folder;
  write_record(full_record(), folder.path);
  std::string text = read_whole(folder.path / "record.json");
  const auto at = text.find(from);
  BOOST_REQUIRE_MESSAGE(at != std::string::npos, from);
  folder.file("record.json", text.replace(at, from.size(), to));
  return refused(folder);
}

bool same(double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); }

}  // namespace

// Earlier records, and baselines with them, have "words".
BOOST_AUTO_TEST_CASE(the_former_name_of_the_text_of_a_mark_is_read) {
  const Folder folder;
  write_record(full_record(), folder.path);
  std::string text = read_whole(folder.path / "record.json");
  const std::string now = "\"text\": \"here\"", former = "\"words\": \"here\"";
  BOOST_REQUIRE(text.find(now) != std::string::npos);
  folder.file("record.json", text.replace(text.find(now), now.size(), former));
  BOOST_TEST(read_record(folder.path).figures[1].marks.at(0).text == "here");
  BOOST_TEST(refused_edited(now, "\"label\": \"here\"").find("text") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(a_record_comes_back_the_same) {
  const Folder folder;
  const Record record = full_record();
  write_record(record, folder.path);
  const Record back = read_record(folder.path);
  BOOST_TEST(text_of(back) == text_of(record));
  BOOST_TEST(folder.files() == 4);
  for (const char* name : {"error.csv", "map.csv", "tidy.csv", "record.json"})
    BOOST_TEST(fs::exists(folder.path / name), name);
}

// Compares each member separately: one that is missing from the list of fields would be lost in both texts.
BOOST_AUTO_TEST_CASE(each_member_of_a_record_comes_back) {
  const Folder folder;
  const Record record = full_record();
  write_record(record, folder.path);
  const Record back = read_record(folder.path);
  BOOST_TEST(back.id == record.id);
  BOOST_TEST(back.title == record.title);
  BOOST_TEST(back.family == record.family);
  BOOST_TEST(back.main_checks == record.main_checks);
  BOOST_TEST(back.source == record.source);
  BOOST_TEST(back.page == record.page);
  BOOST_TEST((back.tier == record.tier && back.status == record.status));
  BOOST_TEST(back.message == record.message);
  BOOST_TEST(back.seconds == record.seconds);
  BOOST_TEST(back.evaluations == record.evaluations);
  BOOST_TEST(back.notes == record.notes);
  BOOST_REQUIRE(back.requirements.size() == 2u);
  BOOST_TEST(back.requirements[0].requirement == "Eq. 21");
  BOOST_TEST(back.requirements[0].checks == record.requirements[0].checks);
  BOOST_TEST(back.requirements[0].unmatched == "gone");
  BOOST_REQUIRE(back.checks.size() == record.checks.size());
  for (std::size_t i = 0; i < record.checks.size(); ++i) {
    const Check &a = back.checks[i], &b = record.checks[i];
    BOOST_TEST_CONTEXT(b.name) {
      BOOST_TEST((a.name == b.name && a.unit == b.unit && a.why == b.why && a.kind == b.kind));
      BOOST_TEST((same(a.measured, b.measured) && same(a.reference, b.reference) && same(a.error, b.error)));
      BOOST_TEST((same(a.bound, b.bound) && same(a.margin, b.margin)));
      BOOST_TEST((a.relative == b.relative && a.pass == b.pass && a.slack == b.slack && a.order == b.order));
      BOOST_TEST((a.text_measured == b.text_measured && a.message == b.message && a.main == b.main));
    }
  }
  BOOST_REQUIRE(back.controls.size() == 2u);
  const Control& control = back.controls[0];
  BOOST_TEST((control.name == "mass_halved" && control.what == "m/2" && control.turns_red == "third"));
  BOOST_TEST((control.observed == Colour::red && control.unplanted == Colour::green));
  BOOST_TEST((control.measured == 1.0 && control.reference == 2.0 && control.error == infinity));
  BOOST_TEST((control.bound == 0.5 && control.message == "late"));
  BOOST_TEST((back.controls[1].observed == Colour::missing && back.controls[1].unplanted == Colour::missing));
  BOOST_TEST(back.tables[0].caption == "A table.");
  BOOST_TEST(back.tables[0].columns == record.tables[0].columns);
  BOOST_TEST((back.tables[0].rows == record.tables[0].rows));
  BOOST_TEST(back.data[0].name == "tidy");
  BOOST_TEST(back.data[0].columns == record.data[0].columns);
  BOOST_TEST((back.data[0].rows == record.data[0].rows));
}

BOOST_AUTO_TEST_CASE(each_member_of_a_figure_comes_back) {
  const Folder folder;
  const Record record = full_record();
  write_record(record, folder.path);
  const Record back = read_record(folder.path);
  for (std::size_t f = 0; f < 2; ++f) {
    const Figure &a = back.figures[f], &b = record.figures[f];
    BOOST_TEST((a.name == b.name && a.title == b.title && a.caption == b.caption && a.csv == b.csv));
    for (const auto& [x, y] : {std::pair{a.x, b.x}, std::pair{a.y, b.y}}) {
      BOOST_TEST((x.label == y.label && x.unit == y.unit && x.log == y.log));
      BOOST_TEST((x.min == y.min && x.max == y.max && x.divisions == y.divisions));
    }
    BOOST_TEST((a.panels == b.panels && a.columns == b.columns && a.grid == b.grid && a.equal == b.equal));
    BOOST_REQUIRE(a.series.size() == b.series.size());
    for (std::size_t i = 0; i < a.series.size(); ++i) {
      const Series &p = a.series[i], &q = b.series[i];
      BOOST_TEST((p.label == q.label && p.style == q.style && p.panel == q.panel));
      BOOST_TEST((p.x == q.x && p.y == q.y && p.y_low == q.y_low && p.y_high == q.y_high && p.values == q.values));
      BOOST_TEST((p.look.colour == q.look.colour && p.look.fill == q.look.fill));
      BOOST_TEST((p.look.width == q.look.width && p.look.dashed == q.look.dashed));
      BOOST_TEST((p.columns.where == q.columns.where && p.columns.value == q.columns.value));
    }
  }
  const Slope& slope = back.figures[0].slopes.at(0);
  BOOST_TEST((slope.order == 2.0 && slope.x == 0.1 && slope.y == 1.0 && slope.label == "h^2"));
  const Line& line = back.figures[0].lines.at(0);
  BOOST_TEST((line.axis == 'x' && line.at == 0.15 && line.label == "limit"));
  const Mark& mark = back.figures[1].marks.at(0);
  BOOST_TEST((mark.x == 0.5 && mark.y == 0.25 && mark.text == "here"));
  const Scale& scale = back.figures[1].scale.value();
  BOOST_TEST((scale.label == "growth" && scale.min == -2.0 && scale.max == 3.0 && scale.unit == "m"));
  BOOST_TEST(!back.figures[0].scale.has_value());
}

BOOST_AUTO_TEST_CASE(each_absent_or_wrong_field_is_refused_by_its_path) {
  const Json good = Json::parse(text_of(full_record()));
  demand_strict(good, "record.json: record",
                {"order",   "text_measured", "message",   "where",  "y_low", "y_high", "value",  "panel",
                 "min",     "max",           "divisions", "colour", "fill",  "width",  "dashed", "panels",
                 "columns", "scale",         "marks",     "grid",   "equal", "main"},
                [](const Json& json) {
                  Record record;
                  read_into(Node{json, "record.json: record"}, record, Completeness::complete);
                });
}

BOOST_AUTO_TEST_CASE(unknown_keys_are_passed_over) {
  const Folder folder;
  write_record(full_record(), folder.path);
  Json json = Json::parse(read_whole(folder.path / "record.json"));
  json["later"] = 1;
  json["checks"][0]["later"] = Json::array();
  folder.file("record.json", json.dump());
  BOOST_TEST(text_of(read_record(folder.path)) == text_of(full_record()));
}

BOOST_AUTO_TEST_CASE(missing_empty_and_truncated_records_are_refused) {
  const Folder folder;
  BOOST_TEST(holds(refused(folder), "record.json: No such file or directory"));
  folder.file("record.json", "");
  BOOST_TEST(holds(refused(folder), "record.json: is empty"));
  write_record(full_record(), folder.path);
  const std::string text = read_whole(folder.path / "record.json");
  for (const std::size_t length : {std::size_t{1}, text.size() / 2, text.size() - 3}) {
    folder.file("record.json", text.substr(0, length));
    BOOST_TEST(holds(refused(folder), "record.json: is truncated or not JSON: "));
  }
}

BOOST_AUTO_TEST_CASE(other_schemas_and_unknown_names_are_refused) {
  BOOST_TEST(holds(refused_edited("\"schema\": 1", "\"schema\": 2"), "record.schema: must be 1, found 2"));
  BOOST_TEST(holds(refused_edited("\"kind\": \"model\"", "\"kind\": \"guess\""),
                   "checks[0].kind: must be one of exact, round_off, truncation, model, interval, found \"guess\""));
  BOOST_TEST(holds(refused_edited("\"tier\": \"full\"", "\"tier\": \"long\""), "must be one of quick, full"));
  BOOST_TEST(
      holds(refused_edited("\"status\": \"fail\"", "\"status\": \"lost\""), "pass, fail, error, timeout, missing"));
  BOOST_TEST(holds(refused_edited("\"observed\": \"red\"", "\"observed\": \"blue\""), "one of green, red, missing"));
  BOOST_TEST(holds(refused_edited("\"style\": \"heat\"", "\"style\": \"cold\""), "figures[1].series[0].style"));
}

BOOST_AUTO_TEST_CASE(numbers_that_may_not_be_infinite_are_refused) {
  BOOST_TEST(holds(refused_edited("\"seconds\": 0.25", "\"seconds\": \"nan\""), "seconds: must be a finite number"));
  BOOST_TEST(holds(refused_edited("\"seconds\": 0.25", "\"seconds\": null"), "seconds: is null"));
  BOOST_TEST(holds(refused_edited("\"bound\": 0.0001", "\"bound\": \"inf\""), "checks[0].bound"));
  BOOST_TEST(holds(refused_edited("\"at\": 0.15", "\"at\": \"nan\""), "lines[0].at"));
  BOOST_TEST(holds(refused_edited("\"min\": 0.001", "\"min\": \"-inf\""), "figures[0].x.min"));
}

BOOST_AUTO_TEST_CASE(what_does_not_follow_is_refused) {
  const auto refused_check = [](void (*spoil)(Check&)) {
    const Folder folder;
    Record record = full_record();
    spoil(record.checks[0]);
    write_record(record, folder.path);
    return refused(folder);
  };
  const std::string verdict = "checks[0]: check 'third': its verdict does not follow from its numbers";
  BOOST_TEST(holds(refused_check([](Check& c) { c.pass = false; }), verdict));
  BOOST_TEST(holds(refused_check([](Check& c) { c.measured = not_a_number; }), verdict));
  BOOST_TEST(holds(refused_check([](Check& c) { c.bound = 1e-9; }), verdict));
  BOOST_TEST(holds(refused_check([](Check& c) { c.reference = 0.33; }), "its error does not follow"));
  BOOST_TEST(holds(refused_check([](Check& c) { c.margin = 0.5; }), "its margin does not follow"));
  BOOST_TEST(holds(refused_check([](Check& c) { c.slack = true; }), "its mark of slack does not follow"));
  BOOST_TEST(holds(refused_check([](Check& c) { c.main = false; }), "check 'third' must be marked as main"));
  BOOST_TEST(holds(refused_check([](Check& c) { c.name = "lost"; }), "checks: 'lost' occurs twice"));
  const auto refused_record = [](void (*spoil)(Record&)) {
    const Folder folder;
    Record record = full_record();
    spoil(record);
    write_record(record, folder.path);
    return refused(folder);
  };
  BOOST_TEST(holds(refused_record([](Record& r) { r.status = Status::pass; }), "passes with a failed check"));
  BOOST_TEST(holds(refused_record([](Record& r) {
                     r.status = Status::pass;
                     r.checks.clear();
                   }),
                   "passes without a check"));
  BOOST_TEST(holds(refused_record([](Record& r) {
                     r.status = Status::pass;
                     r.checks.resize(1);
                   }),
                   "passes with a control that did not turn red"));
  BOOST_TEST(holds(refused_record([](Record& r) { r.page = " "; }), "page: must be a text that is not empty"));
  BOOST_TEST(holds(refused_record([](Record& r) { r.id = "../up"; }), "id: must be a plain file name"));
  BOOST_TEST(refused_record([](Record& r) {
               r.status = Status::error;
               r.page = r.title = "";
             }) == "");
  BOOST_TEST(
      holds(refused_record([](Record& r) { r.tables.push_back(r.tables[0]); }), "tables: 'values' occurs twice"));
  BOOST_TEST(holds(refused_record([](Record& r) { r.figures[1].name = "error"; }), "figures: 'error' occurs twice"));
  BOOST_TEST(holds(refused_record([](Record& r) { r.tables[0].rows[1].pop_back(); }),
                   "tables[0].rows[1]: has 1 cells, the table 2 columns"));
  BOOST_TEST(holds(refused_record([](Record& r) { r.tables[0].columns.clear(); }), "must hold at least one column"));
  BOOST_TEST(
      holds(refused_record([](Record& r) { r.figures[0].y.log = false; }), "figures[0].slopes[0]: a slope needs"));
  BOOST_TEST(holds(refused_edited("\"expected\": \"red\"", "\"expected\": \"green\""), "expected: must be \"red\""));
  BOOST_TEST(holds(refused_edited("\"pass\": true,\n   \"message\"", "\"pass\": false,\n   \"message\""),
                   "controls[0].pass: must be true, which follows from observed and unplanted, found false"));
  BOOST_TEST(holds(refused_edited("\"measured\": null", "\"measured\": 1.0"),
                   "controls[1].measured: must be null: the check was not made, found 1.0"));
  BOOST_TEST(
      holds(refused_edited("\"Eq. 21\",", "\"Eq. 20\","), "record.requirements: must be [\"Eq. 21\",\"Eq. 22\"]"));
}

BOOST_AUTO_TEST_CASE(missing_and_broken_figure_data_are_refused) {
  const Folder folder;
  write_record(full_record(), folder.path);
  folder.file("error.csv", "");
  BOOST_TEST(holds(refused(folder), "error.csv: found no header"));
  folder.file("error.csv", "series,x,y,y_low,y_high\na,0.1,nan,1,1\nb,1,1,1,1\n");
  BOOST_TEST(holds(refused(folder), "error.csv:2: column 'y': found 'nan'"));
  folder.file("error.csv", "series,x,y,y_low,y_high\na,0.1,1,1,1\nb,1,1,1,1\nc,1,1,1,1\n");
  BOOST_TEST(holds(refused(folder), "error.csv:4: found a row of 'c'"));
  fs::remove(folder.path / "error.csv");
  BOOST_TEST(holds(refused(folder), "error.csv: No such file or directory"));
}

BOOST_AUTO_TEST_CASE(a_text_that_is_not_utf8_is_still_written) {
  const Folder folder;
  Record record = full_record();
  record.message = "no bracket \xff";
  write_record(record, folder.path);
  BOOST_TEST(read_record(folder.path).message == "no bracket \xef\xbf\xbd");
}

BOOST_AUTO_TEST_CASE(a_record_that_cannot_be_written_leaves_the_old_one) {
  const Folder folder;
  write_record(full_record(), folder.path);
  Record other = full_record();
  other.title = "Another";
  other.figures.resize(1);
  other.figures[0].csv = "none/error.csv";  // data are written first
  BOOST_CHECK_THROW(write_record(other, folder.path), FileError);
  BOOST_TEST(text_of(read_record(folder.path)) == text_of(full_record()));
}

BOOST_AUTO_TEST_CASE(a_control_passes_only_if_red_with_and_green_without_its_fault) {
  Control control;
  for (const Colour observed : {Colour::red, Colour::green, Colour::missing}) {
    for (const Colour unplanted : {Colour::red, Colour::green, Colour::missing}) {
      control.observed = observed;
      control.unplanted = unplanted;
      BOOST_TEST(control.pass() == (observed == Colour::red && unplanted == Colour::green));
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
