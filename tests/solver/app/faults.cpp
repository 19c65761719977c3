/// Disturbances of a run: kill -9 at any time, signals, closed streams, full or read-only disks, a second run in its
/// folder, other locales, unusual paths, little memory. The folder contains complete files at any time, the program
/// ends with a message, and the resumed run writes the files of an undisturbed one.
#include <fmt/format.h>
#include <sys/mount.h>
#include <sys/wait.h>
#include <unistd.h>

#include <boost/test/unit_test.hpp>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <locale>
#include <nlohmann/json.hpp>
#include <random>
#include <thread>
#include <utility>

#include "solver/app/command.hpp"
#include "tests/solver/app/program.hpp"
#include "verification/record/audits.hpp"

BOOST_AUTO_TEST_SUITE(faults_tests)

namespace {

using Json = nlohmann::json;
using Clock = std::chrono::steady_clock;
using Arguments = std::vector<std::string>;

/// Runs `script` in a shell, with $TALUS as the program and $1, $2, ... as the arguments.
Ended shell(const std::string& script, Arguments shell_arguments = {}) {
  shell_arguments.insert(shell_arguments.begin(), {"-c", "TALUS='" TALUS_EXECUTABLE "'\n" + script, "sh"});
  return ran("/bin/bash", shell_arguments);
}

/// A run by its command without --out, and the files that it writes when undisturbed.
struct Undisturbed {
  Arguments command;
  std::map<std::string, std::string> content;
  double seconds{};

  explicit Undisturbed(Arguments run) : command{std::move(run)} {
    const Folder folder;
    const Clock::time_point start = Clock::now();
    const Ended ended = talus_ran(into(folder.path / "run"));
    BOOST_TEST_REQUIRE(ended.code == 0, ended.err);
    seconds = std::chrono::duration<double>(Clock::now() - start).count();
    content = files(folder.path / "run");
  }
  Arguments into(const fs::path& out) const {
    Arguments all = command;
    all.insert(all.end(), {"--out", out.string()});
    return all;
  }
  /// Resumes the run from its checkpoint, or starts it again if it has none.
  Ended continued(const fs::path& out) const {
    if (fs::exists(out / "checkpoint.json")) return talus_ran({command.front(), "--resume", out.string()});
    return talus_ran(into(out));
  }
  void same(const fs::path& out) const {
    const auto found = files(out);
    for (const auto& [name, text] : found)
      BOOST_TEST((content.contains(name) && content.at(name) == text), name << " differs or should not be there");
    BOOST_TEST(found.size() == content.size());
  }
};

Arguments fence_run() { return {"run", scene("fence/table_2.toml"), "--end", "60 ms"}; }
Arguments scene_run(const char* end) {
  return {"run", scene("two_cable.toml"), "--step", "0.5 ms", "--end", end, "--frames", "40"};
}

/// A cell of 80 discs that writes its state after every LOOP; there are 20.
std::string cell_file(const Folder& folder) {
  return folder.file("CNTRL.DAT",
                     "0 1\n1.7e4 34693.877551020405 1e-3 7.2e-7 9.81 0.00897\n8 10 11 5.0\n6e-7 1e-3 2e-2\n");
}

/// True for temporary names, of files and of the folder in which pages are made.
bool is_temporary(const std::string& name) {
  const std::string file = fs::path{name}.filename().string();
  return (file.front() == '.' && file.find(".talus-") != std::string::npos) || name.starts_with(".partial-");
}

/// Checks that every file of an interrupted run is complete: it equals that of the undisturbed run, or the one from
/// before, or it is a file that the run replaces as it advances. Returns the number of temporary files.
int whole_files(const fs::path& out, const Undisturbed& run, const std::map<std::string, std::string>& before = {}) {
  int temporary = 0;
  if (!fs::exists(out)) return 0;
  for (const auto& [name, text] : files(out)) {
    if (is_temporary(name)) {
      ++temporary;
    } else if (name == "checkpoint.json") {
      BOOST_TEST(Json::accept(text), name);
    } else if (name == "RESTART.DAT") {
      const auto lines = [](const std::string& of) { return std::count(of.begin(), of.end(), '\n'); };
      BOOST_TEST(lines(text) == lines(run.content.at(name)), name);
    } else if (name == "PIC.DAT") {  // with as many lines as there are contacts
      BOOST_TEST(text.ends_with('\n'), name);
    } else if (name.ends_with(".vtp") && !run.content.contains(name)) {  // of the step of a checkpoint
      BOOST_TEST(text.ends_with("</VTKFile>\n"), name);
    } else if (!before.contains(name) || before.at(name) != text) {
      BOOST_TEST((run.content.contains(name) && run.content.at(name) == text), name << " is not whole");
    }
  }
  return temporary;
}

long number_of_kills() {
  const char* given = std::getenv("TALUS_FAULTS");
  return given != nullptr ? std::strtol(given, nullptr, 10) : 10;
}

}  // namespace

