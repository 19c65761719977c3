/// Files of measurements: what is read, and what is refused.
#include "verification/data/measured_set.hpp"

#include <boost/test/unit_test.hpp>

#include "solver/base/error.hpp"
#include "tests/temporary_folder.hpp"
#include "tests/verification/data/measured_files.hpp"
#include "tests/verification/driver/text_parts.hpp"
#include "verification/data/scene_field.hpp"

BOOST_AUTO_TEST_SUITE(measured_set_tests)

using namespace talus;
using namespace talus::verification;

namespace {

/// Whether reading the files fails with a message that contains the text.
bool refused(const MeasuredFolder& folder, const std::string& text) {
  try {
    static_cast<void>(read_measured_set(folder.set()));
  } catch (const std::exception& wrong) {
    BOOST_TEST_MESSAGE(wrong.what());
    if (holds_text(wrong.what(), text)) return true;
    BOOST_ERROR(wrong.what());
    return false;
  }
  return false;
}

bool set_refused(const std::string& old, const std::string& fresh, const std::string& text) {
  return refused(MeasuredFolder{"speed [m/s],height [m],u\n4,1.76,0.01\n6,2.74,0.02\n", with(flight_set, old, fresh)},
                 text);
}

bool field_refused(const std::string& field, const std::string& text) {
  try {
    static_cast<void>(with_field(flight_scene, field, "1.0"));
  } catch (const InputError& wrong) {
    BOOST_TEST_MESSAGE(wrong.what());
    if (holds_text(wrong.what(), text)) return true;
    BOOST_ERROR(wrong.what());
  }
  return false;
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_set_is_read) {
  const MeasuredFolder folder;
  const MeasuredSet set = read_measured_set(folder.set());
  BOOST_TEST(set.id == "heights");
  BOOST_TEST(set.rows == 2U);
  BOOST_TEST(set.inputs.at(0).unit == "m/s");
  BOOST_TEST(set.inputs.at(0).values == RowNumbers({4.0, 6.0}), boost::test_tools::per_element());
  BOOST_TEST(set.inputs.at(0).uncertainty == RowNumbers({0.04, 0.04}), boost::test_tools::per_element());
  BOOST_TEST(set.quantities.at(0).unit == "m");
  BOOST_TEST(set.quantities.at(0).values == RowNumbers({1.76, 2.74}), boost::test_tools::per_element());
  BOOST_TEST(set.quantities.at(0).uncertainty == RowNumbers({0.01, 0.02}), boost::test_tools::per_element());
  BOOST_TEST(set.quantities.at(0).model_error == 0.02);
  BOOST_TEST(set.axis.label == "speed");
  BOOST_TEST(set.axis.unit == "m/s");
  const MeasuredFolder with_axis{"speed [m/s],height [m],u\n4,1.76,0.01\n6,2.74,0.02\n",
                                 with(flight_set, "data = ", "axis = \"u\"\ndata = ")};
  const MeasuredAxis axis = read_measured_set(with_axis.set()).axis;
  BOOST_TEST(axis.label == "u");
  BOOST_TEST(axis.unit == "1");
  BOOST_TEST(axis.values == RowNumbers({0.01, 0.02}), boost::test_tools::per_element());
  BOOST_TEST(set.controls.at(0).value == "\"-3.7 m/s^2\"");
  BOOST_TEST(set.not_shown == "air resistance.");
  BOOST_TEST(measured_files(folder.files.path).size() == 1U);
}

BOOST_AUTO_TEST_CASE(wrong_fields_are_named_with_file_and_line) {
  BOOST_TEST(set_refused("title = \"Heights\"", "titel = \"Heights\"", ".measured.toml:1: key 'titel' is not known"));
  BOOST_TEST(set_refused("title = \"Heights\"", "title = 3", "title: found 3; it must be a text in quotes"));
  BOOST_TEST(set_refused("not_shown = \"air resistance\"\n", "", "not_shown: it is missing"));
  BOOST_TEST(set_refused("flight.toml", "flihgt.toml", "scene: "));
  BOOST_TEST(set_refused("heights.csv", "none.csv", "none.csv"));
  BOOST_TEST(set_refused("data = \"heights.csv\"", "data = \"heights.csv\"\naxis = \"speed\"", "axis: column of "));
  BOOST_TEST(set_refused("\"speed [m/s]\"", "\"sped [m/s]\"", "input 'sped [m/s]': column: column of "));
  BOOST_TEST(set_refused("body.ball.velocity[1]", "body.bal.velocity[1]",
                         "field: 'body.bal.velocity[1]': name 'bal' is not known; nearest: ball"));
  BOOST_TEST(set_refused("uncertainty = 0.04", "uncertainty = -0.04", "uncertainty: found -0.04; it must be >= 0"));
  BOOST_TEST(set_refused("uncertainty = 0.04", "uncertainty = nan", "uncertainty: found nan; it must be a number"));
  BOOST_TEST(set_refused("uncertainty = \"u\"", "uncertainty = 0.0", "uncertainty: found 0; it must be > 0"));
  BOOST_TEST(set_refused("uncertainty = \"u\"", "uncertainty = \"v\"", "'v' is not known"));
  BOOST_TEST(set_refused("model_error = 0.02", "model_error = -1", "model_error: found -1; it must be >= 0"));
  BOOST_TEST(set_refused("value = \"-3.7 m/s^2\"", "value = [1]", "value: found [1]; it must be a text, a number"));
  BOOST_TEST(set_refused("value = \"-3.7 m/s^2\"", "value = \"a\\\"b\"", "value: found a text with a quote"));
  BOOST_TEST(
      set_refused("turns_red = \"height\"", "turns_red = \"hight\"", "turns_red: quantity 'hight' is not known"));
  BOOST_TEST(set_refused("field = \"gravity[1]\"", "field = \"gravity[2]\"", "'gravity' has no element [2]"));
  BOOST_TEST(set_refused("field = \"gravity[1]\"", "field = \"body.ball.velocity[1]\"", "which the column"));
  BOOST_TEST(set_refused("[[control]]", "[[controls]]", "key 'controls' is not known"));
  const std::string without_control = flight_set.substr(0, flight_set.find("[[control]]"));
  BOOST_TEST(refused(MeasuredFolder{"speed [m/s],height [m],u\n4,1.76,0.01\n6,2.74,0.02\n", without_control},
                     "a comparison that no wrong scene fails shows nothing"));
  const std::string twice =
      flight_set + flight_set.substr(flight_set.find("[[quantity]]"),
                                     flight_set.find("[[control]]") - flight_set.find("[[quantity]]"));
  BOOST_TEST(refused(MeasuredFolder{"speed [m/s],height [m],u\n4,1.76,0.01\n6,2.74,0.02\n", twice},
                     "name: found \"height\" twice; give each name once"));
}

BOOST_AUTO_TEST_CASE(wrong_data_and_scenes_are_refused) {
  BOOST_TEST(
      refused(MeasuredFolder{"speed [m/s],height [m],u\n4,1.76,0.01\n"}, "found 1 rows; there must be at least two"));
  BOOST_TEST(refused(MeasuredFolder{"speed [m/s],height [m],u\n4,1.76,0.01\n6,high,0.01\n"}, "heights.csv:3"));
  BOOST_TEST(refused(MeasuredFolder{"speed [m/s],height [m],u\n4,1.76,0.01\n6,2.7,0\n"}, "found 0; it must be > 0"));
  BOOST_TEST(refused(MeasuredFolder{"speed [m/s],height [m],u\n4,1.76,0.01\n6,2.7,0.01"}, "heights.csv"));
  BOOST_TEST(refused(MeasuredFolder{"speed [m/s],height [m],u\n4,1.76,0.01\n6,2.74,0.02\n", flight_set, "title = \n"},
                     "flight.toml:1: not TOML"));
  const Folder empty;
  BOOST_CHECK_EXCEPTION(static_cast<void>(measured_files(empty.path)), InputError, [](const InputError& wrong) {
    return holds_text(wrong.what(), "found no file NAME.measured.toml");
  });
  BOOST_CHECK_THROW(static_cast<void>(measured_files(empty.path / "none")), IoError);
}

BOOST_AUTO_TEST_CASE(a_field_is_found_by_its_path) {
  const auto changed = [](const std::string& field, const std::string& value, const std::string& expected) {
    const std::string text = with_field(flight_scene, field, value);
    BOOST_TEST(holds_text(text, expected), text);
    BOOST_TEST(!holds_text(flight_scene, expected));
  };
  changed("run.step", "\"2 ms\"", "2 ms");
  changed("gravity[0]", "\"7 m/s^2\"", "7 m/s^2");
  changed("body.ball.shape.radius", "\"0.7 m\"", "0.7 m");
  changed("contact.fall.friction", "0.375", "friction = 0.375");  // new
  BOOST_TEST(field_refused("", "it must be a path"));
  BOOST_TEST(field_refused("run.", "it must be a path"));
  BOOST_TEST(field_refused("gravity[x]", "it must be a path"));
  BOOST_TEST(field_refused("gravity[1", "it must be a path"));
  BOOST_TEST(field_refused("rum.step", "field 'rum' is not known; nearest: run"));
  BOOST_TEST(field_refused("body.ball", "it must end with a field of 'ball'"));
  BOOST_TEST(field_refused("body.ball.shape", "found a table; it must be a value"));
  BOOST_TEST(field_refused("gravity", "found an array; it must be a value"));
  BOOST_TEST(field_refused("title[0]", "'title' is not an array; give it without [0]"));
  BOOST_TEST(field_refused("title.text", "nothing can be below 'title', which is a value"));
}

BOOST_AUTO_TEST_SUITE_END()
