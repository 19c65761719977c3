#define BOOST_TEST_MODULE record
#include "verification/check/record.hpp"

#include <unistd.h>

#include <boost/test/unit_test.hpp>
#include <filesystem>
#include <fstream>
#include <limits>
#include <sstream>

using namespace talus::verification;
namespace fs = std::filesystem;

namespace {

/// A folder of its own, removed at the end.
struct Folder {
  fs::path path = fs::temp_directory_path() / ("talus_record_" + std::to_string(::getpid()));
  Folder() { fs::create_directories(path); }
  ~Folder() { fs::remove_all(path); }
};

std::string text_in(const fs::path& file) {
  std::stringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

void write(const fs::path& file, const std::string& text) { std::ofstream(file, std::ios::trunc) << text; }

Record full_record() {
  Findings findings;
  findings.expect("third", 1.0 / 3.0, 0.3333, Tolerance::model(1e-4, "four digits are \"printed\""), "m");
  findings.expect("lost", std::numeric_limits<double>::quiet_NaN(), 1.0, Tolerance::exact("same"));
  findings.expect("unequal", 1.0, 2.0, Tolerance::exact("same"));
  findings.expect("of zero", 1.0, 0.0, Tolerance::model(1.0, "why").relative());
  findings.expect_between("order", 2.1, 1.85, 2.35, "second order");
  findings.figure({.name = "error",
                   .title = "Error",
                   .caption = "It falls.",
                   .x = {.label = "step", .unit = "s", .log = true, .min = 1e-3, .max = {}},
                   .y = {.label = "error"},
                   .series = {{"a", {0.1, 0.2}, {1.0, 2.0}}, {"b", {0.1}, {1.0}, Style::errorbars, {0.5}, {1.5}}},
                   .slopes = {{2.0, 0.1, 1.0, "h^2"}},
                   .lines = {{'x', 0.15, "limit"}}});
  findings.table({"values", "A table.", {"x", "y"}, {{"1", "2"}, {"3", "4"}}});
  findings.data({"tidy", {"method", "error"}, {{"a", "1e-3"}, {"b", ""}}});
  findings.note("A note with $\\theta$.");
  findings.count(42);

  Record record;
  record.id = "example";
  record.title = "An example";
  record.requirements = traced({{"Eq. 21", {"third", "order"}}}, findings.checks());
  record.main_checks = {"third"};
  record.source = "A source, p. 1";
  record.page = "# Page\n\n$x^2$";
  record.status = Status::fail;
  record.message = "a check failed";
  record.seconds = 0.25;
  record.evaluations = findings.evaluations();
  record.checks = findings.checks();
  record.controls = {{"mass_halved", "m/2", "third", Colour::red, Colour::green, 1.0, 2.0, 1.0, 0.5},
                     {"unseen", "nothing", "gone", Colour::missing, Colour::missing, 0, 0, 0, 0, "not made"}};
  record.figures = findings.figures();
  record.tables = findings.tables();
  record.data = findings.data_files();
  record.notes = findings.notes();
  return record;
}

/// Refused with a message that holds `words`.
void refuse(const fs::path& folder, const std::string& words) {
  BOOST_CHECK_EXCEPTION((void)read_record(folder), RecordError, [&](const RecordError& fault) {
    BOOST_TEST_INFO(fault.what());
    BOOST_TEST(std::string(fault.what()).find(words) != std::string::npos);
    return true;
  });
}

/// Refused after `from` was replaced by `to` in record.json.
void refuse_edited(const fs::path& folder, const std::string& from, const std::string& to, const std::string& words) {
  write_record(full_record(), folder);
  std::string text = text_in(folder / "record.json");
  const auto at = text.find(from);
  BOOST_REQUIRE(at != std::string::npos);
  write(folder / "record.json", text.replace(at, from.size(), to));
  refuse(folder, words);
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_record_comes_back_the_same) {
  const Folder folder;
  const Record record = full_record();
  write_record(record, folder.path);
  const Record back = read_record(folder.path);
  BOOST_TEST(text_of(back) == text_of(record));
  BOOST_TEST(back.checks[0].measured == 1.0 / 3.0);
  BOOST_TEST(back.figures[0].series[0].y == record.figures[0].series[0].y);
  BOOST_TEST(back.data[0].columns == record.data[0].columns);
  BOOST_TEST((back.data[0].rows == record.data[0].rows));
  BOOST_TEST(back.figures[0].series[0].y_low.empty());
  BOOST_TEST(back.figures[0].series[1].y_high == record.figures[0].series[1].y_high);
  for (const auto& entry : fs::directory_iterator(folder.path))
    BOOST_TEST(entry.path().extension() != ".part");
}

BOOST_AUTO_TEST_CASE(a_requirement_is_traced_to_the_checks_whose_names_hold_its_parts) {
  const auto checks = full_record().checks;
  const auto traces = traced({{"Eq. 21", {"order", "of zero"}}, {"Eq. 22", {"order", "gone"}}, {"Eq. 23", {}}}, checks);
  BOOST_TEST(traces[0].checks == std::vector<std::string>({"of zero", "order"}));
  BOOST_TEST(traces[0].shown());
  BOOST_TEST(!traces[1].shown());
  BOOST_TEST(traces[1].unmatched == "gone");
  BOOST_TEST(!traces[2].shown());
}

BOOST_AUTO_TEST_CASE(missing_empty_and_truncated_records_are_refused) {
  const Folder folder;
  refuse(folder.path, "is missing");
  write(folder.path / "record.json", "");
  refuse(folder.path, "is empty");
  write_record(full_record(), folder.path);
  const std::string text = text_in(folder.path / "record.json");
  for (const std::size_t length : {std::size_t{1}, text.size() / 2, text.size() - 3}) {
    write(folder.path / "record.json", text.substr(0, length));
    refuse(folder.path, "truncated");
  }
}

BOOST_AUTO_TEST_CASE(other_schemas_and_absent_fields_are_refused) {
  const Folder folder;
  refuse_edited(folder.path, "\"schema\": 1", "\"schema\": 2", "schema 2");
  refuse_edited(folder.path, "\"schema\": 1", "\"scheme\": 1", "schema");
  refuse_edited(folder.path, "\"checks\"", "\"cheques\"", "checks");
  refuse_edited(folder.path, "\"kind\": \"model\"", "\"kind\": \"guess\"", "guess");
}

BOOST_AUTO_TEST_CASE(numbers_that_are_none_are_refused) {
  const Folder folder;
  refuse_edited(folder.path, "\"seconds\": 0.25", "\"seconds\": \"nan\"", "seconds");
  refuse_edited(folder.path, "\"seconds\": 0.25", "\"seconds\": null", "seconds");
  refuse_edited(folder.path, "\"reference\": 0.3333", "\"reference\": \"nan\"", "third");
}

BOOST_AUTO_TEST_CASE(verdicts_that_do_not_follow_are_refused) {
  const Folder folder;
  refuse_edited(folder.path, "\"pass\": true", "\"pass\": false", "third");
  refuse_edited(folder.path, "\"reference\": 0.3333", "\"reference\": 0.4333", "third");
}

BOOST_AUTO_TEST_CASE(missing_and_broken_figure_data_are_refused) {
  const Folder folder;
  write_record(full_record(), folder.path);
  write(folder.path / "error.csv", "");
  refuse(folder.path, "is empty");
  write(folder.path / "error.csv", "series,x,y\na,0.1,nan\n");
  refuse(folder.path, "not a finite number");
  fs::remove(folder.path / "error.csv");
  refuse(folder.path, "is missing");
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
