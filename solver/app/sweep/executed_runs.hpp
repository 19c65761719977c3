#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "solver/app/sweep/sweep_base.hpp"
#include "solver/app/sweep/sweep_folder.hpp"

namespace talus::app {

/// Executes `count` runs on up to `threads` threads: result(i) executes run i, and take(i, result) receives its result,
/// from one thread at a time. Once `interrupted` is true no run begins, and a run that it ends, whose result has no id,
/// is not taken. Errors: those of result() and take().
void for_each_executed(std::size_t count, unsigned threads, const std::function<bool()>& interrupted,
                       const std::function<SweepResult(std::size_t)>& result,
                       const std::function<void(std::size_t, SweepResult&&)>& take);

/// Executes runs of a sweep on up to `threads` threads, and writes their results to a new file of its folder unless
/// there are none; `take` receives each one as above. Errors: IoError.
void execute(const SweepFolder& sweep, const SweepBase& base, const std::vector<const SweptRun*>& runs,
             unsigned threads, const std::function<bool()>& interrupted,
             const std::function<void(SweepResult&&)>& take);

}  // namespace talus::app
