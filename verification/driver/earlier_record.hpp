#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "verification/check/case.hpp"
#include "verification/check/record.hpp"

/// Reuse of records of an earlier run that the same program would only reproduce.
namespace talus::verification {

/// Hash of files and of the contents of folders, with their names. Errors: records::FileError.
[[nodiscard]] std::string content_hash(const std::vector<std::filesystem::path>& paths);

/// Hash of this executable and of the files and folder contents that its cases read. Errors: records::FileError.
[[nodiscard]] std::string program_fingerprint(const std::vector<std::filesystem::path>& read);

/// Marks the record in a case's folder as written by the given program. If the mark cannot be written, the record is
/// not reused.
void mark_record(const std::filesystem::path& folder, const std::string& program);

/// The record in a case's folder if the given program wrote it, it is complete and unchanged, and the case passed.
[[nodiscard]] std::optional<Record> earlier_record(const Case& verification_case, const std::filesystem::path& folder,
                                                   const std::string& program);

}  // namespace talus::verification
