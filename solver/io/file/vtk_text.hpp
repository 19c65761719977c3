#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace talus {

/// One array of numbers of a VTK XML file. The text of its values must outlive it.
struct VtkArray {
  std::string_view type, name;
  int components{1};
  std::string_view values;
};

/// The contents of one piece of VTK XML poly data: points, verts and lines as arrays `connectivity` and `offsets`,
/// data.
struct PolyData {
  long points{}, verts{}, lines{};
  std::vector<VtkArray> point_data, cell_data;  ///< cells are the verts, then the lines
  std::string_view coordinates;                 ///< x y z of each point; the text must outlive it
  std::vector<VtkArray> vert_arrays, line_arrays;
};
[[nodiscard]] std::string vtk_text(const PolyData& data);

/// Text of the index of a series, which ParaView opens: the files with their times.
[[nodiscard]] std::string vtk_index(const std::vector<std::pair<double, std::string>>& files);

}  // namespace talus
