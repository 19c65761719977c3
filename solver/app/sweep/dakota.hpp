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

/// Reads a parameters file of Dakota in its standard format ("Parameters file format", Dakota User's Manual): one
/// request, or those of a batch one after the other. Errors: InputError with `name`, line, what was found and what is
/// allowed, also for requested gradients, Hessians and metadata, and for analysis components, which nothing would use.
[[nodiscard]] std::vector<DakotaRequest> read_dakota(std::string_view text, std::string_view name);

/// What a results file has for one request: a line with value and label for each requested response; or `FAIL` and the
/// reason if that is not empty. `values`: of all responses in their order.
[[nodiscard]] std::string dakota_results(const DakotaRequest& request, std::span<const double> values,
                                         const std::string& failure);

}  // namespace talus::app
