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

/// Numbers and texts by name: what a checkpoint holds.
using ArchiveItems = std::map<std::string, std::variant<std::vector<double>, std::string>, std::less<>>;

/// One pass over what an object carries from one step of a run to the next. The object names each part once, in a
/// function `remember(Archive&, ...)`, and the pass either saves the parts or puts saved ones back:
///
///   void remember(Archive& archive) { archive.number("internal_step", step_); archive.list("rates", rates_); }
///
/// What is put back is bit for bit what was saved. Errors when putting back: InputError naming the part, what was
/// found and what is allowed.
class Archive {
 public:
  /// A pass that saves.
  Archive() = default;
  /// A pass that puts back. The items must outlive it.
  explicit Archive(const ArchiveItems& saved) : saved_{&saved} {}

  bool is_loading() const { return saved_ != nullptr; }
  /// What a pass that saves has collected.
  const ArchiveItems& items() const { return items_; }
  /// Items that a pass that puts back was not asked for.
  std::vector<std::string> left_over() const;

  void number(std::string_view name, double& value) { numbers(name, {&value, 1}); }
  /// A whole number >= 0, below 2^53.
  void count(std::string_view name, long& value);
  void flag(std::string_view name, bool& value);
  /// As many numbers as there is room for: the count is the object's, not the file's.
  void numbers(std::string_view name, std::span<double> values);
  void numbers(std::string_view name, std::span<std::uint16_t> values);
  /// Numbers of any count.
  void list(std::string_view name, std::vector<double>& values);
  /// The components of a vector.
  void vector(std::string_view name, Vec2& value);
  void vector(std::string_view name, Vec3& value);
  void text(std::string_view name, std::string& value);

  /// A scope: `visit` names its parts, and "name." goes in front.
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
  ArchiveItems items_;  ///< saved, or put back so far
  std::string prefix_;
};

}  // namespace talus
