/// Pictures of a sheared cell by plot, snapshot and animate.
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <nlohmann/json.hpp>

#include "solver/io/output/read_geometry.hpp"
#include "solver/io/output/read_history.hpp"
#include "tests/solver/app/requested.hpp"

BOOST_AUTO_TEST_SUITE(disc_pictures_tests)

namespace {

using Json = nlohmann::json;

/// A cell without units and with ten saved states, run once for all tests; the block falls on the discs, so that many
/// are in contact at the end.
const fs::path& sample() {
  static const Folder folder;
  static const bool made = [] {
    const std::string file = folder.file(
        "CNTRL.DAT", "0 1\n1.7e4 34693.877551020405 1e-3 7.2e-7 9.81 0.00897\n8 10 11 5.0\n6e-7 2.5e-3 2.5e-2\n");
    return talus_ran({"cell", file, "--out", (folder.path / "run").string()}).code == 0;
  }();
  BOOST_REQUIRE(made);
  static const fs::path run = folder.path / "run";
  return run;
}

constexpr double width = 11e-3;

/// The last state that the run wrote.
talus::DiscFrame last_state() { return talus::read_discs(talus::read_geometry_index(sample() / "cell.pvd").back()); }

/// The points at a position or at its periodic images.
std::vector<Row> rows_at(const std::vector<Row>& rows, double x, double y) {
  std::vector<Row> found;
  for (const Row& row : rows) {
    const double periods = (row.x - x) / width;
    if (std::abs(periods - std::round(periods)) < 1e-12 && row.y == y) found.push_back(row);
  }
  return found;
}

}  // namespace

// Speeds and forces are summed here from the VTP files; tests of their reader compare those with the run.
BOOST_AUTO_TEST_CASE(discs_are_drawn_where_they_stand_and_by_what_colours_them) {
  const talus::DiscFrame state = last_state();
  std::vector<double> forces(state.discs.size(), 0.0);
  for (const talus::SeenContact& contact : state.contacts)
    forces[contact.a] += contact.force, forces[contact.b] += contact.force;
  BOOST_REQUIRE(state.contacts.size() > 10U);
  for (const std::string colour : {"speed", "force"}) {
    const Requested requested{{"snapshot", sample().string(), "--count", "1", "--colour", colour}};
    const auto drawn = rows(requested.panel(0));
    double largest = 0.0;
    for (std::size_t i = 0; i < state.discs.size(); ++i) {
      const talus::SeenDisc& disc = state.discs[i];
      const auto found = rows_at(drawn.at(disc.wall ? "wall" : "disc"), disc.p.x, disc.p.y);
      BOOST_TEST(!found.empty());
      const double value = colour == "speed" ? norm(disc.v) : forces[i];
      if (!disc.wall) largest = std::max(largest, value);
      for (const Row& row : found) {
        BOOST_TEST(row.radius == 5e-4);
        BOOST_TEST(row.value == (disc.wall ? 0.0 : value));
      }
    }
    const talus::records::Scale scale = requested.page().scale.value();
    BOOST_TEST(scale.label == (colour == "speed" ? "speed of a disc" : "sum of the contact forces on a disc"));
    BOOST_TEST(scale.unit == "");
    BOOST_TEST(scale.max == largest);
  }
}

// The field is 11 mm wide and shown from -6.5 to 6.5 mm: discs within a disc of a border are also drawn beyond the
// other border.
BOOST_AUTO_TEST_CASE(images_stand_beyond_the_borders) {
  const talus::DiscFrame state = last_state();
  const Requested requested{{"snapshot", sample().string(), "--count", "1"}};
  const talus::records::Axis& x = requested.panel(0).x;
  BOOST_TEST(std::abs(x.min.value() + 6.5e-3) < 1e-12);
  BOOST_TEST(std::abs(x.max.value() - 6.5e-3) < 1e-12);
  const auto drawn = rows(requested.panel(0));
  for (const talus::SeenDisc& disc : state.discs) {
    const double position = disc.p.x - width * std::floor(disc.p.x / width + 0.5);
    const bool near =
        std::abs(position) > 0.5 * width - 1.5e-3 - 1e-9;  // some wall discs just touch the edge of the view
    BOOST_TEST(rows_at(drawn.at(disc.wall ? "wall" : "disc"), disc.p.x, disc.p.y).size() == (near ? 2U : 1U));
  }
  // Two borders with two ends each; each bar has four corners.
  BOOST_TEST(drawn.at("border").size() == 4U);
  BOOST_TEST(drawn.at("border")[0].x == -0.5 * width);
  BOOST_TEST(drawn.at("border")[2].x == 0.5 * width);
  BOOST_TEST(drawn.at("contact").size() % 4 == 0U);
  BOOST_TEST(drawn.at("contact").size() >= 4 * state.contacts.size());
  BOOST_TEST((drawn.at("edge") == drawn.at("contact")));
}

