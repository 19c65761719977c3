#pragma once

#include <vector>

#include "solver/dynamics/candidates.hpp"
#include "solver/dynamics/lanes.hpp"
#include "solver/geometry/gap.hpp"
#include "solver/laws/kinematics.hpp"
#include "solver/state/mode.hpp"

namespace talus {

/// The active part of a scene: bodies that are awake and the cables attached to them.
struct ActiveSet {
  std::vector<Mode> modes;  ///< sleep modes of the state for which the lists are valid
  bool complete{true};      ///< all paths and poses are evaluated, because the modes have just changed; once such an
                            ///< evaluation has reached its loads, the next may omit sleepers
  std::vector<char> awake;  ///< one for each body
  bool any_asleep{};        ///< true if some body sleeps
  std::size_t moving{};     ///< number of coordinates up to the last of an awake body
  std::size_t reached_bodies{};  ///< number of bodies up to the last that is computed or at the end of a computed cable
  std::vector<BodySpan> bodies;  ///< the awake free bodies
  std::vector<JointSpan> joints;               ///< joints to compute
  std::vector<std::vector<CableSpan>> cables;  ///< for each law, cables to compute
  std::vector<std::vector<CableSpan>> lines;   ///< for each law, those in rows, consecutive rows in one span
  bool rows_only{};                            ///< all these cables are in rows, in the order of their joints
  bool on_linear_branch{};           ///< in the last evaluation all these cables were on their linear branches, and
                                     ///< Workspace::pulls are their forces
  std::vector<std::size_t> borders;  ///< those of the cables with a sleeping body at one end only
};

/// Cables that continue as one through broken hangers: straight from the first joint to the last, with one tension.
struct Chain {
  /// Support of the first joint.
  enum class Start {
    held,      ///< a body or an anchor
    mirrored,  ///< the mirror image of the chain behind a symmetry plane of the scene: it runs straight along the fence
    free,      ///< none: its hanger broke and no other cable ended there
  };
  Start start{Start::held};
  bool carries{true};               ///< has tension, in the last evaluation: false with a free start or a broken cable
  std::vector<std::size_t> joints;  ///< one more than cables; all but the ends are broken hangers
  std::vector<std::size_t> cables;
};

/// Connections of the cables, given the broken hangers.
struct HangerTopology {
  std::vector<Mode> modes;               ///< modes of the hangers for which the rest is valid
  std::vector<char> broken;              ///< one for each joint: detached from its body
  std::vector<std::size_t> free_joints;  ///< the detached joints
  std::vector<Chain> chains;
};

/// Stage that the evaluation of a state has reached; each includes those before it. (Modes belong to the state:
/// update_modes() updates them to the geometry.)
enum class Evaluated : unsigned char {
  nothing,   ///< valid for no state
  geometry,  ///< poses, velocities, joints, paths and gaps
  forces,    ///< the normal forces of the contacts within reach, in the state's modes
  loads,     ///< the wrenches of the bodies
};

/// Results required of an evaluation. If only the rates are required, with or without the ledger, joints (except for
/// their forces) and paths of rows of cables may remain out of date and, as long as no pair is near, the velocities of
/// free bodies, too.
enum class Need { everything, rates };

/// Scratch memory of force evaluations. The caller owns it, so that Dynamics stays pure and a step of a scene with
/// neither broken hangers nor many bodies does not allocate.
struct Workspace {
  Evaluated evaluated{Evaluated::nothing};
  bool pulled{};                        ///< the cable forces are already in the wrenches; see Need::rates
  Poses poses;                          ///< one for each body
  Wrenches wrenches;                    ///< one for each body
  Wrenches pulls;                       ///< forces of rows of cables alone
  JointPoints joints;                   ///< one for each joint
  Paths paths;                          ///< one for each cable
  CableLinearization lines;             ///< one for each cable
  std::vector<Gap> gaps;                ///< one for each law instance of the contacts; valid where its pair is near
  std::vector<double> rates;            ///< their overlap rates [L/T]
  std::vector<LawForce> normal_forces;  ///< of the instances that act [F]
  ActiveSet active;
  HangerTopology topology;
  Sweep sweep;  ///< of the contact search
  /// Values of `near`, the state of the gaps of a pair of the contact search.
  static constexpr char wanted = 1;  ///< the gaps are computed in this evaluation
  static constexpr char known = 2;   ///< the gaps have been computed
  std::vector<char> near;            ///< one for each pair; 0: no gaps, out of reach
  bool any_near{};                   ///< some pair has gaps

  /// True if the geometry of the active set is known, including joints, paths and velocities.
  bool has_geometry() const { return evaluated >= Evaluated::geometry && !pulled; }
};

}  // namespace talus
