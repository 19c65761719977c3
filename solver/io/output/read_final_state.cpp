#include "solver/io/output/read_final_state.hpp"

#include <fmt/format.h>

#include "solver/base/error.hpp"
#include "solver/io/file/json_text.hpp"
#include "verification/record/json_fault.hpp"
#include "verification/record/json_node.hpp"

namespace talus {
namespace {

InputError not_a_state(const std::filesystem::path& file, std::string_view reason) {
  return InputError{fmt::format("{}: it is not the final state of a run: {}", file.string(), reason)};
}

}  // namespace

std::vector<scenes::StretchedCable> read_stretched_cables(const std::filesystem::path& folder,
                                                          const UnitSystem& units) {
  const std::filesystem::path file = folder / "final_state.json";
  const std::string text = read_json_text(file);
  std::vector<scenes::StretchedCable> stretched;
  try {
    const auto json = records::Json::parse(text);
    const records::Node state{json, "state"};
    // What is read here has the same names in both; schema 2 renamed the reason of a run that diverged.
    if (const records::Json& schema = state.at("schema").json(); schema != 1 && schema != 2) {
      throw InputError{fmt::format(
          "schema: found {}; it must be 1 or 2: run the fence again with this version of talus", schema.dump())};
    }
    if (const std::string system = state.at("units").at("system").text(); system != units.name) {
      throw InputError{fmt::format("units: found \"{}\"; they must be \"{}\", the fence's", system, units.name)};
    }
    for (const char* const kind : {"cable", "hanger"}) {
      for (const records::Node& part : state.at(fmt::format("{}s", kind).c_str()).list()) {
        const std::string name = part.at("name").text();
        if (part.at("mode").text() == "broken") {
          throw InputError{fmt::format("{} '{}': found it broken; broken parts cannot be carried over", kind, name)};
        }
        if (const double stretch = part.at("plastic_stretch").number(); stretch > 0.0)
          stretched.push_back({name, stretch});
      }
    }
  } catch (const InputError& error) {
    throw InputError{fmt::format("{}: {}", file.string(), error.what())};
  } catch (const records::RecordError& error) {
    throw not_a_state(file, error.what());
  } catch (const records::Json::exception& error) {
    throw not_a_state(file, records::json_fault(error));
  }
  return stretched;
}

}  // namespace talus
