/// The readers of requirements.toml, peers.toml and errata.toml: accepted input, and messages for mistakes.
#include "verification/catalogue/catalogue.hpp"

#include <boost/test/unit_test.hpp>
#include <map>

#include "solver/base/error.hpp"
#include "tests/temporary_folder.hpp"

BOOST_AUTO_TEST_SUITE(catalogue_tests)

using namespace talus::verification;
namespace fs = std::filesystem;

namespace {

/// A small catalogue without mistakes.
const std::map<std::string, std::string> sound{
    {"references.bib", "@misc{lammps,\n title = {{LAMMPS}},\n}\n@misc{mfix,\n title = {{MFiX}},\n}\n"},
    {"requirements.toml",
     "[equations]\n\"Eq. 1\" = \"outline\"\n\n[[family]]\ntitle = \"A: motion\"\n[family.problems]\nA1 = \"flight\"\n"
     "A2 = \"spin\"\n\n[[family]]\ntitle = \"the fence\"\n"},
    {"peers.toml",
     "[[check]]\nsuite = \"mfix\"\nid = \"DEM01\"\nwhat = \"fall\"\nform = \"closed\"\nproblems = [\"A1\"]\n\n"
     "[[check]]\nsuite = \"mfix\"\nid = \"DEM02\"\nwhat = \"drag\"\nform = \"closed\"\nproblems = []\nremark = "
     "\"no\"\n"},
    {"errata.toml",
     "[[erratum]]\nid = \"E1\"\nwhere = \"Eq. 1\"\nprinted = '$\\alpha$'\ncorrected = \"\"\"\n  one\n    and two "
     "\"\"\"\n"
     "evidence = \"it is\"\nproved_by = \"a_case\"\n"},
    {"findings.toml",
     "[[finding]]\ncase = \"a_case\"\ntext = \"It is <<value>>.\"\n\n"
     "[[highlight]]\ncase = \"a_case\"\nfigure = \"f\"\ncaption = \"See.\"\n"},
};

Catalogue read(const std::map<std::string, std::string>& files) {
  const Folder folder;
  for (const auto& [name, text] : files)
    folder.file(name, text);
  return read_catalogue(folder.path);
}

/// Error message for the valid catalogue with `old` in a file replaced by `changed`, from the file's name on.
std::string error_message(const std::string& file, const std::string& old, const std::string& changed) {
  auto files = sound;
  std::string& text = files.at(file);
  const std::size_t at = text.find(old);
  BOOST_TEST_REQUIRE(at != std::string::npos, old);
  text.replace(at, old.size(), changed);
  try {
    static_cast<void>(read(files));
  } catch (const talus::InputError& error) {
    const std::string message = error.what();
    return message.substr(message.find(file));
  }
  return "none";
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_sound_catalogue_is_read_whole) {
  const Catalogue catalogue = read(sound);
  BOOST_TEST((catalogue.families == std::vector<std::string>{"A: motion", "the fence"}));
  BOOST_TEST_REQUIRE(catalogue.requirements.size() > 3u);
  BOOST_TEST(catalogue.requirements[0].group == "equation");
  BOOST_TEST(catalogue.requirements[2].id == "A2");
  BOOST_TEST(catalogue.requirements[2].group == "A: motion");
  BOOST_TEST(catalogue.requirements[2].text == "spin");
  BOOST_TEST(catalogue.requirement("shape.circle") != nullptr);  // from the solver's lists
  BOOST_TEST(catalogue.requirement("A3") == nullptr);
  BOOST_TEST_REQUIRE(catalogue.peers.size() == 2u);
  BOOST_TEST(catalogue.peers[0].remark == "");
  BOOST_TEST((catalogue.peers[0].problems == std::vector<std::string>{"A1"}));
  BOOST_TEST(catalogue.peers[1].remark == "no");
  BOOST_TEST_REQUIRE(catalogue.errata.size() == 1u);
  BOOST_TEST(catalogue.errata[0].printed == "$\\alpha$");
  BOOST_TEST(catalogue.errata[0].corrected == "one and two");
  BOOST_TEST(catalogue.errata[0].proved_by == "a_case");
  BOOST_TEST_REQUIRE((catalogue.findings.size() == 1u && catalogue.highlights.size() == 1u));
  BOOST_TEST((catalogue.findings[0].case_id == "a_case" && catalogue.findings[0].text == "It is <<value>>."));
  BOOST_TEST((catalogue.highlights[0].figure == "f" && catalogue.highlights[0].caption == "See."));
  BOOST_TEST(catalogue.bibliography.works.size() == 2u);
}

BOOST_AUTO_TEST_CASE(a_missing_file_is_no_input_error) {
  for (const auto& [name, text] : sound) {
    auto files = sound;
    files.erase(name);
    BOOST_CHECK_THROW(static_cast<void>(read(files)), talus::IoError);
  }
}

BOOST_AUTO_TEST_CASE(errors_of_toml_name_their_line) {
  BOOST_TEST(error_message("peers.toml", "id = \"DEM01\"", "id = DEM01").starts_with("peers.toml:3: not TOML: "));
  BOOST_TEST(error_message("peers.toml", "id = \"DEM01\"", "suite = \"mfix\"").starts_with("peers.toml:3: not TOML: "));
  BOOST_TEST(error_message("requirements.toml", "A2", "A1").starts_with("requirements.toml:8: not TOML: "));
}

BOOST_AUTO_TEST_CASE(unknown_and_missing_keys_are_refused) {
  BOOST_TEST(error_message("peers.toml", "form", "from") ==
             "peers.toml:5: check 'DEM01': key 'from' is not known; nearest: form; known: suite, id, what, form, "
             "problems, remark");
  BOOST_TEST(error_message("errata.toml", "[[erratum]]", "[[eratum]]") ==
             "errata.toml:1: key 'eratum' is not known; nearest: erratum; known: erratum");
  BOOST_TEST(error_message("requirements.toml", "title = \"the fence\"", "titel = \"the fence\"")
                 .starts_with("requirements.toml:11: family: key 'titel' is not known; nearest: title; "));
  BOOST_TEST(error_message("peers.toml", "form = \"closed\"\n", "") ==
             "peers.toml:1: check 'DEM01': form: it is missing");
  BOOST_TEST(error_message("findings.toml", "text = ", "texts = ") ==
             "findings.toml:3: finding 'a_case': key 'texts' is not known; nearest: text; known: case, text");
  BOOST_TEST(error_message("errata.toml", "id = \"E1\"\n", "") == "errata.toml:1: erratum: id: it is missing");
  BOOST_TEST(error_message("requirements.toml", "[equations]\n\"Eq. 1\" = \"outline\"\n", "") ==
             "requirements.toml:1: equations: it is missing");
}

BOOST_AUTO_TEST_CASE(values_of_another_kind_are_refused) {
  BOOST_TEST(error_message("peers.toml", "\"fall\"", "3") ==
             "peers.toml:4: check 'DEM01': what: found 3; it must be a text in quotes");
  BOOST_TEST(error_message("errata.toml", "\"it is\"", "\" \"") ==
             "errata.toml:8: erratum 'E1': evidence: found \" \"; it must not be empty");
  BOOST_TEST(error_message("peers.toml", "[\"A1\"]", "\"A1\"") ==
             "peers.toml:6: check 'DEM01': problems: found \"A1\"; it must be an array of texts, [\"..\", \"..\"]");
  BOOST_TEST(error_message("peers.toml", "[\"A1\"]", "[1]") ==
             "peers.toml:6: check 'DEM01': problems: found 1; it must be a text in quotes");
  BOOST_TEST(error_message("peers.toml", "[\"A1\"]", "[\"A1\", \"A1\"]") ==
             "peers.toml:6: check 'DEM01': problems: found \"A1\" twice; each may be given once");
  BOOST_TEST(error_message("errata.toml", "[[erratum]]", "[erratum]") ==
             "errata.toml:1: erratum: found a table; it must be an array of tables, [[erratum]]");
  BOOST_TEST(error_message("requirements.toml", "[equations]\n\"Eq. 1\" =", "equations =") ==
             "requirements.toml:1: equations: found \"outline\"; it must be a table");
  BOOST_TEST(error_message("requirements.toml", "\"spin\"", "[2]") ==
             "requirements.toml:8: family 'A: motion': problems: A2: found [2]; it must be a text in quotes");
}

BOOST_AUTO_TEST_CASE(names_must_fit_and_be_used_once) {
  BOOST_TEST(error_message("requirements.toml", "Eq. 1", "Eq. one") ==
             "requirements.toml:2: equations: Eq. one: it must be \"Eq. \" and a number");
  BOOST_TEST(error_message("requirements.toml", "A2", "B2") ==
             "requirements.toml:8: family 'A: motion': problems: B2: it must be A and a number, as the title of "
             "its family begins");
  BOOST_TEST(error_message("requirements.toml", "A2", "\"\"").find("it must be A and a number") != std::string::npos);
  BOOST_TEST(error_message("requirements.toml", "the fence", "A: motion") ==
             "requirements.toml:11: family 'A: motion': title: it is given twice");
  BOOST_TEST(error_message("requirements.toml", "title = \"the fence\"\n",
                           "title = \"A: again\"\n[family.problems]\nA1 = \"flight\"\n") ==
             "requirements.toml:13: family 'A: again': problems: A1: it is given twice");
  BOOST_TEST(error_message("peers.toml", "DEM02", "DEM01") ==
             "peers.toml:10: check 'DEM01': id: its suite has it twice");
  BOOST_TEST(error_message("errata.toml", "\"E1\"", "\"E2\"") ==
             "errata.toml:2: erratum 'E2': id: found \"E2\"; the next must be E1");
}

BOOST_AUTO_TEST_CASE(what_is_referred_to_must_be_there) {
  BOOST_TEST(error_message("peers.toml", "mfix", "mfx") ==
             "peers.toml:2: check 'DEM01': suite: reference 'mfx' is not known; nearest: mfix; known: lammps, mfix");
  BOOST_TEST(error_message("peers.toml", "\"A1\"", "\"A9\"")
                 .starts_with("peers.toml:6: check 'DEM01': problems: requirement 'A9' is not known; nearest: A"));
  BOOST_TEST(error_message("peers.toml", "remark = \"no\"\n", "") ==
             "peers.toml:13: check 'DEM02': problems: found an empty array; a remark must then give the reason");
  const std::string third =
      "[[check]]\nsuite = \"lammps\"\nid = \"1\"\nwhat = \"a\"\nform = \"b\"\nproblems = [\"A1\"]\n\n[[check]]\nsuite";
  BOOST_TEST(error_message("peers.toml", "\n[[check]]\nsuite", "\n" + third) ==
             "peers.toml:16: check 'DEM02': suite: found \"mfix\" after another suite; the checks of a suite must be "
             "adjacent");
}

BOOST_AUTO_TEST_SUITE_END()
