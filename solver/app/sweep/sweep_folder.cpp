#include "solver/app/sweep/sweep_folder.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <nlohmann/json.hpp>
#include <set>
#include <string_view>
#include <unordered_set>

#include "solver/base/error.hpp"
#include "solver/io/file/atomic_file.hpp"
#include "solver/io/file/json_text.hpp"
#include "solver/io/file/toml_document.hpp"
#include "solver/io/output/checkpoint.hpp"
#include "verification/record/json_fault.hpp"
#include "verification/record/json_node.hpp"

namespace talus::app {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr const char *description_name = "sweep.json", *base_name = "base.toml", *manifest_name = "manifest.jsonl",
                     *results_name = "results";
constexpr int schema = 1;

std::string description(const SweepFolder& sweep) {
  Json json{{"schema", schema}, {"title", sweep.title}, {"base", base_name}, {"outputs", sweep.outputs}};
  Json limits = Json::object();
  if (sweep.limits.time > 0.0) limits["time"] = sweep.limits.time;
  if (sweep.limits.evaluations > 0) limits["evaluations"] = sweep.limits.evaluations;
  json["limits"] = limits;
  json["runs"] = sweep.runs.size();
  return json.dump(2) + "\n";
}

/// The whole lines of a text; what follows the last line end is left out.
std::vector<std::string> whole_lines(const std::string& text) {
  std::vector<std::string> lines;
  for (std::size_t from = 0; from < text.size();) {
    const std::size_t end = text.find('\n', from);
    if (end == std::string::npos) break;
    lines.push_back(text.substr(from, end - from));
    from = end + 1;
  }
  return lines;
}

/// The files of results, in the order of their names.
std::set<fs::path> result_files(const fs::path& folder) {
  std::set<fs::path> files;
  std::error_code none;
  for (const auto& entry : fs::directory_iterator{folder / results_name, none})
    if (entry.path().extension() == ".jsonl") files.insert(entry.path());
  return files;
}

template <class Read>
void for_each_line(const fs::path& file, Read&& read) {
  std::size_t number = 0;
  for (const std::string& line : whole_lines(read_text(file))) {
    demand_shallow_json(line, file, ++number);
    try {
      read(line);
    } catch (const InputError& error) {
      throw InputError{fmt::format("{}:{}: {}", file.string(), number, error.what())};
    }
  }
}

/// The description and the base of a folder; the number of its runs in `count`.
SweepFolder read_description(const fs::path& folder, std::size_t& count) {
  demand_folder_with(folder, description_name, "the folder of a sweep, written by `talus sweep plan`");
  SweepFolder sweep;
  sweep.folder = folder;
  const fs::path file = folder / description_name;
  const auto refused = [&](std::string_view reason) {
    return InputError{
        fmt::format("{}: not the description of a sweep; plan the sweep again: {}", file.string(), reason)};
  };
  try {
    const Json json = Json::parse(read_json_text(file));
    const records::Node node{json, "sweep"};
    if (const int found = node.at("schema").integer(); found != schema)
      throw InputError{fmt::format("{}: found schema {}; it must be {}", file.string(), found, schema)};
    sweep.title = node.at("title").text();
    sweep.outputs = node.at("outputs").texts();
    const records::Node limits = node.at("limits");
    if (limits.has("time")) sweep.limits.time = limits.at("time").number();
    if (limits.has("evaluations")) sweep.limits.evaluations = static_cast<long>(limits.at("evaluations").count());
    count = node.at("runs").count();
  } catch (const records::RecordError& error) {
    throw refused(error.what());
  } catch (const Json::exception& error) {
    throw refused(records::json_fault(error));
  }
  sweep.base_text = read_text(folder / base_name);
  return sweep;
}

/// Calls visit(file, result) for each line of the results. Errors: IoError; InputError with file and line.
template <class Visit>
void for_each_result(const SweepFolder& sweep, Visit&& visit) {
  const std::string key = sweep.key();
  for (const fs::path& file : result_files(sweep.folder)) {
    for_each_line(file, [&](const std::string& line) {
      SweepResult result = result_of_line(line, key);
      const bool has_values = result.end == SweepEnd::finished || result.end == SweepEnd::unusable;
      const std::size_t expected = has_values ? sweep.outputs.size() : 0;
      if (const std::size_t count = result.values.size(); count != expected) {
        throw InputError{fmt::format("found {} values; with the end '{}' there are {}; remove this line", count,
                                     name_of(result.end), expected)};
      }
      visit(file, std::move(result));
    });
  }
}

/// Errors: InputError if results in the folder are of another base, or have other outputs or limits.
void check_results(const SweepFolder& sweep) {
  const std::set<fs::path> files = result_files(sweep.folder);
  if (std::ranges::all_of(files, [](const fs::path& file) { return whole_lines(read_text(file)).empty(); })) return;
  std::size_t count = 0;
  const SweepFolder old = read_description(sweep.folder, count);
  const char* const differs =
      old.base_text != sweep.base_text                                                             ? "another base"
      : old.outputs != sweep.outputs                                                               ? "other outputs"
      : old.limits.time != sweep.limits.time || old.limits.evaluations != sweep.limits.evaluations ? "other limits"
                                                                                                   : nullptr;
  if (differs != nullptr)
    throw InputError{fmt::format("{}: found results of a sweep with {}; give another folder, or remove {}",
                                 sweep.folder.string(), differs, (sweep.folder / results_name).string())};
}

[[noreturn]] void fail(const fs::path& file) {
  throw IoError{fmt::format("{}: {}", file.string(), std::strerror(errno))};
}

}  // namespace

