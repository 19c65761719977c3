#include "tests/fuzz/readers.hpp"

#include <cxxabi.h>
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <fstream>
#include <string_view>
#include <typeinfo>

#include "reports/figures/plot.hpp"
#include "reports/sheet/sheet_record.hpp"
#include "solver/app/capacity/capacity_file.hpp"
#include "solver/app/fit/fit_file.hpp"
#include "solver/app/life_cycle.hpp"
#include "solver/app/sweep/dakota.hpp"
#include "solver/app/sweep/sweep_file.hpp"
#include "solver/app/sweep/sweep_result.hpp"
#include "solver/app/sweep/sweep_runs.hpp"
#include "solver/base/error.hpp"
#include "solver/io/cell/cell_restart.hpp"
#include "solver/io/file/quantity_table.hpp"
#include "solver/io/file/toml_document.hpp"
#include "solver/io/output/checkpoint.hpp"
#include "solver/io/output/read_final_state.hpp"
#include "solver/io/output/read_geometry.hpp"
#include "solver/io/output/read_history.hpp"
#include "solver/io/output/run_folder.hpp"
#include "solver/io/read_scene_file.hpp"
#include "tests/fuzz/bounded_runs.hpp"
#include "tests/solver/io/complete_files.hpp"
#include "verification/catalogue/catalogue.hpp"
#include "verification/driver/renames.hpp"
#include "verification/record/error.hpp"
#include "verification/record/figure_points.hpp"
#include "verification/record/plots.hpp"
#include "verification/record/record_files.hpp"

