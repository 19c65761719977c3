#pragma once

#include <set>
#include <string>
#include <string_view>

namespace talus::verification {

/// Members of the solver's closed lists, by the ids of their requirements: "law.hertz", "regime.friction.sticking",
/// "pair.circle.half_plane", "integrator.rk4", ...
using Usage = std::set<std::string, std::less<>>;

/// "law" for "law.hertz"; empty if the id belongs to no closed list of the solver, such as "Eq. 21" and "B6".
[[nodiscard]] std::string_view kind_of_use(std::string_view id);

/// The members of one kind that were used, e.g. "law.hertz, law.tension_only"; "nothing" if there are none.
[[nodiscard]] std::string used_of_kind(const Usage& usage, std::string_view kind);

/// Collects all uses in this process during its lifetime. The runs of a case are made in many functions, most of which
/// have no access to its Findings; this way none of them can be forgotten. Errors: std::logic_error if a recording is
/// already in progress.
class UsageRecording {
 public:
  UsageRecording();
  UsageRecording(const UsageRecording&) = delete;
  UsageRecording& operator=(const UsageRecording&) = delete;
  ~UsageRecording();

  [[nodiscard]] const Usage& usage() const { return usage_; }

 private:
  friend void record_use(std::string id);
  Usage usage_;
};

/// Whether a recording is in progress in this process.
[[nodiscard]] bool is_recording_use();

/// Adds a member of a closed list to the recording in progress, if any; thread-safe. Errors: std::invalid_argument if
/// the id belongs to no closed list.
void record_use(std::string id);

}  // namespace talus::verification
