/// talus_vtkhdf: the states of a run as one VTKHDF file. A program beside `talus`, which the libraries of HDF5 would
/// make start later.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <new>
#include <string>

#include "solver/base/error.hpp"
#include "solver/base/exit_code.hpp"
#include "solver/base/progress.hpp"
#include "solver/command_line/usage_error.hpp"
#include "solver/version/version.hpp"
#include "solver/vtkhdf/vtkhdf_file.hpp"
#include "verification/record/utf8.hpp"

namespace talus {
namespace {

struct VtkHdfOptions {
  std::string index, file;
};

void describe(CLI::App& program, VtkHdfOptions& options) {
  program.description(
      "The states of a run (NAME.pvd with its .vtp files) as one VTKHDF file, which ParaView 5.12 and VTK 9.3 read.");
  program.add_option("INDEX", options.index, "NAME.pvd in the folder of a run, or cell.pvd of a cell")->required();
  program.add_option("--out", options.file, "the file, NAME.vtkhdf")->required();
  program.set_version_flag("--version", version_text("talus_vtkhdf"));
  program.footer(
      "Example:\n"
      "  talus run cases/two_cable.toml --out out && talus_vtkhdf out/two_cable.pvd --out out/two_cable.vtkhdf");
  refuse_empty_values(program);
}

int run(int count, const char* const* arguments) {
  CLI::App program{"", "talus_vtkhdf"};
  VtkHdfOptions options;
  describe(program, options);
  try {
    program.parse(count, arguments);
  } catch (const CLI::ParseError& wrong) {
    return exit_of_parse(program, wrong);
  }
  const auto fail = [](app::ExitCode code, const char* message) {
    fmt::print(stderr, "talus_vtkhdf: {}\n", records::shown_lines(message));
    return code;
  };
  try {
    if (!options.file.ends_with(".vtkhdf")) {
      throw InputError{fmt::format("--out: found \"{}\"; it must end with .vtkhdf, by which ParaView knows the format",
                                   options.file)};
    }
    {
      Progress progress;
      write_vtkhdf(options.index, options.file, [&](std::size_t done, std::size_t all) {
        if (progress.due()) progress.show(fmt::format("{} of {} states", done, all));
      });
    }
    fmt::print("{}\n", options.file);
    if (std::fflush(stdout) != 0) return fail(app::io_failed, "standard output: it cannot be written");
    return app::ok;
  } catch (const InputError& wrong) {
    return fail(app::bad_input, wrong.what());
  } catch (const std::bad_alloc&) {
    return fail(app::io_failed, "not enough memory: it takes twice the size of the file");
  } catch (const std::exception& wrong) {
    return fail(app::io_failed, wrong.what());
  }
}

}  // namespace
}  // namespace talus

int main(int count, char** arguments) { return talus::run(count, arguments); }
