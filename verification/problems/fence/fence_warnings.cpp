#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>

#include "solver/base/error.hpp"
#include "solver/io/scene/read_scene.hpp"
#include "solver/scenes/fence_plausibility.hpp"
#include "solver/scenes/fence_scene.hpp"
#include "verification/check/case_file.hpp"
#include "verification/problems/fence/fence_layouts.hpp"
#include "verification/study/toolkit.hpp"

namespace talus::verification::problems::fence_layouts {

/// Checks the warnings for a sound fence that is changed to slightly within and slightly beyond each warning's limit.
void check_warnings(Findings& findings) {
  const scenes::Fence sound = fence_of_today();
  struct Change {
    const char* begins;  ///< beginning of the only warning beyond the limit
    void (*make)(scenes::Fence& fence, double limits);
  };
  static constexpr std::array changes{
      Change{"sag: ", [](scenes::Fence& f, double limits) { f.sag = limits * f.span; }},
      Change{"spacing: ", [](scenes::Fence& f, double limits) { f.spacing = 2.0 * f.column.a / limits; }},
      Change{"changed_column: ",
             [](scenes::Fence& f, double limits) {
               f.spacing = 3.0, f.changed_columns = {unlike}, f.changed_columns[0].b = f.column.b;
               f.changed_columns[0].y_top = f.y_top;
               f.changed_columns[0].a = limits * 1.75;  // next to a half-width of 1.25
             }},
      Change{"layer_spacing: ",
             [](scenes::Fence& f, double limits) { f.layers = 2, f.layer_spacing = 2.0 * f.column.a / limits; }},
      // Both neighbours of the centre are changed, and a column of each layer.
      Change{"changed_column: ",
             [](scenes::Fence& f, double limits) {
               f.columns = 4, f.spacing = 3.0,
               f.changed_columns = {{1, limits * 1.5, f.column.b, f.column.density, f.y_top, f.y_bottom}};
             }},
      Change{"layer_spacing: ",
             [](scenes::Fence& f, double limits) {
               f.layers = 2, f.spacing = 4.0, f.layer_spacing = 3.0;
               f.changed_columns = {{2, limits * 1.5, f.column.b, f.column.density, f.y_top, f.y_bottom}};
             }},
      Change{"ground: ", [](scenes::Fence& f, double limits) { f.ground.position.y = -5.0 + 0.5 * limits; }}};
  double wrong = 0.0;
  const auto count = [&](const std::vector<std::string>& within, const std::vector<std::string>& beyond,
                         const std::string& begins) {
    wrong += within.empty() && beyond.size() == 1 && beyond[0].starts_with(begins) ? 0.0 : 1.0;
  };
  for (const Change& change : changes) {
    const auto warnings = [&](double limits) {
      scenes::Fence fence = sound;
      change.make(fence, limits);
      return scenes::implausible_geometry(fence, scenes::fence_scene(fence));
    };
    count(warnings(0.9999), warnings(1.0001), change.begins);
  }
  const auto motion = [&](double heights, double spans, bool touched) {
    scenes::FenceSummary summary;
    summary.layers.resize(1), summary.rocks.resize(1);
    summary.layers[0].top.start = 10.0;
    scenes::RockPassage& rock = summary.rocks[0];
    rock.name = "rock", rock.touched = touched, rock.highest = heights * 10.0, rock.distance = spans * sound.span;
    return scenes::implausible_motion(sound, summary);
  };
  count(motion(4.9999, 4.9999, true), motion(5.0001, 4.9999, true), "'rock' flies away: ");
  count(motion(4.9999, 4.9999, true), motion(4.9999, 5.0001, true), "'rock' is 275 ft ");
  count(motion(1.0, 1.0, true), motion(1.0, 1.0, false), "'rock' never touches ");
  // A single column has no neighbour; warnings report overlaps as numbers.
  scenes::Fence single = sound;
  single.columns = 1, single.spacing = 1.0, single.changed_columns = {unlike};
  single.changed_columns[0] = {1, 1.75, sound.column.b, sound.column.density, sound.y_top, sound.y_bottom};
  const std::vector<std::string> alone = scenes::implausible_geometry(single, scenes::fence_scene(single));
  findings.expect_exact("number of warnings for a single column wider than the spacing",
                        static_cast<double>(alone.size()), 0.0, "a count");
  scenes::Fence tight = sound;
  tight.layers = 2, tight.spacing = 2.0, tight.layer_spacing = 1.75;
  const std::vector<std::string> said = scenes::implausible_geometry(tight, scenes::fence_scene(tight));
  findings.expect_true("overlaps of neighbours and of layers given in the warnings",
                       said.size() == 2 && said[0].ends_with("overlap by 0.5 ft") &&
                           said[1].ends_with("overlap by 0.75 ft") && said[0].find("2.5 ft") != std::string::npos &&
                           said[1].find("2.5 ft") != std::string::npos,
                       "columns 2.5 ft wide at distances of 2 ft and 1.75 ft");
  scenes::Fence wide = sound;
  wide.spacing = 3.0;
  wide.changed_columns = {{1, 2.0, sound.column.b, sound.column.density, sound.y_top, sound.y_bottom}};
  const std::vector<std::string> of_width = scenes::implausible_geometry(wide, scenes::fence_scene(wide));
  findings.expect_true(
      "width and spacing given in the warning of a changed column",
      of_width.size() == 1 &&
          of_width[0] == "changed_column: a column of a width of 4 ft overlaps its neighbours, 3 ft apart",
      "a half-width of 2 ft next to columns of 1.25 ft");
  // The ground, 1 ft higher than the bottom of the central column, also reaches into its neighbours, which hang higher.
  scenes::Fence sunk = sound;
  sunk.ground.position.y = -3.5;
  const std::vector<std::string> of_ground = scenes::implausible_geometry(sunk, scenes::fence_scene(sunk));
  findings.expect_true(
      "depth and column given in the warning of the ground",
      of_ground.size() == 1 && of_ground[0] == "ground: it reaches 1 ft into the columns, furthest into 'column1'",
      "a ground whose surface is 0.5 ft above its centre, and columns whose bottom is 4 ft below theirs");
  findings.expect_exact("number of warning limits with a missing, wrong or additional warning", wrong, 0.0,
                        "a count of ten limits; tested a ten-thousandth to either side");
}

namespace {

/// The fence of Table 2 as a scene.
std::string published_scene() {
  std::ifstream file{case_file("fence/table_2.toml")};
  return {std::istreambuf_iterator<char>{file}, {}};
}

}  // namespace

/// Checks which positions of rocks are refused: beside the columns, and behind the exit, where the run ends.
void check_positions(Findings& findings) {
  const std::string sound = published_scene();
  const std::size_t first = sound.find("[[fence.rock]]"), next = sound.find("[fence.column]");
  const std::string rock = sound.substr(first, next - first);
  const auto is_refused = [&](const std::string& rocks, const std::string& options, const std::string& message) {
    try {
      static_cast<void>(read_scene_file(
          sound.substr(0, first) + rocks + sound.substr(next) + "\n[fence.options]\n" + options, "table_2.toml"));
    } catch (const InputError& error) {
      return std::string_view{error.what()}.find(message) != std::string_view::npos;
    }
    return false;
  };
  double wrong = 0.0;
  // 13 columns 2.5 ft apart: half a distance beyond the outermost ones.
  for (const double sign : {1.0, -1.0}) {
    for (const auto& [ratio, refused] : {std::pair{0.9999, false}, {1.0001, true}}) {
      const std::string along = fmt::format("along = \"{} ft\"\n", sign * ratio * 6.5 * 2.5);
      wrong += is_refused(rock + along, "symmetry = \"full\"\n",
                          "it must be in front of the columns, within 16.25 ft") == refused
                   ? 0.0
                   : 1.0;
    }
  }
  // Of two rocks each in turn starts behind the exit.
  const auto at = [&](double x) {
    std::string moved = rock;
    const std::size_t from = moved.find("position = "), to = moved.find('\n', from);
    return moved.replace(from, to - from, fmt::format("position = [\"{} ft\", \"0 ft\"]", x));
  };
  const std::string ends = "end = \"exit\"\nexit_x = \"2.5 ft\"\n", behind = "it must be > exit_x, 2.5 ft";
  for (const auto& [one, other] : {std::pair{2.501, 9.0}, {2.499, 9.0}, {9.0, 2.501}, {9.0, 2.499}})
    wrong += is_refused(at(one) + at(other), ends, behind) == (std::min(one, other) < 2.5) ? 0.0 : 1.0;
  findings.expect_exact("number of positions of rocks that are wrongly accepted or refused", wrong, 0.0,
                        "a count of 8");
}

/// Checks the number of steps that a duration takes, and how often a state and a row are written.
void check_duration(Findings& findings) {
  std::string text = published_scene();
  const auto remove = [&](const std::string& key) {
    const std::size_t from = text.find("\n" + key + " = ") + 1;
    text.erase(from, text.find('\n', from) + 1 - from);
  };
  for (const char* const key : {"steps", "print_every", "history_every"})
    remove(key);
  const SceneFile read =
      read_scene_file(text.insert(text.find("[fence]\n") + 8, "duration = \"0.0200001 s\"\n"), "table_2.toml");
  const scenes::Fence& fence = read.fence->fence;
  const double steps = 0.0200001 / read.scene.plan.step;
  findings.expect_exact("number of steps of a fence with a duration", static_cast<double>(fence.steps),
                        std::ceil(steps), "the run lasts at least as long");
  findings.expect_true("number of steps between states and between rows of a fence with a duration",
                       fence.print_every == fence.steps / 100 && fence.history_every == fence.steps / 1000,
                       "a hundred states and a thousand rows");
}

/// Checks which integers of a fence file are refused by name: at both ends of their ranges and one beyond each.
void check_counts(Findings& findings) {
  const std::string sound = published_scene();
  const auto refusal = [&](const std::string& field, long value) -> std::string {
    const std::size_t from = sound.find("\n" + field + " = "), to = sound.find('\n', from + 1);
    const std::string text = sound.substr(0, from) + fmt::format("\n{} = {}", field, value) + sound.substr(to);
    try {
      static_cast<void>(read_scene_file(text, "table_2.toml"));
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
  struct Range {
    const char* field;
    long minimum, maximum;
  };
  static constexpr std::array ranges{Range{"steps", 1, 1'000'000'000},
                                     Range{"print_every", 1, 1'000'000'000},
                                     Range{"history_every", 1, 1'000'000'000},
                                     Range{"gravity_sign", -1, 1},
                                     Range{"connections", 1, 2},
                                     Range{"columns", 1, 1000},
                                     Range{"layers", 1, 2}};
  double wrong = refusal("gravity_sign", 0).empty() ? 1.0 : 0.0;
  const auto refused = [&](const Range& range, long value) {
    const std::string says = fmt::format("{}: found {}; it must be ", range.field, value);
    return refusal(range.field, value).find(says) != std::string::npos;
  };
  for (const Range& range : ranges) {
    for (const long value : {range.minimum - 1, range.maximum + 1})
      wrong += refused(range, value) ? 0.0 : 1.0;
    // A thousand columns are refused, but for their width.
    for (const long value : {range.minimum, range.maximum})
      wrong += refused(range, value) ? 1.0 : 0.0;
  }
  findings.expect_exact("number of integers at or beyond the ends of their ranges that are wrongly accepted or refused",
                        wrong, 0.0, "a count of 29");
}

/// Checks runs that end when the rocks have passed a position, or are at rest.
void check_ends(Findings& findings) {
  constexpr double step = 1e-4, exit = -7.003;
  scenes::Fence fence = fence_of_today();
  fence.rocks[0].position.y = 30.0;
  fence.options.end = scenes::FenceEnd::exit, fence.options.exit_x = exit;
  const scenes::FenceScene made = scenes::fence_scene(fence);
  const RunEnd run =
      run_scene(made.scene, VelocityVerlet{}, {step, 1.0, 1.0, false}, findings, {},
                [&](const State& state) { return reached(*made.scene.early_end, made.scene.model, state); });
  findings.expect_between("delay between exit of a rock above the fence and end of the run",
                          run.state.t - (fence.rocks[0].position.x - exit) / 65.0, 0.0, step,
                          "the run ends with the first step beyond the exit", "s");
  // A condition that holds at the last step does not stop the run, which has reached its end.
  const auto stopped_at = [&](double time) {
    double at = 0.0;
    (void)run_scene(
        made.scene, VelocityVerlet{}, {step, 5.0 * step, step, false}, findings,
        [&](const State& state, const StepInfo& info) { at = info.stop ? state.t : at; },
        [&](const State& state) { return state.t > time; });
    return at;
  };
  findings.expect_true("stop of a run by a condition: at the step before the last, but not at the last",
                       std::abs(stopped_at(3.5 * step) - 4.0 * step) < 1e-12 && stopped_at(4.5 * step) == 0.0,
                       "a run of five steps that ends has finished");
  fence.options.end = scenes::FenceEnd::rest;
  scenes::FenceElement slow = fence.rocks[0];
  slow.velocity = {-3.0, 4.0}, slow.position.x += 5.0;
  fence.rocks.push_back(slow);
  const scenes::FenceScene resting = scenes::fence_scene(fence);
  const auto ends = [&](double first, double second) {
    State state = resting.scene.initial;
    set_velocity(resting.scene.model, state, *find_body(resting.scene.model, "rock1"), {0.0, first}, 0.0);
    set_velocity(resting.scene.model, state, *find_body(resting.scene.model, "rock2"), {second, 0.0}, 0.0);
    return reached(*resting.scene.early_end, resting.scene.model, state);
  };
  findings.expect_true("end of a run at rest: both rocks slower than a thousandth of the faster one's initial speed",
                       ends(0.0649, 0.0649) && !ends(0.0651, 0.0) && !ends(0.0, 0.0651),
                       "the initial speeds are 65 ft/s and 5 ft/s");
}

}  // namespace talus::verification::problems::fence_layouts
