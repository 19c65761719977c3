#include "verification/driver/earlier_record.hpp"

#include <algorithm>

#include "solver/io/output/checkpoint.hpp"
#include "verification/record/record_files.hpp"
#include "verification/record/whole_file.hpp"

namespace talus::verification {

namespace {

namespace fs = std::filesystem;

const char* const mark_name = "program.txt";

std::string mark_of(const fs::path& folder, const std::string& program) {
  return program + "\n" + fnv1a(records::read_whole(folder / "record.json")) + "\n";
}

}  // namespace

std::string content_hash(const std::vector<fs::path>& paths) {
  std::vector<fs::path> files;
  for (const fs::path& path : paths) {
    if (!fs::is_directory(path)) {
      files.push_back(path);
      continue;
    }
    std::vector<fs::path> found;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator{path}) {
      if (entry.is_regular_file()) found.push_back(entry.path());
    }
    std::sort(found.begin(), found.end());
    files.insert(files.end(), found.begin(), found.end());
  }
  std::string hashes;
  for (const fs::path& file : files)
    hashes += file.string() + " " + fnv1a(records::read_whole(file)) + "\n";
  return fnv1a(hashes);
}

std::string program_fingerprint(const std::vector<fs::path>& read) {
  std::vector<fs::path> paths{"/proc/self/exe"};
  paths.insert(paths.end(), read.begin(), read.end());
  return content_hash(paths);
}

void mark_record(const fs::path& folder, const std::string& program) {
  try {
    records::write_whole(folder / mark_name, mark_of(folder, program));
  } catch (const records::FileError&) {
  }
}

std::optional<Record> earlier_record(const Case& verification_case, const fs::path& folder,
                                     const std::string& program) {
  try {
    if (records::read_whole(folder / mark_name) != mark_of(folder, program)) return std::nullopt;
    Record record = records::read_record(folder);
    if (record.id != verification_case.id || record.status != Status::pass) return std::nullopt;
    return record;
  } catch (const records::FileError&) {
    return std::nullopt;
  } catch (const records::RecordError&) {
    return std::nullopt;
  }
}

}  // namespace talus::verification
