#pragma once

#include <array>
#include <string>
#include <vector>

#include "verification/problems/program/agreement/agreeing_scenes.hpp"
#include "verification/problems/program/agreement/compared_files.hpp"
#include "verification/record/json_node.hpp"
#include "verification/study/program/program_run.hpp"

/// What the files of a run must contain, from the scene, the rows of history.csv, and what the program prints.
namespace talus::verification::problems::agreeing_files {

using records::Json;
using Vector = std::array<double, 3>;

/// A run with its files.
struct Run {
  Facts facts;
  std::string printed, messages;
  Json summary, state, plot;
  Columns history;
  std::vector<GeometryState> states;

  [[nodiscard]] std::size_t rows() const { return history.rows(); }
  [[nodiscard]] double time(std::size_t row) const { return history.values[0][row]; }
  /// A column of a body, or what the scene says if it has none.
  [[nodiscard]] double of(const Part& body, const char* quantity, std::size_t row, double otherwise) const {
    const std::string name = body.name + quantity;
    return history.has(name) ? history.at(name)[row] : otherwise;
  }
  /// Position in the world of a point in a body's axes.
  [[nodiscard]] Vector position(const Part& body, double u, double v, std::size_t row) const {
    const double turned = of(body, ".angle", row, body.angle), c = std::cos(turned), s = std::sin(turned);
    return {of(body, ".x", row, body.x) + c * u - s * v, of(body, ".y", row, body.y) + s * u + c * v, body.along};
  }
  [[nodiscard]] Vector position(const End& end, std::size_t row) const {
    if (end.body < 0) return {end.x, end.y, end.along};
    return position(facts.bodies[static_cast<std::size_t>(end.body)], end.x, end.y, row);
  }
  [[nodiscard]] const Part& body(const std::string& name) const {
    return *std::ranges::find_if(facts.bodies, [&](const Part& part) { return part.name == name; });
  }
};

[[nodiscard]] Vector between(const Vector& a, const Vector& b);
[[nodiscard]] double size(const Vector& v);

/// Runs the scene with its files in a folder of its name. The cables' stiffness and rest length, where the scene gives
/// them by Young's modulus, follow from the distance of their ends at the start, and the step of 1993 from the
/// stiffness of the first cable: a hundredth of the period of a column between two of them. Throws std::runtime_error
/// with the program's messages if its exit status is another.
[[nodiscard]] Run run_of(const TemporaryFolder& folder, Facts facts, const std::vector<std::string>& more,
                         int exit_code = 0);

/// The text if the program printed it on a line after `before`; else a text that differs.
[[nodiscard]] Json as_printed(const std::string& text, const std::string& before, const std::string& lines);
/// The integer that the program printed after a text; -1 if it did not.
[[nodiscard]] long printed_number(const std::string& lines, const std::string& before);

/// Names of the columns of the energy balance, without "energy.", "dissipated.".
[[nodiscard]] const std::vector<std::string>& energies();
[[nodiscard]] const std::vector<std::string>& mechanisms();

[[nodiscard]] std::vector<std::string> expected_columns(const Facts& facts);
/// The unit of a column, by what its name ends or begins with.
[[nodiscard]] std::string unit_of(const std::string& name, const Units& units);

/// Sum of the columns OF.PART in a row.
[[nodiscard]] double total(const Run& run, const std::string& of, const std::vector<std::string>& parts,
                           std::size_t row);
/// Largest kinetic energy, or change of another energy, over the rows.
[[nodiscard]] double energy_scale(const Run& run);

/// Largest error of the energy balance over the rows, relative to energy_scale().
[[nodiscard]] double relative_balance_error(const Run& run);
/// The last contact of `quality`: any of those that act in the last row with a contact, at its time; or at the end of
/// that contact, in the row after it. null without a contact.
[[nodiscard]] Json last_contact_of(const Run& run);

/// Momentum, angular momentum about the origin, kinetic energy and weight, from the bodies' motion.
struct Sums {
  double x{}, y{}, angular{}, kinetic{}, gravity{};
  double momentum_scale{}, angular_scale{}, gravity_scale{};
};
[[nodiscard]] Sums sums_of(const Run& run, std::size_t row);

/// Elongation at which a cable breaks by its strength.
[[nodiscard]] double elongation_at_break(const Cable& cable);

/// The outline of a body in its axes: 96 points of a circle and the first again, corners of a box and the first again,
/// the ends of a plane.
[[nodiscard]] std::vector<std::array<double, 2>> outline_of(const Part& body, double reach);

/// summary.json without what only fences have.
[[nodiscard]] Json expected_summary(const Run& run);
[[nodiscard]] Json expected_final_state(const Run& run);
/// plot.json: one figure for each kind of column, without curves that are zero throughout.
[[nodiscard]] Json expected_plot(const Run& run);

}  // namespace talus::verification::problems::agreeing_files
