#include "solver/vtkhdf/hdf_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "solver/base/error.hpp"
#include "solver/io/file/atomic_file.hpp"

namespace talus {
namespace {

namespace fs = std::filesystem;

hid_t stored(HdfType type) {
  switch (type) {
    case HdfType::float64:
      return H5T_IEEE_F64LE;
    case HdfType::int64:
      return H5T_STD_I64LE;
    case HdfType::int32:
      return H5T_STD_I32LE;
    case HdfType::uint8:
      return H5T_STD_U8LE;
  }
  return H5I_INVALID_HID;
}

/// Size of a chunk of rows: some 64 KiB of numbers, and at least the first rows if these are fewer.
hsize_t chunk_rows(std::size_t rows, std::size_t columns) {
  const std::size_t largest = std::max<std::size_t>(8192 / columns, 1);
  return std::clamp<hsize_t>(rows, std::min<std::size_t>(64, largest), largest);
}

}  // namespace

HdfFile::HdfFile(fs::path file) : file_{std::move(file)} {
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);  // errors are thrown, not printed
  const hid_t creation = H5Pcreate(H5P_FILE_CREATE), access = H5Pcreate(H5P_FILE_ACCESS);
  H5Pset_obj_track_times(creation, false);
  constexpr std::size_t increment = 1 << 20;
  H5Pset_fapl_core(access, increment, false);
  // A name that no file has: the library reads one that exists.
  id_ = H5Fcreate((file_ / "memory").c_str(), H5F_ACC_TRUNC, creation, access);
  H5Pclose(creation), H5Pclose(access);
  if (id_ < 0) fail();
}

HdfFile::~HdfFile() {
  if (id_ != H5I_INVALID_HID) close_handles();
}

void HdfFile::fail() const { throw IoError{fmt::format("{}: HDF5 cannot make the file", file_.string())}; }

hid_t HdfFile::checked(hid_t result) const {
  if (result < 0) fail();
  return result;
}

void HdfFile::group(const std::string& path) {
  const hid_t creation = H5Pcreate(H5P_GROUP_CREATE);
  H5Pset_obj_track_times(creation, false);
  const hid_t made = H5Gcreate2(id_, path.c_str(), H5P_DEFAULT, creation, H5P_DEFAULT);
  H5Pclose(creation);
  H5Gclose(checked(made));
}

void HdfFile::attribute(const std::string& group, const std::string& name, const std::string& text) {
  const hid_t type = H5Tcopy(H5T_C_S1), space = H5Screate(H5S_SCALAR);
  H5Tset_size(type, text.size());
  H5Tset_strpad(type, H5T_STR_NULLPAD);
  const hid_t made =
      H5Acreate_by_name(id_, group.c_str(), name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
  const bool is_written = made >= 0 && H5Awrite(made, type, text.data()) >= 0;
  if (made >= 0) H5Aclose(made);
  H5Sclose(space), H5Tclose(type);
  if (!is_written) fail();
}

void HdfFile::attribute(const std::string& group, const std::string& name, const std::vector<std::int64_t>& numbers) {
  const hsize_t size = numbers.size();
  const hid_t space = size == 1 ? H5Screate(H5S_SCALAR) : H5Screate_simple(1, &size, nullptr);
  const hid_t made =
      H5Acreate_by_name(id_, group.c_str(), name.c_str(), H5T_STD_I64LE, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
  const bool is_written = made >= 0 && H5Awrite(made, H5T_NATIVE_INT64, numbers.data()) >= 0;
  if (made >= 0) H5Aclose(made);
  H5Sclose(space);
  if (!is_written) fail();
}

HdfFile::Table& HdfFile::table(const std::string& path, HdfType type, std::size_t columns, std::size_t rows) {
  const auto found = tables_.find(path);
  if (found != tables_.end()) return found->second;
  const int rank = columns == 1 ? 1 : 2;
  const std::array<hsize_t, 2> none{0, columns}, unlimited{H5S_UNLIMITED, columns},
      chunk{chunk_rows(rows, columns), columns};
  const hid_t space = H5Screate_simple(rank, none.data(), unlimited.data()), creation = H5Pcreate(H5P_DATASET_CREATE);
  H5Pset_chunk(creation, rank, chunk.data());
  H5Pset_deflate(creation, 4);
  H5Pset_obj_track_times(creation, false);
  const hid_t set = H5Dcreate2(id_, path.c_str(), stored(type), space, H5P_DEFAULT, creation, H5P_DEFAULT);
  H5Pclose(creation), H5Sclose(space);
  return tables_.emplace(path, Table{checked(set), 0, columns}).first->second;
}

void HdfFile::write(const std::string& path, HdfType type, hid_t memory_type, const void* numbers, std::size_t count,
                    std::size_t columns) {
  if (columns == 0 || count % columns != 0) fail();
  Table& to = table(path, type, columns, count / columns);
  if (to.columns != columns) fail();
  if (count == 0) return;
  const int rank = columns == 1 ? 1 : 2;
  const std::array<hsize_t, 2> begin{to.rows, 0}, size{count / columns, columns};
  to.rows += size[0];
  const std::array<hsize_t, 2> all{to.rows, columns};
  if (H5Dset_extent(to.set, all.data()) < 0) fail();
  const hid_t here = H5Dget_space(to.set), there = H5Screate_simple(rank, size.data(), nullptr);
  H5Sselect_hyperslab(here, H5S_SELECT_SET, begin.data(), nullptr, size.data(), nullptr);
  const herr_t written = H5Dwrite(to.set, memory_type, there, here, H5P_DEFAULT, numbers);
  H5Sclose(here), H5Sclose(there);
  if (written < 0) fail();
}

void HdfFile::append(const std::string& path, const std::vector<double>& numbers, std::size_t columns) {
  write(path, HdfType::float64, H5T_NATIVE_DOUBLE, numbers.data(), numbers.size(), columns);
}

void HdfFile::append(const std::string& path, HdfType type, const std::vector<std::int64_t>& numbers,
                     std::size_t columns) {
  write(path, type, H5T_NATIVE_INT64, numbers.data(), numbers.size(), columns);
}

void HdfFile::close_handles() {
  for (auto& [path, table] : tables_)
    H5Dclose(table.set);
  tables_.clear();
  H5Fclose(std::exchange(id_, H5I_INVALID_HID));
}

void HdfFile::close() {
  if (H5Fflush(id_, H5F_SCOPE_LOCAL) < 0) fail();
  const ssize_t size = H5Fget_file_image(id_, nullptr, 0);
  if (size < 0) fail();
  std::string image(static_cast<std::size_t>(size), '\0');
  if (H5Fget_file_image(id_, image.data(), image.size()) < 0) fail();
  close_handles();
  write_whole(file_, image);
}

}  // namespace talus
