#pragma once

#include "solver/app/outputs/run_output.hpp"
#include "solver/io/fence1993/out_listing.hpp"
#include "solver/io/file/atomic_file.hpp"

namespace talus::app {

/// NAME.OUT: the listing of the 1993 program, for a fence.
class ListingOutput {
 public:
  static constexpr std::string_view name = "listing";
  static constexpr std::array<std::string_view, 0> fixed_files{};

  explicit ListingOutput(const OutputRequest& request)
      : file_{request.folder / (request.name + ".OUT")},
        listing_{request.file.fence->fence, request.file.fence->made, request.file.scene.plan} {}

  static std::optional<ListingOutput> make(const OutputRequest& request) {
    if (!request.file.fence) return std::nullopt;
    return ListingOutput{request};
  }
  void operator()(const Snapshot& snapshot, const StepInfo& info) { listing_(snapshot.state(), info); }
  void write(const OutputSource&) const { write_whole(file_, listing_.text(), Durability::later); }
  std::vector<std::string> files() const { return {file_.filename().string()}; }
  void serialize(Archive& archive) { listing_.serialize(archive); }

 private:
  std::filesystem::path file_;
  OutListing listing_;
};

}  // namespace talus::app
