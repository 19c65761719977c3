#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "verification/record/case_record.hpp"

namespace talus::verification {

using records::Evidence;

/// The paragraph **Evidence.** of a case's page: "**Evidence.** Closed form, property. Not shown: impacts with
/// friction."
struct EvidenceParagraph {
  std::vector<Evidence> kinds;
  std::string not_shown;  ///< Plain text with formulas, one line.
  std::string error;      ///< Found and allowed; empty if the paragraph is complete.
};

/// Reads the paragraph. The kinds are those of records::Evidence, in their order, each at most once.
[[nodiscard]] EvidenceParagraph evidence_of(std::string_view page);

/// A paragraph for a page without one.
[[nodiscard]] std::string text_of(const EvidenceParagraph& paragraph);

}  // namespace talus::verification
