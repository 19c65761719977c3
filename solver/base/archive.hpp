#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "solver/base/vec.hpp"

namespace talus {

/// Named lists of numbers and texts: the content of a checkpoint.
using ArchiveItems = std::map<std::string, std::variant<std::vector<double>, std::string>, std::less<>>;

/// Saves or restores the state that an object carries from one step of a run to the next. The object names each part
/// once, in a function `serialize(Archive&, ...)` that serves both directions:
///
///   void serialize(Archive& archive) { archive.number("internal_step", step_); archive.list("rates", rates_); }
///
/// Restored values are bit-identical to the saved ones. Errors when restoring: InputError naming the part, what was
/// found and what is allowed.
class Archive {
 public:
  /// An archive that saves.
  Archive() = default;
  /// An archive that restores. The items must outlive it.
  explicit Archive(const ArchiveItems& saved) : saved_{&saved} {}

  bool is_loading() const { return saved_ != nullptr; }
  /// The items saved so far.
  const ArchiveItems& items() const { return items_; }
  /// Names of the items that have not been restored; empty when saving.
  std::vector<std::string> left_over() const;

  void number(std::string_view name, double& value) { numbers(name, {&value, 1}); }
  /// A whole number from 0 to 2^53.
  void count(std::string_view name, long& value);
  void flag(std::string_view name, bool& value);
  /// Exactly values.size() numbers: the object determines the count, not the file.
  void numbers(std::string_view name, std::span<double> values);
  void numbers(std::string_view name, std::span<std::uint16_t> values);
  /// A list of any length.
  void list(std::string_view name, std::vector<double>& values);
  /// The components of a vector.
  void vector(std::string_view name, Vec2& value);
  void vector(std::string_view name, Vec3& value);
  void text(std::string_view name, std::string& value);

  /// Calls `visit`; the names of the parts that it serializes get the prefix "name.".
  template <class Visit>
  void scope(std::string_view name, Visit&& visit) {
    const std::size_t length = prefix_.size();
    prefix_.append(name).append(".");
    visit();
    prefix_.resize(length);
  }

 private:
  std::string full_name(std::string_view name) const { return prefix_ + std::string{name}; }
  template <class Kind>
  const Kind& saved(std::string_view name, std::string_view kind);
  void demand_whole(std::string_view name, double value, double largest) const;

  const ArchiveItems* saved_{nullptr};
  ArchiveItems items_;  ///< saved so far; when restoring, the names of the items restored so far
  std::string prefix_;
};

}  // namespace talus
