/// talus_mutate: writes a copy of the source tree with mutants compiled in, and a list of them.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "solver/threads/parallel_for.hpp"
#include "tests/mutants/equivalent.hpp"
#include "tests/mutants/operators.hpp"
#include "tests/mutants/schemata.hpp"
#include "tests/mutants/written_bugs.hpp"
#include "verification/record/mutants.hpp"
#include "verification/record/whole_file.hpp"

namespace talus::mutants {

namespace {

namespace fs = std::filesystem;

struct Options {
  fs::path root = ".";
  fs::path out = "build/mutants";
  std::size_t sample = 0;
  std::size_t skip = 0;
  std::uint64_t seed = 1;
  bool bugs = false;
  bool sources = false;
  bool list = false;
  fs::path blame;
  /// Folders whose sources are mutated: those that a run executes.
  std::vector<std::string> folders{"solver/dynamics", "solver/granular", "solver/integrate", "solver/laws",
                                   "solver/scenes"};
};

/// FNV-1a hash.
std::uint64_t hash_of(std::string_view text, std::uint64_t hash = 14695981039346656037ULL) {
  for (const char letter : text) {
    hash ^= static_cast<unsigned char>(letter);
    hash *= 1099511628211ULL;
  }
  return hash;
}

/// A candidate mutant with its source text and its position in the sample.
struct Candidate {
  Mutant mutant{};
  std::string original{};
  std::string line{};     ///< the source line on which it begins, trimmed
  std::uint64_t order{};  ///< rank in the sample: smaller is drawn earlier
  std::string reason{};   ///< why it is equivalent; empty: it is not known to be
};

std::string line_at(const std::string& text, std::size_t at) {
  const std::size_t start = at == 0 ? 0 : text.rfind('\n', at - 1) + 1;
  std::string line = text.substr(start, std::min(text.find('\n', at), text.size()) - start);
  line.erase(0, std::min(line.find_first_not_of(' '), line.size()));
  return line;
}

/// Hash of the texts, then the finaliser of splitmix64: an order that depends only on the texts of a mutant and the
/// seed, so that the sample changes only where the sources do.
std::uint64_t order_of(const Candidate& candidate, std::uint64_t seed) {
  const Edit& edit = candidate.mutant.edits[0];
  std::uint64_t hash = hash_of(edit.file);
  for (const std::string& part : {candidate.mutant.operation, candidate.line, candidate.original, edit.replacement})
    hash = hash_of("\n" + part, hash);
  hash += seed * 0x9e3779b97f4a7c15ULL;
  hash = (hash ^ (hash >> 30)) * 0xbf58476d1ce4e5b9ULL;
  hash = (hash ^ (hash >> 27)) * 0x94d049bb133111ebULL;
  return hash ^ (hash >> 31);
}

std::vector<std::string> mutated_files(const Options& options) {
  std::set<std::string> files;
  for (const std::string& folder : options.folders) {
    for (const auto& entry : fs::recursive_directory_iterator(options.root / folder)) {
      const fs::path extension = entry.path().extension();
      if (extension == ".cpp" || (extension == ".hpp" && !options.sources))
        files.insert(fs::relative(entry.path(), options.root).generic_string());
    }
  }
  return {files.begin(), files.end()};
}

/// Hash of all headers that a source may include.
std::uint64_t hash_of_headers(const fs::path& root) {
  std::set<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(root / "solver")) {
    if (entry.path().extension() == ".hpp") files.insert(entry.path());
  }
  std::uint64_t hash = hash_of("");
  for (const fs::path& file : files)
    hash = hash_of(records::read_whole(file), hash);
  return hash;
}

fs::path absolute_root(const Options& options) { return fs::absolute(options.root).lexically_normal(); }
fs::path precompiled(const Options& options) { return fs::absolute(options.out) / "candidates" / "libraries.pch"; }

/// The mutants of a file, which take a second to find; from the file `kept` if they were found in the same sources
/// before.
std::vector<Mutant> known_mutants(const Options& options, const std::string& file, const fs::path& kept) {
  std::vector<Mutant> mutants;
  if (fs::exists(kept)) {
    for (const auto& entry : nlohmann::json::parse(records::read_whole(kept))) {
      Mutant& mutant = mutants.emplace_back(Mutant{.id = entry["id"], .operation = entry["operation"]});
      for (const auto& edit : entry["edits"])
        mutant.edits.push_back(
            {file, edit["begin"], edit["end"], static_cast<Form>(edit["form"].get<int>()), edit["new"]});
    }
    return mutants;
  }
  mutants = mutants_of(Source(absolute_root(options), file, precompiled(options)), file);
  nlohmann::json list = nlohmann::json::array();
  for (const Mutant& mutant : mutants) {
    nlohmann::json edits = nlohmann::json::array();
    for (const Edit& edit : mutant.edits)
      edits.push_back(
          {{"begin", edit.begin}, {"end", edit.end}, {"form", static_cast<int>(edit.form)}, {"new", edit.replacement}});
    list.push_back({{"id", mutant.id}, {"operation", mutant.operation}, {"edits", edits}});
  }
  records::write_whole(kept, list.dump(), records::Durability::later);
  return mutants;
}

/// All candidates in the order of the sample. Each entry of the list of equivalents must name one.
std::vector<Candidate> candidates(const Options& options) {
  const auto files = mutated_files(options);
  std::vector<std::vector<Candidate>> found(files.size());
  const std::uint64_t headers = hash_of_headers(options.root);
  std::vector<std::string> texts;
  std::vector<fs::path> kept;
  for (const std::string& file : files) {
    texts.push_back(records::read_whole(options.root / file));
    kept.push_back(options.out / "candidates" / fmt::format("{:016x}.json", hash_of(file + texts.back(), headers)));
  }
  fs::create_directories(options.out / "candidates");
  if (!std::all_of(kept.begin(), kept.end(), [](const fs::path& file) { return fs::exists(file); }))
    precompile_libraries(absolute_root(options), files, precompiled(options));
  parallel_for(files.size(), std::max(1u, std::thread::hardware_concurrency()), [&](std::size_t i) {
    const std::string& text = texts[i];
    for (Mutant& mutant : known_mutants(options, files[i], kept[i])) {
      const Edit& edit = mutant.edits[0];
      Candidate candidate{.original = text.substr(edit.begin, edit.end - edit.begin),
                          .line = line_at(text, edit.begin)};
      candidate.mutant = std::move(mutant);
      candidate.order = order_of(candidate, options.seed);
      found[i].push_back(std::move(candidate));
    }
  });
  std::vector<Candidate> all;
  for (auto& each : found)
    std::move(each.begin(), each.end(), std::back_inserter(all));
  for (const Equivalent& known : equivalent_mutants(options.root / "tests/mutants/equivalent.toml")) {
    std::size_t count = 0;
    for (Candidate& candidate : all) {
      const Edit& edit = candidate.mutant.edits[0];
      if (edit.file != known.file || candidate.mutant.operation != known.operation || candidate.line != known.line ||
          edit.replacement != known.replacement)
        continue;
      candidate.reason = known.reason;
      ++count;
    }
    if (count == 0 && std::find(files.begin(), files.end(), known.file) != files.end())
      throw std::runtime_error(fmt::format("equivalent.toml: there is no mutant {} '{}' in {} at '{}'", known.operation,
                                           known.replacement, known.file, known.line));
  }
  std::stable_sort(all.begin(), all.end(), [](const Candidate& a, const Candidate& b) { return a.order < b.order; });
  return all;
}

std::set<std::string> lines_of(const fs::path& file) {
  std::set<std::string> lines;
  std::ifstream in(file);
  for (std::string line; std::getline(in, line);)
    lines.insert(line);
  return lines;
}

records::SourceRange range_of(const std::string& text, const Edit& edit) {
  const auto line_of = [&](std::size_t at) {
    return 1 + static_cast<std::size_t>(std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n'));
  };
  const auto column_of = [&](std::size_t at) { return at == 0 ? 1 : at - text.rfind('\n', at - 1); };
  return {line_of(edit.begin), column_of(edit.begin), line_of(edit.end), column_of(edit.end)};
}

records::MutantRecord record_of(const Mutant& mutant, int number, const fs::path& root) {
  const Edit& edit = mutant.edits[0];
  const std::string text = records::read_whole(root / edit.file);
  records::MutantRecord record;
  record.number = number;
  record.id = mutant.id;
  record.operation = mutant.operation;
  record.description = mutant.description;
  record.file = edit.file;
  record.range = range_of(text, edit);
  record.original = text.substr(edit.begin, edit.end - edit.begin);
  record.replacement = edit.replacement;
  record.cases = mutant.cases;
  return record;
}

/// Writes a file only if its content differs, so that only changed files are compiled again.
void write_changed(const fs::path& file, const std::string& text) {
  if (fs::exists(file) && records::read_whole(file) == text) return;
  fs::create_directories(file.parent_path());
  records::write_whole(file, text, records::Durability::later);
}

/// Writes all files that a build needs, with the switches compiled in, and removes others.
void write_tree(const fs::path& root, const fs::path& copy, const std::map<std::string, std::vector<Switched>>& edits) {
  std::set<fs::path> kept;
  for (const char* part : {"CMakeLists.txt", "cases", "reports", "scripts", "solver", "tests", "verification"}) {
    std::vector<fs::path> files;
    if (fs::is_directory(root / part)) {
      for (const auto& entry : fs::recursive_directory_iterator(root / part)) {
        if (entry.is_regular_file()) files.push_back(fs::relative(entry.path(), root));
      }
    } else {
      files.emplace_back(part);
    }
    for (const fs::path& file : files) {
      const auto found = edits.find(file.generic_string());
      const std::string text = records::read_whole(root / file);
      write_changed(copy / file, found == edits.end() ? text : with_switches(text, found->second));
      kept.insert(file);
    }
  }
  std::vector<fs::path> stale;
  for (const auto& entry : fs::recursive_directory_iterator(copy)) {
    if (entry.is_regular_file() && kept.count(fs::relative(entry.path(), copy)) == 0) stale.push_back(entry.path());
  }
  for (const fs::path& file : stale)
    fs::remove(file);
}

void mutate(const Options& options) {
  const auto all = candidates(options);
  if (options.list) {
    for (const Candidate& one : all)
      fmt::print("{}  {}  ->  {}\n", one.mutant.id, one.original, one.mutant.edits[0].replacement);
    return;
  }
  const auto uncompiled = lines_of(options.out / "uncompiled.txt");
  records::Mutants list;
  list.candidates = all.size();
  list.seed = options.seed;
  list.operator_count = operations().size();
  std::map<std::string, std::vector<Switched>> edits;
  const auto take = [&](const Mutant& mutant, std::size_t index) {
    const int number = static_cast<int>(index) + 1;
    list.mutants.push_back(record_of(mutant, number, options.root));
    for (const Edit& edit : mutant.edits)
      edits[edit.file].push_back({edit, number});
  };
  // A mutant that does not compile keeps its number, so that the sources of the others need no recompilation.
  std::size_t count = 0;
  if (options.bugs) {
    const auto files = mutated_files(options);
    const auto elsewhere = [&](const Edit& edit) {
      return std::find(files.begin(), files.end(), edit.file) == files.end();
    };
    for (const Mutant& bug : written_bugs(options.root / "tests/mutants/bugs", options.root)) {
      if (options.sources && std::any_of(bug.edits.begin(), bug.edits.end(), elsewhere)) continue;
      take(bug, count++);
    }
  }
  std::size_t drawn = 0;
  for (std::size_t i = options.skip; i < all.size() && drawn < options.sample; ++i) {
    const Candidate& one = all[i];
    const std::size_t index = count++;
    if (uncompiled.count(one.mutant.id) > 0) {
      ++list.uncompiled;
      continue;
    }
    ++drawn;
    if (one.reason.empty()) {
      take(one.mutant, index);
      continue;
    }
    auto record = record_of(one.mutant, 0, options.root);
    record.status = records::MutantStatus::equivalent;
    record.reason = one.reason;
    list.mutants.push_back(std::move(record));
  }
  write_tree(options.root, options.out / "source", edits);
  records::write_mutants(list, options.out / "mutants.json");
  fmt::print("mutants: {} in {} files; {} candidates, {} of those drawn do not compile\n", list.mutants.size(),
             edits.size(), all.size(), list.uncompiled);
}

/// Adds the mutants at which a build failed to the list of those that do not compile. Errors: std::runtime_error for a
/// compiler error that no mutant explains.
void blame(const Options& options) {
  const auto list = records::read_mutants(options.out / "mutants.json");
  auto uncompiled = lines_of(options.out / "uncompiled.txt");
  const std::size_t before = uncompiled.size();
  const fs::path source = options.out / "source";
  const std::regex error(R"(^(.*)/source/([^:]+):(\d+):(\d+): error: (.*)$)");
  const std::regex named(R"(talus::mutants::on\((\d+)\))");
  std::ifstream log(options.blame);
  std::string unexplained;
  for (std::string line; std::getline(log, line);) {
    std::smatch part;
    if (!std::regex_match(line, part, error)) continue;
    // Some messages quote the switch; for the others the position identifies it.
    std::smatch quoted;
    const std::string message = part[5];
    const int number =
        std::regex_search(message, quoted, named)
            ? std::stoi(quoted[1])
            : switch_at(records::read_whole(source / part[2].str()), std::stoul(part[3]), std::stoul(part[4]));
    const auto found = std::find_if(list.mutants.begin(), list.mutants.end(),
                                    [&](const auto& mutant) { return number > 0 && mutant.number == number; });
    if (found == list.mutants.end() || found->operation == "bug")
      unexplained = line;
    else
      uncompiled.insert(found->id);
  }
  if (uncompiled.size() == before)
    throw std::runtime_error(
        fmt::format("the build failed, and no mutant explains it; see {}: {}", options.blame.string(), unexplained));
  std::string text;
  for (const std::string& id : uncompiled)
    text += id + "\n";
  records::write_whole(options.out / "uncompiled.txt", text);
  fmt::print("mutants: {} more do not compile\n", uncompiled.size() - before);
}

}  // namespace

}  // namespace talus::mutants

