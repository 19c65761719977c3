#include "solver/version/version.hpp"

namespace talus {

std::string version_text(const std::string& program) {
  return program + " " + version_number + "\nrevision " + source_revision + (source_dirty ? ", changed" : "") +
         "\nbuild " + build_type + ", " + build_compiler;
}

}  // namespace talus
