#pragma once

#include <vector>

#include "verification/check/case.hpp"
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

/// The head of a record: what the case says of itself, nothing found yet.
[[nodiscard]] Record record_of(const Case& verification_case);

/// The checks of `checks` that show what `claims` say, a trace for each claim.
[[nodiscard]] std::vector<Trace> traced(const std::vector<Claim>& claims, const std::vector<Check>& checks);

}  // namespace talus::verification