int main(int argc, char** argv) {
  using namespace talus::mutants;
  CLI::App app{
      "talus_mutate: copies the sources with mutants compiled in, to OUT/source, and lists them in "
      "OUT/mutants.json. Exit status: 0 done, 2 wrong command line, 1 what else went wrong"};
  Options options;
  app.add_option("--root", options.root, "The source tree")->capture_default_str()->check(CLI::ExistingDirectory);
  app.add_option("--out", options.out, "Where the copy is made")->capture_default_str();
  app.add_option("--sample", options.sample, "Number of generated mutants")->capture_default_str();
  app.add_option("--skip", options.skip, "Leave out this many at the start of the order")->capture_default_str();
  app.add_option("--seed", options.seed, "Of the order in which they are drawn")->capture_default_str();
  app.add_option("--folders", options.folders, "Folders whose sources are mutated: F[,F...]")->delimiter(',');
  app.add_flag("--bugs", options.bugs, "The written bugs as well (tests/mutants/bugs)");
  app.add_flag(
      "--sources", options.sources,
      "No mutants in headers, and bugs in these folders alone: such sources can be linked before a build's libraries");
  app.add_flag("--list", options.list, "Print all candidates and end");
  app.add_option("--blame", options.blame, "Log of a failed build: note the mutants that do not compile")
      ->check(CLI::ExistingFile);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& fault) {
    return app.exit(fault) == 0 ? 0 : 2;
  }
  try {
    options.blame.empty() ? mutate(options) : blame(options);
  } catch (const std::exception& fault) {
    fmt::print(stderr, "talus_mutate: {}\n", fault.what());
    return 1;
  }
  return 0;
}
