#include "reports/sheet/capacity_page.hpp"

#include <boost/test/unit_test.hpp>
#include <string>

#include "reports/base/error.hpp"
#include "reports/base/process.hpp"
#include "tests/temporary_folder.hpp"
#include "verification/record/error.hpp"
#include "verification/record/whole_file.hpp"

BOOST_AUTO_TEST_SUITE(capacity_page_tests)

using namespace talus::reports;
using talus::records::read_whole;
using talus::records::write_whole;
namespace fs = std::filesystem;

namespace {

const std::string ends = R"({"stopped": 6, "undecided": 0, "passed_under": 2, "passed_over": 0, "broke_through": 0,
 "failed": 0})",
                  outputs = R"({"fence.anchor_force": {"runs": 8, "median": {"value": 1000, "interval": [null, 2000]},
 "p95": {"value": 4448.2216152605, "interval": [3000, null]}},
 "fence.exit_energy": {"runs": 8, "median": {"value": 1000, "interval": [1, 2]},
 "p95": {"value": 2000, "interval": [1500, 2500]}}})";

std::string line(const std::string& speed, const std::string& energy) {
  const std::string node = "{\"ends\": " + ends + ", \"outputs\": " + outputs + "}";
  return "{\"mass\": 453.59237, \"speed\": " + speed + ", \"kinetic_energy\": " + energy + ", \"stopped\": " + node +
         ", \"not_stopped\": null}";
}

std::string map(const std::string& height, const std::string& lines) {
  return "{\"height\": " + height + R"(, "spin": 0, "along": 0, "runs": 8, "full_grid_runs": 80, "ends": )" + ends +
         R"(, "audit": {"runs": 8, "ends": )" + ends +
         R"(, "contradictions": 1, "interval": [0, 1]}, "energy_factor": 2.5, "boundary": [)" + lines + "]}";
}

std::string record(const std::string& maps, const std::string& more = "") {
  return R"({"schema": 5, "title": "A & B_1", "units": "SI", "base": "f_1.toml", "scene_units": "US",
 "symmetry": "half",
 "mass": [453.59237, 907.18474], "speed": [0.3048, 3.048], "seed": 3,
 "changes": {"speed": 0.01, "height": 0.5, "angle": 0, "spin": 0, "along": 0}, "maps": [)" +
         maps + "]" + more + "}";
}

const std::string rocks = R"({"mass": {"p95": 453.59237, "p99": 907.18474}, "speed": {"value": 3.048},
 "height": {"value": 1.524}, "spin": {"from": -5, "to": 7}})",
                  hazard = R"(, "hazard": {"rocks": )" + rocks + R"(, "runs": 8, "ends": )" + ends +
                           R"(, "probability_of_failure": 0.25, "interval": [0.07, 0.6], "outputs": )" + outputs + "}";

/// The text with all `what` replaced.
std::string replaced_all(std::string text, const std::string& what, const std::string& by) {
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + by.size()))
    text.replace(at, what.size(), by);
  return text;
}

std::string fact(const SheetBox& box, const std::string& name) {
  const auto found = std::ranges::find(box.facts, name, &SheetFact::name);
  return found == box.facts.end() ? std::string{"none"} : found->text;
}

SheetPage page_of(const std::string& text) {
  const Folder scratch;
  write_whole(scratch.path / "capacity.json", text);
  return capacity_page(read_capacity_record(scratch.path / "capacity.json"));
}

}  // namespace

BOOST_AUTO_TEST_CASE(boundaries_and_expected_rocks_in_the_units_of_the_base) {
  const SheetPage page = page_of(
      record(map("1.524", line("[0.3048, 0.6096]", "[1355.817948, 2711.635896]") + "," +
                              line("[0, 0.6096]", "[0, 2711.635896]") + "," + line("[3.048, null]", "[5e3, null]")),
             hazard));
  BOOST_TEST(page.title == "A & B_1");
  BOOST_TEST(page.lines[0] == "Rocks that the fence of f_1.toml stops: 1000 lb (453.6 kg) to 2000 lb (907.2 kg)");
  BOOST_TEST(page.boxes[0].heading == "Probability of failure per impact: 0.25");
  BOOST_TEST(fact(page.boxes[0], "95 %") == "0.07 to 0.6");
  BOOST_TEST(fact(page.boxes[0], "expected rocks") ==
             "mass 1000 lb (95 %), 2000 lb (99 %); speed 10 ft/s; height 5 ft; spin -5 to 7 rad/s");
  BOOST_TEST(fact(page.boxes[0], "their runs") == "8 runs: 6 stopped, 2 passed under");
  BOOST_TEST(fact(page.boxes[0], "energy") ==
             "at some mass no energy of the map is stopped; at some mass rocks are stopped up to the end of the map");
  BOOST_TEST(fact(page.boxes[0], "one energy") == "misjudges masses by a factor of up to 2.5");
  BOOST_TEST(fact(page.boxes[1], "model") ==
             "plane motion, half fence, elastic, plastic or breaking cables, columns that do not break, no net");
  BOOST_TEST(fact(page.boxes[1], "interval") ==
             "of the runs alone: it knows nothing of errors of the model; no conformity with a standard is claimed");
  BOOST_TEST(page.boxes[1].heading == "Audit: 1 of 8 runs contradict the map");
  BOOST_TEST(page.boxes[1].colour == "amber");
  BOOST_TEST(fact(page.boxes[1], "runs") == "8, 10 % of the full grid");
  BOOST_TEST(fact(page.boxes[1], "random") == "speed +-1 %, height +-1.64 ft; seed 3");
  using Row = std::vector<std::string>;
  BOOST_TEST(
      (page.tables.at(0).rows.at(0) == Row{"5 ft", "1000 (453.6)", "1 to 2", "1 to 2", "1 (4.448)", "", "", ""}));
  BOOST_TEST(page.tables.at(0).rows.at(1).at(2) == "below 2");
  BOOST_TEST(page.tables.at(0).rows.at(2).at(2) == "above 10");
  BOOST_TEST((page.tables.at(1).rows.at(0) == Row{"anchor force", "kip", "0.2248", "1", "0.6744 to unknown"}));
  BOOST_TEST((page.tables.at(2).rows.at(2) == Row{"passed under", "2", "2", "2"}));
}

