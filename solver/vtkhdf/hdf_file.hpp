#pragma once

#include <hdf5.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace talus {

/// Types of the numbers in a file, all little-endian.
enum class HdfType { float64, int64, int32, uint8 };

/// A new HDF5 file of groups, attributes, and tables to which rows are appended. It is made in memory: the library of
/// HDF5 1.10 ends the process by a signal if the disk is full. This takes twice its size. It appears complete, or not
/// at all, when it is closed.
/// The same calls give the same bytes: no times are stored. Errors of all functions: IoError with the file.
class HdfFile {
 public:
  explicit HdfFile(std::filesystem::path file);
  HdfFile(const HdfFile&) = delete;
  HdfFile& operator=(const HdfFile&) = delete;
  ~HdfFile();

  /// Creates a group, "/a/b", in one that exists.
  void group(const std::string& path);
  /// Attributes of a group that exists. A text has no terminating zero.
  void attribute(const std::string& group, const std::string& name, const std::string& text);
  void attribute(const std::string& group, const std::string& name, const std::vector<std::int64_t>& numbers);

  /// Appends rows to a table, which the first call creates: all numbers, row by row. A table of one column has one
  /// dimension, of 0 columns is refused. Later calls need the same columns and type.
  void append(const std::string& path, const std::vector<double>& numbers, std::size_t columns = 1);
  void append(const std::string& path, HdfType type, const std::vector<std::int64_t>& numbers, std::size_t columns = 1);

  /// Writes the file. Errors: IoError with the system's reason; the file then has its previous content.
  void close();

 private:
  struct Table {
    hid_t set{H5I_INVALID_HID};
    hsize_t rows{}, columns{};
  };
  Table& table(const std::string& path, HdfType type, std::size_t columns, std::size_t rows);
  void write(const std::string& path, HdfType type, hid_t memory_type, const void* numbers, std::size_t count,
             std::size_t columns);
  void close_handles();
  [[noreturn]] void fail() const;
  hid_t checked(hid_t result) const;

  std::filesystem::path file_;
  hid_t id_{H5I_INVALID_HID};
  std::map<std::string, Table> tables_;
};

}  // namespace talus
