#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "solver/app/sweep/sweep_file.hpp"
#include "solver/app/sweep/swept_cell.hpp"
#include "solver/app/sweep/swept_scene.hpp"

namespace talus::app {

/// What the runs of a sweep change, a scene of bodies or a shear cell, and the numbers that are read of each run.
class SweepBase {
 public:
  /// Without outputs; `name` is the file named in errors. Errors: InputError for a scene or cell that is wrong.
  SweepBase(TomlValue document, std::string name);

  /// Takes these outputs in place of others. `where` begins errors: InputError for outputs that the base does not have.
  void choose(std::vector<std::string> outputs, std::string_view where = "outputs");

  const TomlValue& document() const;
  /// The outputs, with names and dimensions.
  const std::vector<SweepOutput>& outputs() const;
  const UnitSystem& units() const;
  bool is_fence() const;

  /// Errors: InputError for an axis whose field the base does not have, or of whole numbers whose field takes other
  /// numbers, too, in this run: of such a field `range = [0, 1]` hardly means two values; and for two names of a field.
  void check_axes(const SweepFile& sweep, const SweptRun& run) const;

  /// Time at which a run is planned to end [T]. Errors: InputError for a wrong field or value.
  [[nodiscard]] double end(const SweptRun& run) const;

  /// The parameter of a run that alone is refused with this reason; nothing if only several together are.
  [[nodiscard]] std::optional<std::size_t> refused_parameter(const SweptRun& run, std::string_view reason) const;

  /// Executes a run as `talus run` or `talus cell` does, without files. `interrupted` is called at intervals of at most
  /// 128 steps of a scene, or of half a contact of a cell; if it is true, the run has no result, and its id is empty.
  [[nodiscard]] SweepResult result(const SweptRun& run, const SweepLimits& limits,
                                   const std::function<bool()>& interrupted) const;

 private:
  std::variant<SweptScene, SweptCell> swept_;
};

/// The text of a scene, cell or deck of 1993 as TOML. `where` names the field that gives the file, if one does. Errors:
/// IoError that begins with `where`; InputError for a wrong deck, or for CNTRL.DAT, which has no units.
[[nodiscard]] std::string base_text(const std::filesystem::path& file, std::string_view where = {});

}  // namespace talus::app
