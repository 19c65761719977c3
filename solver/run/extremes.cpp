#include "solver/run/extremes.hpp"

#include "solver/base/rows.hpp"

namespace talus {

void Extremes::add(double time, std::span<const double> values) {
  if (least_.empty()) {
    least_.assign(values.begin(), values.end()), largest_ = least_;
    least_time_.assign(values.size(), time), largest_time_ = least_time_;
    return;
  }
  take_extremes(values.data(), time, values.size(), least_.data(), least_time_.data(), largest_.data(),
                largest_time_.data());
}

void Extremes::serialize(Archive& archive, std::size_t count) {
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
