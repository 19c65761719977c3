#include "solver/io/output/write_geometry.hpp"

#include <fmt/compile.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "solver/io/file/atomic_file.hpp"
#include "solver/io/file/toml_document.hpp"
#include "solver/io/file/vtk_text.hpp"
#include "solver/io/output/run_folder.hpp"
#include "solver/model/outline.hpp"

namespace talus {
namespace {

/// Poly lines with their data, as text for a file.
class PolyLines {
 public:
  void add(Vec2 p, double z, long body) {
    fmt::format_to(fmt::appender{points_}, FMT_COMPILE("{} {} {}\n"), p.x, p.y, z);
    fmt::format_to(fmt::appender{connectivity_}, FMT_COMPILE("{} "), count_);
    fmt::format_to(fmt::appender{point_bodies_}, FMT_COMPILE("{} "), body);
    finite_ = finite_ && std::isfinite(p.x) && std::isfinite(p.y);
    ++count_;
  }
  /// Ends a line that consists of the points added since the line before.
  void end(long body, long cable, double tension, bool slack) {
    fmt::format_to(fmt::appender{offsets_}, FMT_COMPILE("{} "), count_);
    fmt::format_to(fmt::appender{bodies_}, FMT_COMPILE("{} "), body);
    fmt::format_to(fmt::appender{cables_}, FMT_COMPILE("{} "), cable);
    fmt::format_to(fmt::appender{tensions_}, FMT_COMPILE("{} "), tension);
    fmt::format_to(fmt::appender{slacks_}, FMT_COMPILE("{} "), slack ? 1 : 0);
    finite_ = finite_ && std::isfinite(tension);
    ++lines_;
  }
  bool finite() const { return finite_; }

  std::string xml() const {
    return vtk_text(
        {.points = count_,
         .verts = 0,
         .lines = lines_,
         .point_data = {{"Int32", "body", 1, view(point_bodies_)}},
         .cell_data = {{"Int32", "body", 1, view(bodies_)},
                       {"Int32", "cable", 1, view(cables_)},
                       {"Float64", "tension", 1, view(tensions_)},
                       {"UInt8", "slack", 1, view(slacks_)}},
         .coordinates = view(points_),
         .vert_arrays = {},
         .line_arrays = {{"Int64", "connectivity", 1, view(connectivity_)}, {"Int64", "offsets", 1, view(offsets_)}}});
  }

 private:
  static std::string_view view(const fmt::memory_buffer& text) { return {text.data(), text.size()}; }

  fmt::memory_buffer points_, connectivity_, point_bodies_, offsets_, bodies_, cables_, tensions_, slacks_;
  long count_{0}, lines_{0};
  bool finite_{true};
};

}  // namespace

GeometryText::GeometryText(const Dynamics& dynamics)
    : dynamics_{&dynamics}, along_(dynamics.model().bodies.size(), 0.0) {
  const Model& model = dynamics.model();
  for (const Joint& joint : dynamics.cables().joints()) {
    if (joint.on_body) along_[index(joint.body)] = joint.along;
  }
  double reach = 0.0;
  for (const Body& body : model.bodies)
    reach = std::max({reach, std::abs(body.p_WB.x), std::abs(body.p_WB.y)});
  for (const Body& body : model.bodies)
    outlines_.push_back(outline(body, 2.0 * reach));
}

std::optional<std::string> GeometryText::text(const Snapshot& snapshot) const {
  const Workspace& work = snapshot.geometry();
  const LawForces& forces = snapshot.forces();
  PolyLines lines;
  for (std::size_t i = 0; i < outlines_.size(); ++i) {
    const auto body = static_cast<long>(i);
    for (const Vec2 p : outlines_[i])
      lines.add(world_point(work.poses[i], p), along_[i], body);
    if (!outlines_[i].empty()) lines.end(body, -1, 0.0, false);
  }
  const CableForces& cables = dynamics_->cables();
  for (std::size_t c = 0; c < cables.size(); ++c) {
    for (const std::size_t j : {cables.ends()[c].a, cables.ends()[c].b}) {
      const Joint& joint = cables.joints()[j];
      const bool held = joint.on_body && (work.topology.broken.empty() || !work.topology.broken[j]);
      lines.add(work.joints.p_WP(j), joint.along, held ? static_cast<long>(index(joint.body)) : -1);
    }
    lines.end(-1, static_cast<long>(c), forces.tensions[c], forces.tensions[c] == 0.0);
  }
  if (!lines.finite()) return {};
  return lines.xml();
}

VtpSeries::VtpSeries(const Dynamics& dynamics, std::filesystem::path folder, std::string name, long every)
    : folder_{std::move(folder)}, name_{std::move(name)}, every_{every}, geometry_{dynamics} {
  std::error_code none;
  std::filesystem::remove(folder_ / (name_ + ".pvd"), none);
  make_folder(folder_ / (name_ + "_geometry"));
}

void VtpSeries::operator()(const Snapshot& snapshot, const StepInfo& info) {
  remove_stop();
  const bool due = info.step % every_ == 0;
  if (!due && !info.last) return;
  const std::optional<std::string> text = geometry_.text(snapshot);
  if (!text) return;
  const File file{snapshot.state().t, info.step};
  write_whole(folder_ / path(file), *text, Durability::later);
  if (due || !info.stop) return files_.push_back(file);
  of_stop_ = file;
}

void VtpSeries::remove_stop() {
  if (!of_stop_) return;
  std::error_code none;
  std::filesystem::remove(folder_ / path(*of_stop_), none);
  of_stop_.reset();
}

std::string VtpSeries::path(const File& file) const {
  return fmt::format("{0}_geometry/{0}_{1:08}.vtp", name_, file.step);
}

void VtpSeries::serialize(Archive& archive) {
  archive.count("every", every_);
  std::vector<double> times;
  for (const File& file : files_)
    times.push_back(file.time);
  archive.list("times", times);
  files_.resize(times.size());
  for (std::size_t i = 0; i < times.size(); ++i) {
    files_[i].time = times[i];
    archive.count(fmt::format("step_{}", i), files_[i].step);
  }
  // 0 means none: at step 0 a file is always due.
  long step = of_stop_ ? of_stop_->step : 0;
  archive.count("step_of_stop", step);
  if (archive.is_loading() && step > 0) of_stop_ = File{0.0, step};
}

void VtpSeries::bring_files(const std::filesystem::path& from) {
  for (const File& file : files_) {
    const std::string text = read_text(from / path(file));
    if (!std::filesystem::equivalent(from, folder_)) write_whole(folder_ / path(file), text);
  }
  remove_stop();
  // Removes the files that a killed run wrote after its last checkpoint.
  const std::filesystem::path geometry = folder_ / (name_ + "_geometry");
  remove_remains(geometry, [](std::string_view) { return true; });
  remove_files(geometry, [&](std::string_view name) {
    const std::string whole = fmt::format("{}_geometry/{}", name_, name);
    return names_geometry(name, name_) &&
           std::none_of(files_.begin(), files_.end(), [&](const File& file) { return path(file) == whole; });
  });
}

void VtpSeries::write_index() const {
  std::vector<std::pair<double, std::string>> files;
  for (const File& file : files_)
    files.emplace_back(file.time, path(file));
  if (of_stop_) files.emplace_back(of_stop_->time, path(*of_stop_));
  write_whole(folder_ / (name_ + ".pvd"), vtk_index(files), Durability::later);
}

}  // namespace talus
