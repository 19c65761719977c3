#include "verification/check/usage.hpp"

#include <algorithm>
#include <array>
#include <mutex>
#include <stdexcept>
#include <utility>

namespace talus::verification {

namespace {

/// The groups of requirements from the solver's lists (catalogue/solver_lists.cpp).
constexpr std::array<std::string_view, 9> kinds{"law",        "shear_law", "end_rule", "method", "mechanism",
                                                "integrator", "shape",     "pair",     "regime"};

std::mutex mutex;
UsageRecording* recording = nullptr;

}  // namespace

std::string_view kind_of_use(std::string_view id) {
  const std::string_view kind = id.substr(0, id.find('.'));
  const bool known = kind.size() < id.size() && std::find(kinds.begin(), kinds.end(), kind) != kinds.end();
  return known ? kind : std::string_view{};
}

std::string used_of_kind(const Usage& usage, std::string_view kind) {
  std::string list;
  for (const std::string& id : usage) {
    if (kind_of_use(id) == kind) list += (list.empty() ? "" : ", ") + id;
  }
  return list.empty() ? "nothing" : list;
}

UsageRecording::UsageRecording() {
  const std::lock_guard lock{mutex};
  if (recording != nullptr) throw std::logic_error("a recording of usage is in progress already");
  recording = this;
}

UsageRecording::~UsageRecording() {
  const std::lock_guard lock{mutex};
  recording = nullptr;
}

bool is_recording_use() {
  const std::lock_guard lock{mutex};
  return recording != nullptr;
}

void record_use(std::string id) {
  if (kind_of_use(id).empty()) throw std::invalid_argument("'" + id + "' is of no closed list of the solver");
  const std::lock_guard lock{mutex};
  if (recording != nullptr) recording->usage_.insert(std::move(id));
}

}  // namespace talus::verification
