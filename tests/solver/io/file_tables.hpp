#pragma once

#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "solver/base/error.hpp"
#include "solver/io/cell/read_cell.hpp"
#include "solver/io/scene/read_scene.hpp"
#include "tests/solver/io/complete_files.hpp"

/// One table of a complete file.
struct FileTable {
  std::string header;              ///< its header line; empty for the file itself
  std::string path;                ///< "body.shape"; empty for the file itself
  std::string group;               ///< id in the catalogue
  std::vector<std::string> lines;  ///< `key = value`
};

inline std::string key_of(const std::string& line) { return line.substr(0, line.find(" = ")); }
inline std::string value_of(const std::string& line) { return line.substr(line.find(" = ") + 3); }

/// The tables of a complete file, in their order.
inline std::vector<FileTable> tables_of(std::string_view file) {
  std::vector<FileTable> tables;
  std::istringstream in{std::string{file}};
  for (std::string line; std::getline(in, line);) {
    const std::size_t comment = line.find("# ");
    if (comment == std::string::npos) {
      tables.back().lines.push_back(line);
      continue;
    }
    const std::string header = line.substr(0, comment);
    const std::size_t from = header.find_first_not_of('['), to = header.find(']');
    tables.push_back({header, header.empty() ? "" : header.substr(from, to - from), line.substr(comment + 2), {}});
  }
  return tables;
}

/// The text of the tables.
inline std::string file_of(const std::vector<FileTable>& tables) {
  std::string text;
  for (const FileTable& table : tables) {
    text += table.header + "\n";
    for (const std::string& line : table.lines)
      text += line + "\n";
  }
  return text;
}

/// Error message of a file's reader; empty if there is none.
inline std::string errors_of(const std::vector<FileTable>& tables) {
  try {
    if (tables.front().group == "cell file") {
      static_cast<void>(talus::read_cell(file_of(tables), "f.toml", {}));
    } else {
      static_cast<void>(talus::read_scene_file(file_of(tables), "f.toml"));
    }
  } catch (const talus::InputError& error) {
    return error.what();
  }
  return "";
}
