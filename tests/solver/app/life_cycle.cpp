/// Life cycle of runs by the built program: the same checks for a scene and for a cell.
#include <signal.h>
#include <unistd.h>

#include <boost/test/unit_test.hpp>
#include <chrono>
#include <fstream>
#include <nlohmann/json.hpp>
#include <thread>

#include "solver/io/file/folder_lock.hpp"
#include "tests/solver/app/program.hpp"

BOOST_AUTO_TEST_SUITE(life_cycle_tests)

namespace {

using Json = nlohmann::json;

/// A command and a file that it runs.
struct Kind {
  std::string command, other;        ///< `other`: command that does not resume these runs
  std::string file, text;            ///< name and text of the scene file
  std::vector<const char*> written;  ///< files that only this kind writes
  std::vector<std::string> option;   ///< option that a resumed run retains

  std::string put(const Folder& folder) const { return folder.file(file.c_str(), text); }
};

std::vector<Kind> kinds() {
  std::string scene_text = talus::read_text(scene("two_cable.toml"));
  const std::string cell_text = "0 1\n1.7e4 34693.877551020405 1e-3 7.2e-7 9.81 0.00897\n8 10 11 5.0\n6e-7 1e-2 5e-1\n";
  return {{"run", "cell", "scene.toml", scene_text, {"final_state.json"}, {"--integrator", "rk4"}},
          {"cell", "run", "CNTRL.DAT", cell_text, {"RESTART.DAT", "cell.pvd"}, {"--integrator", "euler_cromer"}}};
}

/// Arguments of a run of about a second.
std::vector<std::string> arguments(const Kind& kind, const std::string& file, const std::string& out) {
  std::vector<std::string> all{kind.command, file, "--out", out};
  if (kind.command == "run") all.insert(all.end(), {"--end", "60 s", "--frames", "7"});
  return all;
}

/// Interrupts a run in `out`; returns its output.
std::string interrupted(const Kind& kind, const std::string& file, const Folder& folder, const std::string& out,
                        int signal = SIGINT) {
  const fs::path output = folder.path / "output";
  fs::remove(output);
  // A scene's geometry, or a cell's first checkpoint, exists once the run has begun.
  const fs::path once = fs::path{out} / (kind.command == "run" ? "scene_geometry" : "checkpoint.json");
  StartedProgram program{TALUS_EXECUTABLE, arguments(kind, file, out), {output, output}};
  while (!fs::exists(once))
    std::this_thread::sleep_for(std::chrono::milliseconds{1});
  std::this_thread::sleep_for(std::chrono::milliseconds{20});
  program.send(signal);
  BOOST_TEST_REQUIRE(program.exit_code() == 128 + signal, talus::read_text(output));
  return talus::read_text(output);
}

void refused(const std::vector<std::string>& command_line, int code, const std::string& message) {
  const Ended ended = talus_ran(command_line);
  BOOST_TEST(ended.code == code);
  BOOST_TEST(ended.err.rfind("talus: " + message, 0) == 0U, ended.err);
}

}  // namespace

