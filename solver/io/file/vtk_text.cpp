#include "solver/io/file/vtk_text.hpp"

#include <fmt/format.h>

namespace talus {
namespace {

/// Text as it may stand in an attribute of XML.
std::string escaped(std::string_view text) {
  std::string made;
  for (const char c : text) {
    if (c == '&' || c == '<' || c == '"') {
      made += c == '&' ? "&amp;" : c == '<' ? "&lt;" : "&quot;";
    } else {
      made += c;
    }
  }
  return made;
}

constexpr std::string_view head =
    "<?xml version=\"1.0\"?>\n<VTKFile type=\"{}\" version=\"0.1\" "
    "byte_order=\"LittleEndian\">\n";

}  // namespace

std::string vtk_array(std::string_view type, std::string_view name, int components, std::string_view values) {
  return fmt::format(
      "<DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\" format=\"ascii\">\n{}\n</DataArray>\n", type, name,
      components, values);
}

std::string vtk_text(const PolyData& data) {
  std::string text = fmt::format(head, "PolyData");
  text += fmt::format(
      "<PolyData>\n<Piece NumberOfPoints=\"{}\" NumberOfVerts=\"{}\" NumberOfLines=\"{}\" "
      "NumberOfStrips=\"0\" NumberOfPolys=\"0\">\n",
      data.points, data.verts, data.lines);
  text += "<PointData>\n" + data.point_data + "</PointData>\n<CellData>\n" + data.cell_data +
          "</CellData>\n<Points>\n" + vtk_array("Float64", "Points", 3, data.coordinates) + "</Points>\n";
  if (data.verts > 0) text += "<Verts>\n" + data.vert_arrays + "</Verts>\n";
  return text + "<Lines>\n" + data.line_arrays + "</Lines>\n</Piece>\n</PolyData>\n</VTKFile>\n";
}

std::string vtk_index(const std::vector<std::pair<double, std::string>>& files) {
  std::string text = fmt::format(head, "Collection") + "<Collection>\n";
  for (const auto& [time, name] : files)
    text += fmt::format("<DataSet timestep=\"{}\" part=\"0\" file=\"{}\"/>\n", time, escaped(name));
  return text + "</Collection>\n</VTKFile>\n";
}

}  // namespace talus
