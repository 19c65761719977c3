#include "solver/io/output/fence_history.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>

#include "solver/base/error.hpp"
#include "solver/io/fence1993/read_deck.hpp"
#include "tests/solver/io/fence_run.hpp"

BOOST_AUTO_TEST_SUITE(fence_history_tests)

using namespace talus;

namespace {

FenceInput sample(std::vector<int> elements, std::vector<int> codes, long every = 30) {
  scenes::Fence fence = read_deck(std::filesystem::path{TALUS_CASES} / "fence/sample2.DAT");
  fence.history_elements = std::move(elements);
  fence.history_codes = std::move(codes);
  fence.history_every = every;
  scenes::FenceScene made = scenes::fence_scene(fence);
  return {std::move(fence), std::move(made)};
}

/// A history after `steps` steps, with the objects that it refers to.
struct Kept {
  FenceInput input;
  Dynamics dynamics{input.made.scene.model};
  FenceHistory history{input.fence, input.made, dynamics};

  Kept(FenceInput from, long steps) : input{std::move(from)} { run_fence(input, dynamics, steps, std::ref(history)); }
  double first(std::size_t column) const { return history.history().rows.at(0).at(column); }
  double last(std::size_t column) const { return history.history().rows.back().at(column); }
};

bool near(double a, double b, double relative) { return std::abs(a - b) <= relative * std::abs(b); }

}  // namespace

BOOST_AUTO_TEST_CASE(every_code_has_a_history_or_a_reason_why_not) {
  std::set<std::string_view> names;
  int histories = 0;
  for (std::size_t i = 0; i < fence_codes().size(); ++i) {
    const FenceCode& code = fence_codes()[i];
    BOOST_TEST(code.number == static_cast<int>(i) + 1);
    BOOST_TEST(!code.title.empty());
    BOOST_TEST(code.refusal.empty() == (code.value != nullptr));
    BOOST_TEST(code.refusal.empty() == !code.name.empty());
    if (!code.value) continue;
    ++histories;
    BOOST_TEST(names.insert(code.name).second);
  }
  BOOST_TEST(histories == 23 + 6 + 15);  // 3 .. 25, 33 .. 38, 46 .. 60
}

BOOST_AUTO_TEST_CASE(codes_without_a_history_are_refused_by_name) {
  const FenceInput input = sample({3}, {6, 26, 45});
  const Dynamics dynamics{input.made.scene.model};
  BOOST_CHECK_EXCEPTION((FenceHistory{input.fence, input.made, dynamics}), InputError, [](const InputError& error) {
    return std::string{error.what()} ==
           "history_codes (variab): found 26 (OLD ELEMENT VELOCITY AT CENTROID X-DIR.): it was working memory of the "
           "integrator of 1993; codes 6 to 8 are velocities; 45 (ELEMENT POTENTIAL ENERGY (GRAVIT. & SPRI): the model "
           "has no nodal springs; allowed are 3 .. 25, 33 .. 38 and 46 .. 60";
  });
}

BOOST_AUTO_TEST_CASE(pairs_that_do_not_fit_are_skipped_and_named) {
  const Kept kept{sample({1, 2, 9, 10}, {6, 13, 23, 48, 52}), 1};
  BOOST_TEST(kept.history.skipped() ==
                 (std::vector<std::string>{"element 1: code 13 skipped: it is not a column",
                                           "element 1: code 23 skipped: a motion of it is held",
                                           "element 1: codes 48, 52 skipped: no cable begins at it",
                                           "element 2: code 13 skipped: it is not a column",
                                           "element 2: codes 48, 52 skipped: no cable begins at it",
                                           "element 9: code 52 skipped: no bottom cable begins at it",
                                           "element 10: codes 6, 13, 23, 48, 52 skipped: it is a fixed end of the "
                                           "top cable, not a body"}),
             boost::test_tools::per_element());
  std::vector<std::string> columns;
  for (const Column& column : kept.history.history().columns)
    columns.push_back(column.name);
  BOOST_TEST(
      columns == (std::vector<std::string>{"time", "element1.vx", "element2.vx", "element2.load_x", "element9.vx",
                                           "element9.attachment_length", "element9.load_x", "element9.top_tension"}),
      boost::test_tools::per_element());
  const std::string csv = kept.history.csv_text();
  BOOST_TEST(csv.rfind("# element 1: code 13 skipped: it is not a column\n", 0) == 0U);
  BOOST_TEST(csv.find("\ntime [s],element1.vx [ft/s],element2.vx [ft/s],element2.load_x [lbf],") != std::string::npos);
}

// Computed by hand from the report's static shape: H = (W/sag) sum (i+1/2) d_i = 22046 lb, W = m g, T_i = H l_i/d_i;
// both segments of the central column pull it up by its weight; the bottom cable is slack by 0.5 ft.
BOOST_AUTO_TEST_CASE(the_start_is_the_static_shape) {
  constexpr double m = 3.14159265358979 * 1.25 * 1.25 * 8.0 * 0.76, W = m * 32.18;
  constexpr double H = W / 5.5 * (2.5 * (0.5 + 1.5 + 2.5 + 3.5 + 4.5 + 5.5) + 6.5 * 12.5);
  const double rise = 0.5 * W / H * 2.5, l = std::hypot(2.5, rise), T = H * l / 2.5;
  const double k = 2e7 * 1.076 / l, k_bottom = 2.0 * 2e7 * 0.25 / l;
  const auto start = [](std::vector<int> codes) { return Kept{sample({3}, std::move(codes)), 1}; };
  const Kept tops = start({46, 48, 49, 50, 51, 55, 58, 60});
  const double expected[] = {l, T, 0.0, 0.5 * W, W, k, 1e8, 0.0};
  for (std::size_t i = 0; i < 8; ++i)
    BOOST_TEST(std::abs(tops.first(i + 1) - expected[i]) <= 1e-9 * std::abs(expected[i]));
  const Kept bottoms = start({47, 52, 53, 54, 56, 57, 59, 24});
  const double below[] = {l, 0.0, 0.0, 0.0, k_bottom, l + 0.5, 1e8};
  for (std::size_t i = 0; i < 7; ++i)
    BOOST_TEST(std::abs(bottoms.first(i + 1) - below[i]) <= 1e-9 * std::abs(below[i]));
}

