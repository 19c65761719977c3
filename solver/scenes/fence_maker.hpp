#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "solver/base/error.hpp"
#include "solver/model/model_builder.hpp"
#include "solver/scenes/fence_element.hpp"
#include "solver/scenes/fence_scene.hpp"

namespace talus::scenes {

/// Prefix of the names of a layer's parts.
inline std::string prefix(int layer) { return layer == 1 ? "" : "back_"; }

/// Builds the scene of one fence.
class FenceMaker {
 public:
  explicit FenceMaker(const Fence& fence);

  FenceScene make();

 private:
  /// One column, as suspended from the top cable.
  struct Column {
    BodyId body{};
    std::string number;  ///< number in names: its position from 1, with a minus on the other side
    int position{};      ///< position from the centre outwards, from 0
    double along{};      ///< position along the fence [L]
    double height{};     ///< of its centroid, y [L]
    double mass{};       ///< of the body: doubled where one body represents two columns
    double inertia{};
    int multiplicity{1};
    bool struck{};  ///< is in front of a rock
  };
  double column_weight() const { return mass_properties(fence_.column).mass * fence_.gravity; }
  bool full() const { return fence_.options.symmetry == FenceSymmetry::full; }
  bool even() const { return fence_.columns % 2 == 0; }
  bool doubled() const { return even() && !full() && fence_.options.even_centre == EvenCentre::doubled; }

  NodeDepth node_depth(NodeDepth of_1993) const {
    return fence_.options.contact == FenceContact::smoother ? NodeDepth::smoother : of_1993;
  }

  void add_ground();

  void add_rocks();

  ChangedColumn column(int position) const;
  bool meets(const FenceElement& rock, const Column& column) const;
  void add_layer(int layer);
  void add_segments(int layer, bool top, const StaticShape& shape, const std::vector<std::array<std::size_t, 2>>& hung);
  void add_hangers(int layer);
  void add_member(int layer, const Column& column, const ChangedColumn& changed, Vec2 position, double angle);
  CableId add_cable(const std::string& name, CableEnd a, CableEnd b, double stiffness, double rest_length, bool top);
  void add_contacts();
  void add_rock_contacts(std::size_t i);
  void add_rock_pairs();
  void add_column_pairs();
  void add_columns_on_ground();
  FenceContactLaw contact_law(double mass, double factor, double overlap, double damped_mass,
                              double Fence::*allowed = &Fence::penetration) const;
  double damped_mass(std::size_t rock, const Column& column) const;
  Contact contact(std::string name, BodyId a, BodyId b, FenceContactLaw law) const;
  void check_stretched() const;
  void hang_sides(Model& model) const;
  Model hung(Model model);
  Model balanced(Model model) const;
  void plan();
  void kick_half_a_step();

  const Fence& fence_;
  ModelBuilder builder_;
  FenceScene made_;
  double speed_{};
  double first_stiffness_{};
  BodyId ground_{};
  std::vector<BodyId> rocks_;
  std::vector<double> rock_masses_;
  std::vector<std::vector<Column>> layers_;  ///< columns of each layer, from the centre outwards
};

}  // namespace talus::scenes