namespace talus::fuzz {
namespace {

namespace fs = std::filesystem;
using Texts = std::vector<std::string>;

/// Texts of the files in a folder whose names have this ending, in the order of their names.
Texts texts_in(const fs::path& folder, std::string_view end) {
  std::vector<fs::path> files;
  for (const fs::directory_entry& entry : fs::directory_iterator{folder})
    if (entry.is_regular_file() && entry.path().string().ends_with(end)) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  Texts texts;
  for (const fs::path& file : files)
    texts.push_back(read_text(file));
  return texts;
}

/// The first 30 lines of texts with a line for each record: longer ones are rarely mutated in their head.
Texts first_lines(Texts texts) {
  for (std::string& text : texts) {
    std::size_t end = 0;
    for (int line = 0; line < 30 && end < text.size(); ++line)
      end = std::min(text.find('\n', end), text.size() - 1) + 1;
    text.resize(end);
  }
  return texts;
}

Texts joined(Texts one, const Texts& other) {
  one.insert(one.end(), other.begin(), other.end());
  return one;
}

/// The files that contain a table, out of those that together have every field.
Texts complete_files_with(std::string_view table) {
  Texts texts;
  for (const std::string_view file : complete_files)
    if (file.find(table) != std::string_view::npos) texts.emplace_back(file);
  return texts;
}

/// Reads a file that is not a model.
template <class Read>
std::function<bool(const fs::path&)> only(Read read) {
  return [read](const fs::path& file) {
    static_cast<void>(read(file));
    return true;
  };
}

bool reads_scene(const fs::path& file) {
  if (describes_cell(file)) return true;
  const SceneFile scene = read_scene_file(file);
  return run_scene(scene, file);
}

bool reads_cell(const fs::path& file) {
  static_cast<void>(describes_cell(file));
  return run_cell(read_cell(file, {}));
}

/// Replaces the hash at the end of a checkpoint.
void seal_checkpoint(std::string& text) {
  constexpr std::string_view line = "\"fnv1a\": ";
  const std::size_t end = text.rfind(line);
  if (end == std::string::npos) return;
  const std::string hash = fnv1a(std::string_view{text}.substr(0, end));
  const std::size_t digits = end + line.size() + 1;
  if (digits + hash.size() <= text.size()) text.replace(digits, hash.size(), hash);
}

/// Adds readers of files that users write: scenes, decks, cells.
void add_scene_readers(const fs::path& scratch, std::vector<Reader>& readers) {
  const fs::path cases = TALUS_CASES;
  readers.push_back({.name = "scene",
                     .file = "scene.toml",
                     .corpus = joined(texts_in(cases, ".toml"), complete_files_with("[[body]]")),
                     .slow = true,
                     .read = reads_scene});
  readers.push_back({.name = "fence",
                     .file = "fence.toml",
                     .corpus = joined(texts_in(cases / "fence", ".toml"), complete_files_with("[fence]")),
                     .slow = true,
                     .read = reads_scene});
  readers.push_back({.name = "deck",
                     .file = "deck.DAT",
                     .corpus = texts_in(cases / "fence", ".DAT"),
                     .slow = true,
                     .read = reads_scene});
  readers.push_back({.name = "cell",
                     .file = "cell.toml",
                     .corpus = joined(texts_in(cases / "cell", ".toml"), complete_files_with("[cell]")),
                     .slow = true,
                     .read = reads_cell});
  readers.push_back({.name = "cell_deck",
                     .file = "CNTRL.DAT",
                     .corpus = texts_in(cases / "cell", ".DAT"),
                     .slow = true,
                     .read = reads_cell});
  const CellScene restarted = read_cell(cases / "cell" / "CNTRL.DAT", {});
  readers.push_back({.name = "cell_restart",
                     .file = "RESTART.DAT",
                     .corpus = texts_in(scratch / "cell", "RESTART.DAT"),
                     .slow = true,
                     .read = [restarted](const fs::path& file) {
                       CellRestart restart = read_cell_restart(file, restarted.cell);
                       return run_cell(restarted, std::move(restart.start));
                     }});
}

/// Adds the reader of the pairs of `talus calibrate`.
void add_pair_reader(std::vector<Reader>& readers) {
  const std::vector<AllowedColumn> allowed{{"mass_1", dimension::mass, Range::positive},
                                           {"mass_2", dimension::mass, Range::positive},
                                           {"speed", dimension::velocity, Range::positive},
                                           {"exponent", dimension::number, Range::one_to_hundred}};
  readers.push_back({.name = "pairs",
                     .file = "pairs.csv",
                     .corpus = {"mass_1 [kg],mass_2 [g],speed [ft/s]\n1,20,3.5\n2,1e3,0.1\n",
                                "# a wall\nmass_2 [slug]\n0.5\n", "exponent,mass_2 [kg]\n1.5,1\n"},
                     .read = only([allowed](const fs::path& file) { return read_quantity_table(file, allowed, si); })});
}

/// Adds readers of sweeps, of questions about a fence, and of lines that they write.
void add_sweep_readers(std::vector<Reader>& readers) {
  const fs::path cases = TALUS_CASES;
  // The commands add the file's name, and the line.
  const auto named = [](const fs::path& file, const auto& read) {
    try {
      return read();
    } catch (const InputError& error) {
      throw InputError{fmt::format("{}:1: {}", file.string(), error.what())};
    }
  };
  const auto lines = [named](auto read) {
    return only([=](const fs::path& file) { return named(file, [&] { return read(read_text(file)); }); });
  };
  readers.push_back(
      {.name = "sweep",
       .file = "sweep.toml",
       .corpus = joined(texts_in(cases / "sweeps", ".toml"),
                        {"base = \"a.toml\"\noutputs = [\"x.end\"]\n[[axis]]\nfield = \"run.step\"\nrange = [\"1 s\", "
                         "\"2 s\"]\ncount = 3\nspacing = \"logarithmic\"\n[[axis]]\nfield = \"a.b[0]\"\nvalues = [1, "
                         "true]\n[[constraint]]\nfield = \"run.step\"\nat_most = \"1.5 s\"\nfactor = 2\n"}),
       .read = only([named](const fs::path& file) {
         const app::SweepFile sweep = app::read_sweep(read_text(file), file);
         std::int64_t runs = std::max<std::int64_t>(sweep.design.runs, 1);
         for (const app::SweepAxis& axis : sweep.axes)
           runs *= axis.continuous ? std::max<std::int64_t>(axis.continuous->count, 1) : 1;
         // Many runs take long to list, as they should.
         return runs > 1000 ? app::SweptRuns{} : app::swept_runs(sweep);
       })});
  readers.push_back(
      {.name = "capacity",
       .file = "capacity.toml",
       .corpus =
           {read_text(cases / "capacity/table_2.toml"),
            "base = \"a.toml\"\nmass = [\"1 kg\", \"2 kg\"]\nspeed = [\"1 m/s\", \"2 "
            "m/s\"]\nheight = [\"1 m\", \"2 ft\"]\n"
            "set = { \"a.b\" = 1 }\nseed = 3\n[map]\ncells = 8\nfirst_cells = 2\nruns = "
            "9\nfew_runs = 2\naudit = "
            "4\n[changes]\nangle = \"1 deg\"\nspin = \"1 rad/s\"\nalong = \"1 m\"\n[hazard]\nmass = \"1 kg\"\nspeed = "
            "\"1 m/s\"\nheight = \"1 m\"\nspin = [\"1 rad/s\", \"2 rad/s\"]\n[limits]\nevaluations = 3\n"},
       .read = only([](const fs::path& file) { return app::read_capacity(read_text(file), file); })});
  std::string fit = read_text(cases / "measured/rebound.fit.toml");
  fit.replace(fit.find("rebound.csv"), 11, (cases / "measured/rebound.csv").string());
  readers.push_back(
      {.name = "fit",
       .file = "fit.toml",
       .corpus = {fit + "start = \"8 MN/m\"\n[bootstrap]\nsamples = 90\nseed = 2\n[limits]\nevaluations = 3\n"},
       .read = only([](const fs::path& file) { return app::read_fit(read_text(file), file); })});
  readers.push_back(
      {.name = "dakota",
       .file = "params.in",
       .corpus = {"  2 variables\n -6.0e+01 fence.rock[0].velocity[0]\n 2.5e-01 x_2\n  2 functions\n"
                  "  1 ASV_1:rock.vx.end\n  0 ASV_2:top1.tension.max\n  2 derivative_variables\n"
                  "  1 DVV_1:fence.rock[0].velocity[0]\n  2 DVV_2:x_2\n  0 analysis_components\n"
                  "  1 eval_id\n  0 metadata\n"},
       .read = only([](const fs::path& file) { return app::read_dakota(read_text(file), file.string()); })});
  readers.push_back({.name = "sweep_run",
                     .file = "run.json",
                     .corpus = {R"({"id":"b163a6a19d49fbb8","parameters":{"fence.steps":20000,"run.a[0]":"-1 ft"}})"},
                     .read = lines(app::run_of_line)});
  readers.push_back(
      {.name = "sweep_result",
       .file = "result.json",
       .corpus =
           {R"({"id":"b1","sweep":"0","end":"finished","time":0.2,"evaluations":200,"verdict":"stopped","values":[-5.1,null]})",
            R"({"id":"b1","sweep":"0","end":"diverged","reason":"why","time":0.2,"evaluations":200,"values":[]})"},
       .read = lines([](const std::string& line) { return app::result_of_line(line, "0"); })});
}

/// Adds readers of files that a run writes.
void add_run_readers(const fs::path& scratch, std::vector<Reader>& readers) {
  const fs::path scene = scratch / "scene", fence = scratch / "fence", cell = scratch / "cell";
  readers.push_back({.name = "scene_checkpoint",
                     .file = app::checkpoint_name,
                     .corpus = joined(texts_in(scene, "saved.json"), texts_in(fence, "saved.json")),
                     .slow = true,
                     .read = resume_scene,
                     .seal = seal_checkpoint});
  readers.push_back({.name = "cell_checkpoint",
                     .file = app::checkpoint_name,
                     .corpus = texts_in(cell, "saved.json"),
                     .slow = true,
                     .read = resume_cell,
                     .seal = seal_checkpoint});
  readers.push_back({.name = "summary",
                     .file = "summary.json",
                     .corpus = texts_in(scene, "summary.json"),
                     .read = [](const fs::path& file) {
                       app::RunOptions options;
                       options.resume = file.parent_path();
                       static_cast<void>(app::report_ended_run(options, {}));
                       return true;
                     }});
  readers.push_back({.name = "final_state",
                     .file = "final_state.json",
                     .corpus = texts_in(fence, "final_state.json"),
                     .read = only([](const fs::path& file) { return read_stretched_cables(file.parent_path(), us); })});
  readers.push_back({.name = "run_folder",
                     .file = "plot.json",
                     .corpus = joined(texts_in(scene, "plot.json"), texts_in(cell, "plot.json")),
                     .read = only([](const fs::path& file) { return read_run_folder(file.parent_path()); })});
  readers.push_back({.name = "plots",
                     .file = "plot.json",
                     .corpus = texts_in(scene, "plot.json"),
                     .read = only(records::read_plots)});
  readers.push_back({.name = "history",
                     .file = "history.csv",
                     .corpus = first_lines(texts_in(scene, "history.csv")),
                     .read = only(read_history)});
  readers.push_back({.name = "geometry_index",
                     .file = "scene.pvd",
                     .corpus = texts_in(scene, ".pvd"),
                     .read = only(read_geometry_index)});
  readers.push_back(
      {.name = "geometry",
       .file = "state.vtp",
       .corpus = joined(texts_in(scene / "pendulum_geometry", ".vtp"), texts_in(fence / "table_2_geometry", ".vtp")),
       .read = only([](const fs::path& file) {
         return read_geometry({0.0, file});
       })});
  readers.push_back({.name = "disc_states",
                     .file = "cell.vtp",
                     .corpus = texts_in(cell, ".vtp"),
                     .read = only([](const fs::path& file) {
                       return read_discs({0.0, file});
                     })});
}

/// Adds readers of the verification's results and of the files beside its cases.
void add_verification_readers(std::vector<Reader>& readers) {
  const fs::path data = TALUS_TEST_DATA, catalogue = TALUS_CATALOGUE;
  const Texts results = joined(texts_in(data / "pass", "results.json"), texts_in(data / "fail", "results.json"));
  readers.push_back(
      {.name = "results", .file = "results.json", .corpus = results, .read = only([](const fs::path& file) {
                                                                       return records::read_results(file);
                                                                     })});
  Texts record_texts;
  for (const records::Record& record : records::read_results(data / "pass" / "results.json").records)
    record_texts.push_back(records::text_of(record));
  std::vector<std::pair<std::string, std::string>> csv_files;
  for (const char* const name : {"two_cable/path.csv", "two_cable/stiffness.csv", "pendulum/work.csv"})
    csv_files.emplace_back(fs::path{name}.filename(), read_text(data / "pass" / name));
  readers.push_back({.name = "record",
                     .file = "record.json",
                     .corpus = record_texts,
                     .beside = csv_files,
                     .read = only([](const fs::path& file) { return records::read_record(file.parent_path()); })});
  const auto figures = records::read_results(data / "pass" / "results.json").records;
  records::Figure path;
  for (const records::Record& record : figures)
    for (const records::Figure& figure : record.figures)
      if (figure.csv == "path.csv") path = figure;
  readers.push_back(
      {.name = "figure",
       .file = "path.csv",
       .corpus = {read_text(data / "pass" / "two_cable" / "path.csv")},
       .read = only([path](const fs::path& file) { return reports::plot_of(path, file.parent_path()); })});
  readers.push_back({.name = "sheet",
                     .file = "sheet.json",
                     .corpus = texts_in(data / "sheet", ".json"),
                     .read = only(reports::read_sheet)});
  readers.push_back(
      {.name = "renames",
       .file = "renames.txt",
       .corpus = {"# of version 2\n\ncaught_fall -> damped_bungee\r\n  a/error / bound -> b/ratio of a/b  \n",
                  "a/control: mass halved -> a/control: half the mass\na/old -> -\ngone -> -\n",
                  "a/x -> a/y\na/y -> a/x\n"},
       .read = only(verification::read_renames)});
  std::vector<std::pair<std::string, std::string>> all;
  for (const char* const name : {"requirements.toml", "peers.toml", "errata.toml", "findings.toml", "references.bib"})
    all.emplace_back(name, read_text(catalogue / name));
  for (const auto& [name, text] : all) {
    readers.push_back(
        {.name = fs::path{name}.stem(),
         .file = name,
         .corpus = {text},
         .beside = all,
         .slow = true,  // It reads all five files.
         .read = only([](const fs::path& file) { return verification::read_catalogue(file.parent_path()); })});
    std::erase_if(readers.back().beside, [own = readers.back().file](const auto& each) { return each.first == own; });
  }
}

std::string type_name(const std::exception& error) {
  int status = 0;
  char* name = abi::__cxa_demangle(typeid(error).name(), nullptr, nullptr, &status);
  const std::string result = name ? name : typeid(error).name();
  std::free(name);
  return result;
}

/// True if the text behind a file's name gives a position in it: ":12: ...", ": field: ...", ".member: ..." or "...
/// line 12 ...".
bool says_where(std::string_view rest) {
  if (rest.size() > 1 && rest[0] == ':' && std::isdigit(static_cast<unsigned char>(rest[1])) != 0) return true;
  if (rest.find("line ") != std::string_view::npos || rest.starts_with(".")) return true;
  return rest.starts_with(": ") && rest.substr(2).find(": ") != std::string_view::npos;
}

/// Describes what is wrong with an error's message; empty if nothing is. The message must name the file, or one of
/// those beside it, and a line or a field in it; except where the system refuses the file, the file is empty, or its
/// value is not an object.
std::string case_error(const std::string& message, const fs::path& file) {
  const std::string name = file.string(), folder = file.parent_path().string() + "/";
  const std::size_t offset = message.find(name), beside = message.find(folder);
  if (beside == std::string::npos) return "the error does not name the file: " + message;
  const std::size_t end = offset != std::string::npos ? offset + name.size() : message.find(':', beside);
  const std::string_view rest = std::string_view{message}.substr(std::min(end, message.size()));
  for (const std::string_view whole : {"is empty", "must be an object", "found a run of", "No such file or directory"})
    if (rest.find(whole) != std::string_view::npos) return {};
  return says_where(rest) ? std::string{} : "the error names neither line nor field: " + message;
}

}  // namespace

std::vector<Reader> all_readers(const fs::path& scratch) {
  const fs::path cases = TALUS_CASES;
  leave_scene_run(cases / "pendulum.toml", scratch / "scene");
  leave_scene_run(cases / "fence" / "table_2.toml", scratch / "fence");
  leave_cell_run(cases / "cell" / "CNTRL.DAT", scratch / "cell");
  std::vector<Reader> readers;
  add_scene_readers(scratch, readers);
  add_pair_reader(readers);
  add_sweep_readers(readers);
  add_run_readers(scratch, readers);
  add_verification_readers(readers);
  return readers;
}

Reading read(const Reader& reader, const fs::path& file) {
  const auto refused = [&](const std::exception& error) -> Reading {
    return {Ending::refused, error.what(), case_error(error.what(), file)};
  };
  try {
    return {reader.read(file) ? Ending::accepted : Ending::cut_short, {}, {}};
  } catch (const InputError& error) {
    return refused(error);
  } catch (const IoError& error) {
    return refused(error);
  } catch (const records::RecordError& error) {
    return refused(error);
  } catch (const records::FileError& error) {
    return refused(error);
  } catch (const std::exception& error) {
    return {Ending::refused, error.what(), fmt::format("{}: {}", type_name(error), error.what())};
  }
}

fs::path put(const Reader& reader, const std::string& input, const fs::path& folder) {
  const auto write = [&](const std::string& name, const std::string& text) {
    std::ofstream{folder / name, std::ios::binary} << text;
  };
  for (const auto& [name, text] : reader.beside)
    if (!fs::exists(folder / name)) write(name, text);
  write(reader.file, input);
  return folder / reader.file;
}

std::string pattern_of(const std::string& message, const fs::path& file) {
  std::string text = message, pattern;
  for (std::size_t at = text.find(file.string()); at != std::string::npos; at = text.find(file.string(), at))
    text.replace(at, file.string().size(), "FILE");
  const auto is_word = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; };
  for (std::size_t i = 0; i < text.size();) {
    const char c = text[i];
    const std::size_t end = c == '\'' || c == '"' ? text.find(c, i + 1) : std::string::npos;
    if (end != std::string::npos) {
      pattern += std::string{c} + "..." + c;
      i = end + 1;
    } else if (std::isdigit(static_cast<unsigned char>(c)) != 0 && (i == 0 || !is_word(text[i - 1]))) {
      pattern += 'N';
      while (i < text.size() &&
             (is_word(text[i]) || text[i] == '.' || ((text[i] == '-' || text[i] == '+') && text[i - 1] == 'e')))
        ++i;
    } else {
      pattern += c == '\n' ? ' ' : c;
      ++i;
    }
  }
  return pattern.substr(0, 200);
}

}  // namespace talus::fuzz
