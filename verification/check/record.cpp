#include "verification/check/record.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <fstream>
#include <sstream>
#include <utility>

#include "verification/check/figure_data.hpp"

namespace talus::verification {

namespace {

constexpr std::array statuses{std::pair{Status::pass, "pass"}, std::pair{Status::fail, "fail"},
                              std::pair{Status::error, "error"}, std::pair{Status::timeout, "timeout"},
                              std::pair{Status::missing, "missing"}};
constexpr std::array colours{std::pair{Colour::green, "green"}, std::pair{Colour::red, "red"},
                             std::pair{Colour::missing, "missing"}};

}  // namespace

const char* name_of(Status status) {
  for (const auto& entry : statuses) {
    if (entry.first == status) return entry.second;
  }
  throw std::invalid_argument("a status outside its enumeration");
}

Status status_named(const std::string& name) {
  for (const auto& entry : statuses) {
    if (name == entry.second) return entry.first;
  }
  throw std::invalid_argument("status '" + name + "' is not known");
}

const char* name_of(Colour colour) {
  for (const auto& entry : colours) {
    if (entry.first == colour) return entry.second;
  }
  throw std::invalid_argument("a colour outside its enumeration");
}

Colour colour_named(const std::string& name) {
  for (const auto& entry : colours) {
    if (name == entry.second) return entry.first;
  }
  throw std::invalid_argument("colour '" + name + "' is not known");
}

std::vector<Trace> traced(const std::vector<Claim>& claims, const std::vector<Check>& checks) {
  std::vector<Trace> traces;
  for (const auto& claim : claims) {
    Trace trace{claim.requirement, {}};
    std::vector<bool> used(claim.parts.size(), false);
    for (const auto& check : checks) {
      bool touched = false;
      for (std::size_t i = 0; i < claim.parts.size(); ++i) {
        if (check.name.find(claim.parts[i]) == std::string::npos) continue;
        used[i] = touched = true;
      }
      if (touched) trace.checks.push_back(check.name);
    }
    const auto unused = std::find(used.begin(), used.end(), false);
    if (unused != used.end()) trace.unmatched = claim.parts[static_cast<std::size_t>(unused - used.begin())];
    traces.push_back(std::move(trace));
  }
  return traces;
}

Record record_of(const Case& verification_case) {
  Record record;
  record.id = verification_case.id;
  record.title = verification_case.title;
  record.family = verification_case.family;
  record.requirements = traced(verification_case.requirements, {});
  record.main_checks = verification_case.main_checks;
  record.source = verification_case.source;
  record.page = verification_case.page;
  record.tier = verification_case.tier;
  return record;
}

void write_whole(const std::filesystem::path& file, const std::string& text) {
  const std::filesystem::path part = file.string() + ".part";
  {
    std::ofstream out(part, std::ios::binary | std::ios::trunc);
    out << text << std::flush;
    if (!out) throw std::runtime_error(file.string() + ": cannot be written");
  }
  std::error_code failure;
  std::filesystem::rename(part, file, failure);
  if (failure) throw std::runtime_error(file.string() + ": " + failure.message());
}

void write_record(const Record& record, const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder);
  for (const auto& figure : record.figures)
    write_whole(folder / (figure.name + ".csv"), csv_of(figure));
  for (const auto& file : record.data)
    write_whole(folder / (file.name + ".csv"), csv_of(file));
  write_whole(folder / "record.json", text_of(record));
}

}  // namespace talus::verification
