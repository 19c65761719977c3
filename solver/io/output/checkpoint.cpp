#include "solver/io/output/checkpoint.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>

#include "solver/base/error.hpp"
#include "solver/io/file/json_text.hpp"
#include "verification/record/json_fault.hpp"
#include "verification/record/json_number.hpp"

namespace talus {
namespace {

constexpr int schema = 4;
constexpr std::string_view hash_line = "\"fnv1a\": ";

nlohmann::json item(const std::vector<double>& numbers) {
  nlohmann::json list = nlohmann::json::array();
  for (const double value : numbers)
    list.push_back(nlohmann::json(records::json_number(value)));
  return list;
}

nlohmann::json item(const std::string& text) { return text; }

/// Reads fields of the file. Errors: InputError naming file, field, what was found and what is allowed.
class Reader {
 public:
  Reader(const std::filesystem::path& file, const nlohmann::json& json) : file_{file}, json_{json} {}

  [[noreturn]] void refuse(std::string_view field, std::string_view found, std::string_view allowed) const {
    throw InputError{fmt::format("{}: {}: found {}; it must be {}", file_.string(), field, found, allowed)};
  }

  const nlohmann::json& member(std::string_view field, std::string_view allowed) const {
    const auto found = json_.find(field);
    if (found == json_.end()) refuse(field, "nothing", allowed);
    return *found;
  }
  std::string text(std::string_view field) const {
    const nlohmann::json& value = member(field, "a text");
    if (!value.is_string()) refuse(field, value.dump(), "a text");
    return value.get<std::string>();
  }
  double quantity(std::string_view field, bool zero_allowed) const {
    const std::string_view allowed = zero_allowed ? "a number >= 0" : "a number > 0";
    const nlohmann::json& value = member(field, allowed);
    const double number = value.is_number() ? value.get<double>() : -1.0;
    if (number < 0.0 || (number == 0.0 && !zero_allowed)) refuse(field, value.dump(), allowed);
    return number;
  }
  long steps() const {
    constexpr std::string_view allowed = "a whole number from 0 to 2^53";
    const nlohmann::json& value = member("steps", allowed);
    if (!value.is_number_unsigned() || value.get<std::uint64_t>() > 1ULL << 53) refuse("steps", value.dump(), allowed);
    return value.get<long>();
  }
  ArchiveItems memory() const {
    ArchiveItems items;
    for (const auto& [name, value] : member("memory", "a table of lists and texts").items()) {
      if (value.is_string()) {
        items.emplace(name, value.get<std::string>());
        continue;
      }
      if (!value.is_array()) refuse("memory: " + name, value.dump(), "a list of numbers or a text");
      std::vector<double> numbers;
      for (const nlohmann::json& element : value)
        numbers.push_back(list_number(fmt::format("memory: {}[{}]", name, numbers.size()), element));
      items.emplace(name, std::move(numbers));
    }
    return items;
  }

 private:
  double list_number(const std::string& field, const nlohmann::json& element) const {
    const std::optional<double> number = records::number_of(element);
    if (!number) refuse(field, element.dump(), "a number");
    return *number;
  }

  const std::filesystem::path& file_;
  const nlohmann::json& json_;
};

}  // namespace

std::string fnv1a(std::string_view text) {
  std::uint64_t hash = 14695981039346656037ULL;
  for (const char c : text)
    hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211ULL;
  return fmt::format("{:016x}", hash);
}

std::string checkpoint_text(const Checkpoint& checkpoint, std::string_view program) {
  std::string text = "{\n";
  const auto member = [&text](std::string_view name, const nlohmann::json& value) {
    text += fmt::format("{}: {},\n", nlohmann::json(name).dump(), value.dump());
  };
  member("schema", schema);
  member("talus", program);
  member("scene_file", checkpoint.scene_file);
  member("scene_fnv1a", checkpoint.scene_fnv1a);
  member("integrator", checkpoint.integrator);
  member("tolerance", checkpoint.tolerance);
  member("step", checkpoint.step);
  member("end", checkpoint.end);
  member("steps", checkpoint.steps);
  text += "\"memory\": {\n";
  std::string_view separator;
  for (const auto& [name, value] : checkpoint.memory) {
    const nlohmann::json written = std::visit([](const auto& kept) { return item(kept); }, value);
    text += fmt::format("{}{}: {}", separator, nlohmann::json(name).dump(), written.dump());
    separator = ",\n";
  }
  text += "\n},\n";
  return text + fmt::format("{}\"{}\"\n}}\n", hash_line, fnv1a(text));
}

Checkpoint read_checkpoint(const std::filesystem::path& file, std::string_view program) {
  const std::string content = read_json_text(file);
  const auto fail = [&](std::string_view reason) {
    throw InputError{
        fmt::format("{}: {}; it must be a checkpoint that talus wrote, whole: was it cut short or changed?",
                    file.string(), reason)};
  };
  nlohmann::json json;
  try {
    json = nlohmann::json::parse(content);
  } catch (const nlohmann::json::exception& error) {
    fail(records::json_fault(error));
  }
  if (!json.is_object()) fail(fmt::format("found {} instead of an object", json.type_name()));
  const Reader reader{file, json};
  const auto demand = [&](std::string_view field, const nlohmann::json& allowed, std::string_view remedy = "") {
    const std::string allowed_text = fmt::format("{}{}", allowed.dump(), remedy);
    if (const nlohmann::json& found = reader.member(field, allowed_text); found != allowed)
      reader.refuse(field, found.dump(), allowed_text);
  };
  demand("schema", schema, ": resume the run with the version of talus that wrote it, or run the scene again");
  demand("talus", program);
  demand("fnv1a", fnv1a(std::string_view{content}.substr(0, content.rfind(hash_line))),
         ", the hash of the lines above it: they were changed; run the scene again");
  return {.scene_file = reader.text("scene_file"),
          .scene_fnv1a = reader.text("scene_fnv1a"),
          .integrator = reader.text("integrator"),
          .tolerance = reader.quantity("tolerance", true),
          .step = reader.quantity("step", false),
          .end = reader.quantity("end", false),
          .steps = reader.steps(),
          .memory = reader.memory()};
}

}  // namespace talus
