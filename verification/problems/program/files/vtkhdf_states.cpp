#include "verification/problems/program/files/vtkhdf_states.hpp"

#include <fmt/format.h>

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "verification/check/case_file.hpp"
#include "verification/record/whole_file.hpp"
#include "verification/study/program/hdf_numbers.hpp"
#include "verification/study/program/program_options.hpp"

namespace talus::verification::problems::converted_files {
namespace {

/// The numbers between two texts of a section of a VTK file.
std::vector<double> of_section(const std::string& text, const std::string& section, const std::string& name) {
  const std::size_t from = text.find("<" + section + ">"), to = text.find("</" + section + ">");
  return from == std::string::npos ? std::vector<double>{} : data_array(text.substr(from, to - from), name);
}

/// Names and types of the arrays of a section.
std::vector<std::pair<std::string, std::string>> arrays_of(const std::string& text, const std::string& section) {
  std::vector<std::pair<std::string, std::string>> arrays;
  const std::size_t to = text.find("</" + section + ">");
  for (std::size_t at = text.find("<DataArray", text.find("<" + section + ">")); at < to;
       at = text.find("<DataArray", at + 1)) {
    const auto attribute = [&](const std::string& key) {
      const std::size_t from = text.find(key + "=\"", at) + key.size() + 2;
      return text.substr(from, text.find('"', from) - from);
    };
    arrays.emplace_back(attribute("Name"), attribute("type"));
  }
  return arrays;
}

/// A file with the offsets of its steps, as a reader uses them.
class StatesFile {
 public:
  explicit StatesFile(std::filesystem::path path) : path_{std::move(path)} {}

  /// Read once.
  [[nodiscard]] const HdfTable& table(const std::string& name) const {
    const auto found = tables_.find(name);
    return found != tables_.end() ? found->second
                                  : tables_.emplace(name, hdf_table(path_, "/VTKHDF/" + name)).first->second;
  }
  [[nodiscard]] std::vector<double> attribute(const std::string& group, const char* name) const {
    return hdf_attribute(path_, "/VTKHDF" + group, name);
  }
  [[nodiscard]] double of_step(const std::string& name, std::size_t step, std::size_t column = 0) const {
    const HdfTable& all = table("Steps/" + name);
    return all.numbers.at(step * all.columns() + column);
  }
  /// A number of the part of a step, which is its only one.
  [[nodiscard]] double of_part(const std::string& name, std::size_t step) const {
    return table(name).numbers.at(static_cast<std::size_t>(of_step("PartOffsets", step)));
  }

 private:
  std::filesystem::path path_;
  mutable std::map<std::string, HdfTable> tables_;
};

/// Compares a state with the step of the file.
void compare_state(const StatesFile& file, std::size_t step, const std::string& state, Differences& differ) {
  differ.compare("parts of a step", file.of_step("NumberOfParts", step), 1.0);
  const double points = file.of_part("NumberOfPoints", step);
  differ.compare("points", file.table("Points").rows(file.of_step("PointOffsets", step), points),
                 of_section(state, "Points", "Points"));
  double cells = 0.0;
  std::size_t kind = 0;
  for (const auto& [group, section] :
       {std::pair{"Vertices", "Verts"}, {"Lines", "Lines"}, {"Polygons", "Polys"}, {"Strips", "Strips"}}) {
    const std::string of = fmt::format("{}/", group);
    const double number = file.of_part(of + "NumberOfCells", step),
                 ids = file.of_part(of + "NumberOfConnectivityIds", step);
    const std::vector<double> connectivity =
        file.table(of + "Connectivity").rows(file.of_step("ConnectivityIdOffsets", step, kind), ids);
    // Each part has one more offset than cells.
    std::vector<double> ends =
        file.table(of + "Offsets")
            .rows(file.of_step("CellOffsets", step, kind) + file.of_step("PartOffsets", step), number + 1.0);
    differ.compare(of + "first offset", ends.empty() ? -1.0 : ends.front(), 0.0);
    if (!ends.empty()) ends.erase(ends.begin());
    differ.compare(of + "connectivity", connectivity, of_section(state, section, "connectivity"));
    differ.compare(of + "offsets", ends, of_section(state, section, "offsets"));
    cells += number, ++kind;
  }
  for (const auto& [section, rows] : {std::pair{"PointData", points}, {"CellData", cells}}) {
    for (const auto& [name, type] : arrays_of(state, section)) {
      const HdfTable& data = file.table(fmt::format("{}/{}", section, name));
      const double begin = file.of_step(fmt::format("{}Offsets/{}", section, name), step);
      differ.compare(fmt::format("{} {}", section, name), data.rows(begin, rows), of_section(state, section, name));
      differ.compare(fmt::format("type of {} {}", section, name), data.type, type);
    }
  }
}

}  // namespace

void check_vtkhdf_states(const TemporaryFolder& folder, Findings& findings, const Setup& setup) {
  Differences differ;
  std::string cell = records::read_whole(case_file("cell/rough.toml"));
  replace(cell, "end = \"100 ms\"", "end = \"20 ms\"");
  folder.write("discs.toml", cell);
  folder.write("cables.toml", records::read_whole(case_file("two_cable.toml")));
  (void)talus_output(folder, {"cell", "discs.toml", "--out", "discs"});
  (void)talus_output(folder, {"run", "cables.toml", "--end", "0.2 s", "--frames", "3", "--out", "cables"});
  std::size_t steps = 0;
  for (const auto& [out, name] : {std::pair{"discs", "cell"}, {"cables", "cables"}}) {
    const std::string written = fmt::format("{}.vtkhdf", out);
    const ProgramEnd end = run_vtkhdf(folder, {fmt::format("{}/{}.pvd", out, name), "--out", written});
    differ.compare("exit status", end.exit_code, 0);
    differ.compare("messages", end.messages, std::string{});
    differ.compare("printed name", end.output, written + "\n");
    const std::vector<GeometryState> states = geometry_states(folder, out, name);
    const StatesFile file{folder.path() / written};
    const auto text = file.attribute("", "Type");
    differ.compare("type", std::string{text.begin(), text.end()}, std::string{"PolyData"});
    differ.compare("version", file.attribute("", "Version"), std::vector{2.0, 0.0});
    differ.compare("number of steps", file.attribute("/Steps", "NSteps"),
                   std::vector{static_cast<double>(states.size())});
    std::vector<double> times;
    for (std::size_t step = 0; step < states.size(); ++step) {
      times.push_back(states[step].time);
      const std::size_t other = setup.has("next_state") ? (step + 1) % states.size() : step;
      compare_state(file, step, states[other].text, differ);
      ++steps;
    }
    differ.compare("times", file.table("Steps/Values").numbers, times);
  }
  differ.holds("states of a run and of a cell", steps > 6);
  differ.expect_none(findings, "states as VTKHDF: numbers, types and texts that differ",
                     "points, cells and data of each state, written twice");
}

}  // namespace talus::verification::problems::converted_files
