#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace talus {

/// One array of numbers of a VTK XML file, as text.
[[nodiscard]] std::string vtk_array(std::string_view type, std::string_view name, int components,
                                    std::string_view values);

/// The parts of a piece of VTK XML poly data: points; verts and lines as arrays `connectivity` and `offsets`; data.
struct PolyData {
  long points{}, verts{}, lines{};
  std::string point_data, cell_data;  ///< arrays; cells are the verts, then the lines
  std::string coordinates;            ///< x y z of each point
  std::string vert_arrays, line_arrays;
};
[[nodiscard]] std::string vtk_text(const PolyData& data);

/// The index of a series: files by time, which ParaView opens.
[[nodiscard]] std::string vtk_index(const std::vector<std::pair<double, std::string>>& files);

}  // namespace talus
