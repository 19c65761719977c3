#include "verification/driver/provenance.hpp"

#include <fmt/format.h>
#include <sched.h>
#include <sys/utsname.h>

#include <cstdlib>
#include <ctime>
#include <fstream>

#include "solver/version/version.hpp"
#include "verification/driver/build_facts.hpp"

namespace talus::verification {

namespace {

/// The value on the first line of `file` that starts with `key`, without separators and quotes.
std::string value_in(const std::string& file, const std::string& key) {
  std::ifstream in(file);
  for (std::string line; std::getline(in, line);) {
    if (line.rfind(key, 0) != 0) continue;
    const auto first = line.find_first_not_of("\t :=\"", key.size());
    if (first == std::string::npos) continue;
    return line.substr(first, line.find_last_not_of(" \"") + 1 - first);
  }
  return "unknown";
}

std::string operating_system() {
  utsname kernel{};
  ::uname(&kernel);
  return fmt::format("{}, {} {} {}", value_in("/etc/os-release", "PRETTY_NAME"), kernel.sysname, kernel.release,
                     kernel.machine);
}

unsigned usable_cores() {
  cpu_set_t set;
  CPU_ZERO(&set);
  if (::sched_getaffinity(0, sizeof set, &set) != 0) return 1;
  return static_cast<unsigned>(CPU_COUNT(&set));
}

std::string date() {
  std::time_t seconds = std::time(nullptr);
  const char* const epoch = std::getenv("SOURCE_DATE_EPOCH");
  char* end = nullptr;
  const long long given = epoch == nullptr ? 0 : std::strtoll(epoch, &end, 10);
  if (epoch != nullptr && end != epoch && *end == '\0') seconds = static_cast<std::time_t>(given);
  std::tm utc{};
  ::gmtime_r(&seconds, &utc);
  char text[32];
  std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", &utc);
  return text;
}

}  // namespace

Provenance provenance() {
  return {source_revision, source_dirty,       build_compiler,
          build_flags,     build_type,         value_in("/proc/cpuinfo", "model name"),
          usable_cores(),  operating_system(), build_libraries,
          date()};
}

std::string machine_text() {
  return fmt::format("{}, {}, {}", value_in("/proc/cpuinfo", "model name"), build_compiler, build_flags);
}

}  // namespace talus::verification
