#include "solver/vtkhdf/vtkhdf_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "solver/base/error.hpp"
#include "solver/io/file/vtk_file.hpp"
#include "solver/io/output/read_geometry.hpp"
#include "solver/vtkhdf/hdf_file.hpp"
#include "verification/record/utf8.hpp"

namespace talus {
namespace {

using Numbers = std::vector<std::int64_t>;

/// Kinds of cells, in the order of the columns of CellOffsets; a .vtp file has those with a section.
struct Topology {
  const char *group, *section, *count;
};
constexpr std::array<Topology, 4> topologies{{{"Vertices", "Verts", "NumberOfVerts"},
                                              {"Lines", "Lines", "NumberOfLines"},
                                              {"Polygons", "Polys", "NumberOfPolys"},
                                              {"Strips", "Strips", "NumberOfStrips"}}};

/// An array of points or cells.
struct DataName {
  std::string name;
  HdfType type{};
  std::size_t components{};

  bool operator==(const DataName&) const = default;
};

/// What is read of a state, and written, one after the other.
class VtkHdfSeries {
 public:
  explicit VtkHdfSeries(const std::filesystem::path& file) : hdf_{file} {
    hdf_.group("/VTKHDF");
    hdf_.attribute("/VTKHDF", "Version", Numbers{2, 0});
    hdf_.attribute("/VTKHDF", "Type", "PolyData");
    for (const char* const group :
         {"Steps", "Steps/PointDataOffsets", "Steps/CellDataOffsets", "PointData", "CellData"})
      hdf_.group(fmt::format("/VTKHDF/{}", group));
    for (const Topology& topology : topologies)
      hdf_.group(fmt::format("/VTKHDF/{}", topology.group));
  }

  /// Errors: InputError, IoError.
  void add(const GeometryFile& state) {
    const VtkFile vtk{state.path};
    const auto points = vtk.array<double>("Points", "Points");
    const std::size_t number = points.size() / 3;
    vtk.demand_size(points, 3 * number, "three for each point");
    // One part for each step, which begins where the earlier ones end.
    hdf_.append("/VTKHDF/Steps/Values", std::vector{state.time});
    append("Steps/PartOffsets", {steps_});
    append("Steps/NumberOfParts", {1});
    append("Steps/PointOffsets", {points_});
    append("Steps/CellOffsets", Numbers(cells_.begin(), cells_.end()), topologies.size());
    append("Steps/ConnectivityIdOffsets", Numbers(ids_.begin(), ids_.end()), topologies.size());
    append("NumberOfPoints", {static_cast<std::int64_t>(number)});
    hdf_.append("/VTKHDF/Points", points.values, 3);
    std::size_t cells = 0;
    for (std::size_t i = 0; i < topologies.size(); ++i)
      cells += add_cells(vtk, i, number);
    add_data(vtk, "PointData", number, point_data_, points_);
    add_data(vtk, "CellData", cells, cell_data_, all_cells_);
    ++steps_, points_ += static_cast<std::int64_t>(number), all_cells_ += static_cast<std::int64_t>(cells);
  }

  void close() {
    hdf_.attribute("/VTKHDF/Steps", "NSteps", Numbers{steps_});
    hdf_.close();
  }

 private:
  void append(const std::string& name, const Numbers& numbers, std::size_t columns = 1) {
    hdf_.append("/VTKHDF/" + name, HdfType::int64, numbers, columns);
  }

  /// The cells of a kind; returns their number.
  std::size_t add_cells(const VtkFile& vtk, std::size_t kind, std::size_t points) {
    const Topology& topology = topologies[kind];
    Numbers connectivity, offsets{0};
    const std::size_t number = vtk.piece().attribute(topology.count).as_ullong();
    if (number > 0) {
      const auto ids = vtk.array<std::int64_t>(topology.section, "connectivity"),
                 ends = vtk.array<std::int64_t>(topology.section, "offsets");
      connectivity = ids.values;
      for (const std::int64_t id : connectivity)
        if (id < 0 || id >= static_cast<std::int64_t>(points))
          vtk.report_array(ids.node, fmt::format("found point {}; it must be below {}", id, points));
      for (const std::int64_t end : ends.values) {
        if (end < offsets.back() || end > static_cast<std::int64_t>(connectivity.size()))
          vtk.report_array(ends.node,
                           fmt::format("found {}; it must be in {} .. {}", end, offsets.back(), connectivity.size()));
        offsets.push_back(end);
      }
      vtk.demand_size(ends, number, "one for each cell");
      if (offsets.back() != static_cast<std::int64_t>(connectivity.size()))
        vtk.report_array(ends.node, fmt::format("the last is {}; it must be the number of points of all cells, {}",
                                                offsets.back(), connectivity.size()));
    }
    const std::size_t cells = offsets.size() - 1;
    const std::string group = std::string{topology.group} + "/";
    append(group + "NumberOfCells", {static_cast<std::int64_t>(cells)});
    append(group + "NumberOfConnectivityIds", {static_cast<std::int64_t>(connectivity.size())});
    append(group + "Connectivity", connectivity);
    append(group + "Offsets", offsets);
    cells_[kind] += static_cast<std::int64_t>(cells), ids_[kind] += static_cast<std::int64_t>(connectivity.size());
    return cells;
  }