// Reasons of refused runs name the file, but not the folder: results are the same in any.
SweepBase SweepFolder::base() const {
  SweepBase base{parse_toml(base_text, base_name), base_name};
  base.choose(outputs);
  return base;
}

std::string SweepFolder::key() const {
  const Json json{base_text, outputs, limits.time, limits.evaluations};
  return fnv1a(json.dump(-1, ' ', false, Json::error_handler_t::replace));
}

SweepFolder SweepFolder::part(std::size_t number, std::size_t of) && {
  std::vector<SweptRun> kept;
  for (std::size_t i = number - 1; i < runs.size(); i += of)
    kept.push_back(std::move(runs[i]));
  runs = std::move(kept);
  return std::move(*this);
}

void write_sweep_folder(const SweepFolder& sweep) {
  if (fs::exists(sweep.folder / base_name) && !fs::exists(sweep.folder / description_name))
    throw InputError{
        fmt::format("{}: found {} of something else; give another folder", sweep.folder.string(), base_name)};
  make_folder(sweep.folder / results_name);
  check_results(sweep);
  std::string manifest;
  for (const SweptRun& run : sweep.runs)
    manifest += manifest_line(run) + "\n";
  write_whole(sweep.folder / base_name, sweep.base_text, Durability::later);
  write_whole(sweep.folder / manifest_name, manifest, Durability::later);
  write_whole(sweep.folder / description_name, description(sweep), Durability::later);
  sync_folder(sweep.folder);
}

SweepFolder read_sweep_folder(const fs::path& folder) {
  std::size_t count = 0;
  SweepFolder sweep = read_description(folder, count);
  for_each_line(folder / manifest_name, [&](const std::string& line) { sweep.runs.push_back(run_of_line(line)); });
  if (sweep.runs.size() != count)
    throw InputError{fmt::format("{}: found {} runs; {} has {}; plan the sweep again",
                                 (folder / manifest_name).string(), sweep.runs.size(), description_name, count)};
  std::vector<SweptRun> made = sweep.runs;
  set_ids(made);
  const auto [wrong, right] = std::ranges::mismatch(sweep.runs, made, {}, &SweptRun::id, &SweptRun::id);
  if (wrong != sweep.runs.end())
    throw InputError{fmt::format("{}:{}: found the id {}; these parameters have {}; plan the sweep again",
                                 (folder / manifest_name).string(), wrong - sweep.runs.begin() + 1, wrong->id,
                                 right->id)};
  return sweep;
}

std::vector<SweepResult> all_results(const SweepFolder& sweep) {
  std::vector<SweepResult> all;
  for_each_result(sweep, [&](const fs::path&, SweepResult&& result) { all.push_back(std::move(result)); });
  return all;
}

KnownResults read_results(const SweepFolder& sweep) {
  std::unordered_set<std::string> ids;
  for (const SweptRun& run : sweep.runs)
    ids.insert(run.id);
  KnownResults known;
  for_each_result(sweep, [&](const fs::path& file, SweepResult&& result) {
    if (!ids.contains(result.id)) {
      ++known.of_others;
      return;
    }
    std::string id = result.id;
    if (!known.by_id.emplace(id, std::move(result)).second) known.duplicates.push_back({std::move(id), file});
  });
  return known;
}

ResultFile::ResultFile(const SweepFolder& sweep) : key_{sweep.key()} {
  make_folder(sweep.folder / results_name);
  char host[256] = "host";
  static_cast<void>(::gethostname(host, sizeof host - 1));
  for (int number = 0; descriptor_ < 0; ++number) {
    file_ = sweep.folder / results_name / fmt::format("{}-{}-{}.jsonl", host, ::getpid(), number);
    descriptor_ = ::open(file_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_APPEND | O_CLOEXEC, 0666);
    if (descriptor_ < 0 && errno != EEXIST) fail(file_);
  }
}

ResultFile::~ResultFile() { ::close(descriptor_); }

void ResultFile::add(const SweepResult& result) {
  const std::string line = result_line(result, key_) + "\n";
  std::string_view left = line;
  while (!left.empty()) {
    const ssize_t written = ::write(descriptor_, left.data(), left.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) {
      const int reason = errno;
      // Without its end the line would be one with the next, if the disk has space again.
      static_cast<void>(::ftruncate(descriptor_, size_));
      errno = reason;
      fail(file_);
    }
    left.remove_prefix(static_cast<std::size_t>(written));
  }
  size_ += static_cast<off_t>(line.size());
}

void ResultFile::flush() {
  if (::fsync(descriptor_) != 0) fail(file_);
}

}  // namespace talus::app
