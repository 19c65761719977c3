#include "solver/io/file/quantity_table.hpp"

#include <boost/test/unit_test.hpp>
#include <string>
#include <vector>

#include "solver/base/error.hpp"
#include "tests/temporary_folder.hpp"

BOOST_AUTO_TEST_SUITE(quantity_table_tests)

using namespace talus;

namespace {

const std::vector<AllowedColumn> allowed{{"mass", dimension::mass, Range::positive},
                                         {"speed", dimension::velocity, Range::any},
                                         {"exponent", dimension::number, Range::one_to_hundred}};

std::vector<QuantityColumn> read(const std::string& text, const UnitSystem& units = si) {
  const Folder folder;
  return read_quantity_table(folder.file("table.csv", text), allowed, units);
}

/// The message of the error without the folder.
std::string refusal(const std::string& text) {
  const Folder folder;
  const auto file = folder.file("table.csv", text);
  try {
    (void)read_quantity_table(file, allowed, si);
  } catch (const InputError& error) {
    const std::string message = error.what(), path = file.string();
    BOOST_REQUIRE(message.starts_with(path));
    return message.substr(path.size());
  }
  return "read";
}

}  // namespace

BOOST_AUTO_TEST_CASE(columns_are_read_in_their_units) {
  const auto columns = read("# comment\nspeed [ft/s],exponent,mass [g]\n10,1.5,500\n-2.5,1,1\n");
  BOOST_REQUIRE(columns.size() == 3U);
  BOOST_TEST(columns[0].name == "speed");
  BOOST_TEST((columns[0].values == std::vector{3.048, -0.762}));
  BOOST_TEST((columns[0].dimension == dimension::velocity));
  BOOST_TEST((columns[1].values == std::vector{1.5, 1.0}));
  BOOST_TEST((columns[2].values == std::vector{0.5, 0.001}));
  BOOST_TEST((read("exponent [1]\n2\n")[0].values == std::vector{2.0}));
  BOOST_TEST((read("speed [ft/s]\n3\n", us)[0].values == std::vector{3.0}));
}

BOOST_AUTO_TEST_CASE(wrong_tables_are_refused) {
  const std::vector<std::pair<std::string, std::string>> wrong{
      {"sped [m/s]\n1\n",
       ": column 'sped [m/s]': column 'sped' is not known; nearest: speed; known: mass, speed, exponent"},
      {"speed\n1\n", ": column 'speed': found no unit; it must be a velocity, e.g. speed [m/s]"},
      {"speed [kg]\n1\n",
       ": column 'speed [kg]': found \"1 kg\"; that is a mass; it must be a velocity, e.g. \"1 m/s\""},
      {"exponent [m]\n1\n", ": column 'exponent [m]': found the unit m; it must be a pure number, without a unit"},
      {"mass [kg],mass [g]\n1,1\n", ": column 'mass [g]': it is the second one named mass; remove one"},
      {"\"mass\n[kg]\"\n1\n",
       ": column 1: found a line end or a control character in its heading, after 'mass'; remove it"},
      {"mass [kg]\n", ": found no line below the header; there must be one for each row"},
      {"", ": found no header; the first line must name the columns"},
      {"mass [kg]\n1\n0\n", ":3: column 'mass [kg]': found '0'; it must be > 0"},
      {"mass [kg]\nx\n", ":2: column 'mass [kg]': found 'x'; it must be a finite number"},
      {"exponent\n0.5\n", ":2: column 'exponent': found '0.5'; it must be in [1, 100]"},
      {"mass [kg]\n1,2\n", ":2: found 2 cells; the header has 1"}};
  for (const auto& [text, message] : wrong)
    BOOST_TEST(refusal(text) == message);
  BOOST_CHECK_THROW((void)read_quantity_table("no/such.csv", allowed, si), IoError);
}

BOOST_AUTO_TEST_CASE(a_byte_order_mark_is_skipped) {
  BOOST_TEST((read("\xEF\xBB\xBFmass [kg]\n2\n")[0].values == std::vector{2.0}));
}

BOOST_AUTO_TEST_CASE(a_written_table_is_read_back) {
  const std::vector<QuantityColumn> columns{{"mass", dimension::mass, {1.0, 14.5939}},
                                            {"speed", dimension::velocity, {0.3048, -3.0}}};
  const std::string text = quantity_csv(columns, us);
  BOOST_TEST(text.starts_with("mass [slug],speed [ft/s]\n"), text);
  const auto found = read(text);
  for (std::size_t i = 0; i < 2; ++i)
    for (std::size_t row = 0; row < 2; ++row)
      BOOST_TEST(found[i].values[row] == columns[i].values[row], boost::test_tools::tolerance(1e-15));
}

BOOST_AUTO_TEST_CASE(a_head_has_a_name_and_a_unit) {
  BOOST_TEST((name_and_unit("rock.vx [ft/s]") == std::pair<std::string, std::string>{"rock.vx", "ft/s"}));
  BOOST_TEST((name_and_unit("rock.vx") == std::pair<std::string, std::string>{"rock.vx", ""}));
  BOOST_TEST((name_and_unit("a [b] [m]") == std::pair<std::string, std::string>{"a [b]", "m"}));
}

BOOST_AUTO_TEST_SUITE_END()