  /// All arrays of points or cells, those of the first state.
  void add_data(const VtkFile& vtk, const char* section, std::size_t rows, std::vector<DataName>& known,
                std::int64_t offset) {
    const auto arrays = vtk.piece().child(section).children("DataArray");
    std::vector<DataName> names;
    for (const pugi::xml_node& array : arrays) {
      names.push_back(name_of(vtk, array));
      if (std::ranges::count(names, names.back().name, &DataName::name) > 1)
        vtk.report_array(array, "found a second array of this name; remove one");
    }
    if (steps_ == 0) known = names;
    if (names != known)
      vtk.report(vtk.piece(), fmt::format("{}: the arrays must be those of the first state", section));
    auto name = names.begin();
    for (const pugi::xml_node& array : arrays) {
      add_array(vtk, array, section, *name, rows);
      append(fmt::format("Steps/{}Offsets/{}", section, name->name), {offset});
      ++name;
    }
  }

  void add_array(const VtkFile& vtk, const pugi::xml_node& array, const char* section, const DataName& name,
                 std::size_t rows) {
    const std::string path = fmt::format("/VTKHDF/{}/{}", section, name.name), what = "one for each point or cell";
    if (name.type == HdfType::float64) {
      const auto numbers = vtk.numbers<double>(array);
      vtk.demand_size(numbers, rows * name.components, what);
      hdf_.append(path, numbers.values, name.components);
      return;
    }
    const auto numbers = vtk.numbers<std::int64_t>(array);
    vtk.demand_size(numbers, rows * name.components, what);
    const auto [low, high] = range_of(name.type);
    for (const std::int64_t number : numbers.values)
      if (number < low || number > high)
        vtk.report_array(array, fmt::format("found {}; it must be in {} .. {}", number, low, high));
    hdf_.append(path, name.type, numbers.values, name.components);
  }

  /// The whole numbers that a type has.
  static std::pair<std::int64_t, std::int64_t> range_of(HdfType type) {
    if (type == HdfType::uint8) return {0, 255};
    if (type == HdfType::int32)
      return {std::numeric_limits<std::int32_t>::min(), std::numeric_limits<std::int32_t>::max()};
    return {std::numeric_limits<std::int64_t>::min(), std::numeric_limits<std::int64_t>::max()};
  }

  static DataName name_of(const VtkFile& vtk, const pugi::xml_node& array) {
    static constexpr std::array<std::pair<std::string_view, HdfType>, 4> types{{{"Float64", HdfType::float64},
                                                                                {"Int64", HdfType::int64},
                                                                                {"Int32", HdfType::int32},
                                                                                {"UInt8", HdfType::uint8}}};
    const std::string_view type{array.attribute("type").value()}, name{array.attribute("Name").value()};
    const auto found = std::ranges::find(types, type, &std::pair<std::string_view, HdfType>::first);
    if (found == types.end())
      vtk.report_array(array, fmt::format("found type \"{}\"; it must be Float64, Int64, Int32 or UInt8",
                                          records::shown_text(type)));
    const unsigned components = array.attribute("NumberOfComponents").as_uint(1);
    if (components < 1 || components > 9)
      vtk.report_array(array, fmt::format("found {} components; there must be 1 to 9", components));
    if (name.empty() || name == "." || name.find('/') != std::string_view::npos)
      vtk.report_array(array, "found a name that is empty, a point, or has a slash; it must be another one");
    return {std::string{name}, found->second, components};
  }

  HdfFile hdf_;
  std::int64_t steps_{}, points_{}, all_cells_{};
  std::array<std::int64_t, topologies.size()> cells_{}, ids_{};
  std::vector<DataName> point_data_, cell_data_;
};

}  // namespace

void write_vtkhdf(const std::filesystem::path& index, const std::filesystem::path& file,
                  const std::function<void(std::size_t, std::size_t)>& progress) {
  const std::vector<GeometryFile> states = read_geometry_index(index);
  // Before the states are read: the file is written at the end.
  const std::filesystem::path folder = std::filesystem::absolute(file).parent_path();
  if (!std::filesystem::is_directory(folder))
    throw IoError{fmt::format("{}: found no folder {}; it must exist", file.string(), folder.string())};
  if (std::filesystem::is_directory(file)) throw IoError{fmt::format("{}: it is a folder; name a file", file.string())};
  VtkHdfSeries series{file};
  for (std::size_t i = 0; i < states.size(); ++i) {
    series.add(states[i]);
    progress(i + 1, states.size());
  }
  series.close();
}

}  // namespace talus
