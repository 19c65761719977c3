#include "verification/study/program/hdf_numbers.hpp"

#include <fmt/format.h>
#include <hdf5.h>

#include <algorithm>
#include <array>
#include <stdexcept>

namespace talus::verification::problems {
namespace {

hid_t checked(hid_t result, const std::string& what) {
  if (result < 0) throw std::runtime_error{fmt::format("{} cannot be read", what)};
  return result;
}

std::string name_of(hid_t type) {
  const std::size_t bits = 8 * H5Tget_size(type);
  if (H5Tget_class(type) == H5T_FLOAT) return fmt::format("Float{}", bits);
  return fmt::format("{}Int{}", H5Tget_sign(type) == H5T_SGN_NONE ? "U" : "", bits);
}

}  // namespace

std::vector<double> HdfTable::rows(double begin, double count) const {
  const std::size_t from = std::min(static_cast<std::size_t>(begin) * columns(), numbers.size()),
                    to = std::min(from + static_cast<std::size_t>(count) * columns(), numbers.size());
  return {numbers.begin() + static_cast<std::ptrdiff_t>(from), numbers.begin() + static_cast<std::ptrdiff_t>(to)};
}

HdfTable hdf_table(const std::filesystem::path& file, const std::string& path) {
  const hid_t id = checked(H5Fopen(file.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), file.string());
  const hid_t set = checked(H5Dopen2(id, path.c_str(), H5P_DEFAULT), path);
  const hid_t space = H5Dget_space(set), type = H5Dget_type(set);
  std::array<hsize_t, 8> size{};
  const int rank = H5Sget_simple_extent_dims(space, size.data(), nullptr);
  HdfTable table{.type = name_of(type), .size = {size.begin(), size.begin() + rank}, .numbers = {}};
  table.numbers.resize(static_cast<std::size_t>(H5Sget_simple_extent_npoints(space)));
  checked(H5Dread(set, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, table.numbers.data()), path);
  H5Tclose(type), H5Sclose(space), H5Dclose(set), H5Fclose(id);
  return table;
}

std::vector<double> hdf_attribute(const std::filesystem::path& file, const std::string& group,
                                  const std::string& name) {
  const hid_t id = checked(H5Fopen(file.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), file.string());
  const hid_t of = checked(H5Aopen_by_name(id, group.c_str(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT), name);
  const hid_t type = H5Aget_type(of), space = H5Aget_space(of);
  std::vector<double> numbers;
  if (H5Tget_class(type) == H5T_STRING) {
    std::string text(H5Tget_size(type), ' ');
    checked(H5Aread(of, type, text.data()), name);
    numbers.assign(text.begin(), text.end());
  } else {
    numbers.resize(static_cast<std::size_t>(H5Sget_simple_extent_npoints(space)));
    checked(H5Aread(of, H5T_NATIVE_DOUBLE, numbers.data()), name);
  }
  H5Sclose(space), H5Tclose(type), H5Aclose(of), H5Fclose(id);
  return numbers;
}

}  // namespace talus::verification::problems
