#include "solver/io/file/vtk_file.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "solver/base/error.hpp"
#include "solver/io/file/atomic_file.hpp"
#include "solver/io/file/toml_document.hpp"
#include "verification/record/utf8.hpp"

namespace talus {
namespace {

std::string array_message(const pugi::xml_node& array, std::string_view message) {
  return fmt::format("{}: array '{}': {}", array.parent().name(), array.attribute("Name").value(), message);
}

}  // namespace

VtkFile::VtkFile(const std::filesystem::path& path) : name_{path.string()}, text_{read_text(path)} {
  const pugi::xml_parse_result result = document_.load_buffer(text_.data(), text_.size());
  if (result) return;
  fail(line_at(result.offset), fmt::format("not XML: {}", result.description()));
}

void VtkFile::report(const pugi::xml_node& node, std::string_view message) const {
  fail(line_at(node.offset_debug()), message);
}

void VtkFile::report_array(const pugi::xml_node& array, std::string_view message) const {
  report(array, array_message(array, message));
}

pugi::xml_node VtkFile::part(const char* path) const {
  const pugi::xml_node found = document_.first_element_by_path(path);
  if (!found) report(document_.document_element(), fmt::format("{}: it is missing; `talus run` writes it", path));
  return found;
}

pugi::xml_node VtkFile::node_of(const char* section, const char* name) const {
  const pugi::xml_node of = piece();
  const pugi::xml_node found = of.child(section).find_child_by_attribute("DataArray", "Name", name);
  if (!found) report(of, fmt::format("{}: array '{}': it is missing; `talus run` writes it", section, name));
  return found;
}

void VtkFile::report_token(const pugi::xml_node& array, std::string_view text, std::string_view token) const {
  const auto lines = std::count(text.data(), token.data(), '\n');
  fail(
      line_at(array.first_child().offset_debug()) + lines,
      array_message(array, fmt::format("found \"{}\"; it must be a number", records::shown_text(token.substr(0, 20)))));
}

void VtkFile::report_size(const pugi::xml_node& array, std::size_t found, std::size_t size,
                          std::string_view reason) const {
  report_array(array, fmt::format("found {} numbers; it must have {}, {}", found, size, reason));
}

void VtkFile::fail(std::ptrdiff_t line, std::string_view message) const {
  throw InputError{fmt::format("{}:{}: {}", name_, line, message)};
}

std::ptrdiff_t VtkFile::line_at(std::ptrdiff_t offset) const {
  const auto size = static_cast<std::ptrdiff_t>(text_.size());
  return 1 + std::count(text_.begin(), text_.begin() + std::clamp<std::ptrdiff_t>(offset, 0, size), '\n');
}

}  // namespace talus
