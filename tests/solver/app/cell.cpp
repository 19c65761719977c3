/// The shear cell by the built program: its output, refused input, and runs that are killed and resumed.
#include <fmt/format.h>

#include <signal.h>
#include <sys/wait.h>

#include <boost/test/unit_test.hpp>
#include <chrono>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>
#include <thread>

#include "tests/solver/app/program.hpp"

BOOST_AUTO_TEST_SUITE(cell_tests)

namespace {

using Json = nlohmann::json;

const std::string control = "0 1\n1.7e4 34693.877551020405 1e-3 7.2e-7 9.81 0.00897\n8 10 11 5.0\n6e-7 1e-3 1e-2\n";

/// Starts the program and sends it a signal once a file exists; returns its exit status as given by waitpid.
int stopped(const std::vector<std::string>& arguments, const fs::path& once, int signal) {
  StartedProgram program{TALUS_EXECUTABLE, arguments};
  while (!fs::exists(once))
    std::this_thread::sleep_for(std::chrono::milliseconds{1});
  program.send(signal);
  return program.wait();
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_run_leaves_its_files) {
  const Folder folder;
  const std::string file = folder.file("CNTRL.DAT", control), out = folder.path / "out";
  const Ended ended = talus_ran({"cell", file, "--out", out, "--units", "SI"});
  BOOST_TEST_REQUIRE(ended.code == 0, ended.err);
  BOOST_TEST(holds(ended.out, "overburden               8000 N/m^2"));
  BOOST_TEST(holds(ended.out, "stress_ratio_top"));
  const auto left = files(out);
  for (const char* name :
       {"RESTART.DAT", "PIC.DAT", "cell.pvd", "history.csv", "profile.csv", "plot.json", "summary.json"})
    BOOST_TEST(left.contains(name), name);
  BOOST_TEST(!left.contains("checkpoint.json"));
  BOOST_TEST(left.contains("cell_states/cell_000009.vtp"));
  const Json summary = Json::parse(left.at("summary.json"));
  BOOST_TEST(summary["outcome"]["kind"] == "finished");
  BOOST_TEST(summary["results"]["top_shear"]["unit"] == "N/m^2");
  BOOST_TEST(summary["counts"]["steps"] == 16667);
  // The printed means are followed by their standard errors.
  for (const char* name : {"top_shear", "top_normal"}) {
    const Json& result = summary["results"][name];
    const std::string expected = fmt::format("  {:24} {:.4g} N/m^2 +- {:.2g} ", name, result["value"].get<double>(),
                                             result["error"].get<double>());
    BOOST_TEST(holds(ended.out, expected), expected);
  }
  const std::string history = left.at("history.csv");
  BOOST_TEST(std::count(history.begin(), history.end(), '\n') == 11);
  // Without a unit system no units are printed; the numbers are the same.
  const Ended bare = talus_ran({"cell", file, "--json"});
  const Json plain = Json::parse(bare.out);
  BOOST_TEST(plain["units"].is_null());
  BOOST_TEST(!plain["results"]["top_shear"].contains("unit"));
  BOOST_TEST(plain["results"]["top_shear"]["value"] == summary["results"]["top_shear"]["value"]);
}

BOOST_AUTO_TEST_CASE(a_run_that_was_killed_goes_on_to_the_same_files) {
  const Folder folder;
  const std::string file = folder.file("CNTRL.DAT", control);
  for (const std::string integrator : {"velocity_verlet", "euler_cromer", "central_difference"}) {
    const std::string whole = folder.path / (integrator + "_whole"), killed = folder.path / (integrator + "_killed");
    BOOST_TEST(talus_ran({"cell", file, "--out", whole, "--integrator", integrator}).code == 0);
    // SIGKILL leaves no time to write anything; half-written files are removed when the run is resumed.
    const int status = stopped({"cell", file, "--out", killed, "--integrator", integrator},
                               fs::path{killed} / "cell_states/cell_000003.vtp", SIGKILL);
    BOOST_TEST(WIFSIGNALED(status));
    BOOST_TEST(fs::exists(fs::path{killed} / "checkpoint.json"));
    const Ended ended = talus_ran({"cell", "--resume", killed});
    BOOST_TEST_REQUIRE(ended.code == 0, ended.err);
    same_files(killed, whole);
  }
}

namespace {

/// Runs a rough cell of cases, killed and resumed, and whole; returns its summary.
Json resumed_summary(const char* name) {
  const Folder folder;
  std::string text = talus::read_text(scene(name));
  text.replace(text.find("5 ms"), 4, "2 ms"), text.replace(text.find("100 ms"), 6, "20 ms");
  const std::string file = folder.file("rough.toml", text);
  const std::string whole = folder.path / "whole", killed = folder.path / "killed";
  BOOST_TEST(talus_ran({"cell", file, "--out", whole}).code == 0);
  const int status =
      stopped({"cell", file, "--out", killed}, fs::path{killed} / "cell_states/cell_000003.vtp", SIGKILL);
  BOOST_TEST(WIFSIGNALED(status));
  BOOST_TEST(talus_ran({"cell", "--resume", killed}).code == 0);
  same_files(killed, whole);
  const auto left = files(whole);
  BOOST_TEST(holds(left.at("history.csv"), ",sliding_fraction,spin [rad/s]\n"));
  BOOST_TEST(holds(left.at("cell_states/cell_000009.vtp"), "Name=\"spin\""));
  Json summary = Json::parse(left.at("summary.json"));
  BOOST_TEST(!summary["groups"].contains("stepped_restitution"));
  BOOST_TEST(summary["results"]["spin"]["value"] < 0.0);
  BOOST_TEST(summary["results"]["sliding_fraction"]["value"] > 0.0);
  BOOST_TEST(summary["energy"]["friction_work"] > 0.0);
  return summary;
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_rough_cell_leaves_spins_and_goes_on_to_the_same_files) {
  const Json linear = resumed_summary("cell/rough.toml")["parameters"];
  BOOST_TEST(linear["law"] == "linear_spring_dashpot");
  BOOST_TEST(linear["end_rule"] == "clamped");
  BOOST_TEST(linear["friction"] == 0.5);
  BOOST_TEST(linear["shear_stiffness"] == 14214.0);
  BOOST_TEST(!linear.contains("shear_law"));
  const Json spheres = resumed_summary("cell/spheres.toml")["parameters"];
  BOOST_TEST(spheres["law"] == "hertz");
  BOOST_TEST(spheres["friction"] == 0.5);
  BOOST_TEST(spheres["shear_law"] == "mindlin");
  BOOST_TEST(spheres["shear_modulus"] == 144e6);
  BOOST_TEST(!spheres.contains("shear_stiffness"));
}

BOOST_AUTO_TEST_CASE(a_run_whose_last_files_cannot_be_written_can_be_resumed) {
  const Folder folder;
  const std::string file = folder.file("CNTRL.DAT", control);
  const std::string whole = folder.path / "whole";
  BOOST_TEST(talus_ran({"cell", file, "--out", whole}).code == 0);
  for (const char* name : {"history.csv", "summary.json"}) {
    const std::string left = folder.path / (std::string{"without_"} + name);
    fs::create_directories(fs::path{left} / name / "in_the_way");
    BOOST_TEST(talus_ran({"cell", file, "--out", left}).code == 4);
    BOOST_TEST(fs::exists(fs::path{left} / "checkpoint.json"));
    fs::remove_all(fs::path{left} / name);
    BOOST_TEST(talus_ran({"cell", "--resume", left}).code == 0);
    same_files(left, whole);
  }
}

BOOST_AUTO_TEST_CASE(another_run_is_not_taken_on_for_this_one) {
  const Folder folder;
  const std::string file = folder.file("CNTRL.DAT", control), out = folder.path / "out";
  stopped({"cell", file, "--out", out}, fs::path{out} / "checkpoint.json", SIGKILL);
  // The next run into the folder is refused because of its control file, or starts and removes the first run's
  // checkpoint.
  BOOST_TEST(talus_ran({"cell", folder.file("BAD.DAT", "0 1\n"), "--out", out}).code == 2);
  BOOST_TEST(fs::exists(fs::path{out} / "checkpoint.json"));
  // Or it is refused because of a file that its control file names.
  const std::string restarted = folder.file("CNTRL_1.DAT", std::string{"1"}.append(control, 1));
  folder.file("RESTART.DAT", "no number\n");
  BOOST_TEST(talus_ran({"cell", restarted, "--out", out}).code == 2);
  BOOST_TEST(fs::exists(fs::path{out} / "checkpoint.json"));
  fs::create_directories(fs::path{out} / "RESTART.DAT.d");
  fs::remove(fs::path{out} / "RESTART.DAT"), fs::rename(fs::path{out} / "RESTART.DAT.d", fs::path{out} / "RESTART.DAT");
  BOOST_TEST(talus_ran({"cell", file, "--out", out, "--seed", "6"}).code == 4);
  const Json checkpoint = Json::parse(talus::read_text(fs::path{out} / "checkpoint.json"));
  BOOST_TEST(checkpoint["memory"]["choices.seed"] == Json::array({6.0}));
}

BOOST_AUTO_TEST_CASE(no_file_of_an_earlier_run_stays_beside_those_of_another) {
  const Folder folder;
  const std::string file = folder.file("CNTRL.DAT", control), out = folder.path / "out";
  BOOST_TEST(talus_ran({"cell", file, "--out", out}).code == 0);
  // Unfinished files of a killed run, and files of the user.
  folder.file("out/.history.csv.talus-a1B2c3", ""), folder.file("out/cell_states/.cell_000003.vtp.talus-a1B2c3", "");
  folder.file("out/notes.txt", "mine"), folder.file("out/.history.csv.backup", "mine"),
      folder.file("out/cell_states/cell_notes.vtp", "mine");
  const std::string without = folder.file("NO_PICTURES.DAT", "0 0" + control.substr(3));
  BOOST_TEST(talus_ran({"cell", without, "--out", out}).code == 0);
  const std::string fresh = folder.path / "fresh";
  BOOST_TEST(talus_ran({"cell", without, "--out", fresh}).code == 0);
  auto left = files(out);
  BOOST_TEST(left.erase("notes.txt") == 1U);
  BOOST_TEST(left.erase(".history.csv.backup") == 1U);
  BOOST_TEST(left.erase("cell_states/cell_notes.vtp") == 1U);
  BOOST_TEST((left == files(fresh)));
}

BOOST_AUTO_TEST_CASE(undefined_means_are_null) {
  const Folder folder;
  const std::string out = folder.path / "out";
  // Neither shear nor pressure acts on the discs.
  const std::string still =
      folder.file("STILL.DAT", "0 0\n1.7e4 34693.877551020405 1e-3 7.2e-7 0 0.00897\n8 10 11 0\n6e-7 1e-3 1e-2\n");
  const Ended ended = talus_ran({"cell", still, "--out", out, "--json"});
  BOOST_TEST_REQUIRE(ended.code == 0, ended.err);
  const Json results = Json::parse(ended.out)["results"];
  BOOST_TEST(results["stress_ratio_top"]["value"].is_null());
  BOOST_TEST(results["top_shear"]["value"] == 0.0);
  BOOST_TEST(talus_ran({"plot", out}).code == 0);
  const Ended element = talus_ran({"plot", out, "--history", "depth", "--element", "3"});
  BOOST_TEST(element.code == 2);
  BOOST_TEST(holds(element.err, "history 'depth' belongs to the scene; found --element 3; remove it"), element.err);
}

BOOST_AUTO_TEST_CASE(cells_are_run_by_talus_cell) {
  const Ended ran = talus_ran({"run", scene("cell/CNTRL.DAT")});
  BOOST_TEST(ran.code == 2);
  BOOST_TEST(holds(ran.err, "CNTRL.DAT: a shear cell is run by `talus cell`"), ran.err);
  const Ended listed = talus_ran({"list", "fields"});
  for (const char* const name : {"overburden", "wall_discs", "growth", "end_rule", "images", "every", "jump"})
    BOOST_TEST(holds(listed.out, name), name);
}

BOOST_AUTO_TEST_CASE(a_restart_of_1989_warns_of_what_it_forgot) {
  const Folder folder;
  const std::string file = folder.file("CNTRL.DAT", control), out = folder.path / "out";
  BOOST_TEST(talus_ran({"cell", file, "--out", out}).code == 0);
  fs::copy_file(fs::path{out} / "RESTART.DAT", folder.path / "RESTART.DAT");
  folder.file("CNTRL.DAT", std::string{"1"}.append(control, 1));
  const Ended ended = talus_ran({"cell", file, "--json"});
  BOOST_TEST_REQUIRE(ended.code == 0, ended.err);
  BOOST_TEST(holds(ended.err, "contains neither the block"));
  BOOST_TEST(holds(ended.err, "contacts start without history"));
  const Json summary = Json::parse(ended.out);
  BOOST_TEST(summary["warnings"].size() == 1U);
  // An interrupted and resumed run ends with the same files, including its warning, time and cycles.
  const std::string whole = folder.path / "whole", left = folder.path / "left";
  BOOST_TEST(talus_ran({"cell", file, "--out", whole}).code == 0);
  stopped({"cell", file, "--out", left}, fs::path{left} / "cell_states/cell_000003.vtp", SIGTERM);
  BOOST_TEST(talus_ran({"cell", "--resume", left}).code == 0);
  same_files(left, whole);
  BOOST_TEST(talus::read_text(fs::path{whole} / "RESTART.DAT").starts_with("0.02000"));
  BOOST_TEST(holds(talus::read_text(fs::path{whole} / "history.csv"), "\n0.011"));
  // The time continues from that of the first run.
  BOOST_TEST(summary["outcome"]["time"].get<double>() > 0.0199);
  fs::remove(folder.path / "RESTART.DAT");
  BOOST_TEST(talus_ran({"cell", file}).code == 4);
}

BOOST_AUTO_TEST_CASE(options_that_mean_nothing_are_refused) {
  const Folder folder;
  const std::string
      file = scene("cell/CNTRL.DAT"),
      many = folder.file(
          "MANY.DAT", "0 0\n1.7e4 34693.877551020405 1e-3 7.2e-7 9.81 100\n100000 100000 100000 5.0\n6e-7 1e-3 1e-2\n");
  for (const auto& [arguments, said] : std::vector<std::pair<std::vector<std::string>, std::string>>{
           {{"cell", file, "--out", ""}, "--out: found \"\"; a value must follow"},
           {{"cell", file, "--integrator", ""}, "--integrator: found \"\"; a value must follow"},
           {{"cell", file, "--seed", "9007199254740993"},
            "--seed: found 9007199254740993; it must be a number between 0"},
           {{"cell", file, "--seed", "-1"}, "--seed: found -1; it must be a number between 0 and 9007199254740991"},
           {{"cell", file, "--virtual", "--jump"},
            "--jump: found on; it requires images = \"nearest\", not virtual discs"},
           {{"study", "shear", "--time", "nan"}, "--time: found nan; it must be a number between 0.01 and 1000"},
           {{"cell", many}, "NHT: found 100000; it must be at most 100 of 100000 columns"}}) {
    const Ended ended = talus_ran(arguments);
    BOOST_TEST(ended.code == 2);
    BOOST_TEST(holds(ended.err, said), ended.err);
  }
}

BOOST_AUTO_TEST_CASE(runs_that_fail_say_why) {
  // A block that hits soft discs at speed: they are pressed through each other.
  const Folder folder;
  const std::string file =
      folder.file("CNTRL.DAT", "0 0\n1e3 2e3 1e-3 7.2e-7 9.81e5 0.9\n3 10 11 5.0\n2e-6 1e-3 1e-1\n");
  const std::string out = folder.path / "out";
  const Ended ended = talus_ran({"cell", file, "--out", out});
  BOOST_TEST(ended.code == 3);
  // It failed before its first LOOP: the listed files exist, and the beginning of its history.
  BOOST_TEST(holds(ended.out, "files: " + out + ": summary.json, history.csv, profile.csv, plot.json\n"));
  BOOST_TEST(!fs::exists(fs::path{out} / "RESTART.DAT"));
  BOOST_TEST(talus_ran({"plot", out}).code == 0);
  BOOST_TEST(holds(ended.err, "talus: "));
  const Json summary = Json::parse(talus::read_text(fs::path{out} / "summary.json"));
  BOOST_TEST(summary["outcome"]["kind"] == "diverged");
  BOOST_TEST(summary["outcome"].contains("message"));
  BOOST_TEST(summary["results"]["depth"]["value"].is_null());  // there is no mean yet
}

BOOST_AUTO_TEST_CASE(a_cell_is_exported_for_lammps_with_dashpots_if_they_may_stand_for_latches) {
  const Folder folder;
  const std::string out = folder.path / "lammps";
  const Ended refused = talus_ran({"export", "lammps", scene("cell/ice.toml"), "--out", out});
  BOOST_TEST(refused.code == 2);
  const std::string restarted = folder.file("RESTARTED.DAT", std::string{"1"}.append(control, 1));
  const Ended other = talus_ran({"export", "lammps", restarted, "--dashpot", "--out", folder.path / "other"});
  BOOST_TEST(other.code == 2);
  BOOST_TEST(holds(other.err, "RESTRT: found 1; the cell is written as it is filled: it must be 0"));
  BOOST_TEST(!fs::exists(folder.path / "other"));
  BOOST_TEST(holds(refused.err, "law = latching_spring (a restitution of 0.7), which LAMMPS does not have"));
  BOOST_TEST(!fs::exists(out));
  BOOST_TEST(talus_ran({"export", "lammps", scene("cell/ice.toml"), "--out", out, "--dashpot"}).code == 0);
  BOOST_TEST(holds(talus::read_text(fs::path{out} / "discs.data"), "102 atoms"));
  BOOST_TEST(holds(talus::read_text(fs::path{out} / "in.discs"), "pair_style"));
  // Laws that LAMMPS has are exported without replacement.
  BOOST_TEST(talus_ran({"export", "lammps", scene("cell/rough.toml"), "--out", out}).code == 0);
  BOOST_TEST(holds(talus::read_text(fs::path{out} / "in.discs"), "linear_history"));
  // 8 G: the radius of the law is that of LAMMPS.
  BOOST_TEST(talus_ran({"export", "lammps", scene("cell/spheres.toml"), "--out", out}).code == 0);
  BOOST_TEST(
      holds(talus::read_text(fs::path{out} / "in.discs"), "tangential mindlin_rescale/force 1152000000 0.0 0.5"));
  const auto exported = [&](const std::string& latching, const std::string& law) {
    std::string text = talus::read_text(scene("cell/ice.toml"));
    text.replace(text.find(latching), latching.size(), law);
    return talus_ran({"export", "lammps", folder.file("cell.toml", text), "--out", out, "--dashpot"});
  };
  const std::string stiffness = "stiffness = \"1.7e4 N/m\"";
  const std::string hertz = "law = \"hertz\"\nmodulus = \"700 MPa\"\nradius = \"0.25 mm\"\n";
  BOOST_TEST(exported(stiffness, hertz + "dashpot = \"constant\"").code == 0);
  BOOST_TEST(holds(talus::read_text(fs::path{out} / "in.discs"), "pair_coeff * * hertz 933333333.3333"));
  BOOST_TEST(holds(exported(stiffness, hertz).err,
                   "cell.toml: found law = hertz (a restitution of 0.7), which LAMMPS does not have; the dashpot is "
                   "tsuji; it must be constant"));
  BOOST_TEST(holds(
      exported(stiffness, "law = \"hunt_crossley\"\nreference_overlap = \"0.01 mm\"\nexponent = 1.5\n" + stiffness).err,
      "which LAMMPS does not have; it must be linear_spring_dashpot, hertz or latching_spring"));
}

// Colliding discs: energies change, stresses and contacts are measured, and their means are those of the same cell run
// by Talus.
BOOST_AUTO_TEST_CASE(lammps_prints_what_a_cell_prints) {
  const Folder folder;
  const std::string text = talus::read_text(scene("cell/ice.toml"));
  const std::string latching = "restitution = 0.7 ";
  const std::size_t offset = text.find(latching);
  BOOST_REQUIRE(offset != std::string::npos);
  const std::string cell = folder.file(
      "cell.toml",
      std::string{text}.replace(offset, latching.size(), "law = \"linear_spring_dashpot\"\nrestitution = 0.7 "));
  const std::string out = folder.path / "lammps";
  const Ended ended = talus_ran({"export", "lammps", cell, "--out", out});
  BOOST_TEST(ended.code == 0, ended.err);
  BOOST_TEST(holds(ended.out, "lmp -in in.discs   # 500000 steps to t = 0.1\n"), ended.out);
  // The means of both programs exclude the first quarter.
  BOOST_TEST(holds(talus::read_text(fs::path{out} / "in.discs"), "\"means after step 125000, "));
  if (std::system("command -v lmp > /dev/null 2>&1") != 0) return;  // Debian: apt-get install lammps
  BOOST_REQUIRE(std::system(("cd '" + out + "' && lmp -in in.discs > screen.txt 2>&1").c_str()) == 0);
  std::istringstream screen{talus::read_text(fs::path{out} / "screen.txt")};
  std::set<double> energies;
  std::map<std::string, double> means;
  for (std::string line; std::getline(screen, line);) {
    std::istringstream numbers{line};
    double step{}, time{}, energy{}, shear{}, normal{}, contacts{}, value{};
    if (numbers >> step >> time >> energy >> shear >> normal >> contacts && step > 0.0) {
      energies.insert(energy);
      BOOST_TEST(normal > 0.0);
      BOOST_TEST(contacts > 0.0);
    }
    std::string name;
    if (std::istringstream tokens{line}; tokens >> name >> value) means[name] = value;
  }
  BOOST_TEST(energies.size() == 20U);
  const Json results = Json::parse(talus_ran({"cell", cell, "--json"}).out).at("results");
  for (const char* name : {"stress_ratio_top", "coordination"}) {
    const Json& here = results.at(name);
    BOOST_TEST(std::abs(means.at(name) - here.at("value").get<double>()) < 5.0 * here.at("error").get<double>(), name);
  }
  BOOST_TEST(means.at("top_shear") / means.at("top_normal") == means.at("stress_ratio_top"),
             boost::test_tools::tolerance(1e-3));
}

BOOST_AUTO_TEST_SUITE_END()
