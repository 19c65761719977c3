#include "reports/figures/drawing.hpp"

#include <fmt/format.h>

#include <ctime>

#include "reports/base/error.hpp"
#include "reports/base/process.hpp"
#include "reports/base/progress.hpp"
#include "solver/threads/parallel_for.hpp"
#include "verification/record/whole_file.hpp"

namespace talus::reports {
namespace {

/// Where cairo writes the current time in a file format, and its format (of strftime).
struct DateField {
  const char* extension;
  const char* mark;
  const char* form;
};
constexpr DateField date_fields[] = {{".pdf", "/CreationDate (D:", "%Y%m%d%H%M%S"},
                                     {".ps", "%%CreationDate: ", "%a %b %e %H:%M:%S %Y"}};

std::string date_text(const char* form, std::time_t time) {
  std::tm parts{};
  ::gmtime_r(&time, &parts);
  char text[64];
  return {text, std::strftime(text, sizeof text, form, &parts)};
}

/// True for the message that gnuplot prints to stderr for each GIF.
bool counts_frames(const std::string& said) {
  const std::size_t text = said.find_first_not_of("0123456789 \n");
  return text != std::string::npos && said.substr(text) == "frames in animation sequence\n";
}

}  // namespace

std::string draw(const std::vector<Drawing>& drawings, const std::filesystem::path& folder, unsigned jobs) {
  std::vector<std::string> warnings(drawings.size());
  Progress progress("drawing", drawings.size());
  parallel_for(drawings.size(), jobs, [&](std::size_t i) {
    const std::filesystem::path script = folder / fmt::format("drawing-{}.gp", i);
    records::write_whole(script, drawings[i].script);
    const Command gnuplot{"gnuplot", {script.string()}, folder, {{"LC_ALL", "C.UTF-8"}, {"GNUTERM", "svg"}}};
    const std::string said = run_or_throw(gnuplot, drawings[i].name).messages;
    if (!said.empty() && !counts_frames(said))
      warnings[i] = fmt::format("gnuplot on {}: {}{}", drawings[i].name, said, said.back() == '\n' ? "" : "\n");
    progress.add();
  });
  return fmt::format("{}", fmt::join(warnings, ""));
}

void date_picture(const std::filesystem::path& file, long long epoch_seconds) {
  for (const DateField& field : date_fields) {
    if (file.extension() != field.extension) continue;
    std::string bytes = records::read_whole(file);
    const std::string mark = field.mark;
    const std::size_t offset = bytes.find(mark);
    const std::string date = date_text(field.form, static_cast<std::time_t>(epoch_seconds));
    if (offset == std::string::npos || offset + mark.size() + date.size() > bytes.size()) {
      throw OutputError(file.string() + ": has no creation date where cairo writes it");
    }
    bytes.replace(offset + mark.size(), date.size(), date);
    records::write_whole(file, bytes);
  }
}

}  // namespace talus::reports
