/// The one loop over independent tasks on several threads. A tree apart in scripts/layers.txt, so that reports, which
/// know nothing of the solver, use it too.
#pragma once

#include <cstddef>
#include <functional>

namespace talus {

/// Calls work(i) once for each i < count, in this order, on up to `threads` threads (0 counts as 1), of which the
/// calling one is one, and returns when all calls have ended. Whoever is free takes the next i: tasks may last
/// differently long.
/// Errors: what work(i) throws, that of the smallest i for any number of threads; no call begins after one has thrown.
/// Threads that the system cannot start are done without.
///
/// Threads are started by each call, some 20 us each. For stages of a step there is ThreadPool (solver/base/thread_pool.hpp), whose
/// threads stay.
void parallel_for(std::size_t count, unsigned threads, const std::function<void(std::size_t)>& work);

}  // namespace talus
