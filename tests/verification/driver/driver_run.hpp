#pragma once

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/temporary_folder.hpp"
#include "verification/check/case.hpp"
#include "verification/driver/command.hpp"

namespace talus::verification {

/// Folder of a case that damages its own record; set before the case's process is started.
inline std::string spoiled_folder;

/// Runs the driver in a separate folder and stores its output.
struct Run {
  Folder folder;
  std::filesystem::path out = folder.path;
  int status = -1;
  nlohmann::json results;

  explicit Run(const std::vector<Case>& cases, std::vector<std::string> options = {}) {
    spoiled_folder = out.string();
    options.insert(options.begin(), {"talus_verify", "--out", out.string()});
    std::vector<const char*> argv;
    for (const auto& option : options)
      argv.push_back(option.c_str());
    status = verify(cases, TALUS_CATALOGUE, static_cast<int>(argv.size()), argv.data());
    if (std::filesystem::exists(out / "results.json"))
      results = nlohmann::json::parse(std::ifstream(out / "results.json"));
  }

  nlohmann::json record(std::size_t i = 0) const { return results.at("cases").at(i); }
  bool says(const std::string& expected, std::size_t i = 0) const {
    return record(i).at("message").get<std::string>().find(expected) != std::string::npos;
  }
};

}  // namespace talus::verification
