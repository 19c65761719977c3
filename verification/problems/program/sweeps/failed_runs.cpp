#include "verification/problems/program/sweeps/failed_runs.hpp"

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "verification/problems/program/sweeps/ball_sweep.hpp"
#include "verification/record/csv.hpp"
#include "verification/record/json_node.hpp"
#include "verification/study/program/sweep_results.hpp"

namespace talus::verification::problems::swept_scenes {
namespace {

namespace fs = std::filesystem;
using records::Json;

/// Rows of runs that fail, with their reasons and exit statuses.
void check_rows(const Program& program, Differences& differ) {
  program.write("failing.toml", "base = \"steps.toml\"\noutputs = [\"ball.vx.end\"]\n[limits]\nevaluations = 5000\n" +
                                    axis("body.ball.mass", "values = [\"2 kg\", \"-1 kg\"]") +
                                    axis("run.step", "values = [\"1e-4 s\", \"2e-2 s\", \"1e-6 s\"]"));
  program.run({"sweep", "plan", "failing.toml"});
  const ProgramEnd ran = program.end({"sweep", "run", "failing"});
  differ.compare("exit status if some runs fail", ran.exit_code, 6);
  differ.contains("counts of failures", ran.output, "6 of 6 runs done: 1 finished, 1 diverged, 3 refused, 1 limited\n");
  differ.compare("exit status of collect", program.end({"sweep", "collect", "failing"}).exit_code, 6);
  const records::Csv csv = compared_sweep(program, "failing", differ);
  const std::vector<std::pair<std::string, std::string>> ends{{"finished", ""},
                                                              {"diverged", "overlaps by"},
                                                              {"limited", "limit of 5000 evaluations"},
                                                              {"refused", "found \"-1 kg\""},
                                                              {"refused", "-1 kg"},
                                                              {"refused", "mass"}};
  differ.compare("rows of failures", csv.rows(), ends.size());
  for (std::size_t row = 0; row < std::min(csv.rows(), ends.size()); ++row) {
    differ.compare("end: " + ends[row].first, std::string{csv.cell(row, "end")}, ends[row].first);
    const std::string_view reason = csv.cell(row, "reason");
    differ.holds("reason: " + ends[row].second,
                 row == 0 ? reason.empty() : reason.find(ends[row].second) != std::string_view::npos);
    differ.compare("no value of a failed run", csv.cell(row, "ball.vx.end [m/s]").empty(), row > 0);
  }
  const Json status = program.json({"sweep", "status", "failing"}, {{"--json", {}}});
  for (const auto& [member, count] : {std::pair{"runs", 6},
                                      {"missing", 0},
                                      {"finished", 1},
                                      {"diverged", 1},
                                      {"refused", 3},
                                      {"limited", 1},
                                      {"unusable", 0},
                                      {"duplicates", 0},
                                      {"of_others", 0}})
    differ.compare(member, status.at(member).get<int>(), count);
}

/// A run with a step that is too long, of which the watch only warns.
void check_warnings(const Program& program, Differences& differ) {
  program.write("coarse.toml", ball_scene("velocity_verlet") + "watch = { quality = \"warning\" }\n");
  program.write("warned.toml",
                "base = \"coarse.toml\"\noutputs = [\"ball.vx.end\"]\n" + axis("run.step", "values = [\"5e-3 s\"]"));
  program.run({"sweep", "plan", "warned.toml"});
  differ.compare("exit status with warnings", program.end({"sweep", "run", "warned"}).exit_code, 0);
  program.run({"sweep", "collect", "warned"});
  const records::Csv warned = compared_sweep(program, "warned", differ);
  const std::string reason{warned.cell(0, "reason")};
  differ.compare("end with warnings", std::string{warned.cell(0, "end")}, std::string{"finished"});
  differ.contains("a flaw as reason", reason, "the energy balance is off by");
  const Json summary = program.json({"run", "coarse.toml"}, {{"--step", {"5 ms"}}, {"--json", {}}});
  differ.holds("warnings of the run", !summary.at("warnings").empty());
  for (const Json& warning : summary.at("warnings"))
    differ.contains("a warning as reason", reason, warning.get<std::string>());
}

/// A ball whose speed is a number and whose energy is none.
void check_overflow(const Program& program, Differences& differ) {
  std::string scene = ball_scene("velocity_verlet");
  scene.replace(scene.find("\"5 m/s\""), 7, "\"-1e160 m/s\"");
  program.write("huge.toml", scene);
  const ProgramEnd ended = program.end({"run", "huge.toml"}, {{"--out", {"huge"}}});
  differ.compare("exit status without an energy balance", ended.exit_code, 7);
  const Json quality = program.file("huge/summary.json").at("quality");
  differ.holds("verdict without an energy balance", !quality.at("usable").get<bool>());
  differ.contains("flaw without an energy balance", quality.at("flaw").get<std::string>(), "have no balance");
}

/// Reasons do not depend on the folder, nor on the way to it.
void check_folders(const Program& program, Differences& differ) {
  const ProgramEnd planned = program.end({"sweep", "plan", "failing.toml"}, {{"--out", {"deep/er"}}});
  differ.contains("warning of the plan", planned.messages, "warning: run 4 is refused: ");
  const fs::path deep = fs::canonical(program.folder().path() / "deep/er");
  program.end({"sweep", "run", deep.string()});
  program.end({"sweep", "collect", deep.string()});
  differ.compare("table in another folder", program.read("deep/er/results.csv"), program.read("failing/results.csv"));
}

/// Limits that end every run.
void check_limits(const Program& program, Differences& differ) {
  program.write("none.toml", "base = \"steps.toml\"\noutputs = [\"ball.vx.end\"]\n[limits]\nevaluations = 100\n" +
                                 axis("run.step", "values = [\"1e-7 s\", \"2e-7 s\"]"));
  const Json cost = program.json({"sweep", "plan", "none.toml"}, {{"--json", {}}});
  differ.compare("estimate with a limit", cost.at("evaluations").get<double>(), 200.0);
  differ.compare("exit status if all runs fail", program.end({"sweep", "run", "none"}).exit_code, 3);

  program.write("slow.toml", "base = \"steps.toml\"\noutputs = [\"ball.vx.end\"]\n[limits]\ntime = \"60 ms\"\n" +
                                 axis("run.step", "values = [\"1e-9 s\"]"));
  program.run({"sweep", "plan", "slow.toml"});
  const auto began = std::chrono::steady_clock::now();
  program.end({"sweep", "run", "slow"});
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - began;
  // No upper limit, since a busy machine makes it later; the run would take hours.
  differ.holds("a run ends after its limit of time", taken.count() > 0.06);
  program.end({"sweep", "collect", "slow"});
  const records::Csv slow = compared_sweep(program, "slow", differ);
  differ.compare("limit of time", std::string{slow.cell(0, "reason")}, std::string{"limit of 0.06 s"});
}

}  // namespace

void check_failures(const Program& program, Differences& differ) {
  program.write("steps.toml", ball_scene("velocity_verlet"));
  check_rows(program, differ);
  check_warnings(program, differ);
  check_overflow(program, differ);
  check_folders(program, differ);
  check_limits(program, differ);
}

}  // namespace talus::verification::problems::swept_scenes
