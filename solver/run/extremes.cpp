#include "solver/run/extremes.hpp"

#include <algorithm>

namespace talus {

void Extremes::add(double time, std::span<const double> values) {
  if (least_.empty()) {
    least_.assign(values.begin(), values.end()), largest_ = least_;
    least_time_.assign(values.size(), time), largest_time_ = least_time_;
    return;
  }
  rows_.resize(block_rows * size());
  std::copy(values.begin(), values.end(), rows_.begin() + static_cast<std::ptrdiff_t>(pending_ * size()));
  row_times_[pending_++] = time;
  if (pending_ == block_rows) compare();
}

void Extremes::compare() {
  take_extremes(rows_.data(), row_times_.data(), pending_, size(), least_.data(), least_time_.data(), largest_.data(),
                largest_time_.data());
  pending_ = 0;
}

Extreme Extremes::operator[](std::size_t i) const {
  Extreme found{least_[i], least_time_[i], largest_[i], largest_time_[i]};
  for (std::size_t row = 0; row < pending_; ++row) {
    const double value = rows_[row * size() + i];
    if (value < found.least) found.least = value, found.least_time = row_times_[row];
    if (value > found.largest) found.largest = value, found.largest_time = row_times_[row];
  }
  return found;
}

void Extremes::serialize(Archive& archive, std::size_t count) {
  compare();
  std::vector<double> numbers;
  for (std::size_t i = 0; i < size(); ++i)
    numbers.insert(numbers.end(), {least_[i], least_time_[i], largest_[i], largest_time_[i]});
  numbers.resize(4 * count);
  archive.numbers("extremes", numbers);
  for (std::vector<double>* const list : {&least_, &least_time_, &largest_, &largest_time_})
    list->clear();
  for (std::size_t i = 0; i < numbers.size(); i += 4) {
    least_.push_back(numbers[i]), least_time_.push_back(numbers[i + 1]);
    largest_.push_back(numbers[i + 2]), largest_time_.push_back(numbers[i + 3]);
  }
}

}  // namespace talus