// The time of each kill is random, up to 1.1 times the duration of the undisturbed run; that duration depends on the
// load of the machine, so runs are killed at different moments each time. One in three runs is killed again while it is
// resumed.
BOOST_AUTO_TEST_CASE(a_run_that_is_killed_continues_to_the_same_files) {
  const Folder folder;
  const std::vector<Undisturbed> runs{Undisturbed{fence_run()}, Undisturbed{scene_run("40 s")},
                                      Undisturbed{scene_run("200 s")}, Undisturbed{{"cell", cell_file(folder)}}};
  std::mt19937 random{20251125U};
  const auto fraction = [&] { return static_cast<double>(random()) / 4294967296.0; };
  long ended = 0;
  talus::records::FaultAudit audit;
  for (long trial = 0; std::cmp_less(audit.kills, number_of_kills()) && ended <= 5 + number_of_kills(); ++trial) {
    const Undisturbed& run = runs[static_cast<std::size_t>(trial) % runs.size()];
    const fs::path out = folder.path / fmt::format("out{}", trial);
    BOOST_TEST_CONTEXT("trial " << trial << ", " << run.command[1]) {
      const auto killed = [&](const Arguments& command) {
        const auto before = fs::exists(out) ? files(out) : std::map<std::string, std::string>{};
        StartedProgram program{TALUS_EXECUTABLE, command};
        std::this_thread::sleep_for(std::chrono::duration<double>{1.1 * run.seconds * fraction()});
        program.send(SIGKILL);
        const bool was = WIFSIGNALED(program.wait());
        if (was) {
          ++audit.kills;
        } else {
          ++ended;
        }
        audit.temporary_files += static_cast<std::size_t>(whole_files(out, run, before));
        return was;
      };
      const auto count = [&] { ++(fs::exists(out / "checkpoint.json") ? audit.resumed : audit.before_checkpoint); };
      // From the start, or from a checkpoint in the middle.
      const bool from_midst = fraction() < 0.5 && run.command.front() == "run";
      Arguments command = run.into(out);
      if (from_midst) {
        command.insert(command.end(), {"--until", run.command[1].ends_with("table_2.toml") ? "30 ms" : "5 s"});
        BOOST_TEST_REQUIRE(talus_ran(command).code == 0);
        command = {"run", "--resume", out.string()};
      }
      if (killed(command)) {
        count();
        if (fraction() < 1.0 / 3.0 && fs::exists(out / "checkpoint.json") &&
            killed({run.command.front(), "--resume", out.string()}))
          count();
      }
      const Ended last = run.continued(out);
      BOOST_TEST(last.code == 0, last.err);
      run.same(out);
      ++audit.runs;
      audit.identical += files(out) == run.content ? 1 : 0;
      fs::remove_all(out);
    }
  }
  fmt::print(
      "faults: {} kills, {} of them before a checkpoint, {} resumed; {} came after the end; {} temporary files "
      "left and removed; {} runs with identical files\n",
      audit.kills, audit.before_checkpoint, audit.resumed, ended, audit.temporary_files, audit.identical);
  if (const char* const file = std::getenv("TALUS_FAULTS_FILE")) talus::records::write_faults(audit, file);
  BOOST_TEST(audit.kills > 0U);
}

