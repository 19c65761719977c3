#pragma once

#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace talus::app {

/// One evaluation as Dakota requests it.
struct DakotaRequest {
  std::vector<std::pair<std::string, double>> variables;  ///< labels and values
  /// Labels of the responses, and whether each is requested.
  std::vector<std::pair<std::string, bool>> responses;
};

/// Reads a parameters file of Dakota in its standard format ("Variables", Dakota User's Manual): `N variables`, N
/// lines of value and label, `M functions`, M lines of active set and `ASV_i:label`; the rest is not used. Errors:
/// InputError with `name`, line, what was found and what is allowed, also for requested gradients and Hessians.
[[nodiscard]] DakotaRequest read_dakota(std::string_view text, std::string_view name);

/// A results file of Dakota: a line with value and label for each requested response; or `FAIL` and the reason if that
/// is not empty. `values`: of all responses in their order.
[[nodiscard]] std::string dakota_results(const DakotaRequest& request, std::span<const double> values,
                                         const std::string& failure);

}  // namespace talus::app
