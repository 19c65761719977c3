#include "solver/io/study_text.hpp"

#include <fmt/format.h>

#include <iterator>

namespace talus {

std::string study_text(const std::vector<StudyMean>& study, const std::vector<Verdict>& verdicts) {
  using Q = StudyQuantity;
  std::string text =
      fmt::format("{:10} {:>6} {:>7} {:>9} {:>5}  {:17} {:15} {:10} {:10} {:10} {:8}\n", "series", "kPa", "d/s",
                  "stiffness", "seeds", "S/N", "depth/D", "multiple", "M/S", "overlap/D", "order");
  for (const StudyMean& point : study) {
    const auto of = [&](Q quantity, int digits) {
      const Estimate estimate = point.of(quantity);
      return fmt::format("{:.{}f} +- {:.{}f}", estimate.value, digits, estimate.error, digits);
    };
    fmt::format_to(
        std::back_inserter(text), "{:10} {:6g} {:7g} {:9g} {:5}  {:17} {:15} {:10.3f} {:10.3f} {:10.3f} {:8.3f}\n",
        point.point.series, point.point.overburden / 1e3, point.point.speed, point.point.stiffness, point.seeds,
        of(Q::stress_ratio, 4), of(Q::depth, 3), point.of(Q::multiple_share).value,
        point.of(Q::multiple_shear_share).value, point.of(Q::largest_overlap).value, point.of(Q::order).value);
  }
  for (const Verdict& verdict : verdicts) {
    fmt::format_to(std::back_inserter(text), "{}\n  {}: {} (t = {:+.1f}, chance {:.2g})\n", verdict.prediction,
                   words(verdict.outturn), verdict.measured, verdict.significance, verdict.chance);
  }
  return text;
}

std::string study_csv(const std::vector<StudyMean>& study) {
  std::string text = "series,overburden [Pa],speed [D/s],stiffness,seed";
  for (const std::string_view name : study_names)
    text.append(",").append(name).append(name == "depth" || name == "largest_overlap" ? " [D]" : "");
  text += '\n';
  for (const StudyMean& point : study) {
    for (const StudyMean::Run& run : point.runs) {
      fmt::format_to(std::back_inserter(text), "{},{},{},{},{}", point.point.series, point.point.overburden,
                     point.point.speed, point.point.stiffness, run.seed);
      for (const double value : run.numbers)
        fmt::format_to(std::back_inserter(text), ",{}", value);
      text += '\n';
    }
  }
  return text;
}

}  // namespace talus
