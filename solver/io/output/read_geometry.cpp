#include "solver/io/output/read_geometry.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <pugixml.hpp>
#include <string>
#include <string_view>

#include "solver/base/error.hpp"
#include "solver/io/file/toml_document.hpp"

namespace talus {
namespace {

/// A VTK XML file, read completely.
class VtkFile {
 public:
  explicit VtkFile(const std::filesystem::path& path) : name_{path.string()} {
    const std::string text = read_text(path);
    const pugi::xml_parse_result result = document_.load_buffer(text.data(), text.size());
    if (result) return;
    const auto end =
        text.begin() + static_cast<std::ptrdiff_t>(std::min<std::size_t>(
                           text.size(), static_cast<std::size_t>(std::max<std::ptrdiff_t>(0, result.offset))));
    throw InputError{
        fmt::format("{}:{}: not XML: {}", name_, 1 + std::count(text.begin(), end, '\n'), result.description())};
  }

  [[noreturn]] void report(std::string_view message) const { throw InputError{fmt::format("{}: {}", name_, message)}; }

  pugi::xml_node part(const char* path) const {
    const pugi::xml_node found = document_.first_element_by_path(path);
    if (!found) report(fmt::format("{}: it is missing; `talus run` writes VTK poly data", path));
    return found;
  }

  /// The numbers of an array of the piece, e.g. of section "Points" and name "Points".
  template <class Number>
  std::vector<Number> array(const char* section, const char* name) const {
    const pugi::xml_node found =
        part("VTKFile/PolyData/Piece").child(section).find_child_by_attribute("DataArray", "Name", name);
    if (!found) report(fmt::format("{}: array '{}': it is missing", section, name));
    std::string_view rest{found.text().get()};
    std::vector<Number> numbers;
    for (;;) {
      rest.remove_prefix(std::min(rest.find_first_not_of(" \n\t\r"), rest.size()));
      if (rest.empty()) return numbers;
      Number value{};
      const auto [end, failure] = std::from_chars(rest.data(), rest.data() + rest.size(), value);
      if (failure != std::errc{}) {
        report(fmt::format("{}: array '{}': found \"{}\"; it must be a number", section, name, rest.substr(0, 20)));
      }
      numbers.push_back(value);
      rest.remove_prefix(static_cast<std::size_t>(end - rest.data()));
    }
  }

 private:
  std::string name_;
  pugi::xml_document document_;
};

/// Index of the disc that a point represents, from the point's number; the image of a disc has the negative of its
/// number. For 0, an index beyond all discs.
std::size_t disc_of(long number) {
  const auto size = static_cast<std::size_t>(number);
  return (number < 0 ? 0 - size : size) - 1;
}

}  // namespace

std::vector<GeometryFile> read_geometry_index(const std::filesystem::path& file) {
  const VtkFile index{file};
  std::vector<GeometryFile> files;
  for (const pugi::xml_node& set : index.part("VTKFile/Collection").children("DataSet")) {
    const std::string_view time{set.attribute("timestep").value()};
    double value = 0.0;
    if (std::from_chars(time.data(), time.data() + time.size(), value).ec != std::errc{}) {
      index.report(fmt::format("timestep: found \"{}\"; it must be a number", time));
    }
    files.push_back({value, file.parent_path() / set.attribute("file").value()});
  }
  if (files.empty()) index.report("Collection: it names no file: the run wrote no geometry");
  return files;
}

GeometryFrame read_geometry(const GeometryFile& file) {
  const VtkFile vtk{file.path};
  const auto points = vtk.array<double>("Points", "Points");
  const auto point_bodies = vtk.array<long>("PointData", "body");
  const auto connectivity = vtk.array<std::size_t>("Lines", "connectivity");
  const auto offsets = vtk.array<std::size_t>("Lines", "offsets");
  const auto bodies = vtk.array<long>("CellData", "body");
  const auto cables = vtk.array<long>("CellData", "cable");
  const auto tensions = vtk.array<double>("CellData", "tension");
  const auto slacks = vtk.array<int>("CellData", "slack");
  for (const std::size_t count : {bodies.size(), cables.size(), tensions.size(), slacks.size()}) {
    if (count != offsets.size())
      vtk.report(fmt::format("CellData: found {} values for {} lines", count, offsets.size()));
  }
  GeometryFrame frame{file.time, {}};
  std::size_t begin = 0;
  for (std::size_t i = 0; i < offsets.size(); ++i) {
    GeometryLine line{bodies[i], cables[i], tensions[i], slacks[i] != 0, {}, {}};
    if (offsets[i] < begin || offsets[i] > connectivity.size())
      vtk.report(fmt::format("Lines: offsets: line {} has a wrong offset", i));
    for (; begin < offsets[i]; ++begin) {
      const std::size_t at = connectivity[begin];
      if (at >= point_bodies.size() || 3 * at + 2 >= points.size())
        vtk.report(fmt::format("Lines: connectivity: found point {}, which is not there", at));
      line.points.push_back({points[3 * at], points[3 * at + 1], points[3 * at + 2]});
      line.bodies.push_back(point_bodies[at]);
    }
    frame.lines.push_back(std::move(line));
  }
  return frame;
}

DiscFrame read_discs(const GeometryFile& file) {
  const VtkFile vtk{file.path};
  const auto points = vtk.array<double>("Points", "Points");
  const auto ids = vtk.array<long>("PointData", "id");
  const auto radii = vtk.array<double>("PointData", "radius");
  const auto velocities = vtk.array<double>("PointData", "velocity");
  const auto walls = vtk.array<int>("PointData", "wall");
  const auto ends = vtk.array<std::size_t>("Lines", "connectivity");
  const auto forces = vtk.array<double>("CellData", "force");
  for (const std::size_t count : {points.size() / 3, radii.size(), velocities.size() / 3, walls.size()}) {
    if (count != ids.size()) vtk.report(fmt::format("PointData: found {} values for {} points", count, ids.size()));
  }
  DiscFrame frame{file.time, {}, {}};
  // The points are the discs in the order of their numbers, then images of some of them.
  for (std::size_t i = 0; i < ids.size() && ids[i] == static_cast<long>(i) + 1; ++i) {
    frame.discs.push_back(
        {{points[3 * i], points[3 * i + 1]}, radii[i], {velocities[3 * i], velocities[3 * i + 1]}, walls[i] != 0});
  }
  const std::size_t discs = frame.discs.size(), lines = ends.size() / 2;
  if (discs == 0) vtk.report("PointData: array 'id': found no disc, which is numbered from 1");
  if (forces.size() != discs + lines) {
    vtk.report(
        fmt::format("CellData: array 'force': found {} values for {} discs and {} lines", forces.size(), discs, lines));
  }
  for (std::size_t k = 0; k < lines; ++k) {
    const std::size_t a = ends[2 * k], b = ends[2 * k + 1];
    if (a >= discs || b >= ids.size() || disc_of(ids[b]) >= discs) {
      vtk.report(fmt::format("Lines: connectivity: line {} joins no two of its {} discs", k, discs));
    }
    frame.contacts.push_back(
        {a, disc_of(ids[b]), frame.discs[a].p, {points[3 * b], points[3 * b + 1]}, forces[discs + k]});
  }
  return frame;
}

}  // namespace talus