BOOST_AUTO_TEST_CASE(an_interrupted_run_is_resumed_to_the_same_files) {
  for (const Kind& kind : kinds()) {
    const Folder folder;
    const std::string file = kind.put(folder), whole = folder.path / "whole";
    const Ended straight = talus_ran(arguments(kind, file, whole));
    BOOST_TEST_REQUIRE(straight.code == 0, straight.err);
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
      BOOST_TEST_CONTEXT(kind.command << ", signal " << signal) {
        const std::string out = folder.path / std::to_string(signal);
        const std::string resume = "talus " + kind.command + " --resume " + out;
        const std::string printed = interrupted(kind, file, folder, out, signal);
        const std::string unit = kind.command == "run" ? " s" : "";  // CNTRL.DAT has no units
        BOOST_TEST(holds(printed, "\nresume: " + resume + "\n"), printed);
        BOOST_TEST(holds(printed, "files: " + out + ": summary.json, "), printed);
        BOOST_TEST(holds(printed, ", checkpoint.json\n"), printed);
        BOOST_TEST(holds(printed, std::string{"talus: "} +
                                      (signal == SIGINT    ? "SIGINT"
                                       : signal == SIGTERM ? "SIGTERM"
                                                           : "SIGHUP") +
                                      ": the run was interrupted at t = "),
                   printed);
        BOOST_TEST(holds(printed, unit + " and saved in " + out + "/checkpoint.json; resume it by " + resume + "\n"),
                   printed);
        const Json summary = Json::parse(talus::read_text(out + "/summary.json"));
        BOOST_TEST(summary.at("outcome").at("kind") == "stopped");
        BOOST_TEST(!summary.contains("resume"));
        const Ended resumed = talus_ran({kind.command, "--resume", out});
        BOOST_TEST_REQUIRE(resumed.code == 0, resumed.err);
        BOOST_TEST(holds(resumed.out, "files: " + out + ": summary.json, "));
        BOOST_TEST(!holds(resumed.out, "checkpoint.json"));
        same_files(out, whole);
        for (const char* name : kind.written)
          BOOST_TEST(fs::exists(fs::path{out} / name), name);
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(a_run_under_nohup_outlives_its_terminal) {
  for (const Kind& kind : kinds()) {
    BOOST_TEST_CONTEXT(kind.command) {
      const Folder folder;
      const std::string file = kind.put(folder), out = folder.path / "out";
      std::vector<std::string> command_line = arguments(kind, file, out);
      command_line.insert(command_line.begin(), TALUS_EXECUTABLE);
      StartedProgram program{"/usr/bin/nohup", command_line};
      while (!fs::exists(fs::path{out} / (kind.command == "run" ? "scene_geometry" : "checkpoint.json")))
        std::this_thread::sleep_for(std::chrono::milliseconds{1});
      program.send(SIGHUP);
      BOOST_TEST(program.exit_code() == 0);
      BOOST_TEST(Json::parse(talus::read_text(out + "/summary.json")).at("outcome").at("kind") == "finished");
    }
  }
}

BOOST_AUTO_TEST_CASE(a_run_that_has_ended_is_not_resumed) {
  for (const Kind& kind : kinds()) {
    BOOST_TEST_CONTEXT(kind.command) {
      const Folder folder;
      const std::string file = kind.put(folder), out = folder.path / "out";
      BOOST_TEST(talus_ran(arguments(kind, file, out)).code == 0);
      const auto before = files(out);
      const Ended again = talus_ran({kind.command, "--resume", out});
      BOOST_TEST(again.code == 0);
      BOOST_TEST(again.out == out + ": the run is finished; there is nothing to resume\n");
      BOOST_TEST(talus_ran({kind.command, "--resume", out, "--json"}).out == before.at("summary.json"));
      for (const auto& option : {kind.option, std::vector<std::string>{"--out", out}}) {
        std::vector<std::string> command_line{kind.command, "--resume", out};
        command_line.insert(command_line.end(), option.begin(), option.end());
        refused(command_line, 2,
                option[0] + ": the run in " + out + " has ended; only an interrupted run can be resumed\n");
      }
      BOOST_TEST((files(out) == before));
    }
  }
}

BOOST_AUTO_TEST_CASE(what_does_not_fit_the_interrupted_run_is_refused) {
  for (const Kind& kind : kinds()) {
    BOOST_TEST_CONTEXT(kind.command) {
      const Folder folder;
      const std::string file = kind.put(folder), out = folder.path / "out", checkpoint = out + "/checkpoint.json";
      interrupted(kind, file, folder, out);
      const auto before = files(out);
      std::vector<std::string> with_option{kind.command, "--resume", out};
      with_option.insert(with_option.end(), kind.option.begin(), kind.option.end());
      refused(with_option, 2, kind.option[0] + ": a resumed run (--resume) keeps the options of its start\n");
      refused({kind.other, "--resume", out}, 2,
              checkpoint + ": found a run of `talus " + kind.command + "`; resume it by `talus " + kind.command +
                  " --resume " + out + "`\n");
      const std::string none = folder.path / "none";
      refused({kind.command, "--resume", none}, 4, none + ": found no folder of this name; it must be ");
      refused({kind.command}, 2, "SCENE is required, or --resume DIR\nhelp: talus " + kind.command + " --help\n");
      {
        const talus::FolderLock lock{out};
        const std::string in_use = out + ": another run (process " + std::to_string(::getpid()) +
                                   ") is writing into it; each run needs a separate folder\n";
        refused({kind.command, "--resume", out}, 4, in_use);
        refused(arguments(kind, file, out), 4, in_use);
      }
      std::ofstream{file} << kind.text << "\n";
      refused({kind.command, "--resume", out}, 2, checkpoint + ": scene_fnv1a: found ");
      std::ofstream{file} << kind.text;
      std::string damaged = before.at("checkpoint.json");
      damaged.replace(damaged.find("\"steps\": "), 9, "\"steps\": 1");
      std::ofstream{checkpoint} << damaged;
      refused({kind.command, "--resume", out}, 2, checkpoint + ": fnv1a: found ");
      std::ofstream{checkpoint} << before.at("checkpoint.json");
      BOOST_TEST((files(out) == before), "a refused request changed the folder");
      // A scene file that was moved is given again.
      const std::string moved = folder.path / ("moved_" + kind.file);
      fs::rename(file, moved);
      refused({kind.command, "--resume", out}, 4,
              checkpoint + ": scene_file: " + file + ": No such file or directory\n");
      const Ended resumed = talus_ran({kind.command, moved, "--resume", out});
      BOOST_TEST(resumed.code == 0, resumed.err);
    }
  }
}

BOOST_AUTO_TEST_CASE(a_folder_that_cannot_be_made_or_written) {
  for (const Kind& kind : kinds()) {
    BOOST_TEST_CONTEXT(kind.command) {
      const Folder folder;
      const std::string file = kind.put(folder);
      refused(arguments(kind, file, "/dev/null/out"), 4, "/dev/null/out: found the file '/dev/null' above it; ");
      const std::string out = folder.path / "out";
      fs::create_directories(fs::path{out} / "summary.json/in_the_way");
      refused(arguments(kind, file, out), 4, out + "/summary.json: Is a directory\n");
    }
  }
}

BOOST_AUTO_TEST_CASE(no_file_of_the_other_kind_stays) {
  const std::vector<Kind> both = kinds();
  for (const auto& [first, second] : {std::pair{both[0], both[1]}, {both[1], both[0]}}) {
    BOOST_TEST_CONTEXT(second.command << " after " << first.command) {
      const Folder folder;
      const std::string out = folder.path / "out", fresh = folder.path / "fresh";
      interrupted(first, first.put(folder), folder, out);
      folder.file("out/notes.txt", "mine"), folder.file("out/.history.csv.talus-a1B2c3", "");
      fs::remove(fs::path{out} / "RESTART.DAT");  // is kept for another cell
      const std::string file = second.put(folder);
      BOOST_TEST(talus_ran(arguments(second, file, out)).code == 0);
      BOOST_TEST(talus_ran(arguments(second, file, fresh)).code == 0);
      BOOST_TEST(fs::remove(fs::path{out} / "notes.txt"));
      same_files(out, fresh);
      BOOST_TEST(!fs::exists(fs::path{out} / (first.command == "run" ? "scene_geometry" : "cell_states")));
    }
  }
}

// Arguments that are not UTF-8 are refused in any case; the name of the current folder is no argument.
BOOST_AUTO_TEST_CASE(a_run_in_a_folder_whose_name_is_not_utf8_is_refused_before_it_starts) {
  for (const Kind& kind : kinds()) {
    BOOST_TEST_CONTEXT(kind.command) {
      const Folder folder;
      const fs::path current = folder.path / "caf\xe9";
      fs::create_directory(current);
      std::ofstream{current / kind.file} << kind.text;
      const Ended ended = ran("/bin/sh", {"-c", "cd \"$0\" && exec \"$@\"", current.string(), TALUS_EXECUTABLE,
                                          kind.command, kind.file, "--out", "out"});
      BOOST_TEST(ended.code == 2);
      BOOST_TEST(holds(ended.err, ": the folder of the scene is not UTF-8; the checkpoint names it\n"), ended.err);
      BOOST_TEST(!fs::exists(current / "out"));
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
