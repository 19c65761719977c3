#include "solver/granular/neighbour_list.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <tuple>
#include <utility>

#include "solver/base/error.hpp"

namespace talus {
namespace {

/// Code of an image, which is at most one box away, to either side and up or down.
constexpr std::uint8_t code(PeriodicBox::Image image) {
  return static_cast<std::uint8_t>(static_cast<int>(image.right) + 1 + 3 * (static_cast<int>(image.up) + 1));
}

/// Index of a disc combined with the code of its image; pairs are sorted by it.
using Numbered = std::uint64_t;
constexpr int image_bits = 8;
constexpr Numbered numbered(std::size_t disc, std::uint8_t image) { return Numbered{disc} << image_bits | image; }

/// A disc or an image of one.
struct BinnedDisc {
  double x, y, radius;  ///< [L]
  Numbered number;
};

/// Integer part of x, limited to [minimum, maximum]; `minimum` if x is NaN, as in a diverged run.
std::size_t whole_between(double minimum, double x, double maximum) {
  return static_cast<std::size_t>(x > minimum ? std::min(std::floor(x), maximum) : minimum);
}

/// Cells of a rectangle around all discs, with one more layer of cells around it for images. Cells are so large that
/// pairs within reach are at most one cell apart.
class Cells {
 public:
  Cells(const DiscShapes& shapes, const Discs& discs, const PeriodicBox& box, double offset, double reach,
        ThreadPool* pool) {
    const auto range = [&](const std::vector<double>& at, double period) {
      if (period < PeriodicBox::unbounded) return std::pair{-0.5 * period, 0.5 * period};
      const auto [low, high] = std::minmax_element(at.begin(), at.end());
      return std::pair{*low, *high};
    };
    std::tie(left_, right_) = range(discs.x, box.width);
    std::tie(bottom_, top_) = range(discs.y, box.height);
    // Limits the number of cells, so that most of them are not empty.
    const double maximum = 4.0 * (std::sqrt(static_cast<double>(discs.size())) + 1.0);
    columns_ = whole_between(1.0, (right_ - left_) / reach, maximum);
    rows_ = whole_between(1.0, (top_ - bottom_) / reach, maximum);
    stride_ = columns_ + 2;

    const auto disc = [&](std::size_t i) {
      return BinnedDisc{discs.x[i], discs.y[i], shapes.radius[i], numbered(i, code({}))};
    };
    // For each thread: the images of its discs, and the number of its entries in each cell, which is then replaced by
    // the index in standing_ of the first of them.
    struct ThreadBins {
      std::vector<BinnedDisc> images;
      std::vector<std::uint32_t> in_cell;
    };
    std::vector<ThreadBins> all_bins(pool == nullptr ? 1 : pool->size());
    const std::size_t cells = stride_ * (rows_ + 2);
    cell_.resize(discs.size());
    in_ranges(pool, discs.size(), [&](const IndexRange& part) {
      ThreadBins& bins = all_bins[part.number];
      bins.in_cell.assign(cells, 0);
      for (std::size_t i = part.begin; i < part.end; ++i) {
        const BinnedDisc one = disc(i);
        cell_[i] = static_cast<std::uint32_t>(cell(one));
        ++bins.in_cell[cell_[i]];
        add_images(box, offset, reach, one, bins.images);
      }
      for (const BinnedDisc& image : bins.images)
        ++bins.in_cell[cell(image)];
    });
    begin_.resize(cells + 1);
    std::uint32_t count = 0;
    for (std::size_t c = 0; c < cells; ++c) {
      begin_[c] = count;
      for (ThreadBins& bins : all_bins)
        count += std::exchange(bins.in_cell[c], count);
    }
    begin_[cells] = count;
    standing_.resize(count);
    in_ranges(pool, discs.size(), [&](const IndexRange& part) {
      ThreadBins& bins = all_bins[part.number];
      for (std::size_t i = part.begin; i < part.end; ++i)
        standing_[bins.in_cell[cell_[i]]++] = disc(i);
      for (const BinnedDisc& image : bins.images)
        standing_[bins.in_cell[cell(image)]++] = image;
    });
  }

  /// All discs and images in the 3 x 3 cells around a disc's cell: one span for each row of cells.
  std::array<std::span<const BinnedDisc>, 3> around(std::size_t disc) const {
    std::array<std::span<const BinnedDisc>, 3> rows;
    for (std::size_t row = 0; row < rows.size(); ++row) {
      const std::size_t middle = cell_[disc] + row * stride_ - stride_;
      rows[row] = {standing_.data() + begin_[middle - 1], standing_.data() + begin_[middle + 2]};
    }
    return rows;
  }

