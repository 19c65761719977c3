#include "solver/io/output/read_geometry.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <string>
#include <string_view>

#include "solver/io/file/atomic_file.hpp"
#include "solver/io/file/vtk_file.hpp"
#include "verification/record/utf8.hpp"

namespace talus {
namespace {

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
  const pugi::xml_node collection = index.part("VTKFile/Collection");
  for (const pugi::xml_node& set : collection.children("DataSet")) {
    const std::string_view time{set.attribute("timestep").value()};
    double value = 0.0;
    if (std::from_chars(time.data(), time.data() + time.size(), value).ec != std::errc{})
      index.report(set, fmt::format("DataSet: timestep: found \"{}\"; it must be a number", records::shown_text(time)));
    const std::string_view name{set.attribute("file").value()};
    if (!is_inside_folder(name)) {
      index.report(set, fmt::format("DataSet: file: found \"{}\"; it must be a file in the folder of the collection, "
                                    "by a relative path without \"..\"",
                                    records::shown_text(name)));
    }
    files.push_back({value, file.parent_path() / name});
  }
  if (files.empty()) index.report(collection, "Collection: it names no file: the run wrote no geometry");
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
  const auto demand_one_a_line = [&](const auto& array) {
    vtk.demand_size(array, offsets.size(), "one for each line");
  };
  demand_one_a_line(bodies), demand_one_a_line(cables), demand_one_a_line(tensions), demand_one_a_line(slacks);
  GeometryFrame frame{file.time, {}};
  std::size_t begin = 0;
  for (std::size_t i = 0; i < offsets.size(); ++i) {
    GeometryLine line{bodies[i], cables[i], tensions[i], slacks[i] != 0, {}, {}};
    if (offsets[i] < begin || offsets[i] > connectivity.size()) {
      vtk.report_array(offsets.node, fmt::format("found {} for line {}; it must be in {} .. {}", offsets[i], i + 1,
                                                 begin, connectivity.size()));
    }
    for (; begin < offsets[i]; ++begin) {
      const std::size_t at = connectivity[begin];
      if (const std::size_t count = std::min(point_bodies.size(), points.size() / 3); at >= count)
        vtk.report_array(connectivity.node, fmt::format("found point {}; it must be below {}", at, count));
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
  vtk.demand_size(points, 3 * ids.size(), "three for each id");
  vtk.demand_size(radii, ids.size(), "one for each id");
  vtk.demand_size(velocities, 3 * ids.size(), "three for each id");
  vtk.demand_size(walls, ids.size(), "one for each id");
  DiscFrame frame{file.time, {}, {}};
  // The points are the discs in the order of their numbers, then images of some of them.
  for (std::size_t i = 0; i < ids.size() && ids[i] == static_cast<long>(i) + 1; ++i) {
    frame.discs.push_back(
        {{points[3 * i], points[3 * i + 1]}, radii[i], {velocities[3 * i], velocities[3 * i + 1]}, walls[i] != 0});
  }
  const std::size_t discs = frame.discs.size(), lines = ends.size() / 2;
  if (discs == 0) vtk.report_array(ids.node, "found no disc, which is numbered from 1");
  vtk.demand_size(forces, discs + lines, fmt::format("one for each of {} discs and {} lines", discs, lines));
  for (std::size_t k = 0; k < lines; ++k) {
    const std::size_t a = ends[2 * k], b = ends[2 * k + 1];
    if (a >= discs || b >= ids.size() || disc_of(ids[b]) >= discs) {
      vtk.report_array(ends.node, fmt::format("line {} joins no two of its {} discs", k, discs));
    }
    frame.contacts.push_back(
        {a, disc_of(ids[b]), frame.discs[a].p, {points[3 * b], points[3 * b + 1]}, forces[discs + k]});
  }
  return frame;
}

}  // namespace talus
