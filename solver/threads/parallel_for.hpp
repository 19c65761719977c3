/// Loop over independent tasks on several threads. A separate tree in scripts/layers.txt, so that reports, which do not
/// depend on the solver, can use it too.
#pragma once

#include <cstddef>
#include <functional>

namespace talus {

/// Calls work(i) once for each i < count, started in this order, on up to `threads` threads (0 counts as 1), including
/// the calling thread, and returns when all calls have ended. A free thread takes the next i: tasks may differ in
/// duration.
/// Errors: the exception of work(i), that of the smallest i for any number of threads; no call begins after one has
/// thrown. Runs on fewer threads if the system cannot start all.
///
/// Each call starts its threads, at about 20 us per thread. For stages of a step there is ThreadPool
/// (solver/base/thread_pool.hpp), whose threads persist.
void parallel_for(std::size_t count, unsigned threads, const std::function<void(std::size_t)>& work);

}  // namespace talus
