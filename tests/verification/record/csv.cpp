#include "verification/record/csv.hpp"

#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

#include "tests/verification/record/error_message.hpp"

BOOST_AUTO_TEST_SUITE(csv_tests)

using namespace talus::records;

namespace {

std::vector<std::string> row_of(const Csv& csv, std::size_t row) {
  std::vector<std::string> cells;
  for (std::size_t column = 0; column < csv.header().size(); ++column)
    cells.emplace_back(csv.cell(row, column));
  return cells;
}

std::string refused(const std::string& text) {
  return error_message([&] { const Csv csv("a.csv", text); });
}

using Cells = std::vector<std::string>;

}  // namespace

BOOST_AUTO_TEST_CASE(rows_are_split_at_commas) {
  const Csv csv("a.csv", "series,x [m],y\na,1,\n,-2.5e-3,b c\n");
  BOOST_TEST(csv.header() == Cells({"series", "x [m]", "y"}));
  BOOST_TEST(csv.rows() == 2u);
  BOOST_TEST(row_of(csv, 0) == Cells({"a", "1", ""}));
  BOOST_TEST(row_of(csv, 1) == Cells({"", "-2.5e-3", "b c"}));
  BOOST_TEST(csv.number(1, "x [m]") == -2.5e-3);
}

BOOST_AUTO_TEST_CASE(quoted_cells_hold_commas_quotes_and_ends_of_lines) {
  const Csv csv("a.csv", "\"a,b\",c\n\"say \"\"no\"\"\",\"two\nlines\"\n\"\",x\"y\n");
  BOOST_TEST(csv.header() == Cells({"a,b", "c"}));
  BOOST_TEST(row_of(csv, 0) == Cells({"say \"no\"", "two\nlines"}));
  BOOST_TEST(row_of(csv, 1) == Cells({"", "x\"y"}));
  BOOST_TEST(csv.line(0) == 2u);
  BOOST_TEST(csv.line(1) == 4u);
}

BOOST_AUTO_TEST_CASE(comments_empty_lines_and_line_ends_of_other_systems_are_passed_over) {
  const Csv csv("a.csv", "# made by hand\r\n\r\nx,y\r\n1,2\r\n\n# a pause\n3,4\n");
  BOOST_TEST(csv.header() == Cells({"x", "y"}));
  BOOST_TEST(row_of(csv, 0) == Cells({"1", "2"}));
  BOOST_TEST(row_of(csv, 1) == Cells({"3", "4"}));
  BOOST_TEST(csv.line(1) == 7u);
}

BOOST_AUTO_TEST_CASE(a_file_may_have_no_rows) {
  BOOST_TEST(Csv("a.csv", "x,y\n").rows() == 0u);
  BOOST_TEST(Csv("a.csv", "x\n").header().size() == 1u);
}

BOOST_AUTO_TEST_CASE(cells_stay_valid_when_the_file_is_moved) {
  Csv csv("a.csv", "x\n1\n");
  const Csv moved = std::move(csv);
  BOOST_TEST(moved.cell(0, 0) == "1");
}

