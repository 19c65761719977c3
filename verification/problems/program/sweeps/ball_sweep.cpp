#include "verification/problems/program/sweeps/ball_sweep.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <utility>

#include "verification/record/json_node.hpp"

namespace talus::verification::problems::swept_scenes {

using records::Json;

std::string ball_scene(const std::string& integrator) {
  return fmt::format(
      "title = \"Ball against a wall\"\nunits = \"SI\"\n"
      "[[body]]\nname = \"ball\"\nmobility = \"particle\"\nmass = \"2 kg\"\nposition = [\"-0.15 m\", \"0 m\"]\n"
      "velocity = [\"5 m/s\", \"0 m/s\"]\nshape = {{ kind = \"circle\", radius = \"{} m\" }}\n"
      "[[body]]\nname = \"wall\"\nmobility = \"fixed\"\nposition = [\"0 m\", \"0 m\"]\nangle = \"90 deg\"\n"
      "shape = {{ kind = \"half_plane\" }}\n"
      "[[contact]]\nname = \"hit\"\nbetween = [\"ball\", \"wall\"]\nlaw = \"linear_spring_dashpot\"\n"
      "stiffness = \"1e5 N/m\"\ndamping = \"100 N s/m\"\n"
      "[run]\nintegrator = \"{}\"\nstep = \"{} s\"\nend = \"0.2 s\"\n",
      radius, integrator, step);
}

std::string axis(const std::string& field, const std::string& rest) {
  return fmt::format("[[axis]]\nfield = \"{}\"\n{}\n", field, rest);
}

records::Csv collected(const Program& program, const std::string& name, const std::string& text) {
  program.write(name + ".toml", text);
  program.run({"sweep", "plan", name + ".toml"});
  program.run({"sweep", "run", name});
  program.run({"sweep", "collect", name});
  return program.csv(name + "/results.csv");
}

void compare_ends(const Program& program, const std::string& name, const records::Csv& csv, Differences& differ) {
  const Json json = program.file(name + "/results.json");
  const Json &runs = json.at("runs"), &counts = json.at("counts");
  differ.compare("units of results.json", json.at("units").get<std::string>(), std::string{"SI"});
  differ.compare("rows of results.json", runs.size(), csv.rows());
  std::map<std::string, std::size_t> ends;
  for (std::size_t row = 0; row < std::min(runs.size(), csv.rows()); ++row) {
    const Json& run = runs.at(row);
    for (const std::string member : {"id", "end", "reason", "verdict"})
      if (run.contains(member))
        differ.compare(member + " in results.json", run.at(member).get<std::string>(),
                       std::string{csv.cell(row, member)});
    for (const auto& [member, head] :
         {std::pair{"number", "number"}, {"time", "time [s]"}, {"evaluations", "evaluations"}})
      differ.compare(fmt::format("{} in results.json", member), run.at(member).get<double>(), csv.number(row, head));
    ++ends[std::string{csv.cell(row, "end")}];
  }
  differ.compare("number of runs in results.json", counts.at("runs").get<std::size_t>(), csv.rows());
  differ.compare("number of missing runs", counts.at("missing").get<int>(), 0);
  for (const char* const end : {"finished", "unusable", "diverged", "refused", "limited"})
    differ.compare(fmt::format("number of {} runs", end), counts.at(end).get<std::size_t>(), ends[end]);
}

}  // namespace talus::verification::problems::swept_scenes
