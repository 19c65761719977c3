#pragma once

#include "verification/study/program/program_run.hpp"

/// Interrupted runs that warn, that locate events, and of a fence, and a run into its folder; part of `run_files`.
namespace talus::verification::problems::run_files {

/// 0 if the summary of an interrupted run, including its warnings, is that of an uninterrupted one; otherwise 1. The
/// balance error is largest before the interruption, and the discs overlap before and after it.
[[nodiscard]] double different_warnings(const TemporaryFolder& folder);

/// 0 if the summary of a run by located events that is interrupted after a rebound is that of an uninterrupted one,
/// with two events, the touch and the separation; otherwise 1.
[[nodiscard]] double different_events(const TemporaryFolder& folder);

/// Number of files of a fence's run that differ from those of an interrupted one; 1 if one folder has other files. Its
/// cables yield before the interruption, which is between two rows, states and lines of the listing.
[[nodiscard]] double different_fence_files(const TemporaryFolder& folder);

/// Number of files of the run with warnings that differ if it is run into the folder of that fence, which has a
/// checkpoint; 1 if one folder has other files. Call after the others.
[[nodiscard]] double different_after_a_fence(const TemporaryFolder& folder);

}  // namespace talus::verification::problems::run_files
