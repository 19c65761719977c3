#include "solver/io/file/vtk_text.hpp"

#include <fmt/format.h>

namespace talus {
namespace {

/// Text escaped for an XML attribute.
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

std::string vtk_text(const PolyData& data) {
  fmt::memory_buffer text;
  const auto append = [&text](std::string_view part) { text.append(part.data(), part.data() + part.size()); };
  const auto add = [&](const VtkArray& array) {
    fmt::format_to(fmt::appender{text},
                   "<DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\" format=\"ascii\">\n", array.type,
                   array.name, array.components);
    append(array.values), append("\n</DataArray>\n");
  };
  const auto add_part = [&](std::string_view name, const std::vector<VtkArray>& arrays) {
    append("<"), append(name), append(">\n");
    for (const VtkArray& array : arrays)
      add(array);
    append("</"), append(name), append(">\n");
  };
  fmt::format_to(fmt::appender{text}, head, "PolyData");
  fmt::format_to(fmt::appender{text},
                 "<PolyData>\n<Piece NumberOfPoints=\"{}\" NumberOfVerts=\"{}\" NumberOfLines=\"{}\" "
                 "NumberOfStrips=\"0\" NumberOfPolys=\"0\">\n",
                 data.points, data.verts, data.lines);
  add_part("PointData", data.point_data);
  add_part("CellData", data.cell_data);
  add_part("Points", {{"Float64", "Points", 3, data.coordinates}});
  if (data.verts > 0) add_part("Verts", data.vert_arrays);
  add_part("Lines", data.line_arrays);
  append("</Piece>\n</PolyData>\n</VTKFile>\n");
  return fmt::to_string(text);
}

std::string vtk_index(const std::vector<std::pair<double, std::string>>& files) {
  std::string text = fmt::format(head, "Collection") + "<Collection>\n";
  for (const auto& [time, name] : files)
    text += fmt::format("<DataSet timestep=\"{}\" part=\"0\" file=\"{}\"/>\n", time, escaped(name));
  return text + "</Collection>\n</VTKFile>\n";
}

}  // namespace talus
