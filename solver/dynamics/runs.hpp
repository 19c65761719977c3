/// What is worked out for neighbouring joints and cables several at a time: the arithmetic of CableForces. A bare
/// pointer is to the number of the run's first joint or cable, those of the others behind it.
#pragma once

#include "solver/dynamics/lanes.hpp"

namespace talus {

/// Poses of neighbouring free bodies from their coordinates q and rates v, three for each body.
void place_bodies(const BodyRun& run, const double* q, const double* v, Poses& poses);

/// Joints on neighbouring bodies, from the bodies' poses; p_x, p_y in body coordinates [L].
void place_joints(const JointRun& run, const double* p_x, const double* p_y, const Poses& poses, JointPoints& joints);

/// The lines of cables between neighbouring joints; across_squared: of the distance along the fence [L^2].
void lay_paths(const CableRun& run, const double* across_squared, const JointPoints& joints, Paths& paths);

/// The same, with the tensions on the straight lines of the cables' modes; whether all stay on them.
bool pull_straight(const CableRun& run, const double* across_squared, const double* rest_length,
                   const CableLines& lines, const JointPoints& joints, Paths& paths);

/// Whether, after pull_straight(), all of them stay on their lines for the time ahead [T] at the rates they have.
bool stays_straight(const CableRun& run, const double* rest_length, const CableLines& lines, const Paths& paths,
                    double ahead);

/// Adds the tensions of neighbouring cables, times the share of each end, to the joints at both ends.
void sum_pulls(const CableRun& run, const double* share_a, const double* share_b, const Paths& paths,
               JointPoints& joints);

/// Adds the pulls at joints to the wrenches of the neighbouring bodies that they are on.
void load_bodies(const JointRun& run, const JointPoints& joints, Wrenches& wrenches);

}  // namespace talus
