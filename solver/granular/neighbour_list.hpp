#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "solver/granular/discs.hpp"
#include "solver/granular/periodic_box.hpp"

namespace talus {

/// Brings discs back into the box [-width/2, width/2) x [-height/2, height/2), from whichever image they are in; what
/// crosses the border to a box that slides takes its speed. Along what does not repeat nothing moves.
void wrap(const PeriodicBox& box, Discs& discs);

/// Pairs of discs whose surfaces are nearer than the skin, each with the image of its second disc that is the near one:
/// valid until their surfaces may have come together from further away. (Verlet 1967; by cells, Hockney & Eastwood
/// 1981.) Pairs stand in the order of their first disc, then of their second, whatever order the cells are in, so that
/// sums over them do not depend on when the list was made.
class NeighbourList {
 public:
  /// skin [L] >= 0
  NeighbourList(PeriodicBox box, double skin) : box_{box}, skin_{skin} {}

  const PeriodicBox& box() const { return box_; }
  double skin() const { return skin_; }

  /// Lists the pairs of which at least one disc can move. Errors: InputError if a period is shorter than the discs
  /// and the skin need so that no disc meets two images of another.
  void build(const DiscShapes& shapes, const Discs& discs);

  /// The rest of the skin after a step in which no pair has come nearer by more than this [L]; the list is to be built
  /// anew once nothing is left.
  bool valid() const { return used_ <= skin_; }
  void use(double approach) { used_ += approach; }

  std::size_t size() const { return second_.size(); }
  std::size_t discs() const { return first_.empty() ? 0 : first_.size() - 1; }
  /// Pairs of one first disc: [begin, end).
  std::size_t begin(std::size_t disc) const { return first_[disc]; }
  std::size_t end(std::size_t disc) const { return first_[disc + 1]; }
  std::size_t second(std::size_t pair) const { return second_[pair]; }
  /// Of the second disc of a pair, which of nine images.
  std::uint8_t image(std::size_t pair) const { return image_[pair]; }
  /// The pair of two discs, the first of smaller number; size() if it is not listed.
  std::size_t find(std::size_t first, std::size_t second) const;

  /// By image: how far it is shifted [L], and how much faster it moves [L/T].
  struct Shift {
    double x{}, y{}, vx{};
  };
  static constexpr std::size_t images = 9;
  void shifts(double t, std::span<Shift, images> out) const;

 private:
  void check_periods(double reach) const;

  PeriodicBox box_;
  double skin_;
  double used_{};
  double built_{};   ///< when [T]
  double offset_{};  ///< of the boxes above and below then [L]; goes on without a jump
  std::vector<std::size_t> first_;
  std::vector<std::uint32_t> second_;
  std::vector<std::uint8_t> image_;
};

}  // namespace talus
