#include "verification/problems/program/files/interrupted_runs.hpp"

#include <string>
#include <utility>
#include <vector>

#include "verification/check/case_file.hpp"
#include "verification/record/json_node.hpp"
#include "verification/record/whole_file.hpp"
#include "verification/study/program/compared_folders.hpp"

namespace talus::verification::problems::run_files {
namespace {

using records::Json;

/// A disc that rebounds within too few steps, and later overlaps a second disc, with which it has no contact.
const std::string warned = R"(title = "A run with warnings"
units = "SI"
[[body]]
name = "ground"
mobility = "fixed"
position = ["0 m", "0 m"]
shape = { kind = "half_plane" }
[[body]]
name = "disc"
mobility = "particle"
mass = "1 kg"
position = ["0 m", "0.51 m"]
velocity = ["0 m/s", "-0.4 m/s"]
shape = { kind = "circle", radius = "0.5 m" }
[[body]]
name = "other"
mobility = "particle"
mass = "0.01 kg"
position = ["-1.2 m", "1.6 m"]
velocity = ["2 m/s", "0 m/s"]
shape = { kind = "circle", radius = "0.5 m" }
[[contact]]
name = "touch"
between = ["disc", "ground"]
law = "linear_spring_dashpot"
stiffness = "3000 N/m"
damping = "0 N s/m"
[run]
integrator = "velocity_verlet"
step = "0.02 s"
end = "0.6 s"
watch = { quality = "warning" }
)";

/// summary.json of the scene run at once, and interrupted at 0.52 s, after the rebound, and resumed.
std::pair<Json, Json> summaries(const TemporaryFolder& folder, const std::string& name, const std::string& scene) {
  const std::string halves = name + "_halves";
  folder.write(name + ".toml", scene);
  (void)talus_output(folder, {"run", name + ".toml", "--out", name});
  (void)talus_output(folder, {"run", name + ".toml", "--out", halves, "--until", "0.52 s"});
  (void)talus_output(folder, {"run", "--resume", halves});
  const auto summary = [&](const std::string& out) { return records::read_json(folder.path() / out / "summary.json"); };
  return {summary(name), summary(halves)};
}

}  // namespace

double different_warnings(const TemporaryFolder& folder) {
  const auto [whole, resumed] = summaries(folder, "warned", warned);
  return whole.at("warnings").size() == 3 && resumed == whole ? 0.0 : 1.0;
}

double different_events(const TemporaryFolder& folder) {
  std::string located = warned;
  const std::string method = "velocity_verlet";
  located.replace(located.find(method), method.size(), "stormer_cowell");
  const auto [whole, resumed] = summaries(folder, "located", located);
  return whole.at("events") == 2 && resumed == whole ? 0.0 : 1.0;
}

double different_fence_files(const TemporaryFolder& folder) {
  std::string deck = records::read_whole(case_file("fence/sample2.DAT"));
  const std::string limits = "1e8 1e8";
  deck.replace(deck.find(limits), limits.size(), "20000. 1e8");
  folder.write("fence.DAT", deck);
  // Without the programs that draw the sheet, its page has no pictures. The exit status is 4, and the checkpoint of the
  // interrupted run is not removed.
  const auto ends_otherwise = [&](const std::vector<std::string>& arguments) {
    return run_talus(folder, arguments, {{"PATH", "/nowhere"}}).exit_code != 4;
  };
  if (ends_otherwise({"run", "fence.DAT", "--end", "12 ms", "--sheet", "--out", "fence"}) ||
      ends_otherwise(
          {"run", "fence.DAT", "--end", "12 ms", "--sheet", "--out", "fence_halves", "--until", "6.05 ms"}) ||
      ends_otherwise({"run", "--resume", "fence_halves"}))
    return 1.0;
  return files_of(folder, "fence").size() < 10 ? 1.0
                                               : different_files(folder, "fence", "fence_halves", {"checkpoint.json"});
}

double different_after_a_fence(const TemporaryFolder& folder) {
  (void)talus_output(folder, {"run", "warned.toml", "--out", "fence_halves"});
  return different_files(folder, "warned", "fence_halves");
}

}  // namespace talus::verification::problems::run_files