 private:
  /// Adds those images of a disc that are within reach of the rectangle.
  void add_images(const PeriodicBox& box, double offset, double reach, const BinnedDisc& disc,
                  std::vector<BinnedDisc>& images) const {
    const auto inside = [&](const BinnedDisc& one, double by) {
      return one.x > left_ + by && one.x < right_ - by && one.y > bottom_ + by && one.y < top_ - by;
    };
    if (inside(disc, reach)) return;
    const int beside = box.repeats_x() ? 1 : 0, above = box.repeats_y() ? 1 : 0;
    for (int up = -above; up <= above; ++up) {
      for (int right = -beside; right <= beside; ++right) {
        const PeriodicBox::Image which{static_cast<double>(right), static_cast<double>(up)};
        const Vec2 shift = box.shift(which, offset);
        const BinnedDisc image{disc.x + shift.x, disc.y + shift.y, disc.radius, disc.number + code(which) - code({})};
        if (image.number != disc.number && inside(image, -reach)) images.push_back(image);
      }
    }
  }
  std::size_t cell(const BinnedDisc& one) const {
    // Discs are in inner cells, however the division rounds at an edge; images may be in the outer layer.
    const double outside = (one.number & numbered(0, 0xff)) == code({}) ? 0.0 : 1.0;
    const auto bin_of = [&](double at, double low, double high, std::size_t count) {
      const auto cells = static_cast<double>(count);
      return whole_between(1.0 - outside, 1.0 + (at - low) / (high - low) * cells, cells + outside);
    };
    return bin_of(one.y, bottom_, top_, rows_) * stride_ + bin_of(one.x, left_, right_, columns_);
  }

