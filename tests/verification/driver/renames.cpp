#include "verification/driver/renames.hpp"

#include <boost/test/unit_test.hpp>

#include "solver/base/error.hpp"
#include "tests/temporary_folder.hpp"
#include "tests/verification/driver/text_parts.hpp"

BOOST_AUTO_TEST_SUITE(renames_tests)

using namespace talus::verification;

namespace {

/// Checks that line `number` is refused by a message with FILE:number and `expected`.
void demand_refused(const std::string& text, int number, const std::string& expected) {
  const Folder folder;
  const std::string file = folder.file("renames.txt", text);
  std::string message = "it was read";
  try {
    static_cast<void>(read_renames(file));
  } catch (const talus::InputError& fault) {
    message = fault.what();
  }
  BOOST_TEST(message.find(file + ":" + std::to_string(number) + ": found ") == 0u, message);
  BOOST_TEST(holds_text(message, expected), message);
}

}  // namespace

BOOST_AUTO_TEST_CASE(each_form_is_read) {
  const Folder folder;
  const auto renames = read_renames(folder.file("renames.txt",
                                                "# of version 2\n"
                                                "\n"
                                                "caught_fall -> damped_bungee\r\n"
                                                "  a/error / bound -> b/ratio of a/b  \n"
                                                "a/control: mass halved -> a/control: half the mass\n"
                                                "a/old -> -\n"
                                                "gone -> -"));
  BOOST_REQUIRE(renames.size() == 5u);
  BOOST_TEST((renames[0].before == ItemName{"caught_fall", ""}));
  BOOST_TEST((renames[0].after == ItemName{"damped_bungee", ""}));
  BOOST_TEST(renames[0].location == (folder.path / "renames.txt").string() + ":3");
  BOOST_TEST((renames[1].before == ItemName{"a", "error / bound"}));
  BOOST_TEST((renames[1].after == ItemName{"b", "ratio of a/b"}));
  BOOST_TEST((renames[2].before == ItemName{"a", control_item("mass halved")}));
  BOOST_TEST(text_of(*renames[2].after) == "a/control: half the mass");
  BOOST_TEST(!renames[3].after.has_value());
  BOOST_TEST(text_of(renames[4].before) == "gone");
}

BOOST_AUTO_TEST_CASE(names_may_be_exchanged) {
  const Folder folder;
  BOOST_TEST(read_renames(folder.file("renames.txt", "a/x -> a/y\na/y -> a/x\n")).size() == 2u);
}

BOOST_AUTO_TEST_CASE(other_lines_are_refused_with_their_number) {
  demand_refused("\na/x => a/y\n", 2, "found 'a/x => a/y'; it must be 'old_case -> new_case'");
  demand_refused("a/x -> a/y -> a/z", 1, "it must be");
  demand_refused("a/x ->", 1, "it must be");
  demand_refused(" -> a/y", 1, "it must be");
  demand_refused("/x -> a/y", 1, "it must be");
  demand_refused("a/ -> a/y", 1, "it must be");
  demand_refused("a/x -> a/", 1, "it must be");
  demand_refused("a/control: -> a/control: y", 1, "it must be");
  demand_refused("a -> b/y", 1, "a case on both sides, or a check on both");
  demand_refused("a/x -> b", 1, "a case on both sides, or a check on both");
  demand_refused("a/x -> b/control: y", 1, "a check on both sides, or a control on both");
  demand_refused("a/x -> a/x", 1, "two different names");
  demand_refused("a/x -> a/y\n#\na/x -> a/z\n", 3, "renamed once");
  demand_refused("a/x -> a/y\na/z -> a/y\n", 2, "given once");
}

BOOST_AUTO_TEST_CASE(a_file_that_cannot_be_read_is_no_input_error) {
  const Folder folder;
  BOOST_CHECK_THROW(static_cast<void>(read_renames(folder.path / "none.txt")), talus::IoError);
  BOOST_CHECK_THROW(static_cast<void>(read_renames(folder.path)), talus::IoError);
}

BOOST_AUTO_TEST_SUITE_END()
