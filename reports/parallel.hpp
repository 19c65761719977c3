/// Independent tasks side by side.
#pragma once

#include <functional>
#include <vector>

namespace talus::reports {

/// Calls every task, on up to `jobs` threads; when all have ended, throws again what the first of them in the list
/// threw.
void in_parallel(const std::vector<std::function<void()>>& tasks, unsigned jobs);

}  // namespace talus::reports
