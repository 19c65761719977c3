#include "solver/app/calibration/calibrate_options.hpp"

#include <algorithm>

#include "solver/base/error.hpp"

namespace talus::app {

double demanded_restitution(const CalibrateOptions& options) {
  if (!options.restitution) throw InputError{"--restitution: it is missing; give e.g. --restitution 0.7"};
  return *options.restitution;
}

void demand_masses(const CalibrateOptions& options) {
  if (options.masses.empty())
    throw InputError{"--masses: it is missing; give one or two, e.g. --masses \"2 kg\" \"1 kg\""};
}

std::string option_name(std::string_view field) {
  std::string name = "--" + std::string{field};
  std::replace(name.begin(), name.end(), '_', '-');
  return name;
}

}  // namespace talus::app
