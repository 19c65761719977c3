#include "verification/driver/recorded_results.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <set>
#include <stdexcept>
#include <utility>

#include "solver/base/error.hpp"
#include "solver/io/file/toml_document.hpp"
#include "verification/record/error.hpp"
#include "verification/record/json_depth.hpp"
#include "verification/record/json_fault.hpp"
#include "verification/record/names.hpp"

namespace talus::verification {

namespace {

namespace fs = std::filesystem;

constexpr int schema = 1;

/// A value of the file with its JSON path, so that every error names both.
class Field {
 public:
  Field(const nlohmann::json* value, std::string path, const fs::path& file)
      : value_(value), path_(std::move(path)), file_(&file) {}

  /// Throws InputError with file, path and value found; `allowed` completes "it must be".
  [[noreturn]] void fail(const std::string& allowed) const {
    throw InputError(fmt::format("{}: {}: found {}; it must be {}", file_->string(),
                                 path_.empty() ? "top level" : path_, found(), allowed));
  }

  /// The member `key` of an object; it may be absent, in which case reading its value fails.
  [[nodiscard]] Field at(const std::string& key) const {
    if (value_ == nullptr || !value_->is_object()) fail("an object");
    const auto member = value_->find(key);
    return {member == value_->end() ? nullptr : &*member, path_.empty() ? key : path_ + "." + key, *file_};
  }

  [[nodiscard]] bool is_present() const { return value_ != nullptr; }

  [[nodiscard]] std::vector<Field> elements() const {
    if (value_ == nullptr || !value_->is_array()) fail("an array");
    std::vector<Field> all;
    for (std::size_t i = 0; i < value_->size(); ++i)
      all.emplace_back(&(*value_)[i], fmt::format("{}[{}]", path_, i), *file_);
    return all;
  }

  /// The members of an object, by key.
  [[nodiscard]] std::vector<std::pair<std::string, Field>> members() const {
    if (value_ == nullptr || !value_->is_object()) fail("an object");
    std::vector<std::pair<std::string, Field>> all;
    for (const auto& member : value_->items())
      all.emplace_back(member.key(), at(member.key()));
    return all;
  }

  /// Fails for any other value.
  void require(const nlohmann::json& allowed) const {
    if (value_ == nullptr || *value_ != allowed) fail(allowed.dump());
  }

  [[nodiscard]] std::string text() const {
    if (value_ == nullptr || !value_->is_string()) fail("a string");
    return value_->get<std::string>();
  }

  [[nodiscard]] std::string name() const {
    const std::string name = text();
    if (name.empty()) fail("a string that is not empty");
    return name;
  }

  [[nodiscard]] std::vector<std::string> texts() const {
    std::vector<std::string> all;
    for (const Field& element : elements())
      all.push_back(element.text());
    return all;
  }

  [[nodiscard]] bool flag() const {
    if (value_ == nullptr || !value_->is_boolean()) fail("true or false");
    return value_->get<bool>();
  }

  /// A number, or one of the texts for numbers that JSON does not have.
  [[nodiscard]] double number() const {
    if (value_ != nullptr) {
      if (value_->is_number()) return value_->get<double>();
      if (*value_ == "nan") return std::numeric_limits<double>::quiet_NaN();
      if (*value_ == "inf") return std::numeric_limits<double>::infinity();
      if (*value_ == "-inf") return -std::numeric_limits<double>::infinity();
    }
    fail("a number, \"nan\", \"inf\" or \"-inf\"");
  }

  [[nodiscard]] double not_negative() const {
    if (value_ == nullptr || !value_->is_number() || !(value_->get<double>() >= 0.0)) fail("a number of at least 0");
    return value_->get<double>();
  }

  [[nodiscard]] std::uint64_t count() const {
    if (value_ == nullptr || !value_->is_number_unsigned()) fail("an integer of at least 0");
    return value_->get<std::uint64_t>();
  }

  /// The value of an enumeration with this name.
  template <records::Named Enum>
  [[nodiscard]] Enum word() const {
    for (const auto& [value, name] : records::Names<Enum>::values) {
      if (value_ != nullptr && value_->is_string() && value_->get<std::string>() == name) return value;
    }
    const std::vector<std::string> names = records::all_names<Enum>();
    std::string allowed = "\"" + names.front();
    for (std::size_t i = 1; i < names.size(); ++i)
      allowed += (i + 1 < names.size() ? "\", \"" : "\" or \"") + names[i];
    fail(allowed + '"');
  }

 private:
  [[nodiscard]] std::string found() const {
    if (value_ == nullptr) return "nothing";
    if (value_->is_object()) return "an object";
    if (value_->is_array()) return "an array";
    constexpr std::size_t longest = 60;
    std::string text = value_->dump(-1, ' ', true, nlohmann::json::error_handler_t::replace);
    if (text.size() > longest) text = text.substr(0, longest) + "...";
    return text;
  }