BOOST_AUTO_TEST_CASE(a_reader_that_has_gone_costs_no_file) {
  const Folder folder;
  const Undisturbed run{fence_run()};
  const fs::path out = folder.path / "out";
  // A pipe without a reader, a closed stdout, a full one, all streams closed; with the exit status and the message.
  const std::string start = "\"$TALUS\" \"$@\" ";
  for (const auto& [script, code, expected] :
       {std::tuple{start + "2>/dev/null | head -c 0; exit ${PIPESTATUS[0]}", 128 + SIGPIPE, ""},
        {start + ">&-", 4, "talus: standard output: "},
        {start + ">/dev/full", 4, "talus: standard output: "},
        {start + "<&- >&- 2>&-", 4, ""}}) {
    BOOST_TEST_CONTEXT(script) {
      const Ended ended = shell(script, run.into(out));
      BOOST_TEST(ended.code == code);
      BOOST_TEST(holds(ended.err, expected), ended.err);
      run.same(out);
    }
  }
}

BOOST_AUTO_TEST_CASE(help_that_nobody_takes_is_an_error) {
  for (const char* const option : {"--help", "--version", "run --help"}) {
    for (const char* const to : {">/dev/full", ">&-"}) {
      const Ended ended = shell(fmt::format("\"$TALUS\" {} {}", option, to), {});
      BOOST_TEST(ended.code == 4, option << to);
      BOOST_TEST(ended.err == "talus: standard output: cannot be written\n");
    }
  }
}

// The run warns before its first step.
BOOST_AUTO_TEST_CASE(messages_that_nobody_takes_cost_no_run) {
  const Folder folder;
  const fs::path out = folder.path / "out";
  const Arguments command{"run", scene("fence/sample2.DAT"), "--end", "5 ms", "--out", out.string()};
  BOOST_TEST(holds(talus_ran(command).err, "talus: warning: "));
  const auto before = files(out);
  for (const char* const to : {"2>&-", "2>/dev/full"}) {
    fs::remove_all(out);
    BOOST_TEST(shell(std::string{"\"$TALUS\" \"$@\" "} + to, command).code == 0, to);
    BOOST_TEST((files(out) == before), to);
    BOOST_TEST(shell(std::string{"\"$TALUS\" run none.toml "} + to).code == 4, to);
  }
}

namespace {

/// A separate file system: a small disk, which requires root.
class Disk {
 public:
  explicit Disk(const fs::path& folder) : path{folder} { fs::create_directories(path); }
  Disk(const Disk&) = delete;
  Disk& operator=(const Disk&) = delete;
  ~Disk() { unmount(); }

  bool mount(const std::string& options, unsigned long flags = 0) {
    mounted_ = ::mount("talus", path.c_str(), "tmpfs", flags, options.c_str()) == 0;
    return mounted_;
  }
  void change(const std::string& options, unsigned long flags = 0) const {
    BOOST_REQUIRE(::mount("talus", path.c_str(), "tmpfs", MS_REMOUNT | flags, options.c_str()) == 0);
  }
  void unmount() {
    if (mounted_) ::umount(path.c_str());
    mounted_ = false;
  }

  fs::path path;

 private:
  bool mounted_{false};
};

std::uintmax_t bytes(const std::map<std::string, std::string>& content) {
  std::uintmax_t sum = 0;
  for (const auto& [name, text] : content)
    sum += (text.size() + 4095) / 4096 * 4096 + 4096;  // pages, and room for the name
  return sum;
}

}  // namespace