BOOST_AUTO_TEST_CASE(broken_files_are_refused_with_file_and_line) {
  BOOST_TEST(refused("") == "a.csv: found no header; the first line must name the columns");
  BOOST_TEST(refused("# only words\n\n") == "a.csv: found no header; the first line must name the columns");
  BOOST_TEST(refused("x,y\n1,2\n3\n") == "a.csv:3: found 1 cells; the header has 2");
  BOOST_TEST(refused("x,y\n1,2,3\n") == "a.csv:2: found 3 cells; the header has 2");
  BOOST_TEST(refused("x,y\n1,2") == "a.csv:2: the last line has no end; the file was cut short");
  BOOST_TEST(refused("x,y") == "a.csv:1: the last line has no end; the file was cut short");
  BOOST_TEST(refused("x,y\n1,\"2\n3,4\n") == "a.csv:2: a quoted cell that begins here does not end");
  BOOST_TEST(refused("# f\xfcr\nx,y\n1,w\xfcrfel\n") ==
             "a.csv:3: found \"w\u00fcrfel\", which is not UTF-8; save the file as UTF-8");
  BOOST_TEST(refused("x,h\xf6he\n1,2\n") == "a.csv:1: found \"h\u00f6he\", which is not UTF-8; save the file as UTF-8");
  BOOST_TEST(refused("# y\nx;y\n1,5;2\n") ==
             "a.csv:2: found the header \"x;y\"; cells must be separated by commas, with points in numbers");
  const Csv twice("a.csv", "x,y,x\n1,2,3\n");
  BOOST_TEST(twice.column("y") == 1U);
  BOOST_TEST(error_message([&] { (void)twice.column("x"); }) ==
             "a.csv: found two columns 'x'; give them different names");
  const Csv csv("a.csv", "x,y\n1,2\n");
  BOOST_TEST(error_message([&] { (void)csv.column("z"); }) == "a.csv: has no column 'z'; its columns: x, y");
  const Folder folder;
  BOOST_TEST(holds(error_message([&] { (void)read_csv(folder.path / "none.csv"); }), "No such file or directory"));
}

BOOST_AUTO_TEST_CASE(only_finite_numbers_are_numbers) {
  for (const char* text : {"", "one", "1x", " 1", "+1", "nan", "inf", "-inf", "1e999", "0x10"}) {
    const Csv csv("a.csv", std::string("n,x\n0,") + text + "\n");
    BOOST_TEST(error_message([&] { (void)csv.number(0, 1); }) ==
               std::string("a.csv:2: column 'x': found '") + text + "'; it must be a finite number");
  }
  const Csv csv("a.csv", "x\n.5\n-1e-320\n7\n");
  BOOST_TEST(csv.number(0, 0) == 0.5);
  BOOST_TEST(csv.number(1, 0) == -1e-320);
  BOOST_TEST(csv.number(2, 0) == 7.0);
}

BOOST_AUTO_TEST_CASE(what_is_written_is_read_back) {
  using Limits = std::numeric_limits<double>;
  const std::vector<double> numbers{0.1, 1.0 / 3.0, -0.0, 1e300, Limits::denorm_min(), Limits::max()};
  const Cells texts{"", "#1", "a,b", "\"", "two\nlines", "cr\rhere", " blank "};
  CsvText text({"#word", "short", "long"});
  for (const std::string& word : texts) {
    for (const double number : numbers) {
      text.cell(word);
      text.number(number);
      text.number(number, 17);
      text.end_row();
    }
  }
  const Csv csv("a.csv", std::move(text).text());
  BOOST_TEST(csv.header() == Cells({"#word", "short", "long"}));
  BOOST_REQUIRE(csv.rows() == texts.size() * numbers.size());
  for (std::size_t row = 0; row < csv.rows(); ++row) {
    const double number = numbers[row % numbers.size()];
    BOOST_TEST(csv.cell(row, 0) == texts[row / numbers.size()]);
    BOOST_TEST(csv.number(row, 1) == number);
    BOOST_TEST(csv.number(row, 2) == number);
    BOOST_TEST(std::signbit(csv.number(row, 1)) == std::signbit(number));
  }
}

BOOST_AUTO_TEST_CASE(a_row_of_one_empty_cell_is_not_lost) {
  CsvText text({"x"});
  text.cell("");
  text.end_row();
  const std::string written = std::move(text).text();
  BOOST_TEST(written == "x\n\"\"\n");
  BOOST_TEST(Csv("a.csv", written).rows() == 1u);
}

BOOST_AUTO_TEST_CASE(a_row_has_as_many_cells_as_the_header) {
  CsvText text({"x", "y"});
  text.number(1.0);
  BOOST_CHECK_THROW(text.end_row(), std::logic_error);
  text.number(2.0);
  text.number(3.0);
  BOOST_CHECK_THROW(text.end_row(), std::logic_error);
}

BOOST_AUTO_TEST_SUITE_END()
