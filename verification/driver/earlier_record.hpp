#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "verification/check/case.hpp"
#include "verification/check/record.hpp"

/// Records of an earlier run that the same program would only make again.
namespace talus::verification {

/// Hash of this executable and of the files, and those in the folders, that its cases read. Errors: records::FileError.
[[nodiscard]] std::string program_fingerprint(const std::vector<std::filesystem::path>& read);

/// Marks the record in a case's folder as one of that program. Without a mark, where none can be written, it is not
/// reused.
void mark_record(const std::filesystem::path& folder, const std::string& program);

/// The record in a case's folder if that program left it, it is whole and unchanged, and the case passed.
[[nodiscard]] std::optional<Record> earlier_record(const Case& verification_case, const std::filesystem::path& folder,
                                                   const std::string& program);

}  // namespace talus::verification