// A disk of every size up to that which the run needs; without a disk, a limit on the size of files.
BOOST_AUTO_TEST_CASE(a_full_disk_ends_a_run_that_is_continued_where_there_is_room) {
  const Folder folder;
  Disk disk{folder.path / "disk"};
  const bool mounted = disk.mount("size=1m");
  fmt::print("faults: full disk by {}\n", mounted ? "a tmpfs" : "RLIMIT_FSIZE (no tmpfs can be mounted)");
  disk.unmount();
  const fs::path out = disk.path / "out";
  int full = 0;
  for (const Undisturbed& run :
       {Undisturbed{fence_run()}, Undisturbed{scene_run("5 s")}, Undisturbed{{"cell", cell_file(folder)}}}) {
    for (const int part : {0, 2, 6, 9, 11, 13, 15}) {
      BOOST_TEST_CONTEXT(run.command[1] << ", " << part << " of 16 parts") {
        const std::uintmax_t size = 4096 + bytes(run.content) * static_cast<std::uintmax_t>(part) / 16 / 4096 * 4096;
        Ended ended;
        if (mounted) {
          BOOST_REQUIRE(disk.mount(fmt::format("size={}", size)));
          ended = talus_ran(run.into(out));
        } else {
          ended = shell(fmt::format("ulimit -f {}; exec \"$TALUS\" \"$@\"", part), run.into(out));
        }
        BOOST_TEST((ended.code == 4 || ended.code == 0), ended.code);
        if (ended.code == 4) {
          ++full;
          BOOST_TEST(ended.err.starts_with("talus: " + out.string()), ended.err);
          BOOST_TEST(holds(ended.err, mounted ? ": No space left on device\n" : ": File too large\n"), ended.err);
          BOOST_TEST(whole_files(out, run) == 0);
        }
        if (mounted) disk.change("size=100m");
        const Ended again = ended.code == 0 ? ended : run.continued(out);
        BOOST_TEST(again.code == 0, again.err);
        run.same(out);
        fs::remove_all(out);
        disk.unmount();
      }
    }
  }
  BOOST_TEST(full >= 9);
}

BOOST_AUTO_TEST_CASE(a_folder_that_is_read_only) {
  const Folder folder;
  Disk disk{folder.path / "disk"};
  const Undisturbed run{scene_run("5 s")};
  const fs::path out = disk.path / "out";
  const bool mounted = disk.mount("size=4m");
  Arguments until = run.into(out);
  until.insert(until.end(), {"--until", "2 s"});
  BOOST_TEST(talus_ran(until).code == 0);
  const auto before = files(out);
  if (mounted) {
    disk.change("size=4m", MS_RDONLY);
  } else {
    if (::geteuid() == 0) return;  // root may write to any folder
    fs::permissions(out, fs::perms::owner_read | fs::perms::owner_exec);
  }
  const std::string reason = mounted ? "Read-only file system" : "Permission denied";
  for (const Arguments& command :
       {Arguments{"run", "--resume", out.string()}, run.into(out), run.into(disk.path / "other")}) {
    const Ended ended = talus_ran(command);
    BOOST_TEST(ended.code == 4);
    BOOST_TEST(ended.err.starts_with("talus: " + disk.path.string()), ended.err);
    BOOST_TEST(ended.err.ends_with(reason + "); it must be a writable folder, or a new one\n"), ended.err);
    BOOST_TEST((files(out) == before));
  }
  if (mounted) {
    disk.change("size=4m");
  } else {
    fs::permissions(out, fs::perms::owner_all);
  }
  BOOST_TEST(run.continued(out).code == 0);
  run.same(out);
}

BOOST_AUTO_TEST_CASE(a_second_run_in_the_folder_is_refused_and_names_the_first) {
  const Folder folder;
  const Undisturbed run{scene_run("40 s")};
  const fs::path out = folder.path / "out", written = folder.path / "pid";
  // The shell is replaced by the program, which keeps its process id.
  Arguments shell_arguments{"-c", "echo $$ > \"$1\"; shift; exec '" TALUS_EXECUTABLE "' \"$@\"", "sh",
                            written.string()};
  const Arguments command{"run", scene("two_cable.toml"), "--end", "100000 s", "--out", out.string()};
  shell_arguments.insert(shell_arguments.end(), command.begin(), command.end());
  StartedProgram first{"/bin/bash", shell_arguments};
  while (!fs::exists(out / "checkpoint.json"))
    std::this_thread::sleep_for(std::chrono::milliseconds{5});
  std::string pid = talus::read_text(written);
  pid.pop_back();
  for (const Arguments& other : {run.into(out), Arguments{"run", "--resume", out.string()}}) {
    const Ended refused = talus_ran(other);
    BOOST_TEST(refused.code == 4);
    BOOST_TEST(refused.err == fmt::format("talus: {}: another run (process {}) is writing into it; each run needs a "
                                          "separate folder\n",
                                          out.string(), pid));
  }
  first.send(SIGTERM);
  BOOST_TEST(first.exit_code() == 128 + SIGTERM);
  // The lock ends with its process.
  BOOST_TEST(talus_ran(run.into(out)).code == 0);
  run.same(out);
}

