/// Pictures from scripts: gnuplot, one process a script, side by side on the cores.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace talus::reports {

/// A script and the words that name it in a message ("case two_cable").
struct Drawing {
  std::string name;
  std::string script;
};

/// Runs gnuplot on each drawing, at most `jobs` at a time; scripts are kept in `folder`. Throws OutputError with
/// gnuplot's own words when it is absent or refuses a script; returns its warnings.
std::string draw(const std::vector<Drawing>& drawings, const std::filesystem::path& folder, unsigned jobs);

/// Sets the creation date in a PDF or PostScript file of gnuplot's to the given time, digits for digits; other pictures
/// hold none. Cairo writes the clock's, and a picture must depend on its numbers only. Throws OutputError when the file
/// is not as cairo writes it.
void date_picture(const std::filesystem::path& file, long long epoch_seconds);

}  // namespace talus::reports
