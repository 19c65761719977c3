#pragma once

#include "solver/app/outputs/run_output.hpp"
#include "solver/io/file/atomic_file.hpp"
#include "solver/io/output/write_sheet.hpp"

namespace talus::app {

/// sheet.json: the data of a fence's engineer's sheet, from which draw_sheet() makes sheet.pdf and sheet.html.
class SheetOutput {
 public:
  static constexpr std::string_view name = "sheet";
  static constexpr std::array<std::string_view, 3> fixed_files{"sheet.json", "sheet.pdf", "sheet.html"};

  explicit SheetOutput(const OutputRequest& request)
      : file_{request.folder / "sheet.json"}, input_{&*request.file.fence}, dynamics_{&request.dynamics} {}

  static std::optional<SheetOutput> make(const OutputRequest& request) {
    if (!request.options.sheet || !request.file.fence) return std::nullopt;
    return SheetOutput{request};
  }
  void write(const OutputSource& source) const {
    write_whole(file_, sheet_json(source.record, *input_, *dynamics_, *source.fence, source.end.state()),
                Durability::later);
  }

 private:
  std::filesystem::path file_;
  const FenceInput* input_;
  const Dynamics* dynamics_;
};

}  // namespace talus::app
