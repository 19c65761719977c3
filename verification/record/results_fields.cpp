#include "verification/record/results_fields.hpp"

#include <algorithm>
#include <set>

namespace talus::records {
namespace {

void demand_once(const Node& node, const char* key, const std::vector<std::string>& ids) {
  const std::set<std::string> distinct(ids.begin(), ids.end());
  if (distinct.size() != ids.size()) node.at(key).fail("names a case twice");
}

}  // namespace

void demand_sound(const Node& node, const Provenance& provenance) {
  try {
    static_cast<void>(epoch_seconds(provenance.date));
  } catch (const RecordError& wrong) {
    node.at("date").fail(wrong.what());
  }
}

void demand_sound(const Node& node, const Results& results) {
  demand_once(node, "registered", results.registered);
  demand_once(node, "selected", results.selected);
  const auto among = [](const std::vector<std::string>& ids, const std::string& id) {
    return std::find(ids.begin(), ids.end(), id) != ids.end();
  };
  for (const std::string& id : results.selected) {
    if (!among(results.registered, id)) node.at("selected").fail(fmt::format("'{}' is not registered", id));
    const auto named = [&](const Record& record) { return record.id == id; };
    const auto count = std::count_if(results.records.begin(), results.records.end(), named);
    if (count != 1) node.at("cases").fail(fmt::format("selected case '{}' has {} records", id, count));
  }
  for (const Record& record : results.records) {
    if (!among(results.selected, record.id))
      node.at("cases").fail(fmt::format("'{}' was not registered and selected", record.id));
    if (!record.family.empty() && !among(results.families, record.family)) {
      node.at("cases").fail(fmt::format("case '{}' is of family '{}', which is not listed; listed: {}", record.id,
                                        record.family, fmt::join(results.families, ", ")));
    }
  }
}

}  // namespace talus::records
