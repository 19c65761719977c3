/// Output of the program to a terminal, and to one file that receives both of its streams.
#include <pty.h>
#include <unistd.h>

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cctype>
#include <cstdlib>
#include <fstream>
#include <sstream>

#include "tests/solver/app/program.hpp"

BOOST_AUTO_TEST_SUITE(streams_tests)

namespace {

/// Output of the program to a terminal as its stderr; stdout is discarded. One variable of the environment has the
/// given value.
std::string shown_on_terminal(const std::vector<std::string>& arguments, const std::string& variable = "NO_COLOR",
                              const std::string& value = "1") {
  int ours = 0, terminal = 0;
  BOOST_REQUIRE(::openpty(&ours, &terminal, nullptr, nullptr, nullptr) == 0);
  StartedProgram program{TALUS_EXECUTABLE, arguments, {.err = ::ttyname(terminal)}, {{variable, value}}};
  ::close(terminal);
  std::string shown;
  char text[4096];
  // Reading fails once the terminal has been closed by all its users.
  for (ssize_t count = ::read(ours, text, sizeof text); count > 0; count = ::read(ours, text, sizeof text))
    shown.append(text, static_cast<std::size_t>(count));
  ::close(ours);
  BOOST_TEST(program.exit_code() == 0, shown);
  return shown;
}

/// Lines in alphabetical order, without digits: measured times differ.
std::vector<std::string> sorted_lines(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in{text};
  for (std::string line; std::getline(in, line);) {
    line.erase(std::remove_if(line.begin(), line.end(), [](unsigned char c) { return std::isdigit(c) != 0; }),
               line.end());
    lines.push_back(line);
  }
  std::sort(lines.begin(), lines.end());
  return lines;
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_study_shows_how_long_it_takes) {
  const std::vector<std::string> command{"study", "shear", "--time", "0.05", "--seeds", "2", "--threads", "1"};
  const std::string shown = shown_on_terminal(command);
  BOOST_TEST(holds(shown, " of 44 runs, "), shown);
  BOOST_TEST(holds(shown, " s left of about "), shown);
  BOOST_TEST(!holds(shown, "\x1b"));
  BOOST_TEST(shown.back() == '\r');  // the line is erased
  BOOST_TEST(talus_ran(command).err == "");
  BOOST_TEST(holds(talus_ran({"study", "--help"}).out, "takes about"));
}

BOOST_AUTO_TEST_CASE(long_work_shows_how_far_it_is) {
  const Folder folder;
  const std::string run = (folder.path / "run").string();
  const std::string shown =
      shown_on_terminal({"run", scene("two_cable.toml"), "--step", "0.5 us", "--frames", "4", "--out", run});
  BOOST_TEST(holds(shown, " of 3  ("), shown);
  // A slow gnuplot.
  const fs::path slow = folder.path / "gnuplot";
  std::ofstream{slow} << "#!/bin/sh\nsleep 2.5\nPATH=${PATH#*:} exec gnuplot \"$@\"\n";
  fs::permissions(slow, fs::perms::owner_all);
  const std::string path = folder.path.string() + ":" + std::getenv("PATH");
  const std::string drawn = shown_on_terminal({"animate", run, "--gif", "--seconds", "1"}, "PATH", path);
  BOOST_TEST(holds(drawn, "drawing, 2 s"), drawn);
}

// Warnings before, during and after the printed output, which is longer than a buffer of stdout.
BOOST_AUTO_TEST_CASE(lines_are_whole_where_both_streams_go_to_one_file) {
  const Folder folder;
  const std::string run = (folder.path / "run").string();
  for (const std::vector<std::string>& command :
       {std::vector<std::string>{"run", scene("fence/sample2.DAT"), "--all", "--out", run},
        {"plot", run, "--format", "svg"},
        {"cell", scene("cell/ice.toml"), "--historical"}}) {
    const Ended apart = talus_ran(command);
    const std::string log = (folder.path / "log").string();
    fs::remove(log);
    BOOST_TEST(StartedProgram(TALUS_EXECUTABLE, command, {log, log}).exit_code() == apart.code);
    const auto together = sorted_lines(talus::read_text(log)), expected = sorted_lines(apart.out + apart.err);
    BOOST_TEST(together == expected, boost::test_tools::per_element());
    if (command.front() == "run") BOOST_TEST((apart.out.size() > 4096U && !apart.err.empty()));
    if (command.front() == "plot") {
      // Omitted curves are reported before the pictures are drawn.
      const std::string text = talus::read_text(log);
      BOOST_TEST(text.find("curves drawn") < text.find("positions.svg"), text);
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
