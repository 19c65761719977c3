#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "solver/base/thread_pool.hpp"
#include "solver/base/vec.hpp"
#include "solver/granular/discs.hpp"
#include "solver/granular/periodic_box.hpp"

namespace talus {

/// Moves discs from whichever image they are in back into the box, from -width/2 to width/2 and -height/2 to height/2.
/// A disc that crosses the border to a sliding box changes its velocity by the box's. Directions that are not periodic
/// are left unchanged.
void wrap(const PeriodicBox& box, Discs& discs);

/// Pairs of discs whose surfaces are nearer than a law's reach plus the skin, each with the nearest image of its second
/// disc. The list is valid until surfaces that were further apart may have come within the reach. (Verlet 1967; by
/// cells, Hockney & Eastwood 1981.) Pairs are sorted by their first disc, then by their second, whatever the order of
/// the cells, so that sums over them do not depend on when the list was built.
class NeighbourList {
 public:
  /// skin [L] >= 0; law_reach [L] >= 0: largest gap at which surfaces act on each other.
  NeighbourList(PeriodicBox box, double skin, double law_reach = 0.0)
      : box_{box}, skin_{skin}, margin_{law_reach + skin} {}

  const PeriodicBox& box() const { return box_; }
  /// Upper bound of the distance of two listed centres when the list was built [L].
  double reach() const { return reach_; }

  /// Lists the pairs of which at least one disc can move; discs must be in the box (wrap()). A pool's threads build the
  /// same list. Errors: InputError if a period is shorter than the discs and the skin require so that no disc meets two
  /// images of another.
  void build(const DiscShapes& shapes, const Discs& discs, ThreadPool* pool = nullptr);

  /// Serializes the data from which loading rebuilds the same list. Errors: as build().
  void serialize(Archive& archive, const DiscShapes& shapes);

  /// A mean flow (x + rate y, y) [L/T] that neighbouring discs share. A disc's own velocity is relative to it.
  struct Flow {
    double x{}, y{};
    double rate{};  ///< [1/T]

    double own_speed_squared(Vec2 v, double at_y) const {
      const double own_x = v.x - (x + rate * at_y), own_y = v.y - y;
      return own_x * own_x + own_y * own_y;
    }
  };
  /// Mean flow of the discs when the list was built. Its rate is that of the box if this is periodic along y (zero if
  /// it does not slide), else fitted to the discs.
  const Flow& flow() const { return flow_; }
  /// Upper bound of the approach of any listed pair in a drift over h [L]. fastest: largest squared speed relative to
  /// flow().
  double approach(double h, double fastest) const {
    return std::abs(h) * (2.0 * std::sqrt(fastest) + std::abs(flow_.rate) * reach_);
  }
  /// Reduces the unused skin by an upper bound of the approach of any pair in a step [L].
  void use(double approach) { used_ += approach; }
  /// Unused part of the skin [L].
  double left() const { return skin_ - used_; }
  /// Whether the skin may be used up; holds() then decides.
  bool may_end() const { return used_ > (1.0 - round_off) * skin_; }
  /// Whether the list is still valid: no unlisted pair can touch. The summed approach of the steps exceeds the
  /// displacement of discs that move to and fro. Once it exceeds the skin it is replaced by a bound from the actual
  /// displacements since the build, provided that this leaves enough skin for some steps.
  bool holds(const Discs& discs);

  std::size_t size() const { return second_.size(); }
  std::size_t discs() const { return first_.empty() ? 0 : first_.size() - 1; }
  /// Pairs of one first disc: [begin, end).
  std::size_t begin(std::size_t disc) const { return first_[disc]; }
  std::size_t end(std::size_t disc) const { return first_[disc + 1]; }
  std::size_t second(std::size_t pair) const { return second_[pair]; }
  /// Code of the second disc's image, one of nine.
  std::uint8_t image(std::size_t pair) const { return image_[pair]; }
  /// Index of the pair of two discs, first < second; size() if it is not listed.
  std::size_t find(std::size_t first, std::size_t second) const;

  /// Shift of an image [L], and its additional velocity [L/T].
  struct Shift {
    double x{}, y{}, vx{};
  };
  static constexpr std::size_t images = 9;
  /// Shifts of all images, by their codes; shear_displacement: Discs::shear_displacement at present.
  void shifts(double shear_displacement, std::span<Shift, images> out) const;

  /// Calls visit(first, second, pair, d, shift) for the pairs at the present positions: d from the first disc to the
  /// image of the second [L], shift that of the image.
  template <class Visit>
  void for_each_pair(const Discs& discs, Visit&& visit) const {
    std::array<Shift, images> by_image;
    shifts(discs.shear_displacement, by_image);
    for (std::size_t a = 0; a < this->discs(); ++a) {
      for (std::size_t pair = begin(a); pair < end(a); ++pair) {
        const std::size_t b = second(pair);
        const Shift& shift = by_image[image(pair)];
        visit(a, b, pair, Vec2{(discs.x[b] + shift.x) - discs.x[a], (discs.y[b] + shift.y) - discs.y[a]}, shift);
      }
    }
  }

 protected:
  std::vector<double> x_, y_;  ///< positions of the discs when the list was built [L]
  std::vector<std::uint32_t> first_;
  std::vector<std::uint32_t> second_;
  std::vector<std::uint8_t> image_;

 private:
  void check_periods() const;
  void find_pairs(const DiscShapes& shapes, const Discs& discs, ThreadPool* pool);
  double furthest(const Discs& discs) const;
  void find_flow(const Discs& discs);

  static constexpr double round_off = 1e-9;  ///< rounding allowance of summed displacements, over the skin
  static constexpr double worn = 0.9;        ///< used fraction of the skin at which the list is rebuilt

  PeriodicBox box_;
  double skin_;
  double margin_;  ///< largest gap of listed pairs: law_reach + skin [L]
  double reach_{};
  double used_{};
  double shear_displacement_{};  ///< Discs::shear_displacement when the list was built [L]
  double offset_{};              ///< of the boxes above and below then [L]; later offsets continue it without jumps
  Flow flow_;
};

}  // namespace talus
