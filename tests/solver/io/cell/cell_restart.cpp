#include "solver/io/cell/cell_restart.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <map>
#include <sstream>
#include <vector>

#include "solver/base/error.hpp"
#include "tests/solver/io/small_cell.hpp"

BOOST_AUTO_TEST_SUITE(cell_restart_tests)

using namespace talus;

namespace {

const ShearCell& cell = small_cell;

CellRun run() {
  CellRun made = small_cell_run(2000.0);
  while (!made.finished())
    made.advance();
  return made;
}

std::string message(const std::string& text) {
  try {
    static_cast<void>(read_cell_restart(text, "RESTART.DAT", cell));
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

}  // namespace

BOOST_AUTO_TEST_CASE(discs_come_back_to_the_last_bit_and_the_block_is_set_down) {
  CellRun ran = run();
  const Discs discs = ran.discs();
  const CellRestart back = read_cell_restart(cell_restart_text(cell, discs, ran.steps()), "RESTART.DAT", cell);
  BOOST_TEST(back.cycles == ran.steps());
  const Discs& read = back.start.discs;
  BOOST_TEST(read.t == discs.t);
  double lowest = 1e300;
  for (std::size_t i = 0; i < cell.free_discs(); ++i) {
    BOOST_TEST(read.x[i] == discs.x[i]);
    BOOST_TEST(read.y[i] == discs.y[i]);
    BOOST_TEST(read.vx[i] == discs.vx[i]);
    BOOST_TEST(read.vy[i] == discs.vy[i]);
    for (std::size_t j = first_block_disc(cell); j < read.size(); ++j) {
      const double dx = read.x[j] - read.x[i], near = dx - 5.0 * std::round(dx / 5.0);
      lowest = std::min(lowest, std::hypot(near, read.y[j] - read.y[i]));
    }
  }
  BOOST_TEST(lowest == 1.0, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(read.vy.back() == 0.0);
  BOOST_TEST(read.vx.back() == 2.0);
  // Its position by its drive.
  const double moved = read.x.back() - discs.x.back();
  BOOST_TEST(std::abs(moved - 5.0 * std::round(moved / 5.0)) < 1e-9);
  CellRun on{cell, ran.plan(), back.start};
  on.advance();
  BOOST_TEST(on.failure().empty());
}

BOOST_AUTO_TEST_CASE(contacts_that_are_forgotten_are_counted) {
  FilledCell filled = fill(cell);
  filled.discs.x[1] = filled.discs.x[0] + 0.99;
  filled.discs.y[2] = 0.9, filled.discs.x[2] = 0.0;  // in contact with a disc of the base, and with the second disc
  const CellRestart back = read_cell_restart(cell_restart_text(cell, filled.discs, 0), "RESTART.DAT", cell);
  BOOST_TEST(back.forgotten == 3U);
}

BOOST_AUTO_TEST_CASE(wrong_restarts) {
  const std::string text = cell_restart_text(cell, fill(cell).discs, 7);
  BOOST_TEST(message(text).empty());
  BOOST_TEST(message("x 7\n") == "RESTART.DAT:1: elapsed time: found \"x\"; it must be a number");
  BOOST_TEST(message("1.0 7.5\n") == "RESTART.DAT:1: cycles: found 7.5; it must be a whole number between 0 and 1e+15");
  BOOST_TEST(message("1.0 1e300\n").starts_with("RESTART.DAT:1: cycles: found 1e+300; "));
  BOOST_TEST(message("-5 0\n") == "RESTART.DAT:1: elapsed time: found -5; it must be >= 0");
  BOOST_TEST(message("0 0\n1e200 1 0 0\n") ==
             "RESTART.DAT:2: disc 1: x: found 1e+200; it must be within 1e+06 widths of the field");
  BOOST_TEST(
      message(text + "\n 1 2 3 4\n") ==
      "RESTART.DAT:15: found an additional record; it must contain the 12 free discs of the cell, one per record");
  BOOST_TEST(message(text + "\n \r\n").empty());
  // Two discs at one position; one in the base. An overlap of less than a tenth of a diameter is a contact.
  const auto placed = [&](std::size_t disc, double x, double y) {
    FilledCell filled = fill(cell);
    filled.discs.x[disc] = x, filled.discs.y[disc] = y;
    return message(cell_restart_text(cell, filled.discs, 0));
  };
  const Discs discs = fill(cell).discs;
  BOOST_TEST(placed(4, discs.x[3], discs.y[3]) ==
             "RESTART.DAT:6: disc 5: found it 1 diameters inside disc 4; it must be at most 0.1");
  BOOST_TEST(placed(0, discs.x[cell.free_discs()], 0.5) ==
             "RESTART.DAT:2: disc 1: found it 0.5 diameters inside the base; it must be at most 0.1");
  BOOST_TEST(placed(7, discs.x[3], discs.y[3] + 0.91).empty());
  BOOST_TEST(message(text.substr(0, text.rfind(' '))).starts_with("RESTART.DAT:13: disc 12: vy: "));
  BOOST_TEST(message("0 0\n0 -1 0 0\n") ==
             "RESTART.DAT:2: disc 1: y: found -1; it must be above the base's centre line, 0");
}

BOOST_AUTO_TEST_CASE(a_picture_has_all_discs_and_the_images_across_the_border) {
  FilledCell filled = fill(cell);
  Discs& discs = filled.discs;
  discs.x[0] = 2.4;   // reaches across the right border
  discs.x[1] = -2.3;  // across the left one
  discs.x[2] = 0.0;
  discs.x[3] = 7.4;  // in another box: equivalent to 2.4
  std::istringstream lines{cell_picture_text(cell, discs)};
  std::map<long, std::pair<double, double>> seen;
  long number = 0;
  for (double x = 0.0, y = 0.0; lines >> number >> x >> y;) {
    BOOST_TEST(!seen.contains(number));
    seen[number] = {x, y};
    BOOST_TEST(std::abs(x) <= 3.0);
  }
  for (long i = 1; i <= static_cast<long>(discs.size()); ++i)
    BOOST_TEST(seen.contains(i));
  BOOST_TEST(seen.at(-1).first == 2.4 - 5.0, boost::test_tools::tolerance(1e-15));
  BOOST_TEST(seen.at(-2).first == -2.3 + 5.0, boost::test_tools::tolerance(1e-15));
  BOOST_TEST(!seen.contains(-3));
  BOOST_TEST(seen.at(4).first == 2.4, boost::test_tools::tolerance(1e-14));
  BOOST_TEST(seen.at(-4).second == discs.y[3]);
}

BOOST_AUTO_TEST_SUITE_END()
