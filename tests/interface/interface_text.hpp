/// Items of the program's interface in the files that it reads and writes, and small changes of one of them: what a bug
/// that ignores a field or writes a wrong column would do.
#pragma once

#include <filesystem>
#include <optional>
#include <set>
#include <string>

namespace talus::interface_audit {

/// Factor by which a changed number is wrong; a zero becomes 0.01.
inline constexpr double factor = 1.01;

/// Items of a file, from its name and text:
///   "field contact.stiffness"        a value of a TOML file; an element of a list as "body.position.1"
///   "column profile.csv: depth [m]"  a column of a CSV file, with its unit
///   "column history.csv: *.x [m]"    those of all bodies, contacts and cables in a history: the last one is changed
///   "member summary.json: steps"     a member of a JSON file; elements of lists as "bodies[].name"
///   "array *.vtp: velocity"          a data array of a VTK file
/// Names of files are shortened to what follows the scene's name: "*.history.csv". Other files have none, and so does a
/// text that cannot be read.
[[nodiscard]] std::set<std::string> items_of(const std::filesystem::path& file, const std::string& text);

/// The text with that item changed: numbers by `factor` (whole ones by 1), flags inverted; a text of a TOML file is
/// removed with its key or from its list, one of a JSON file gets a letter more. Empty if the file has no such item, or
/// nothing in it that can change (an empty list, a column of words).
[[nodiscard]] std::optional<std::string> changed(const std::filesystem::path& file, const std::string& text,
                                                 const std::string& item);

/// The JSON, CSV or VTK file read and written without a change, in the form in which changed() writes it.
[[nodiscard]] std::optional<std::string> rewritten(const std::filesystem::path& file, const std::string& text);

}  // namespace talus::interface_audit
