#include "solver/granular/neighbour_list.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "solver/base/error.hpp"

namespace talus {
namespace {

/// Images are one box away at most, to either side and up or down.
constexpr std::uint8_t code(PeriodicBox::Image image) {
  return static_cast<std::uint8_t>(static_cast<int>(image.right) + 1 + 3 * (static_cast<int>(image.up) + 1));
}

/// Cells of a rectangle around all discs, of a side that no pair in reach spans more than one of; the numbers of the
/// discs in each, rising.
class Cells {
 public:
  Cells(const Discs& discs, const PeriodicBox& box, double reach) : box_{box} {
    const auto range = [&](const std::vector<double>& at, double period) {
      if (period < PeriodicBox::endless) return std::pair{-0.5 * period, 0.5 * period};
      const auto [low, high] = std::minmax_element(at.begin(), at.end());
      return std::pair{*low, *high};
    };
    const auto [left, right] = range(discs.x, box.width);
    const auto [bottom, top] = range(discs.y, box.height);
    left_ = left, bottom_ = bottom;
    // Not so many cells that most are empty.
    const double most = std::sqrt(static_cast<double>(discs.size())) + 1.0;
    columns_ = static_cast<long>(std::clamp(std::floor((right - left) / reach), 1.0, 4.0 * most));
    rows_ = static_cast<long>(std::clamp(std::floor((top - bottom) / reach), 1.0, 4.0 * most));
    per_x_ = right > left ? static_cast<double>(columns_) / (right - left) : 0.0;
    per_y_ = top > bottom ? static_cast<double>(rows_) / (top - bottom) : 0.0;
    begin_.assign(static_cast<std::size_t>(columns_ * rows_) + 1, 0);
    cell_.resize(discs.size());
    for (std::size_t i = 0; i < discs.size(); ++i) {
      cell_[i] = static_cast<std::size_t>(row(discs.y[i]) * columns_ + column(discs.x[i]));
      ++begin_[cell_[i] + 1];
    }
    for (std::size_t c = 1; c < begin_.size(); ++c)
      begin_[c] += begin_[c - 1];
    std::vector<std::size_t> next{begin_.begin(), begin_.end() - 1};
    discs_.resize(discs.size());
    for (std::size_t i = 0; i < discs.size(); ++i)
      discs_[next[cell_[i]]++] = static_cast<std::uint32_t>(i);
  }

  /// Calls visit(disc, by_image) for the discs of greater number in the cells around one's own; some twice, where a
  /// period is less than three cells long. If not by_image, the disc itself is nearer than any image of it.
  template <class Visit>
  void for_each_near(std::size_t disc, double slid, Visit&& visit) const {
    const long c = static_cast<long>(cell_[disc]) % columns_, r = static_cast<long>(cell_[disc]) / columns_;
    // The row beyond a border has slid: its cells lie between two of ours.
    const bool slides = box_.repeats_y() && slid != 0.0;
    const long by = slides ? static_cast<long>(std::floor(slid * per_x_)) : 0;
    const bool small = (box_.repeats_x() && columns_ < 4) || (box_.repeats_y() && rows_ < 4);
    for (long up = -1; up <= 1; ++up) {
      long at = r + up, from = c - 1, to = c + 1;
      const bool crosses = at < 0 || at >= rows_;
      if (crosses) {
        if (!box_.repeats_y()) continue;
        if (slides && at < 0) from += by, to += by + 1;
        if (slides && at >= rows_) from -= by + 1, to -= by;
        at = (at + rows_) % rows_;
      }
      for (long across = from; across <= to; ++across) {
        long column = across;
        const bool beyond = column < 0 || column >= columns_;
        if (beyond) {
          if (!box_.repeats_x()) continue;
          column = (column % columns_ + columns_) % columns_;
        }
        const auto cell = static_cast<std::size_t>(at * columns_ + column);
        for (std::size_t k = begin_[cell]; k < begin_[cell + 1]; ++k) {
          if (discs_[k] > disc) visit(discs_[k], small || crosses || beyond);
        }
      }
    }
  }

 private:
  long column(double x) const { return std::clamp(static_cast<long>((x - left_) * per_x_), 0L, columns_ - 1); }
  long row(double y) const { return std::clamp(static_cast<long>((y - bottom_) * per_y_), 0L, rows_ - 1); }

