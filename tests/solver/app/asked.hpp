#pragma once

#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "tests/solver/app/program.hpp"

// What the drawing commands leave to talus_report.

/// What the command asks talus_report to draw: its record, kept by a stand-in that draws nothing.
struct Asked {
  Folder folder;
  Ended ended;
  nlohmann::json plot;

  explicit Asked(std::vector<std::string> arguments) {
    fs::copy_file(TALUS_EXECUTABLE, folder.path / "talus");
    const fs::path tool = folder.path / "talus_report";
    std::ofstream{tool} << "#!/bin/sh\ncp -r \"$2\" '" << (folder.path / "record").string() << "'\n";
    fs::permissions(tool, fs::perms::owner_all);
    arguments.insert(arguments.end(), {"--out", (folder.path / "pictures").string()});
    ended = ran((folder.path / "talus").string(), arguments);
    if (ended.code == 0) plot = nlohmann::json::parse(file("plot.json"));
  }
  std::string file(const std::string& name) const { return talus::read_text(folder.path / "record" / name); }
  const nlohmann::json& page() const { return plot.at("pages").at(0); }
};

/// Rows of a record's CSV file by the word in their first column.
inline std::map<std::string, std::vector<std::vector<double>>> rows(const std::string& csv) {
  std::map<std::string, std::vector<std::vector<double>>> made;
  std::istringstream in{csv};
  std::string line;
  std::getline(in, line);
  while (std::getline(in, line)) {
    std::istringstream cells{line};
    std::string word;
    std::getline(cells, word, ',');
    auto& row = made[word].emplace_back();
    for (std::string cell; std::getline(cells, cell, ',');)
      row.push_back(std::stod(cell));
  }
  return made;
}
