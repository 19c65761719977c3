#include "reports/drawing.hpp"

#include <fmt/format.h>

#include <chrono>
#include <functional>

#include "reports/error.hpp"
#include "reports/file.hpp"
#include "reports/parallel.hpp"
#include "reports/process.hpp"

namespace talus::reports {
namespace {

std::string pdf_date(long long epoch_seconds) {
  namespace chr = std::chrono;
  const chr::sys_seconds time{chr::seconds(epoch_seconds)};
  const chr::sys_days day = chr::floor<chr::days>(time);
  const chr::year_month_day date(day);
  const chr::hh_mm_ss clock(time - day);
  return fmt::format("{:04}{:02}{:02}{:02}{:02}{:02}", static_cast<int>(date.year()),
                     static_cast<unsigned>(date.month()), static_cast<unsigned>(date.day()), clock.hours().count(),
                     clock.minutes().count(), clock.seconds().count());
}

}  // namespace

std::string draw(const std::vector<Drawing>& drawings, const std::filesystem::path& folder, unsigned jobs) {
  std::vector<std::string> warnings(drawings.size());
  std::vector<std::function<void()>> tasks;
  for (std::size_t i = 0; i < drawings.size(); ++i) {
    tasks.emplace_back([&, i] {
      const std::filesystem::path script = folder / fmt::format("drawing-{}.gp", i);
      write_file(script, drawings[i].script);
      const Command gnuplot{"gnuplot", {script.string()}, folder, {{"LC_ALL", "C.UTF-8"}, {"GNUTERM", "svg"}}};
      const std::string said = run_or_throw(gnuplot, drawings[i].name).messages;
      if (!said.empty()) warnings[i] = fmt::format("gnuplot on {}: {}", drawings[i].name, said);
    });
  }
  in_parallel(tasks, jobs);
  return fmt::format("{}", fmt::join(warnings, ""));
}

void date_pdf(const std::filesystem::path& file, long long epoch_seconds) {
  std::string bytes = read_file(file);
  const std::string mark = "/CreationDate (D:";
  const std::size_t place = bytes.find(mark);
  const std::string date = pdf_date(epoch_seconds);
  if (place == std::string::npos || place + mark.size() + date.size() > bytes.size()) {
    throw OutputError(file.string() + ": has no creation date where gnuplot's pdfcairo writes it");
  }
  bytes.replace(place + mark.size(), date.size(), date);
  write_file(file, bytes);
}

}  // namespace talus::reports