BOOST_AUTO_TEST_CASE(a_folder_of_a_run_that_was_killed_is_emptied_for_another) {
  const Folder folder;
  const fs::path out = folder.path / "out";
  const Undisturbed run{scene_run("5 s")};
  for (const char* const name :
       {"out/fence_geometry/fence_00000010.vtp", "out/fence_geometry/.fence_00000020.vtp.talus-a1B2c3",
        "out/two_cable_geometry/two_cable_00000001.vtp", "out/two_cable_geometry/.two_cable_00000002.vtp.talus-a1B2c3",
        "out/.fence.OUT.talus-a1B2c3", "out/.fence.pvd.talus-a1B2c3", "out/.checkpoint.json.talus-a1B2c3"}) {
    fs::create_directories((folder.path / name).parent_path());
    folder.file(name, "half");
  }
  // Files of the user remain, also in a folder of a similar name.
  fs::create_directory(out / "site_geometry");
  folder.file("out/site_geometry/site.vtp", "mine"), folder.file("out/site.OUT", "mine");
  BOOST_TEST(talus_ran(run.into(out)).code == 0);
  BOOST_TEST((fs::remove(out / "site_geometry/site.vtp") && fs::remove(out / "site.OUT")));
  fs::remove(out / "site_geometry");
  run.same(out);
  BOOST_TEST(!fs::exists(out / "fence_geometry"));
}

namespace {

struct DecimalComma : std::numpunct<char> {
  char do_decimal_point() const override { return ','; }
  char do_thousands_sep() const override { return '.'; }
  std::string do_grouping() const override { return "\3"; }
};

}  // namespace

// A program that calls the commands may have set its locale. The locale of C functions is also set, if one with a
// decimal comma is installed.
BOOST_AUTO_TEST_CASE(numbers_have_points_in_every_locale) {
  const Folder folder;
  const Undisturbed run{{"run", scene("fence/sample2.toml"), "--end", "20 ms"}};
  const Undisturbed cell{{"cell", cell_file(folder)}};
  const std::locale before = std::locale::global(std::locale{std::locale::classic(), new DecimalComma});
  const char* set = nullptr;
  for (const char* name : {"de_DE.UTF-8", "de_DE.utf8", "fr_FR.UTF-8"})
    if (set == nullptr) set = std::setlocale(LC_ALL, name);
  fmt::print("faults: decimal comma in C++{}\n", set != nullptr ? " and C" : "; no such locale of C is installed");
  for (const auto& [undisturbed, name] : {std::pair{&run, "run"}, {&cell, "cell"}}) {
    const fs::path out = folder.path / name;
    Arguments program_arguments = undisturbed->into(out);
    program_arguments.insert(program_arguments.begin(), "talus");
    program_arguments.push_back("--json");
    std::vector<const char*> arguments;
    for (const std::string& word : program_arguments)
      arguments.push_back(word.c_str());
    BOOST_TEST(talus::app::run_command_line("", static_cast<int>(arguments.size()), arguments.data()) == 0);
    undisturbed->same(out);
  }
  std::locale::global(before);
  std::setlocale(LC_ALL, "C");
  // The program itself, in such a user's environment.
  StartedProgram program{TALUS_EXECUTABLE, run.into(folder.path / "de"), {}, {{"LC_ALL", "de_DE.UTF-8"}}};
  BOOST_TEST(program.exit_code() == 0);
  run.same(folder.path / "de");
}

