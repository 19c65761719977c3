#pragma once

#include <unistd.h>

#include <boost/test/unit_test.hpp>
#include <cstddef>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "verification/record/error.hpp"

namespace fs = std::filesystem;

/// A folder for one test, removed at the end.
struct Scratch {
  fs::path path;

  Scratch() {
    std::string name = (fs::temp_directory_path() / "talus_record_XXXXXX").string();
    BOOST_REQUIRE(::mkdtemp(name.data()) != nullptr);
    path = name;
  }
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;
  ~Scratch() { fs::remove_all(path); }

  /// Number of entries.
  std::ptrdiff_t files() const { return std::distance(fs::directory_iterator{path}, fs::directory_iterator{}); }
  /// Writes a file.
  fs::path file(const std::string& name, const std::string& text) const {
    std::ofstream{path / name, std::ios::binary} << text;
    return path / name;
  }
};

/// The message of the RecordError or FileError that `action` throws; empty if it throws none.
template <class Action>
std::string error_message(Action&& action) {
  try {
    action();
  } catch (const talus::records::RecordError& error) {
    return error.what();
  } catch (const talus::records::FileError& error) {
    return error.what();
  }
  return {};
}

inline bool holds(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }
