#pragma once

#include <filesystem>
#include <string>

#include "tests/temporary_folder.hpp"
#include "verification/record/error.hpp"

namespace fs = std::filesystem;

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
