#pragma once

#include <filesystem>
#include <vector>

#include "solver/base/vec.hpp"

namespace talus {

/// One file of a geometry series, as listed in its index.
struct GeometryFile {
  double time{};  ///< [T]
  std::filesystem::path path;
};

/// The outline of a body, or a cable, at one time; bodies and cables are numbered from 0 in the model's order.
struct GeometryLine {
  long body{-1};             ///< of an outline; -1 for a cable
  long cable{-1};            ///< of a cable; -1 for an outline
  double tension{};          ///< of a cable [F]
  bool slack{};              ///< a cable without tension
  std::vector<Vec3> points;  ///< z along the fence [L]; an outline is closed by its first point, except a half-plane's
  std::vector<long> bodies;  ///< of each point: its body, -1 for the world
};

/// All outlines and cables at one time.
struct GeometryFrame {
  double time{};
  std::vector<GeometryLine> lines;
};

/// A disc at one time.
struct SeenDisc {
  Vec2 p;           ///< position of its centre [L]
  double radius{};  ///< [L]
  Vec2 v;           ///< [L/T]
  bool wall{};      ///< belongs to a wall
};

/// Two discs in contact.
struct SeenContact {
  std::size_t a{}, b{};  ///< their indices in the list of discs
  Vec2 from, to;         ///< centre of a, and of b or its image in contact [L]
  double force{};        ///< [F]
};

/// All discs and contacts at one time.
struct DiscFrame {
  double time{};
  std::vector<SeenDisc> discs;
  std::vector<SeenContact> contacts;
};

/// Reads the index NAME.pvd that VtpSeries and vtk_index write: its files in the order of time. Errors: IoError;
/// InputError with the file and the error in it.
[[nodiscard]] std::vector<GeometryFile> read_geometry_index(const std::filesystem::path& file);

/// Reads one file of the series. Errors: as read_geometry_index.
[[nodiscard]] GeometryFrame read_geometry(const GeometryFile& file);

/// Reads one file of a series of discs, as cell_state_vtp writes it. Errors: as read_geometry_index.
[[nodiscard]] DiscFrame read_discs(const GeometryFile& file);

}  // namespace talus