BOOST_AUTO_TEST_CASE(expected_rocks_of_a_table) {
  const auto expected = [](const std::string& of) {
    return fact(page_of(record(map("1.524", ""), replaced_all(hazard, rocks, of))).boxes[0], "expected rocks");
  };
  BOOST_TEST(expected(R"({"table": "a_1.csv", "rows": 12, "along": {"from": -0.3048, "to": 3.048}})") ==
             "rows of a_1.csv (12); along -1 to 10 ft");
  BOOST_CHECK_THROW(expected("{}"), talus::records::RecordError);
}

BOOST_AUTO_TEST_CASE(failed_runs_say_nothing_about_the_fence) {
  const std::string failed = replaced_all(
      record(map("1.524", ""), replaced_all(hazard, R"("probability_of_failure": 0.25, "interval": [0.07, 0.6])",
                                            R"("probability_of_failure": null, "interval": [null, null])")),
      ends, R"({"stopped": 0, "failed": 8})");
  const SheetPage page = page_of(failed);
  BOOST_TEST(page.boxes[0].heading == "No probability of failure: no run finished");
  BOOST_TEST(page.boxes[0].colour == "amber");
  BOOST_TEST(fact(page.boxes[0], "95 %") == "none");
  BOOST_TEST(fact(page.boxes[0], "energy") == "no boundary: no run finished");
  BOOST_TEST(page.tables.at(0).rows.at(0).at(2) == "no run finished");
}

BOOST_AUTO_TEST_CASE(a_margin_without_a_limit_is_none) {
  const auto margin = [](const std::string& json) {
    return page_of(record(map("1.524", ""), replaced_all(hazard, outputs, R"({"fence.hanger_margin": )" + json + "}")))
        .tables.at(1)
        .rows.at(0);
  };
  using Row = std::vector<std::string>;
  BOOST_TEST((margin("null") == Row{"hanger force/limit", "", "no limit", "no limit", ""}));
  const std::string zero = R"({"value": 0, "interval": [0, 0]})";
  BOOST_TEST((margin(R"({"runs": 8, "median": )" + zero + R"(, "p95": )" + zero + "}") ==
              Row{"hanger force/limit", "", "0", "0", "0 to 0"}));  // hangers without force
}

BOOST_AUTO_TEST_CASE(several_heights_and_energies_of_all_masses) {
  const std::string same = line("[0.3048, 0.6096]", "[1355.817948, 2711.635896]");
  const SheetPage page = page_of(record(map("1.524", same) + "," + map("2", same)));
  BOOST_TEST(page.boxes[0].heading == "Capacity");
  BOOST_TEST(fact(page.boxes[0], "energy") ==
             "every mass of the table is stopped up to 1 kip ft (1.356 kJ); none is from 2 kip ft (2.712 kJ) on");
  BOOST_TEST(page.boxes[1].heading == "Audit: 2 of 16 runs contradict the map");
  BOOST_TEST(page.tables.at(0).rows.at(1).at(0) == "6.562 ft");
  BOOST_TEST(page.tables.size() == 2U);
  std::string lines = same;
  for (int i = 0; i < 19; ++i)
    lines += "," + same;
  const SheetPage cut = page_of(record(map("1.524", lines)));
  BOOST_TEST(cut.tables.at(0).rows.size() == 14U);
  BOOST_TEST(cut.tables.at(0).note.find("6 more are in capacity.json") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(the_program_makes_the_page_and_names_a_missing_figure) {
  const Folder scratch;
  const std::string text =
      record(map("1.524", line("[1, 2]", "[3, 4]")) + "," + map("2", line("[1, 2]", "[3, 4]")), hazard);
  write_whole(scratch.path / "capacity.json", text);
  const Finished made = run({TALUS_REPORT_PROGRAM, {"--sheet", scratch.path.string()}, {}, {}});
  BOOST_TEST(made.status == 4);
  BOOST_TEST(made.messages.find("envelope_1.svg: it is missing; talus capacity draws it") != std::string::npos,
             made.messages);
  BOOST_TEST(fs::exists(scratch.path / "capacity.pdf"));
  BOOST_TEST(read_whole(scratch.path / "capacity.html").find("<h1>A &amp; B_1</h1>") != std::string::npos);
  for (const auto& [wrong, message] :
       {std::pair{std::string{"{\"schema\": 1}"}, "schema: must be 5, found 1: start talus capacity again"},
        std::pair{record(""), "maps: must have a map"},
        std::pair{record(map("1.524", line("[1]", "[1, 2]"))), "speed: must be 2 numbers, found 1"}}) {
    write_whole(scratch.path / "capacity.json", wrong);
    const Finished refused = run({TALUS_REPORT_PROGRAM, {"--sheet", scratch.path.string()}, {}, {}});
    BOOST_TEST(refused.status == 2);
    BOOST_TEST(refused.messages.find(message) != std::string::npos, refused.messages);
  }
}

BOOST_AUTO_TEST_SUITE_END()
