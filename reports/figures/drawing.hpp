/// Pictures from scripts: gnuplot, one process per script, in parallel.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace talus::reports {

/// A script and its name in messages ("case two_cable").
struct Drawing {
  std::string name;
  std::string script;
};

/// Runs gnuplot on each drawing, at most `jobs` at a time; scripts are stored in `folder`. Returns gnuplot's warnings.
/// Throws OutputError with gnuplot's message when it is absent or rejects a script.
std::string draw(const std::vector<Drawing>& drawings, const std::filesystem::path& folder, unsigned jobs);

/// Sets the creation date in a PDF or PostScript file written by gnuplot to the given time, replacing digits in place;
/// other formats contain none. Cairo writes the current time, but a picture must depend on its numbers only. Throws
/// OutputError if the file does not have cairo's format.
void date_picture(const std::filesystem::path& file, long long epoch_seconds);

}  // namespace talus::reports