  double left_{}, right_{}, bottom_{}, top_{};  ///< [L]
  std::size_t columns_{}, rows_{};
  std::size_t stride_{};              ///< from a row of cells to the next
  std::vector<std::uint32_t> begin_;  ///< start of each cell in standing_
  std::vector<std::uint32_t> cell_;   ///< cell of each disc
  std::vector<BinnedDisc> standing_;
};

}  // namespace

void wrap(const PeriodicBox& box, Discs& discs) {
  if (!box.repeats_x() && !box.repeats_y()) return;
  const double offset = box.offset(discs.shear_displacement), sliding = box.sliding();
  for (std::size_t i = 0; i < discs.size(); ++i) {
    const PeriodicBox::Image image = box.nearest({discs.x[i], discs.y[i]}, offset);
    if (image.right == 0.0 && image.up == 0.0) continue;
    const Vec2 shift = box.shift(image, offset);
    discs.x[i] += shift.x, discs.y[i] += shift.y;
    discs.vx[i] += image.up * sliding;
  }
}

void NeighbourList::check_periods() const {
  for (const auto& [name, period] : {std::pair{"width", box_.width}, std::pair{"height", box_.height}}) {
    if (period < 2.0 * reach_) {
      throw InputError{
          fmt::format("{} of the periodic box: found {:g}; discs whose surfaces are within the skin of {:g} "
                      "reach {:g}, and it must be twice that, so that none meets two images of another",
                      name, period, skin_, reach_)};
    }
  }
}

void NeighbourList::build(const DiscShapes& shapes, const Discs& discs, ThreadPool* pool) {
  used_ = 0.0;
  shear_displacement_ = discs.shear_displacement;
  offset_ = box_.offset(discs.shear_displacement);
  x_ = discs.x, y_ = discs.y;
  find_flow(discs);
  find_pairs(shapes, discs, pool);
}

void NeighbourList::find_flow(const Discs& discs) {
  const auto count = static_cast<double>(discs.size());
  double y = 0.0, vx = 0.0, vy = 0.0;
  for (std::size_t i = 0; i < discs.size(); ++i)
    y += discs.y[i], vx += discs.vx[i], vy += discs.vy[i];
  y /= count, vx /= count, vy /= count;
  flow_ = {.x = vx, .y = vy, .rate = box_.repeats_y() ? box_.shear_rate : 0.0};
  if (!box_.repeats_y()) {
    double both = 0.0, squares = 0.0;
    for (std::size_t i = 0; i < discs.size(); ++i) {
      both += (discs.y[i] - y) * (discs.vx[i] - vx);
      squares += (discs.y[i] - y) * (discs.y[i] - y);
    }
    if (squares > 0.0) flow_.rate = both / squares;
  }
  flow_.x -= flow_.rate * y;
}

bool NeighbourList::holds(const Discs& discs) {
  if (!may_end()) return true;
  // In a sliding box displacements since the build include the mean flow, which neighbours share: they are no measure.
  if (box_.sliding() != 0.0) return false;
  used_ = 2.0 * furthest(discs);
  return used_ < worn * skin_;
}

double NeighbourList::furthest(const Discs& discs) const {
  double maximum = 0.0;
  for (std::size_t i = 0; i < x_.size(); ++i) {
    const double dx = discs.x[i] - x_[i], dy = discs.y[i] - y_[i];
    maximum = std::max(maximum, dx * dx + dy * dy);
  }
  return std::sqrt(maximum);
}

void NeighbourList::find_pairs(const DiscShapes& shapes, const Discs& discs, ThreadPool* pool) {
  reach_ = 2.0 * *std::max_element(shapes.radius.begin(), shapes.radius.end()) + margin_;
  check_periods();
  const Cells cells{shapes, discs, box_, offset_, reach_, pool};
  first_.resize(shapes.size() + 1);
  first_[0] = 0;
  // The first thread writes its pairs directly into the list; those of the others are appended, and their ends in
  // first_ shifted.
  struct Found {
    IndexRange of;
    std::vector<std::uint32_t> second;
    std::vector<std::uint8_t> image;
  };
  std::vector<Found> found(pool == nullptr ? 1 : pool->size());
  found[0].second.swap(second_), found[0].image.swap(image_);
  in_ranges(pool, shapes.size(), [&](const IndexRange& part) {
    auto& [of, second, image] = found[part.number];
    of = part;
    second.clear(), image.clear();
    std::vector<Numbered> row;
    for (std::size_t i = part.begin; i < part.end; ++i) {
      const auto around = cells.around(i);
      row.resize(around[0].size() + around[1].size() + around[2].size());
      // The test is unpredictable for the processor, so each candidate is written, and counted only if it is near.
      std::size_t count = 0;
      const Numbered own = numbered(i, 0xff);
      for (const std::span<const BinnedDisc> standing : around) {
        for (const BinnedDisc& other : standing) {
          const double dx = other.x - discs.x[i], dy = other.y - discs.y[i];
          const double within = shapes.radius[i] + other.radius + margin_;
          row[count] = other.number;
          count += static_cast<std::size_t>(dx * dx + dy * dy < within * within) &
                   static_cast<std::size_t>(other.number > own);
        }
      }
      std::sort(row.data(), row.data() + count);
      for (std::size_t k = 0; k < count; ++k) {
        const auto j = static_cast<std::size_t>(row[k] >> image_bits);
        if (shapes.inverse_mass[i] == 0.0 && shapes.inverse_mass[j] == 0.0) continue;
        second.push_back(static_cast<std::uint32_t>(j));
        image.push_back(static_cast<std::uint8_t>(row[k] & numbered(0, 0xff)));
      }
      first_[i + 1] = static_cast<std::uint32_t>(second.size());
    }
  });
  second_.swap(found[0].second), image_.swap(found[0].image);
  for (const Found& other : std::span{found}.subspan(1)) {
    const auto before = static_cast<std::uint32_t>(second_.size());
    for (std::size_t i = other.of.begin; i < other.of.end; ++i)
      first_[i + 1] += before;
    second_.insert(second_.end(), other.second.begin(), other.second.end());
    image_.insert(image_.end(), other.image.begin(), other.image.end());
  }
  // The lists take most of the memory of a run of many discs.
  if (4 * second_.capacity() > 5 * second_.size()) second_.shrink_to_fit(), image_.shrink_to_fit();
}

void NeighbourList::serialize(Archive& archive, const DiscShapes& shapes) {
  archive.number("used", used_);
  archive.number("boundary_shear_displacement", shear_displacement_);
  archive.number("offset", offset_);
  if (archive.is_loading()) x_.resize(shapes.size()), y_.resize(shapes.size());
  archive.numbers("x", x_), archive.numbers("y", y_);
  archive.number("flow_x", flow_.x), archive.number("flow_y", flow_.y), archive.number("flow_rate", flow_.rate);
  if (!archive.is_loading()) return;
  Discs then;
  then.x = x_, then.y = y_;
  find_pairs(shapes, then, nullptr);
}

std::size_t NeighbourList::find(std::size_t first, std::size_t second) const {
  const auto from = second_.begin() + static_cast<std::ptrdiff_t>(begin(first));
  const auto to = second_.begin() + static_cast<std::ptrdiff_t>(end(first));
  const auto found = std::lower_bound(from, to, second);
  return found != to && *found == second ? static_cast<std::size_t>(found - second_.begin()) : size();
}

void NeighbourList::shifts(double shear_displacement, std::span<Shift, images> out) const {
  const double offset = offset_ + (shear_displacement - shear_displacement_);
  for (int up = -1; up <= 1; ++up) {
    for (int right = -1; right <= 1; ++right) {
      const PeriodicBox::Image image{static_cast<double>(right), static_cast<double>(up)};
      // A direction that is not periodic has no other images.
      const bool none = (right != 0 && !box_.repeats_x()) || (up != 0 && !box_.repeats_y());
      const Vec2 shift = none ? Vec2{} : box_.shift(image, offset);
      out[code(image)] = {shift.x, shift.y, none ? 0.0 : up * box_.sliding()};
    }
  }
}

}  // namespace talus
