#pragma once

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <filesystem>
#include <pugixml.hpp>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

namespace talus {

/// An array of numbers of a VTK file.
template <class Number>
struct VtkNumbers {
  pugi::xml_node node;
  std::vector<Number> values;

  std::size_t size() const { return values.size(); }
  Number operator[](std::size_t i) const { return values[i]; }
};

/// A VTK XML file, read completely: an index, or poly data of one piece with numbers as text, as vtk_text() writes
/// them. Errors name file, line, section and array.
class VtkFile {
 public:
  /// Errors: IoError; InputError if it is not XML.
  explicit VtkFile(const std::filesystem::path& path);

  /// Throws InputError with file and line of the node.
  [[noreturn]] void report(const pugi::xml_node& node, std::string_view message) const;
  /// An error about an array: "Points: array 'Points': found ...".
  [[noreturn]] void report_array(const pugi::xml_node& array, std::string_view message) const;

  /// Errors: InputError if there is no such element.
  [[nodiscard]] pugi::xml_node part(const char* path) const;
  [[nodiscard]] pugi::xml_node piece() const { return part("VTKFile/PolyData/Piece"); }

  /// The numbers of an array of the piece, e.g. of section "Points" and name "Points". Errors: InputError if it is
  /// missing, or something in it is not a number.
  template <class Number>
  [[nodiscard]] VtkNumbers<Number> array(const char* section, const char* name) const {
    return numbers<Number>(node_of(section, name));
  }
  /// The numbers of an array. Errors: as array().
  template <class Number>
  [[nodiscard]] VtkNumbers<Number> numbers(const pugi::xml_node& array) const {
    const std::string_view text{array.text().get()};
    VtkNumbers<Number> found{array, {}};
    for (std::string_view rest = text;;) {
      rest.remove_prefix(std::min(rest.find_first_not_of(" \n\t\r"), rest.size()));
      if (rest.empty()) return found;
      const std::string_view token = rest.substr(0, rest.find_first_of(" \n\t\r"));
      Number value{};
      const auto [end, failure] = std::from_chars(token.data(), token.data() + token.size(), value);
      if (failure != std::errc{} || end != token.data() + token.size()) report_token(array, text, token);
      found.values.push_back(value);
      rest.remove_prefix(token.size());
    }
  }

  /// Demands a number of values in an array, which follows from another one: "24, one for each point".
  template <class Number>
  void demand_size(const VtkNumbers<Number>& array, std::size_t size, std::string_view reason) const {
    if (array.size() != size) report_size(array.node, array.size(), size, reason);
  }

 private:
  [[nodiscard]] pugi::xml_node node_of(const char* section, const char* name) const;
  /// A token of an array's text is not a number.
  [[noreturn]] void report_token(const pugi::xml_node& array, std::string_view text, std::string_view token) const;
  [[noreturn]] void report_size(const pugi::xml_node& array, std::size_t found, std::size_t size,
                                std::string_view reason) const;
  [[noreturn]] void fail(std::ptrdiff_t line, std::string_view message) const;
  [[nodiscard]] std::ptrdiff_t line_at(std::ptrdiff_t offset) const;

  std::string name_, text_;
  pugi::xml_document document_;
};

}  // namespace talus
