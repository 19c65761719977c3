#include "verification/problems/program/pictures/thrown_discs.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <map>

#include "verification/reference/motion/constant_force.hpp"

namespace talus::verification::problems::picture_options {
namespace {

namespace fs = std::filesystem;

constexpr double gravity = 10.0;

reference::ConstantForce along(int disc) { return {1.0 * disc, 0.5 * disc, 0.0}; }
reference::ConstantForce up(int disc) { return {0.0, disc + 0.25, -gravity}; }

}  // namespace

std::string name_of(int disc) { return fmt::format("disc{}", disc); }

double exact(const std::string& quantity, int disc, double t) {
  const reference::ConstantForce flight = quantity.ends_with('x') ? along(disc) : up(disc);
  return quantity.starts_with('v') ? speed_at(flight, t) : position_at(flight, t);
}

std::string scene_text(double each) {
  std::string text =
      fmt::format("title = \"Discs in free fall\"\nunits = \"SI\"\ngravity = [\"0 m/s^2\", \"{} m/s^2\"]\n", -gravity);
  for (int i = 1; i <= discs; ++i) {
    text += fmt::format(R"(
[[body]]
name = "{}"
mobility = "free"
mass = "1 kg"
inertia = "1 kg m^2"
shape = {{ kind = "circle", radius = "{} m" }}
position = ["{} m", "0 m"]
velocity = ["{} m/s", "{} m/s"]
)",
                        name_of(i), radius, along(i).position, along(i).speed, up(i).speed);
  }
  return text + fmt::format(R"(
[[cable]]
name = "rope"
law = "tension_only"
from = {{ body = "disc1", point = ["0 m", "0 m", "{} m"] }}
to = {{ point = ["0 m", "{} m", "{} m"] }}
stiffness = "100 N/m"
rest_length = "100 m"

[run]
integrator = "velocity_verlet"
step = "{} s"
end = "{} s"
interval = "{} s"
)",
                            near_z, rope_y, far_z, each, steps * step, each);
}

Pictures::Pictures(const Setup& setup) : setup_{&setup}, environment_{recorded_pictures()} {
  folder_.write("scene.toml", scene_text());
  (void)talus_output(folder_, {"run", "scene.toml", "--out", "out", "--frames", fmt::format("{}", steps)});
}

std::string Pictures::run(const std::vector<std::string>& command, const Options& options) const {
  return talus_output(folder_, with_options(command, options, *setup_), environment_);
}

std::string Pictures::text(const std::string& file) const {
  return fs::exists(folder_.path() / file) ? folder_.read(file) : "";
}

Names Pictures::files(const std::string& folder) const {
  Names names;
  const fs::path path = folder_.path() / folder;
  if (!fs::exists(path)) return names;
  for (const auto& entry : fs::directory_iterator(path))
    names.insert(entry.path().filename().string());
  return names;
}

void check_formats(const Pictures& program, const std::string& stem, const std::vector<std::string>& formats,
                   Differences& differ) {
  const std::map<std::string, std::string> terminals{
      {"pdf", "pdfcairo"}, {"png", "pngcairo"}, {"ps", "epscairo"}, {"svg", "svg"}};
  const std::string content = drawn_content(program.text(stem + "." + formats.front()));
  differ.contains("formats: a plot", content, "\nplot ");
  for (const std::string& format : formats) {
    const std::string text = program.text(stem + "." + format);
    differ.compare("formats: terminal of " + format, read_picture(text).terminal, terminals.at(format));
    differ.compare("formats: content of " + format, drawn_content(text), content);
    if (format == "pdf")
      differ.compare("formats: date of pdf", between(text, "/CreationDate (D:", ")"), std::string{"19700101000000"});
    if (format == "ps")
      differ.compare("formats: date of ps", between(text, "%%CreationDate: ", "\n"),
                     std::string{"Thu Jan  1 00:00:00 1970"});
  }
}

}  // namespace talus::verification::problems::picture_options