BOOST_AUTO_TEST_CASE(bars_are_as_wide_as_their_forces) {
  const talus::DiscFrame state = last_state();
  const Requested requested{{"snapshot", sample().string(), "--count", "1"}};
  const auto corners = rows(requested.panel(0)).at("contact");
  double largest = 0.0;
  for (const talus::SeenContact& contact : state.contacts)
    largest = std::max(largest, contact.force);
  for (const talus::SeenContact& contact : state.contacts) {
    const double back = width * std::floor(contact.from.x / width + 0.5);
    const talus::Vec2 middle = 0.5 * (contact.from + contact.to) - talus::Vec2{back, 0.0};
    bool found = false;
    for (std::size_t i = 0; i < corners.size(); i += 4) {
      const auto at = [&](std::size_t k) { return talus::Vec2{corners[i + k].x, corners[i + k].y}; };
      if (norm(0.25 * (at(0) + at(1) + at(2) + at(3)) - middle) > 1e-12) continue;
      found = true;
      BOOST_TEST(std::abs(norm(at(0) - at(3)) - 0.4e-3 * contact.force / largest) < 1e-15);
      BOOST_TEST(std::abs(norm(at(0) - at(1)) - norm(contact.to - contact.from)) < 1e-15);
    }
    BOOST_TEST(found);
  }
}

BOOST_AUTO_TEST_CASE(the_options_of_snapshots_hold_for_discs) {
  const Requested requested{
      {"snapshot", sample().string(), "--times", "0.0049,0.025", "--numbers", "--window", "0", "0", "0.005", "0.004"}};
  BOOST_TEST(requested.page().title == "Shear cell");
  BOOST_TEST(requested.panel(0).title == "t = 0.005");  // no unit system was named
  BOOST_TEST(requested.panel(0).x.unit == "");
  BOOST_TEST(requested.panel(0).x.max.value() == 0.005);
  const talus::DiscFrame state = last_state();
  const std::vector<talus::records::Mark>& marks = requested.panel(1).marks;
  BOOST_TEST(marks.size() > 20U);
  for (const talus::records::Mark& mark : marks) {
    const talus::Vec2 p = state.discs[std::stoul(mark.text) - 1].p;
    const double periods = (mark.x - p.x) / width;
    BOOST_TEST((std::abs(periods - std::round(periods)) < 1e-12 && mark.y == p.y));
  }
  BOOST_TEST(holds(requested.panel(1).series.back().label, "contact, as wide as its force; widest "));
  const Requested single{{"snapshot", sample().string(), "--count", "3", "--single"}};
  BOOST_TEST(single.pages().at(2).name == "snapshot_side_03");
}

BOOST_AUTO_TEST_CASE(cells_that_cannot_be_drawn) {
  const Folder folder;
  const std::string file =
      folder.file("CNTRL.DAT", "0 0\n1.7e4 34693.877551020405 1e-3 7.2e-7 9.81 0.00897\n8 10 11 5.0\n6e-7 1e-3 1e-3\n");
  const std::string bare = (folder.path / "bare").string(), run = sample().string();
  BOOST_REQUIRE(talus_ran({"cell", file, "--out", bare}).code == 0);
  const std::vector<std::pair<std::vector<std::string>, std::string>> wrong{
      {{"snapshot", bare}, "bare: the run wrote no states; set GRAPH = 1 in CNTRL.DAT or pictures = \"on\" in [run]"},
      {{"animate", bare}, "bare: the run wrote no states; "},
      {{"snapshot", run, "--view", "along"},
       "--view: found \"along\"; the run in '" + run + "' is plane; this view requires a fence"},
      {{"snapshot", run, "--times", "2 ms"},
       "--times: found \"2 ms\"; it must be a bare number: the run named no units"},
      {{"snapshot", run, "--times", "1"}, "--times: found \"1\"; the run has states from 0.0025"},
      {{"animate", run, "--until", "-1"}, "--until: found \"-1\"; it must be > 0"},
      {{"snapshot", run, "--colour", "spin"}, "--colour: spin not in {speed,force}"},
      {{"plot", run, "--history", "top_sheer"}, "history 'top_sheer' is not known; nearest: top_shear; known: "}};
  for (const auto& [arguments, message] : wrong) {
    const Ended ended = talus_ran(arguments);
    BOOST_TEST(ended.code == 2);
    BOOST_TEST(holds(ended.err, message), ended.err << " holds no " << message);
  }
}