  const nlohmann::json* value_;  ///< nullptr: absent.
  std::string path_;
  const fs::path* file_;
};

RecordedCheck check_from(const Field& json) {
  RecordedCheck check;
  check.name = json.at("name").name();
  check.unit = json.at("unit").text();
  check.kind = json.at("kind").word<Kind>();
  check.relative = json.at("relative").flag();
  check.measured = json.at("measured").number();
  check.reference = json.at("reference").number();
  check.error = json.at("error").number();
  check.bound = json.at("bound").not_negative();
  check.margin = json.at("margin").number();
  check.pass = json.at("pass").flag();
  if (const Field text = json.at("text_measured"); text.is_present()) check.text_measured = text.text();
  const bool holds = std::isfinite(check.measured) && std::isfinite(check.reference) && std::isfinite(check.error) &&
                     check.error <= check.bound;
  if (check.pass != holds) {
    json.at("pass").fail(fmt::format("{}, because measured is {}, reference {}, error {} and bound {}", holds,
                                     check.measured, check.reference, check.error, check.bound));
  }
  return check;
}

RecordedControl control_from(const Field& json) {
  RecordedControl control;
  control.name = json.at("name").name();
  control.turns_red = json.at("turns_red").text();
  control.observed = json.at("observed").word<Colour>();
  control.unplanted = json.at("unplanted").word<Colour>();
  control.message = json.at("message").text();
  control.pass = json.at("pass").flag();
  const bool holds = control.observed == Colour::red && control.unplanted == Colour::green;
  if (control.pass != holds) {
    json.at("pass").fail(fmt::format("{}, because observed is \"{}\" and unplanted \"{}\"", holds,
                                     name_of(control.observed), name_of(control.unplanted)));
  }
  return control;
}

/// Makes a name unique by numbering its repetitions.
std::string numbered(const std::string& name, std::set<std::string>& taken) {
  std::string unique = name;
  for (int n = 2; !taken.insert(unique).second; ++n)
    unique = fmt::format("{} #{}", name, n);
  return unique;
}

RecordedCase case_from(const Field& json) {
  RecordedCase recorded;
  recorded.id = json.at("id").name();
  recorded.family = json.at("family").text();
  recorded.outcome.status = json.at("status").word<Status>();
  recorded.outcome.message = json.at("message").text();
  recorded.outcome.seconds = json.at("seconds").not_negative();
  recorded.outcome.evaluations = json.at("evaluations").count();
  std::set<std::string> checks;
  for (const Field& check : json.at("checks").elements()) {
    recorded.checks.push_back(check_from(check));
    recorded.checks.back().name = numbered(recorded.checks.back().name, checks);
  }
  std::set<std::string> controls;
  for (const Field& control : json.at("controls").elements()) {
    recorded.controls.push_back(control_from(control));
    recorded.controls.back().name = numbered(recorded.controls.back().name, controls);
  }
  return recorded;
}

Provenance provenance_from(const Field& json) {
  Provenance from;
  from.revision = json.at("revision").text();
  from.dirty = json.at("dirty").flag();
  from.compiler = json.at("compiler").text();
  from.flags = json.at("flags").text();
  from.build_type = json.at("build_type").text();
  from.cpu = json.at("cpu").text();
  from.cores = static_cast<unsigned>(json.at("cores").count());
  from.os = json.at("os").text();
  from.date = json.at("date").text();
  for (const auto& [library, version] : json.at("libraries").members())
    from.libraries.emplace_back(library, version.text());
  return from;
}

RecordedResults results_from(const Field& root, const fs::path& file) {
  root.at("schema").require(schema);
  RecordedResults results;
  results.source.file = file;
  results.source.provenance = provenance_from(root.at("provenance"));
  results.source.tier = root.at("tier").word<Tier>();
  if (const Field verdict = root.at("verdict"); verdict.text() != "pass" && verdict.text() != "fail")
    verdict.fail("\"pass\" or \"fail\"");
  results.source.holds = root.at("verdict").text() == "pass";
  results.registered = root.at("registered").texts();
  if (const Field only = root.at("only"); only.is_present()) results.source.only = only.texts();
  std::set<std::string> ids;
  for (const Field& recorded : root.at("cases").elements()) {
    results.cases.push_back(case_from(recorded));
    results.cases.back().id = numbered(results.cases.back().id, ids);
  }
  return results;
}

std::string contents(const fs::path& file) {
  std::error_code none;
  if (fs::is_directory(file, none)) throw IoError(file.string() + ": is a folder; it must be a results.json");
  return read_text(file);
}

}  // namespace

const RecordedCase* find_case(const RecordedResults& results, const std::string& id) {
  const auto found =
      std::find_if(results.cases.begin(), results.cases.end(), [&](const RecordedCase& c) { return c.id == id; });
  return found == results.cases.end() ? nullptr : &*found;
}

RecordedResults read_results(const fs::path& file) {
  const std::string text = contents(file);
  if (text.empty()) throw InputError(file.string() + ": is empty; it must be a results.json that talus_verify wrote");
  nlohmann::json json;
  try {
    records::demand_shallow_json(text, file);
    json = nlohmann::json::parse(text);
  } catch (const records::RecordError& fault) {
    throw InputError(fault.what());
  } catch (const nlohmann::json::exception& fault) {
    const std::string message =
        records::json_fault(fault);  // "[json.exception.parse_error.101] parse error at line 1, ..."
    const auto start = message.find("] ");
    throw InputError(fmt::format("{}: is truncated or not JSON: {}", file.string(),
                                 start == std::string::npos ? message : message.substr(start + 2)));
  }
  return results_from(Field(&json, "", file), file);
}

}  // namespace talus::verification
