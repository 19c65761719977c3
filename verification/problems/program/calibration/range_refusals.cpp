#include "verification/problems/program/calibration/range_refusals.hpp"

#include <string>
#include <vector>

namespace talus::verification::problems::calibrated_laws {

void compare_range_refusals(const Program& program, Differences& differ) {
  const Options hertz{{"--law", {"hertz"}}, {"--restitution", {"0.7"}}, {"--modulus", {"1 GPa"}}};
  const Option masses{"--masses", {"1 kg"}}, speeds{"--speeds", {"1 m/s", "2 m/s", "3"}},
      axis{"--masses", {"1 kg", "2 kg", "3"}}, radii{"--radii", {"1 mm", "2 mm", "3"}},
      density{"--density", {"2500 kg/m^3"}}, pairs{"--pairs", {"wrong.csv"}};
  struct Wrong {
    Options options;
    std::string csv, message;
  };
  const std::vector<Wrong> all{
      {{{"--speeds", {"2 m/s", "1 m/s", "3"}}, masses}, "", "found \"2 m/s\" and \"1 m/s\"; the first must be less"},
      {{{"--speeds", {"1 m/s", "2 m/s", "1"}}, masses}, "", "found \"1\"; the count must be a whole number from 2"},
      {{{"--speeds", {"1 m", "2 m/s", "3"}}, masses}, "", "--speeds: found \"1 m\"; that is a length"},
      {{{"--radii", {"0 m", "2 m", "3"}}, density}, "", "--radii: found \"0 m\"; it must be > 0"},
      {{radii}, "", "--density"},
      {{speeds, {"--format", {"svg"}}}, "", "--format requires --out"},
      {{speeds, masses}, "", "--radius: it is missing"},
      {{radii, density, masses}, "", "each pair gives its own; remove them"},
      {{radii, density, {"--radius", {"1 mm"}}}, "", "--radius: each pair gives its own; remove it"},
      {{radii, density, axis}, "", "--masses: found three values, an axis of masses, and --radii; give one of the two"},
      {{pairs, axis},
       "mass_2 [kg],radius [m]\n1,1\n",
       "--masses: found three values, an axis of masses, and --pairs; give one of the two"},
      {{axis, {"--radius", {"1 mm"}}, {"--pivot", {"1 kg m^2", "1 m"}}},
       "",
       "--pivot and --offset: bodies of an axis of masses are hit centrally; remove them"},
      {{{"--masses", {"2 kg", "1 kg", "3"}}, {"--radius", {"1 mm"}}},
       "",
       "--masses: found \"2 kg\" and \"1 kg\"; the first must be less"},
      {{{"--masses", {"1 kg", "2 kg", "3 kg"}}, {"--radius", {"1 mm"}}},
       "",
       "--masses: found \"3 kg\"; the count must be a whole number from 2"},
      {{axis, {"--radius", {"1 mm"}}, {"--bound", {"0"}}}, "", "--bound: found 0; it must be > 0"},
      {{speeds, {"--radius", {"1 mm"}}}, "", "--masses: it is missing"},
      {{pairs}, "mass_2 [kg],sped [m/s]\n1,1\n", "wrong.csv: column 'sped [m/s]': column 'sped' is not known"},
      {{pairs}, "mass_1 [kg],radius [m]\n1,1\n", "wrong.csv: column 'mass_2': it is missing"},
      {{pairs}, "mass_2 [kg],radius [m]\n1,1\n2,-1\n", "wrong.csv:3: column 'radius [m]': found '-1'; it must be > 0"},
      {{pairs}, "mass_2 [kg],radius\n1,1\n", "wrong.csv: column 'radius': found no unit; it must be a length"},
      {{pairs}, "mass_2 [kg],radius [s]\n1,1\n", "column 'radius [s]'"},
      {{pairs}, "mass_2 [kg],mass_2 [g]\n1,1\n", "wrong.csv: column 'mass_2 [g]': it is the second one named mass_2"},
      {{pairs}, "mass_2 [kg],radius [m]\n", "wrong.csv: found no line below the header"},
      {{pairs}, "mass_2 [kg],radius [m]\n1,one\n", "wrong.csv:2: column 'radius [m]': found 'one'"},
      {{masses, {"--radius", {"1 mm"}}, {"--out", {"never"}}}, "", "--out: only a table is written to files"}};
  for (const Wrong& wrong : all) {
    if (!wrong.csv.empty()) program.write("wrong.csv", wrong.csv);
    Options options = hertz;
    options.insert(options.end(), wrong.options.begin(), wrong.options.end());
    const ProgramEnd end = program.end({"calibrate"}, options);
    differ.ended("refusal: " + wrong.message, end, 2, wrong.message);
  }
}

}  // namespace talus::verification::problems::calibrated_laws
