#include "verification/problems/program/sweeps/swept_fences.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>

#include "verification/check/case_file.hpp"
#include "verification/problems/program/sweeps/ball_sweep.hpp"
#include "verification/record/json_node.hpp"
#include "verification/record/whole_file.hpp"

namespace talus::verification::problems::swept_scenes {
namespace {

using records::Json;

/// A run of the sweep is that of `talus run` with the same fields, bit by bit; a fence has a verdict.
void check_fence(const Program& program, Differences& differ) {
  // The fence of the template, whose run ends when the rock passes a position: long before its time.
  std::string fence = program.run({"new", "fence"});
  const auto write_line = [&](const std::string& template_line, const std::string& line) {
    const std::size_t at = fence.find("\n# " + template_line) + 1;
    fence.replace(at, fence.find('\n', at) - at, line);
  };
  write_line("end = ", "end = \"exit\"");
  write_line("exit_x = ", "exit_x = \"0.7 m\"");
  program.write("fence.toml", fence);
  const records::Csv csv =
      collected(program, "speeds",
                "base = \"fence.toml\"\noutputs = [\"rock.vx.end\", \"energy.kinetic.max\", \"rock.x.end\"]\n" +
                    axis("fence.rock[0].velocity[0]", "values = [\"-5 m/s\", \"-25 m/s\"]") +
                    axis("fence.columns", "range = [5, 9]\ncount = 3"),
                differ);
  differ.compare("runs of a fence", csv.rows(), std::size_t{6});
  const std::string scene = program.read("fence.toml");
  for (std::size_t row = 0; row < csv.rows(); ++row) {
    const std::string speed{csv.cell(row, 2)}, columns{csv.cell(row, 3)};
    differ.compare("whole number of columns", columns, std::string{row % 3 == 0 ? "5" : row % 3 == 1 ? "7" : "9"});
    std::string changed = scene;
    const auto replace = [&](const std::string& key, const std::string& value) {
      const std::size_t at = changed.find("\n" + key + " = ") + 1, end = changed.find('\n', at);
      changed.replace(at, end - at, key + " = " + value);
    };
    replace("columns", columns);
    const std::size_t rock = changed.find("[[fence.rock]]"), line = changed.find("\nvelocity = ", rock) + 1;
    const std::size_t comma = changed.find(',', line);
    changed.replace(line, comma - line, fmt::format("velocity = [\"{} m/s\"", speed));
    program.write("changed.toml", changed);
    const Json summary = program.json({"run", "changed.toml"}, {{"--json", {}}});
    differ.compare("early end", csv.number(row, "time [s]"), summary.at("outcome").at("time").get<double>());
    // The states are 0.8 ms apart, at most 2 cm.
    const double beyond = 0.7 - csv.number(row, "rock.x.end [m]");
    differ.holds("the run ends where the rock has passed", beyond > 0.0 && beyond < 0.021);
    differ.compare("verdict", std::string{csv.cell(row, "verdict")},
                   summary.at("verdict").at("fence").get<std::string>());
    const std::string evaluations = fmt::format("{}", summary.at("evaluations").get<long>());
    differ.compare("evaluations", std::string{csv.cell(row, "evaluations")}, evaluations);
    if (row == csv.rows() - 1)
      differ.contains("cost up to the early end", program.run({"check", "changed.toml"}),
                      fmt::format(" s, {} force evaluations; each over ", evaluations));
    for (const Json& body : summary.at("bodies"))
      if (body.at("name").get<std::string>() == "rock")
        differ.compare("velocity", csv.number(row, "rock.vx.end [m/s]"), body.at("velocity").at(0).get<double>());
    for (const Json& extreme : summary.at("extremes"))
      if (extreme.at("name").get<std::string>() == "energy.kinetic")
        differ.compare("extreme", csv.number(row, "energy.kinetic.max [N m]"), extreme.at("maximum").get<double>());
  }
  // Whole numbers of a table: a scene takes no others for a number of columns.
  program.write("columns.csv", "n\n5\n9\n");
  const records::Csv table =
      collected(program, "columns",
                "base = \"fence.toml\"\noutputs = [\"rock.vx.end\"]\n[[axis]]\ntable = \"columns.csv\"\n"
                "columns = { \"fence.columns\" = \"n\" }\n" +
                    axis("fence.rock[0].velocity[0]", "values = [\"-25 m/s\"]"),
                differ);
  differ.compare("rows of a table of columns", table.rows(), std::size_t{2});
  for (std::size_t row = 0; row < table.rows(); ++row)
    differ.compare("velocity with the columns of a table", table.number(row, "rock.vx.end [m/s]"),
                   csv.number(row == 0 ? 3 : 5, "rock.vx.end [m/s]"));
}

/// A sweep records only the columns of its outputs: of each group of columns the one with the largest value, or the
/// first one, alone in a sweep, has the extremes of `talus run`, which records all, bit by bit. One of them is reached
/// between the first and the last step, which have rows of all columns.
void check_single_columns(const Program& program, Differences& differ) {
  program.write("lasting.toml", program.run({"new", "fence"}));
  const Json summary = program.json({"run", "lasting.toml"}, {{"--json", {}}});
  const double end = summary.at("outcome").at("time").get<double>();
  const auto size_of = [](const Json& extreme) {
    return std::max(extreme.at("maximum").get<double>(), -extreme.at("minimum").get<double>());
  };
  const auto is_between = [end](const Json& time) { return time.get<double>() > 0.0 && time.get<double>() < end; };
  int sweeps = 0;
  struct Group {
    std::string end;  ///< of the names of its columns
    bool first;       ///< the first of them, in place of that with the largest value
  };
  for (const Group& group : {Group{".vx", false},
                             {".spin", false},
                             {".overlap", false},
                             {".force", false},
                             {".elongation", false},
                             {".tension", false},
                             {"energy.cables", false},
                             {".x", true},
                             {".overlap", true},
                             {".elongation", true}}) {
    const Json* chosen = nullptr;
    for (const Json& extreme : summary.at("extremes"))
      if (extreme.at("name").get<std::string>().ends_with(group.end) &&
          (chosen == nullptr || (!group.first && size_of(extreme) > size_of(*chosen))))
        chosen = &extreme;
    const bool any = chosen != nullptr && size_of(*chosen) > 0.0 &&
                     (is_between(chosen->at("maximum_time")) || is_between(chosen->at("minimum_time")));
    differ.holds("column of the group " + group.end + (group.first ? ", first" : ""), any);
    if (!any) continue;
    const std::string column = chosen->at("name").get<std::string>(), unit = chosen->at("unit").get<std::string>();
    const records::Csv csv =
        collected(program, fmt::format("alone_{}", ++sweeps),
                  fmt::format("base = \"lasting.toml\"\noutputs = [\"{0}.max\", \"{0}.min\"]\n", column) +
                      axis("fence.rock[0].spin", "values = [\"0 rad/s\"]"),
                  differ);
    for (const auto& [name, of] : {std::pair{"max", "maximum"}, std::pair{"min", "minimum"}})
      differ.compare(fmt::format("{} of the column {} alone", of, column),
                     csv.number(0, fmt::format("{}.{} [{}]", column, name, unit)), chosen->at(of).get<double>());
  }
}

/// A deck of 1993 as base: the run of `talus run` of the deck, bit by bit, and of the deck with another speed.
void check_deck(const Program& program, Differences& differ) {
  std::string deck = records::read_whole(case_file("fence/table_2.DAT"));
  deck.replace(deck.find("0.03418558 100000"), 17, "0.17 2000");
  program.write("fence.DAT", deck);
  const records::Csv csv = collected(program, "deck",
                                     "base = \"fence.DAT\"\noutputs = [\"rock.vx.end\", \"rock.y.end\"]\n" +
                                         axis("fence.rock[0].velocity[0]", "values = [\"-65 ft/s\", \"-50 ft/s\"]"),
                                     differ);
  differ.compare("runs of a deck", csv.rows(), std::size_t{2});
  if (csv.rows() != 2) return;
  for (const std::size_t row : {std::size_t{0}, std::size_t{1}}) {
    if (row == 1) program.write("fence.DAT", deck.replace(deck.find("-65.0"), 5, "-50.0"));
    const Json summary = program.json({"run", "fence.DAT"}, {{"--json", {}}});
    for (const Json& body : summary.at("bodies")) {
      if (body.at("name").get<std::string>() != "rock") continue;
      differ.compare("velocity of a deck's rock", csv.number(row, "rock.vx.end [ft/s]"),
                     body.at("velocity").at(0).get<double>());
      differ.compare("position of a deck's rock", csv.number(row, "rock.y.end [ft]"),
                     body.at("position").at(1).get<double>());
    }
  }
}

}  // namespace

void check_fences(const Program& program, Differences& differ) {
  check_fence(program, differ);
  check_single_columns(program, differ);
  check_deck(program, differ);
}

}  // namespace talus::verification::problems::swept_scenes
