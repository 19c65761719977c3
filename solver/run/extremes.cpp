#include "solver/run/extremes.hpp"

#include <algorithm>

namespace talus {

void Extremes::add(double time, std::span<const double> values) {
  if (minimum_.empty()) {
    minimum_.assign(values.begin(), values.end()), maximum_ = minimum_;
    minimum_time_.assign(values.size(), time), maximum_time_ = minimum_time_;
    return;
  }
  rows_.resize(block_rows * size());
  std::copy(values.begin(), values.end(), rows_.begin() + static_cast<std::ptrdiff_t>(pending_ * size()));
  row_times_[pending_++] = time;
  if (pending_ == block_rows) compare();
}

void Extremes::compare() {
  take_extremes(rows_.data(), row_times_.data(), pending_, size(), minimum_.data(), minimum_time_.data(),
                maximum_.data(), maximum_time_.data());
  pending_ = 0;
}

Extreme Extremes::operator[](std::size_t i) const {
  Extreme found{minimum_[i], minimum_time_[i], maximum_[i], maximum_time_[i]};
  for (std::size_t row = 0; row < pending_; ++row) {
    const double value = rows_[row * size() + i];
    if (value < found.minimum) found.minimum = value, found.minimum_time = row_times_[row];
    if (value > found.maximum) found.maximum = value, found.maximum_time = row_times_[row];
  }
  return found;
}

void Extremes::serialize(Archive& archive, std::size_t count) {
  compare();
  std::vector<double> numbers;
  for (std::size_t i = 0; i < size(); ++i)
    numbers.insert(numbers.end(), {minimum_[i], minimum_time_[i], maximum_[i], maximum_time_[i]});
  numbers.resize(4 * count);
  archive.numbers("extremes", numbers);
  for (std::vector<double>* const list : {&minimum_, &minimum_time_, &maximum_, &maximum_time_})
    list->clear();
  for (std::size_t i = 0; i < numbers.size(); i += 4) {
    minimum_.push_back(numbers[i]), minimum_time_.push_back(numbers[i + 1]);
    maximum_.push_back(numbers[i + 2]), maximum_time_.push_back(numbers[i + 3]);
  }
}

}  // namespace talus