BOOST_AUTO_TEST_CASE(paths_with_blanks_quotes_and_letters_of_all_scripts) {
  const Folder folder;
  const fs::path home = folder.path / "Zäune \"$HOME\" `id` it's; 落石 %d #1 & <b>";
  fs::create_directories(home);
  const fs::path file = home / "Böschung 1.toml", out = home / "mein Lauf";
  fs::copy_file(scene("two_cable.toml"), file);
  const Arguments command{"run", file.string(), "--end", "0.4 s", "--frames", "4", "--out", out.string()};
  Arguments until = command;
  until.insert(until.end(), {"--until", "0.1 s"});
  const Ended stopped = talus_ran(until);
  BOOST_TEST_REQUIRE(stopped.code == 0, stopped.err);
  // A shell accepts the printed command unchanged.
  const std::string mark = "\nresume: talus ";
  const std::size_t offset = stopped.out.find(mark);
  BOOST_TEST_REQUIRE(offset != std::string::npos, stopped.out);
  const std::string rest = stopped.out.substr(offset + mark.size());
  const Ended resumed = shell("\"$TALUS\" " + rest.substr(0, rest.find('\n')));
  BOOST_TEST(resumed.code == 0, resumed.err);
  BOOST_TEST(!fs::exists(out / "checkpoint.json"));
  for (const Arguments& drawing : {Arguments{"plot", out.string(), "--format", "svg"},
                                   {"snapshot", out.string(), "--format", "svg"},
                                   {"animate", out.string(), "--html", "--gif", "--seconds", "1"}}) {
    const Ended drawn = talus_ran(drawing);
    BOOST_TEST(drawn.code == 0, drawn.err);
    BOOST_TEST(drawn.err == "");
  }
  for (const char* picture : {"plots/positions.svg", "plots/animation.html", "plots/animation.gif"})
    BOOST_TEST(fs::exists(out / picture), picture);
  const fs::path sheet = home / "Blatt";
  const Ended made =
      talus_ran({"run", scene("fence/sample2.DAT"), "--end", "5 ms", "--sheet", "--out", sheet.string()});
  BOOST_TEST(made.code == 0, made.err);
  BOOST_TEST((fs::exists(sheet / "sheet.pdf") && fs::exists(sheet / "sheet.html")));
}

// From too little memory to load the program up to enough for the run.
BOOST_AUTO_TEST_CASE(too_little_memory_is_an_error_with_its_exit_code) {
#if defined(__SANITIZE_ADDRESS__) || defined(TALUS_COUNTED_LINES)
  return;  // the sanitizer itself reserves terabytes of addresses, and counts of lines need memory at the end
#endif
  const Folder folder;
  const fs::path out = folder.path / "out";
  const Undisturbed run{fence_run()};
  int short_of_memory = 0;
  bool enough = false;
  // In small steps at first: there is a limit at which not even an exception can be allocated.
  for (long kilobytes = 12000; !enough; kilobytes += short_of_memory < 10 ? 25 : 1000) {
    const Ended ended = shell(fmt::format("ulimit -v {}; exec \"$TALUS\" \"$@\"", kilobytes), run.into(out));
    BOOST_TEST_CONTEXT(kilobytes << " kB: " << ended.err) {
      BOOST_TEST_REQUIRE(kilobytes < 1000000);
      if (ended.code == 127) continue;  // the loader reports it
      enough = ended.code == 0;
      if (enough) continue;
      BOOST_TEST(ended.code == 4);
      BOOST_TEST(ended.err.ends_with("talus: out of memory\n"));
      ++short_of_memory;
      whole_files(out, run);
    }
  }
  BOOST_TEST(short_of_memory > 0);
  run.same(out);
}

BOOST_AUTO_TEST_CASE(runs_side_by_side_write_the_same_bytes) {
  const Folder folder;
  const Undisturbed run{scene_run("5 s")};
  std::vector<std::unique_ptr<StartedProgram>> programs;
  const auto out = [&](int number) { return folder.path / fmt::format("{}", number); };
  for (int i = 0; i < 100; ++i)
    programs.push_back(std::make_unique<StartedProgram>(TALUS_EXECUTABLE, run.into(out(i))));
  for (int i = 0; i < 100; ++i) {
    BOOST_TEST(programs[static_cast<std::size_t>(i)]->exit_code() == 0);
    run.same(out(i));
  }
}

BOOST_AUTO_TEST_SUITE_END()
