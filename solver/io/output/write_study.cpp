#include "solver/io/output/write_study.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <utility>

#include "solver/cell/cell_run.hpp"
#include "verification/record/csv.hpp"

namespace talus {

std::string study_text(const std::vector<StudyMean>& study, const std::vector<Verdict>& verdicts, int seeds) {
  using Q = StudyQuantity;
  std::string text =
      fmt::format("{:10} {:>6} {:>7} {:>9} {:>5}  {:17} {:15} {:15} {:15} {:15} {}\n", "series", "kPa", "d/s",
                  "stiffness", "seeds", "S/N", "depth/D", "multiple", "M/S", "overlap/D", "order");
  bool soft = false, failed = false;
  for (const StudyMean& point : study) {
    const auto of = [&](Q quantity, int digits) {
      const Estimate estimate = point.of(quantity);
      return point.seeds == 0 ? std::string{"-"}
                              : fmt::format("{:.{}f} +- {:.{}f}", estimate.value, digits, estimate.error, digits);
    };
    const bool is_soft = std::any_of(point.runs.begin(), point.runs.end(), [](const StudyMean::Run& run) {
      return run.numbers[static_cast<std::size_t>(Q::largest_overlap)] > CellRun::deepest;
    });
    fmt::format_to(std::back_inserter(text), "{:10} {:6g} {:7g} {:9g} {:5}  {:17} {:15} {:15} {:15} {:15} {}{}\n",
                   point.point.series, point.point.overburden / 1e3, point.point.speed, point.point.stiffness,
                   point.seeds, of(Q::stress_ratio, 4), of(Q::depth, 3), of(Q::multiple_fraction, 3),
                   of(Q::multiple_shear_fraction, 3), of(Q::largest_overlap, 3), of(Q::order, 3), is_soft ? " *" : "");
    soft = soft || is_soft, failed = failed || point.seeds < seeds;
  }
  if (soft) {
    fmt::format_to(std::back_inserter(text),
                   "* In one of the runs discs overlapped by more than {} of a diameter: they do not behave as hard "
                   "ones.\n",
                   CellRun::deepest);
  }
  if (failed) fmt::format_to(std::back_inserter(text), "Where seeds are fewer than {} runs failed.\n", seeds);
  for (const Verdict& verdict : verdicts) {
    fmt::format_to(std::back_inserter(text), "{}\n  {}: {} (t = {:+.1f}, chance {:.2g})\n", verdict.prediction,
                   text_of(verdict.outturn), verdict.measured, verdict.significance, verdict.chance);
  }
  return text;
}

std::string study_csv(const std::vector<StudyMean>& study) {
  std::vector<std::string> names{"series", "overburden [Pa]", "speed [D/s]", "stiffness", "seed"};
  for (const std::string_view name : Names<StudyQuantity>::list)
    names.push_back(fmt::format("{}{}", name, name == "depth" || name == "largest_overlap" ? " [D]" : ""));
  records::CsvText text{names};
  for (const StudyMean& point : study) {
    for (const StudyMean::Run& run : point.runs) {
      text.cell(point.point.series);
      for (const double value : {point.point.overburden, point.point.speed, point.point.stiffness})
        text.number(value);
      text.cell(fmt::format("{}", run.seed));
      for (const double value : run.numbers)
        text.number(value);
      text.end_row();
    }
  }
  return std::move(text).text();
}

}  // namespace talus
