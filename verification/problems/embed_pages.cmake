# Writes the pages of the cases into one C++ source. Usage: cmake -DOUT=FILE.cpp "-DPAGES=A.md;B.md" -P embed_pages.cmake
set(entries "")
foreach(page IN LISTS PAGES)
  get_filename_component(case ${page} NAME_WE)
  file(READ ${page} text)
  string(APPEND entries "  if (name == \"${case}\") return R\"page(\n${text})page\";\n")
endforeach()
file(WRITE ${OUT} "// Generated from the pages of verification/problems.
#include \"verification/problems/pages.hpp\"

#include <stdexcept>
#include <string>

namespace talus::verification::problems {

std::string_view page_of(std::string_view name) {
${entries}  throw std::invalid_argument(\"no page '\" + std::string(name) + \"'\");
}

}  // namespace talus::verification::problems
")