// In motion: codes agree with values computed from other codes by formulas of the report.
BOOST_AUTO_TEST_CASE(codes_agree_with_each_other_in_motion) {
  const Kept cables{sample({3}, {48, 49, 50, 51, 46, 55, 52, 60}), 600};
  const double T = cables.last(1), Tx = cables.last(2), Ty = cables.last(3);
  BOOST_TEST(near(cables.last(4), 2.0 * std::hypot(Tx, Ty), 1e-12));  // both sides have the same tension
  BOOST_TEST(near(std::hypot(Tx, Ty) / T, std::sqrt(1.0 - std::pow(2.5 / cables.last(5), 2)), 1e-12));
  const Kept bottom{sample({3}, {52, 47, 56, 57}), 600};
  double largest = 0.0;
  for (const std::vector<double>& row : bottom.history.history().rows) {
    const double tension = std::max(0.0, row[3] * (row[2] - row[4]));
    BOOST_TEST(std::abs(row[1] - tension) <= 1e-12 * row[3]);
    largest = std::max(largest, tension);
  }
  BOOST_TEST(largest > 0.0);
  const Kept motion{sample({3}, {6, 7, 8, 35, 36, 37, 38, 4}), 300};
  const double m = 3.14159265358979 * 1.25 * 1.25 * 8.0 * 0.76, I = m * (3.0 * 1.25 * 1.25 + 4.0 * 16.0) / 12.0;
  const double linear = 0.5 * m * (std::pow(motion.last(1), 2) + std::pow(motion.last(2), 2));
  const double turning = 0.5 * I * std::pow(motion.last(3), 2);
  BOOST_TEST(near(motion.last(4), linear, 1e-12));
  BOOST_TEST(near(motion.last(5), turning, 1e-12));
  BOOST_TEST(near(motion.last(6), linear + turning, 1e-12));
  BOOST_TEST(near(motion.last(7), m * 32.18 * motion.last(8), 1e-12));
  // The load on the rock equals the change of its momentum: central difference over rows one step apart.
  const Kept rock{sample({2}, {6, 7, 8, 23, 24, 25}, 1), 30};
  const auto& rows = rock.history.history().rows;
  const double h = rows[1][0] - rows[0][0], mass = 4.0 / 3.0 * 3.14159265358979 * std::pow(1.201, 3) * 5.13;
  const double inertia = 0.4 * mass * 1.201 * 1.201;
  for (const auto& [column, sluggish] : {std::pair{1U, mass}, std::pair{2U, mass}, std::pair{3U, inertia}}) {
    const double gained = sluggish * (rows[21][column] - rows[19][column]) / (2.0 * h);
    // A node that enters within two steps causes a jump; the mean of three loads is then within their range.
    double low = rows[19][column + 3], high = low;
    for (std::size_t i = 18; i < 23; ++i)
      low = std::min(low, rows[i][column + 3]), high = std::max(high, rows[i][column + 3]);
    const double slack = 0.02 * std::max(std::abs(low), std::abs(high));
    BOOST_TEST(gained >= low - slack);
    BOOST_TEST(gained <= high + slack);
  }
}

BOOST_AUTO_TEST_CASE(rows_come_every_nhisto_steps_in_both_files) {
  const Kept kept{sample({3, 4}, {6, 51}, 7), 21};
  BOOST_TEST(kept.history.history().rows.size() == 4U);
  const auto json = nlohmann::json::parse(kept.history.json_text());
  BOOST_TEST(json.at("units").get<std::string>() == "US");
  BOOST_TEST(json.at("skipped").empty());
  const auto& joint = json.at("columns").at(2);
  BOOST_TEST(joint.at("name").get<std::string>() == "element3.top_joint_force");
  BOOST_TEST(joint.at("element").get<int>() == 3);
  BOOST_TEST(joint.at("code").get<int>() == 51);
  BOOST_TEST(joint.at("title").get<std::string>() == "FORCE IN TOP JOINT OF ATTENUATOR");
  BOOST_TEST(joint.at("unit").get<std::string>() == "lbf");
  for (std::size_t i = 0; i < 4; ++i)
    BOOST_TEST(joint.at("values").at(i).get<double>() == kept.history.history().rows[i][2]);
}

// A sleeping column beside one that is awake still has the forces of both its segments: its weight, until it is pulled.
BOOST_AUTO_TEST_CASE(hangers_of_sleeping_columns_carry_their_weight) {
  scenes::Fence fence = sample({3, 4, 5, 6, 7, 8, 9}, {51}, 1).fence;
  fence.options.sleep = Sleep::on;
  scenes::FenceScene made = scenes::fence_scene(fence);
  const Kept kept{{std::move(fence), std::move(made)}, 12};
  for (const std::vector<double>& row : kept.history.history().rows) {
    for (std::size_t column = 3; column < row.size(); ++column)
      BOOST_TEST(near(row[column], 960.4162901, 1e-5));  // the wave contributes less than 1e-5 of it within 12 steps
  }
}

BOOST_AUTO_TEST_SUITE_END()
