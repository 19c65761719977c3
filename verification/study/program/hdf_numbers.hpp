#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace talus::verification::problems {

/// A table of an HDF5 file, with its numbers row by row.
struct HdfTable {
  std::string type;               ///< "Float64", "Int64", "UInt8": as VTK names it
  std::vector<std::size_t> size;  ///< rows, or rows and columns
  std::vector<double> numbers;

  [[nodiscard]] std::size_t columns() const { return size.size() > 1 ? size[1] : 1; }
  /// The rows from `begin` on; fewer if there are no more.
  [[nodiscard]] std::vector<double> rows(double begin, double count) const;
};

/// Read by the library, without code of the solver. Throws std::runtime_error.
[[nodiscard]] HdfTable hdf_table(const std::filesystem::path& file, const std::string& path);
/// The numbers of an attribute; of a text, its letters.
[[nodiscard]] std::vector<double> hdf_attribute(const std::filesystem::path& file, const std::string& group,
                                                const std::string& name);

}  // namespace talus::verification::problems
