#pragma once

#include <vector>

#include "solver/dynamics/candidates.hpp"
#include "solver/dynamics/lanes.hpp"
#include "solver/geometry/gap.hpp"
#include "solver/laws/kinematics.hpp"
#include "solver/state/mode.hpp"

namespace talus {

/// What of a scene an evaluation computes: all but sleeping bodies and the cables between them.
struct ActiveSet {
  std::vector<Mode> modes;  ///< sleep modes of the state that the lists stand for
  bool complete{true};      ///< all paths and poses are evaluated, because the modes have just changed; once such an
                            ///< evaluation has reached its loads, the next may leave out sleepers
  std::vector<char> awake;  ///< one for each body
  bool any_asleep{};        ///< whether one of them is not
  std::size_t moving{};     ///< coordinates before the last sleepers, behind whom none is awake
  std::size_t reached_bodies{};   ///< bodies up to the last that is computed, or at the other end of a cable that is
  std::vector<BodySpan> bodies;   ///< the awake free bodies
  std::vector<JointSpan> joints;  ///< joints to compute
  std::vector<std::vector<CableSpan>> cables;  ///< for each law, cables to compute
  bool rows_only{};                            ///< all these cables are in rows, in the order of their joints
  bool
      on_linear_branch{};  ///< as last laid, all of them stay on their straight lines: Workspace::pulls are what they pull
  std::vector<std::size_t> borders;  ///< of these, the ones with a sleeping body at one end only
};

/// Cables that go on as one through broken hangers: straight from the first joint to the last, with one tension.
struct Chain {
  /// What holds the first joint.
  enum class Start {
    held,      ///< a body or an anchor
    mirrored,  ///< the chain's own image behind a plane of symmetry of the scene: it runs straight along the fence
    free,      ///< nothing: its hanger broke and no other cable ended there
  };
  Start start{Start::held};
  bool carries{true};               ///< as it was last laid straight: false with a broken cable in it
  std::vector<std::size_t> joints;  ///< one more than cables; all but the ends are broken hangers
  std::vector<std::size_t> cables;
};

/// How the cables run, by the hangers that are broken.
struct HangerTopology {
  std::vector<Mode> modes;               ///< of the hangers, for which the rest stands
  std::vector<char> broken;              ///< one for each joint: no longer on its body
  std::vector<std::size_t> free_joints;  ///< these joints
  std::vector<Chain> chains;
};

/// The stage that the evaluation of a state has reached; each has what those before it have. (Modes are of the state:
/// update_modes() brings them up to the geometry.)
enum class Evaluated : unsigned char {
  nothing,   ///< of no state
  geometry,  ///< poses, velocities, joints, paths and gaps
  forces,    ///< the normal forces of the contacts within reach, in the state's modes
  loads,     ///< the wrenches of the bodies
};

/// What is needed of an evaluation. Of rates alone: joints and paths of rows of cables may be left as they were, and, as
/// long as no pair is near, the velocities of free bodies.
enum class Need { everything, rates };

/// Scratch of one force evaluation, kept by the caller so that Dynamics stays pure and a step of a scene with neither
/// broken hangers nor many bodies allocates nothing.
struct Workspace {
  Evaluated evaluated{Evaluated::nothing};
  bool pulled{};                        ///< for rates alone: what the cables pull is in the wrenches already; see Need
  Poses poses;                          ///< one for each body
  Wrenches wrenches;                    ///< one for each body
  Wrenches pulls;                       ///< of rows of cables alone
  JointPoints joints;                   ///< one for each joint
  Paths paths;                          ///< one for each cable
  CableLinearization lines;             ///< one for each cable
  std::vector<Gap> gaps;                ///< one for each law instance of the contacts that is near
  std::vector<double> rates;            ///< their depth rates [L/T]
  std::vector<LawForce> normal_forces;  ///< of those that act [F]
  ActiveSet active;
  HangerTopology topology;
  Sweep sweep;  ///< of the contact search
  /// What is said of a pair of the contact search.
  static constexpr char wanted = 1;  ///< its gaps are computed with this evaluation
  static constexpr char known = 2;   ///< they have been
  std::vector<char> near;            ///< one for each pair; 0: it has none, out of reach
  bool any_near{};                   ///< some pair has any

  /// Whether the geometry of what is awake is known, with joints, paths and velocities.
  bool has_geometry() const { return evaluated >= Evaluated::geometry && !pulled; }
};

}  // namespace talus
