#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "verification/check/case.hpp"
#include "verification/problems/program/scenes/toml_values.hpp"
#include "verification/study/program/program_run.hpp"

/// A scene whose parts yield, break, rebound and slide; part of the case `scene_fields`.
namespace talus::verification::problems::scene_fields {

/// The numbers of a scene, as written: "box.mass", "rope.to.point[2]".
class Written {
 public:
  explicit Written(const std::string& scene) {
    const std::vector<TomlValue> values = toml_values(scene);
    std::map<std::string, std::string> names;  // of the tables: "body[3]" is the box
    for (const TomlValue& value : values)
      if (value.key.ends_with(".name")) names[value.key.substr(0, value.key.size() - 5)] = value.text;
    for (const TomlValue& value : values) {
      const std::size_t dot = value.key.find('.');
      const auto name = names.find(value.key.substr(0, dot));
      const std::string key = name == names.end() ? value.key : name->second + value.key.substr(dot);
      if (value.number) numbers_[key] = *value.number;
      if (name != names.end() && value.key.starts_with("body")) bodies_.insert(name->second);
    }
  }
  /// Zero for a field that is not written.
  double operator()(const std::string& key) const {
    const auto found = numbers_.find(key);
    return found == numbers_.end() ? 0.0 : found->second;
  }
  const std::set<std::string>& bodies() const { return bodies_; }

 private:
  std::map<std::string, double> numbers_;
  std::set<std::string> bodies_;
};

/// Runs the moving scene, and compares its final state, its history and its events with closed forms.
void check_moving(const TemporaryFolder& folder, Findings& findings, const Setup& setup);

}  // namespace talus::verification::problems::scene_fields