  PeriodicBox box_;
  double left_{}, bottom_{}, per_x_{}, per_y_{};
  long columns_{}, rows_{};
  std::vector<std::size_t> begin_;  ///< of each cell in discs_
  std::vector<std::size_t> cell_;   ///< of each disc
  std::vector<std::uint32_t> discs_;
};

}  // namespace

void wrap(const PeriodicBox& box, Discs& discs) {
  if (!box.repeats_x() && !box.repeats_y()) return;
  const double offset = box.offset(discs.slid), sliding = box.sliding();
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

void NeighbourList::build(const DiscShapes& shapes, const Discs& discs) {
  used_ = 0.0;
  slid_ = discs.slid;
  offset_ = box_.offset(discs.slid);
  x_ = discs.x, y_ = discs.y;
  find_flow(discs);
  find_pairs(shapes, discs);
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
  // Where the box slides discs flow apart from where they were, together.
  if (box_.sliding() != 0.0) return false;
  used_ = 2.0 * furthest(discs);
  return used_ < worn * skin_;
}

double NeighbourList::furthest(const Discs& discs) const {
  double most = 0.0;
  for (std::size_t i = 0; i < x_.size(); ++i) {
    const double dx = discs.x[i] - x_[i], dy = discs.y[i] - y_[i];
    most = std::max(most, dx * dx + dy * dy);
  }
  return std::sqrt(most);
}

void NeighbourList::find_pairs(const DiscShapes& shapes, const Discs& discs) {
  reach_ = 2.0 * *std::max_element(shapes.radius.begin(), shapes.radius.end()) + skin_;
  check_periods();
  second_.clear();
  image_.clear();
  first_.reserve(shapes.size() + 1);
  first_.assign(1, 0);
  const Cells cells{discs, box_, reach_};
  // Number of the second disc and image in one: in the order that they are sorted in.
  std::vector<std::uint64_t> row;
  constexpr int shift = 8;
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    row.clear();
    cells.for_each_near(i, offset_, [&](std::uint32_t j, bool by_image) {
      Vec2 apart{discs.x[j] - discs.x[i], discs.y[j] - discs.y[i]};
      PeriodicBox::Image image;
      if (by_image) {
        image = box_.nearest(apart, offset_);
        apart += box_.shift(image, offset_);
      }
      const double within = shapes.radius[i] + shapes.radius[j] + skin_;
      if (dot(apart, apart) >= within * within) return;
      if (shapes.inverse_mass[i] == 0.0 && shapes.inverse_mass[j] == 0.0) return;
      row.push_back(std::uint64_t{j} << shift | code(image));
    });
    std::sort(row.begin(), row.end());
    row.erase(std::unique(row.begin(), row.end()), row.end());
    for (const std::uint64_t pair : row) {
      second_.push_back(static_cast<std::uint32_t>(pair >> shift));
      image_.push_back(static_cast<std::uint8_t>(pair & ((1U << shift) - 1U)));
    }
    first_.push_back(static_cast<std::uint32_t>(second_.size()));
  }
  // Lists of many discs are most of what a run takes.
  if (4 * second_.capacity() > 5 * second_.size()) second_.shrink_to_fit(), image_.shrink_to_fit();
}

void NeighbourList::remember(Memory& memory, const DiscShapes& shapes) {
  memory.number("used", used_);
  memory.number("slid", slid_);
  memory.number("offset", offset_);
  if (memory.puts_back()) x_.resize(shapes.size()), y_.resize(shapes.size());
  memory.numbers("x", x_), memory.numbers("y", y_);
  memory.number("flow_x", flow_.x), memory.number("flow_y", flow_.y), memory.number("flow_rate", flow_.rate);
  if (!memory.puts_back()) return;
  Discs then;
  then.x = x_, then.y = y_;
  find_pairs(shapes, then);
}

std::size_t NeighbourList::find(std::size_t first, std::size_t second) const {
  const auto from = second_.begin() + static_cast<std::ptrdiff_t>(begin(first));
  const auto to = second_.begin() + static_cast<std::ptrdiff_t>(end(first));
  const auto found = std::lower_bound(from, to, second);
  return found != to && *found == second ? static_cast<std::size_t>(found - second_.begin()) : size();
}

void NeighbourList::shifts(double slid, std::span<Shift, images> out) const {
  const double offset = offset_ + (slid - slid_);
  for (int up = -1; up <= 1; ++up) {
    for (int right = -1; right <= 1; ++right) {
      const PeriodicBox::Image image{static_cast<double>(right), static_cast<double>(up)};
      // Of what does not repeat there is no other image.
      const bool none = (right != 0 && !box_.repeats_x()) || (up != 0 && !box_.repeats_y());
      const Vec2 shift = none ? Vec2{} : box_.shift(image, offset);
      out[code(image)] = {shift.x, shift.y, none ? 0.0 : up * box_.sliding()};
    }
  }
}

}  // namespace talus
