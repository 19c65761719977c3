#pragma once

#include <algorithm>
#include <functional>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include "verification/check/findings.hpp"
#include "verification/record/case_record.hpp"

namespace talus::verification {

using records::Tier;

/// Configuration of a case run: the correct setup, or the same with one injected fault.
struct Setup {
  std::string fault{};                ///< Name of the injected fault; empty for the correct setup.
  bool coarse = false;                ///< Use the fewest points that still decide the checks named by the faults.
  Tier tier = Tier::quick;            ///< Tier of the whole run.
  std::string machine{};              ///< Processor, compiler and options as text, for captions of measured times.
  std::vector<std::string> needed{};  ///< Names of the only required checks; empty: all checks.

  /// Whether `name` is the injected fault.
  [[nodiscard]] bool has(std::string_view name) const { return fault == name; }
  /// Whether no fault, or one of these, is injected. Parts that a fault does not affect need not run again.
  [[nodiscard]] bool concerns(std::initializer_list<std::string_view> names) const {
    return fault.empty() || std::find(names.begin(), names.end(), fault) != names.end();
  }
  /// Whether a check whose name contains `part` is required. A case may omit the others; a missing required check fails
  /// the control.
  [[nodiscard]] bool needs(std::string_view part) const {
    const auto has_part = [&](const std::string& name) { return name.find(part) != std::string::npos; };
    return needed.empty() || std::any_of(needed.begin(), needed.end(), has_part);
  }
};

/// An injected fault: a named wrong setup and the check that must fail because of it.
struct Fault {
  std::string name;       ///< One word or snake_case, as in Setup::has.
  std::string what;       ///< Description of the error.
  std::string turns_red;  ///< Name or id of the check of the same case that must fail.
};

/// Requirements and the checks that verify each of them. A member of the solver's closed lists can be claimed only if a
/// run of the case has used it (usage.hpp).
struct Claim {
  std::string requirement;          ///< Id from the catalogue: "Eq. 21", "law.NAME", ...; several: "Eq. 23, Eq. 24".
  std::vector<std::string> checks;  ///< Each the name of a check or the id of a group of checks; all must exist.
};

/// A verification case: one page of the manual and the function that computes its results.
struct Case {
  std::string id;                   ///< snake_case; file, function and folder have the same name.
  std::string title;                ///< One line.
  std::string family{};             ///< Section in the report's summary; empty: that of its catalogue problems.
  std::vector<Claim> requirements;  ///< Requirements that the case verifies, and the checks that do so.
  /// Checks of numbers from the case's runs, each by its name or the id of its group. They also claim each law, end
  /// rule, contact method, integrator, pair of shapes, and the shapes of this pair, if it is the only one of its kind
  /// in all runs of the case.
  std::vector<std::string> checks_of_runs{};
  std::vector<std::string> main_checks{};  ///< Names or ids of the checks on the first page; all must exist.
  std::string source;                      ///< Full citation with page or equation.
  std::string page{};  ///< Markdown of the file beside the source: problem, sketch, equations, parameters, faults that
                       ///< would break it. Filled in by the catalogue.
  std::vector<Fault> faults;  ///< At least one: a case that cannot fail shows nothing.
  Tier tier = Tier::quick;    ///< The lowest tier in which this case runs.
  bool recorded = false;  ///< Compares with earlier results of the program itself, not with an independent solution.
  double seconds = 1.0;   ///< Approximate processor time of the quick tier [s]: the driver starts long cases first.
  /// The same for the full tier if it runs more than the quick one; 0: it does not, and Setup::tier is quick in both.
  double full_seconds = 0.0;
  double time_limit = 600.0;  ///< Wall-clock limit [s] with all faulty setups, also of a slow and busy machine.
  double memory_limit = 2.0;  ///< Largest memory [GiB] that the case may use at any time.
  /// Measures and compares; throws on errors that it cannot handle.
  std::function<void(Findings&, const Setup&)> run{};
  /// File of the measurements that a user brought (verification/data); empty for cases of the suite. Such a case claims
  /// no requirement, and its source need not be in the bibliography.
  std::string data_set{};

  /// Whether the full tier runs anything that the quick tier does not.
  [[nodiscard]] bool has_full_part() const { return tier == Tier::full || full_seconds > 0.0; }
};

}  // namespace talus::verification