BOOST_AUTO_TEST_CASE(histories_and_profiles_of_a_cell_are_drawn) {
  const Folder folder;
  const Ended ended = talus_ran({"plot", sample().string(), "--format", "svg", "--out", folder.path.string()});
  BOOST_TEST(ended.code == 0, ended.err);
  for (const char* name : {"stresses", "stress_ratio", "depth", "fractions", "coordination", "velocity_profile",
                           "temperature_profile", "solid_fraction_profile"})
    BOOST_TEST(fs::exists(folder.path / (name + std::string{".svg"})), name);
  // Without a unit system no units are printed.
  BOOST_TEST(!holds(talus::read_text(folder.path / "stresses.svg"), "["));
  const Requested requested{{"plot", sample().string(), "--history", "top_shear,depth", "--apart", "--until", "0.01"}};
  const talus::KeptHistory kept = talus::read_history(sample() / "history.csv");
  const std::vector<double>& drawn = requested.panel(0).series.at(0).y;
  BOOST_REQUIRE(drawn.size() == 4U);
  for (std::size_t i = 0; i < drawn.size(); ++i)
    BOOST_TEST(drawn[i] == kept.find("top_shear")->values[i]);
  const Ended menu = talus_ran({"plot", sample().string(), "--list"});
  BOOST_TEST(holds(menu.out, "multiple_fraction"));
  BOOST_TEST(!holds(menu.out, "["));
}

// The profile ends with the highest layer that contained a disc.
BOOST_AUTO_TEST_CASE(empty_layers_are_left_out_of_the_profile) {
  const talus::KeptHistory profile = talus::read_history(sample() / "profile.csv");
  BOOST_TEST(profile.find("solid_fraction")->values.back() > 0.0);
  BOOST_TEST(profile.columns.front().values.size() > 10U);
}

BOOST_AUTO_TEST_CASE(a_cell_moves_in_a_gif_and_in_one_page) {
  const Folder folder;
  const Ended ended =
      talus_ran({"animate", sample().string(), "--gif", "--html", "--colour", "force", "--out", folder.path.string()});
  BOOST_TEST(ended.code == 0, ended.err);
  BOOST_TEST(ended.err.empty());
  const std::string gif = talus::read_text(folder.path / "animation.gif");
  int pictures = 0;
  for (std::size_t at = 0; (at = gif.find("\x21\xF9\x04", at)) != std::string::npos; ++at)
    ++pictures;
  BOOST_TEST(pictures == 10);
  const std::string page = talus::read_text(folder.path / "animation.html");
  for (const char* part : {"src=", "href=", "@import", "fetch(", "url("})
    BOOST_TEST(!holds(page, part), part);
  const std::string mark = "<script type=\"application/json\" id=\"data\">";
  const std::size_t begin = page.find(mark) + mark.size();
  const auto data = Json::parse(page.substr(begin, page.find("</script>", begin) - begin));
  BOOST_TEST(data.at("frames").size() == 10U);
  BOOST_TEST(data.at("discs").at("colour") == "force");
  BOOST_TEST(data.at("discs").at("walls").size() == 22U);
  BOOST_TEST(data.at("charts").at(0).at("title") == "Stresses on the walls");
  // Positions are in thousandths of a diameter, speeds in thousandths of the largest speed.
  const talus::DiscFrame state = last_state();
  const Json& frame = data.at("frames").back();
  const double quantum = data.at("discs").at("quantum").get<double>();
  const double fastest = data.at("discs").at("largest").at("speed").get<double>();
  BOOST_TEST(std::abs(quantum - 1e-6) < 1e-15);
  for (std::size_t i = 0; i < state.discs.size(); ++i) {
    BOOST_TEST(std::abs(frame.at("positions").at(2 * i + 1).get<double>() * quantum - state.discs[i].p.y) <= 0.51e-6);
    BOOST_TEST(std::abs(frame.at("speeds").at(i).get<double>() / 1000.0 * fastest - norm(state.discs[i].v)) <=
               0.51e-3 * fastest);
  }
  BOOST_TEST(frame.at("contacts").size() == 3 * state.contacts.size());
}

BOOST_AUTO_TEST_SUITE_END()
