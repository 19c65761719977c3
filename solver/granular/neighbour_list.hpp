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

/// Brings discs back into the box, from -width/2 to width/2 and -height/2 to height/2, from whichever image they are
/// in; what crosses the border to a box that slides takes its speed. Along what does not repeat nothing moves.
void wrap(const PeriodicBox& box, Discs& discs);

/// Pairs of discs whose surfaces are nearer than a law's reach and the skin, each with the image of its second disc
/// that is the near one: valid until surfaces from further away may have come within the reach. (Verlet 1967; by cells,
/// Hockney & Eastwood 1981.) Pairs stand in the order of their first disc, then of their second, whatever order the
/// cells are in, so that sums over them do not depend on when the list was made.
class NeighbourList {
 public:
  /// skin [L] >= 0; law_reach [L] >= 0: how far apart surfaces may be where they act on each other.
  NeighbourList(PeriodicBox box, double skin, double law_reach = 0.0)
      : box_{box}, skin_{skin}, margin_{law_reach + skin} {}

  const PeriodicBox& box() const { return box_; }
  /// No two centres that are listed were further apart when it was built [L].
  double reach() const { return reach_; }

  /// Lists the pairs of which at least one disc can move, of discs in the box (wrap()). Errors: InputError if a period
  /// is shorter than the discs and the skin need so that no disc meets two images of another. With a team by its
  /// threads, the same list.
  void build(const DiscShapes& shapes, const Discs& discs, ThreadPool* pool = nullptr);

  /// Names what the list is made of. The list that is put back is the one that was saved. Errors: as build().
  void serialize(Archive& archive, const DiscShapes& shapes);

  /// A mean flow (x + rate y, y) [L/T] that discs near each other share: what they move from it is their own.
  struct Flow {
    double x{}, y{};
    double rate{};  ///< [1/T]

    double own_speed_squared(Vec2 v, double at_y) const {
      const double own_x = v.x - (x + rate * at_y), own_y = v.y - y;
      return own_x * own_x + own_y * own_y;
    }
  };
  /// That of the discs when the list was built; where the box slides, with its rate, and where it repeats up and down
  /// without sliding, with none.
  const Flow& flow() const { return flow_; }
  /// No listed pair comes nearer by more in a drift over h [L], if this is the largest square of an own speed.
  double approach(double h, double fastest) const {
    return std::abs(h) * (2.0 * std::sqrt(fastest) + std::abs(flow_.rate) * reach_);
  }
  /// Takes from the skin that no pair has come nearer by more than this in a step [L].
  void use(double approach) { used_ += approach; }
  /// The rest of the skin [L].
  double left() const { return skin_ - used_; }
  /// Whether it may be used up; then holds() tells.
  bool may_end() const { return used_ > (1.0 - round_off) * skin_; }
  /// Whether still no pair that is not listed can touch. What the steps add up to is more than what discs that are hit
  /// to and fro have moved: once it exceeds the skin it gives way to how far the discs are from where they were, as
  /// long as that leaves enough for some steps.
  bool holds(const Discs& discs);

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

  /// By image: how far it is shifted [L], and how much faster it moves [L/T]. `slid`: that of the discs now.
  struct Shift {
    double x{}, y{}, vx{};
  };
  static constexpr std::size_t images = 9;
  void shifts(double slid, std::span<Shift, images> out) const;

  /// Calls visit(first, second, pair, d, shift) for the pairs as the discs stand now: d from the first to the image of
  /// the second [L], whose shift that is.
  template <class Visit>
  void for_each_pair(const Discs& discs, Visit&& visit) const {
    std::array<Shift, images> by_image;
    shifts(discs.slid, by_image);
    for (std::size_t a = 0; a < this->discs(); ++a) {
      for (std::size_t pair = begin(a); pair < end(a); ++pair) {
        const std::size_t b = second(pair);
        const Shift& shift = by_image[image(pair)];
        visit(a, b, pair, Vec2{(discs.x[b] + shift.x) - discs.x[a], (discs.y[b] + shift.y) - discs.y[a]}, shift);
      }
    }
  }

 protected:
  std::vector<double> x_, y_;  ///< of the discs when it was built [L]
  std::vector<std::uint32_t> first_;
  std::vector<std::uint32_t> second_;
  std::vector<std::uint8_t> image_;

 private:
  void check_periods() const;
  void find_pairs(const DiscShapes& shapes, const Discs& discs, ThreadPool* pool);
  double furthest(const Discs& discs) const;
  void find_flow(const Discs& discs);

  static constexpr double round_off = 1e-9;  ///< share of the skin that sums of ways may be off by
  static constexpr double worn = 0.9;        ///< share of the skin that is not worth going on with

  PeriodicBox box_;
  double skin_;
  double margin_;  ///< between the surfaces of listed pairs: law_reach + skin [L]
  double reach_{};
  double used_{};
  double slid_{};    ///< Discs::slid when it was built [L]
  double offset_{};  ///< of the boxes above and below then [L]; goes on without a jump
  Flow flow_;
};

}  // namespace talus
