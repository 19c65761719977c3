/// Comma-separated numbers with one header row, as the records name them.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace talus::reports {

/// A CSV file as texts; numbers are read when they are asked for.
struct Csv {
  std::filesystem::path file;
  std::vector<std::string> header;
  std::vector<std::vector<std::string>> rows;  ///< each as long as the header

  /// Index of the column of that name; throws RecordError naming file, column and the columns there are.
  [[nodiscard]] std::size_t column(const std::string& name) const;

  /// The number in that cell; throws RecordError (file, line, column) when it is none or not finite.
  [[nodiscard]] double number(std::size_t row, std::size_t column) const;
};

/// Reads the file; throws RecordError when it is absent, empty, or a row has not as many cells as the header.
[[nodiscard]] Csv read_csv(const std::filesystem::path& file);

}  // namespace talus::reports
