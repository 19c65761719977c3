#pragma once

#include <vector>

#include "verification/check/case.hpp"
#include "verification/check/usage.hpp"
#include "verification/record/record_files.hpp"

namespace talus::verification {

using records::Colour;
using records::Control;
using records::read_record;
using records::Record;
using records::RecordError;
using records::Status;
using records::Trace;
using records::write_record;

/// A claim for each requirement, in the order of the definition: `{"Eq. 2, Eq. 3", {"columns"}}` becomes two.
[[nodiscard]] std::vector<Claim> claims_of(const Case& verification_case);

/// The case with the names of its main checks and of the checks that its faults turn red, where its definition gives
/// ids. `findings` are those of the correct setup. An id that means no check, or several, stays, and no check has that
/// name.
[[nodiscard]] Case with_check_names(Case verification_case, const Findings& findings);

/// A record with the case's description, without results.
[[nodiscard]] Record record_of(const Case& verification_case);

/// A trace for each claim of the case, with the checks that it refers to: first the explicit claims, in their order,
/// then those that follow from its groups of checks and from `checks_of_runs`. `usage` is that of the case's runs.
[[nodiscard]] std::vector<Trace> traced(const Case& verification_case, const Findings& findings, const Usage& usage);

}  // namespace talus::verification
