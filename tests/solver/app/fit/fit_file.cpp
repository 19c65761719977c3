#include "solver/app/fit/fit_file.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <string>

#include "solver/base/error.hpp"
#include "tests/temporary_folder.hpp"

BOOST_AUTO_TEST_SUITE(fit_file_tests)

using namespace talus;
using namespace talus::app;

namespace {

const std::string head = "scene = \"s.toml\"\ndata = \"d.csv\"\n",
                  quantity = "[[quantity]]\ncolumn = \"y [mm]\"\nresult = \"b.y.end\"\n",
                  parameter = "[[parameter]]\nfield = \"a.b\"\nrange = [1.0, 4.0]\n";

}  // namespace

BOOST_AUTO_TEST_CASE(all_fields_are_read_and_most_have_defaults) {
  const Folder folder;
  folder.file("d.csv", "t [s],y [mm],n\n1,20,3\n2,30,4\n3,40,5\n");
  const FitFile defaults = read_fit(head + quantity + parameter, folder.path / "f.toml");
  BOOST_TEST(defaults.scene == folder.path / "s.toml");
  BOOST_TEST(defaults.rows == 3U);
  BOOST_TEST(defaults.inputs.empty());
  BOOST_TEST(defaults.quantities.at(0).name == "y");
  BOOST_TEST(defaults.quantities.at(0).unit == "mm");
  BOOST_TEST(!defaults.has_uncertainties());
  BOOST_TEST(defaults.quantities.at(0).divisors.empty());
  BOOST_TEST(defaults.parameters.at(0).parameter.start == 2.5);
  BOOST_TEST((defaults.parameters.at(0).parameter.spacing == Spacing::even));
  BOOST_TEST(defaults.samples == 200U);
  BOOST_TEST(defaults.seed == 1);
  const FitFile all = read_fit(
      "title = \"T\"\n" + head + "[[input]]\ncolumn = \"t [s]\"\nfield = \"run.end\"\n" + quantity +
          "name = \"height\"\ndivided_by = \"n\"\nuncertainty = \"2 mm\"\n" + parameter +
          "spacing = \"logarithmic\"\n[[parameter]]\nfield = \"a.c\"\nrange = [\"-1 m\", \"3 m\"]\nstart = \"2 m\"\n"
          "[bootstrap]\nsamples = 70\nseed = 9\n[limits]\nevaluations = 5\n",
      folder.path / "f.toml");
  BOOST_TEST(all.title == "T");
  BOOST_TEST(all.inputs.at(0).field == "run.end");
  BOOST_TEST(all.inputs.at(0).unit == "s");
  BOOST_TEST(all.inputs.at(0).values == (std::vector<double>{1.0, 2.0, 3.0}), boost::test_tools::per_element());
  BOOST_TEST(all.quantities.at(0).name == "height");
  BOOST_TEST(all.quantities.at(0).values == (std::vector<double>{20.0, 30.0, 40.0}), boost::test_tools::per_element());
  BOOST_TEST(all.quantities.at(0).divisors == (std::vector<double>{3.0, 4.0, 5.0}), boost::test_tools::per_element());
  BOOST_TEST(all.quantities.at(0).uncertainty.value() == 2.0);
  BOOST_TEST(all.parameters.at(0).parameter.start == 2.0);  // sqrt(1 * 4)
  BOOST_TEST((all.parameters.at(0).parameter.spacing == Spacing::logarithmic));
  BOOST_TEST(all.parameters.at(1).unit == "m");
  BOOST_TEST(all.parameters.at(1).parameter.lower == -1.0);
  BOOST_TEST(all.parameters.at(1).parameter.start == 2.0);
  BOOST_TEST(all.samples == 70U);
  BOOST_TEST(all.seed == 9);
  BOOST_TEST(all.limits.evaluations == 5);
}

BOOST_AUTO_TEST_CASE(errors_of_several_tables_are_reported_together) {
  const Folder folder;
  folder.file("d.csv", "t [s],y [mm]\n1,20\n");
  try {
    static_cast<void>(read_fit(head + "[[input]]\ncolumn = \"t\"\nfield = \"a\"\n" + quantity +
                                   "[[parameter]]\nfield = \"a.b\"\nrange = [4.0, 1.0]\n",
                               folder.path / "f.toml"));
    BOOST_FAIL("no error");
  } catch (const InputError& error) {
    const std::string message = error.what();
    BOOST_TEST(message.find("f.toml:4: input 1: column: found \"t\"; it must be a column of ") != std::string::npos,
               message);
    BOOST_TEST(
        message.find("f.toml:11: parameter 1: range: found [4.0, 1.0]; the first must be less than the second") !=
            std::string::npos,
        message);
  }
}

BOOST_AUTO_TEST_CASE(an_uncertainty_has_the_unit_of_its_column) {
  const Folder folder;
  folder.file("d.csv", "y [mm],n\n20,1\n30,2\n");
  const auto message = [&](const std::string& text) -> std::string {
    try {
      static_cast<void>(read_fit(text, folder.path / "f.toml"));
    } catch (const InputError& error) {
      return error.what();
    }
    return "no error";
  };
  const std::string of_number = "[[quantity]]\ncolumn = \"n\"\nresult = \"b.y.end\"\n";
  BOOST_TEST(message(head + of_number + "uncertainty = \"1 mm\"\n" + parameter)
                 .ends_with("uncertainty: found \"1 mm\"; it must be > 0, a pure number as the column"));
  BOOST_TEST(message(head + quantity + "uncertainty = 1.0\n" + parameter)
                 .ends_with("uncertainty: found 1.0; it must be > 0, in the unit of the column, mm"));
  BOOST_TEST(message("scene = \"s.toml\"\ndata = \"\"\n" + quantity + parameter)
                 .ends_with("data: found \"\"; it must be the name of a file, in quotes"));
}

BOOST_AUTO_TEST_SUITE_END()
