#pragma once

#include <fstream>
#include <string>

#include "tests/solver/app/program.hpp"

/// sample2 run for 50 ms, once in each test program, with histories and geometry at the same times: every 60 steps.
inline const fs::path& sample() {
  static const Folder folder;
  static const bool made = [] {
    std::string deck = talus::read_text(scene("fence/sample2.DAT"));
    std::ofstream{folder.path / "fence.DAT"} << deck;
    const Ended ended = talus_ran({"run", (folder.path / "fence.DAT").string(), "--end", "50 ms", "--frames", "10",
                                   "--out", (folder.path / "run").string()});
    return ended.code == 0;
  }();
  BOOST_REQUIRE(made);
  static const fs::path run = folder.path / "run";
  return run;
}
