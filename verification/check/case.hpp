#pragma once

#include <algorithm>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include "verification/check/findings.hpp"
#include "verification/record/case_record.hpp"

namespace talus::verification {

using records::Tier;

/// What a case is asked to run: its right setup, or the same with one planted fault.
struct Setup {
  std::string fault{};      ///< Name of the planted fault; empty for the right setup.
  bool coarse = false;      ///< Fewest points that still decide the checks which the faults name.
  Tier tier = Tier::quick;  ///< Tier of the whole run.
  std::string machine{};    ///< Processor, compiler and options, in words: for the captions of measured times.
  std::vector<std::string> needed{};  ///< Names of the only checks that matter; empty: all do.

  /// Is `name` the planted fault?
  [[nodiscard]] bool has(std::string_view name) const { return fault == name; }
  /// Is none planted, or one of these? What a fault has no part in need not be run again.
  [[nodiscard]] bool concerns(std::initializer_list<std::string_view> names) const {
    return fault.empty() || std::find(names.begin(), names.end(), fault) != names.end();
  }
  /// Does a check matter whose name contains `part`? A case need not make the others; a needed check that is not made
  /// fails the control.
  [[nodiscard]] bool needs(std::string_view part) const {
    const auto has_part = [&](const std::string& name) { return name.find(part) != std::string::npos; };
    return needed.empty() || std::any_of(needed.begin(), needed.end(), has_part);
  }
};

/// A planted fault: a named wrong setup and the check that must turn red because of it.
struct Fault {
  std::string name;       ///< One word or snake_case, as in Setup::has.
  std::string what;       ///< What is made wrong, in words.
  std::string turns_red;  ///< Name of a check of the same case.
};

/// A requirement and the checks that show it. What a claim says of the solver's closed lists must have been used by a
/// run of the case (usage.hpp).
struct Claim {
  std::string requirement;          ///< Id from the catalogue: "Eq. 21", "law.NAME", "integrator.NAME", ...
  std::vector<std::string> checks;  ///< Each the name of a check or the id of a group of checks; each must exist.
};

/// A verification case: one page of the manual and the function that fills it.
struct Case {
  std::string id;                   ///< snake_case; file, function and folder carry the same name.
  std::string title;                ///< One line.
  std::string family{};             ///< Place in the report's summary; empty: that of its catalogue problems.
  std::vector<Claim> requirements;  ///< What the case shows, and by which checks.
  /// Checks of numbers that the case's runs gave, each by its name or the id of its group. Each law, end rule, contact
  /// method, integrator, pair of shapes, and each shape of this pair, that is the only one of its kind in all runs of the
  /// case is claimed for them.
  std::vector<std::string> checks_of_runs{};
  std::vector<std::string> main_checks{};  ///< Names of the checks on the first page; each must be made.
  std::string source;                      ///< Full citation with page or equation.
  std::string page{};  ///< Markdown of the file beside the source: problem, sketch, equations, parameters, what would
                       ///< break it. The catalogue fills it in.
  std::vector<Fault> faults;  ///< At least one: a case that cannot turn red shows nothing.
  Tier tier = Tier::quick;    ///< The lowest tier that runs this case.
  bool recorded = false;  ///< Compares with earlier results of the program itself, not with an independent solution.
  double seconds = 1.0;   ///< Processor time of the quick tier [s], roughly: the driver starts long cases first.
  /// The same of the full tier, if that runs more than the quick one. 0: it does not, and Setup::tier is quick in both.
  double full_seconds = 0.0;
  double time_limit = 60.0;   ///< Wall-clock limit [s] for the whole case, its faulty setups included.
  double memory_limit = 2.0;  ///< Most memory [GiB] that the case may hold at any time.
  void (*run)(Findings&, const Setup&) = nullptr;  ///< Measures and compares; throws what it cannot handle.

  /// Whether the full tier runs what the quick one does not.
  [[nodiscard]] bool has_full_part() const { return tier == Tier::full || full_seconds > 0.0; }
};

}  // namespace talus::verification
