/// The engineer's sheet of a fence as written by `talus run --sheet`. All in SI; directions and positions are x across
/// the fence, y up, z along it.
#pragma once

#include <array>
#include <cmath>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace talus::reports {

using Triple = std::array<double, 3>;
using Pair = std::array<double, 2>;
inline double size(Triple v) { return std::hypot(v[0], v[1], v[2]); }
inline double size(Pair v) { return std::hypot(v[0], v[1]); }

struct SheetForce {
  double peak{}, peak_time{};
  Triple at_peak{}, impulse{};
};

struct SheetRock {
  std::string name, verdict;
  double passed_time{}, end_energy{};
  Pair end_velocity{};
  double mass{}, approach_energy{};
  Pair approach_velocity{};
  bool touched{}, left{}, turned{};
  double touch_time{}, exit_time{}, exit_energy{}, energy_loss_fraction{}, braking_time{}, travel{};
  Pair exit_velocity{};
};

struct SheetHeight {
  double start{}, extreme{}, extreme_time{}, end{};
};

struct SheetLayer {
  SheetHeight top, bottom;
};

struct SheetColumn {
  std::string name;
  int layer{};
  double along{}, travel{}, travel_time{}, margin{};
  SheetForce hanger;
};

struct SheetSegment {
  std::string name;
  int layer{};
  bool top{};
  double peak{}, peak_time{}, margin{};
};

struct SheetAnchor {
  int layer{};
  Triple position{};
  SheetForce force;
};

struct SheetEvent {
  double time{};
  std::string part, what;
};

/// One line of the energy ledger: the change from start to end, or a loss.
struct SheetEnergy {
  std::string name;
  double value{};
};

/// Positions of all bodies and cables at one time.
struct SheetState {
  struct Body {
    std::string name;
    int layer{};  ///< 0 for a rock
    std::vector<Pair> outline;
  };
  struct Segment {
    int layer{};
    bool top{};
    std::array<Triple, 2> ends{};
  };
  std::string name;
  double time{};
  std::vector<Body> bodies;
  std::vector<Segment> cables;
};

/// Quality of the run.
struct SheetQuality {
  bool usable{};
  std::string flaw;  ///< reason why it is not usable
  std::string step;
  std::optional<double> balance;        ///< energy balance error over the largest energy
  std::optional<double> contact_steps;  ///< number of steps in the shortest contact
  std::optional<std::string> touching;  ///< contact that still acts at the end
  struct Repeat {
    double change{};  ///< relative change of the rocks' speed
    std::string failure, verdict;
    double cable_change{};  ///< relative change of the largest tension
  };
  std::optional<Repeat> repeat;
  struct Repair {
    std::string option, flaw, verdict;
    std::optional<double> balance;
  };
  std::optional<Repair> repair;
};

struct SheetRecord {
  std::string title, outcome, integrator;
  std::string verdict;
  bool us_units{};  ///< units of the scene
  SheetQuality quality;
  double end{}, step{};
  int steps{};
  int layers{}, columns_of_layer{};
  bool half_model{};
  double span{}, sag{}, spacing{}, travel{}, travel_time{};
  std::vector<SheetRock> rocks;
  std::vector<SheetLayer> heights;
  std::vector<SheetColumn> columns;
  std::vector<SheetSegment> segments;
  std::vector<SheetAnchor> anchors;
  std::vector<SheetEvent> events;
  std::vector<SheetEnergy> energies;  ///< empty if the run had no energy ledger
  std::vector<Pair> ground;           ///< ground line, from left to right
  double column_half_width{};
  std::vector<SheetState> states;
  std::vector<std::string> history_columns;
  std::vector<std::vector<double>> history;
};

/// Reads sheet.json. Throws RecordError with file and field.
[[nodiscard]] SheetRecord read_sheet(const std::filesystem::path& file);

}  // namespace talus::reports
