#include <fmt/format.h>

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <string>
#include <vector>

#include "tests/fuzz/readers.hpp"
#include "tests/temporary_folder.hpp"

BOOST_AUTO_TEST_SUITE(refused_inputs_tests)

// Inputs that were findings of talus_mutate_inputs: each is refused by its present message.

using namespace talus::fuzz;

namespace {

/// A reader with its first valid file.
class Tried {
 public:
  explicit Tried(const std::string& name) {
    static const Folder shared;
    static const std::vector<Reader> readers = all_readers(shared.path);
    const auto found =
        std::find_if(readers.begin(), readers.end(), [&](const Reader& each) { return each.name == name; });
    BOOST_REQUIRE_MESSAGE((found != readers.end()), name);
    reader_ = &*found;
  }

  const std::string& sound() const { return reader_->corpus.front(); }
  /// The valid file with its first occurrence of `from` replaced.
  std::string changed(const std::string& from, const std::string& to) const {
    std::string text = sound();
    const std::size_t at = text.find(from);
    BOOST_REQUIRE_MESSAGE((at != std::string::npos), from);
    text.replace(at, from.size(), to);
    if (reader_->seal) reader_->seal(text);
    return text;
  }
  /// Checks that the text is refused by a message that begins with FILE and `message`.
  void refuses(const std::string& text, const std::string& message) const {
    const std::filesystem::path file = put(*reader_, text, folder_.path);
    const Reading reading = read(*reader_, file);
    BOOST_TEST((reading.ending == Ending::refused), reader_->name);
    BOOST_TEST(reading.flaw == "");
    BOOST_TEST(reading.message.starts_with(file.string() + message), reading.message);
  }
  /// Describes what is wrong with how the reader ended; empty if it read the text, or refused it properly.
  std::string flaw(const std::string& text) const { return read(*reader_, put(*reader_, text, folder_.path)).flaw; }

 private:
  Folder folder_;
  const Reader* reader_;
};

std::string repeated(const std::string& text, int times) {
  std::string all;
  for (int i = 0; i < times; ++i)
    all += text;
  return all;
}

}  // namespace

BOOST_AUTO_TEST_CASE(json_that_is_nested_too_deeply) {
  const std::string lists = "\n{\"a\": " + repeated("[", 10'000), objects = "\n" + repeated("{\"a\":", 65);
  for (const char* const name : {"scene_checkpoint", "final_state", "run_folder", "plots", "results", "sheet"}) {
    const Tried reader{name};
    for (const std::string& text : {lists + repeated("]", 10'000) + "}", lists, objects})
      reader.refuses(text, ": line 2: found lists and objects nested deeper than 64 levels");
  }
  // Brackets in a string do not nest, and 64 levels are read.
  const Tried sheet{"sheet"};
  sheet.refuses("{\"a\\\"" + repeated("[", 100) + "\": 1}", ".schema: is missing");
  sheet.refuses(repeated("[", 64) + repeated("]", 64), ": must be an object");
}

BOOST_AUTO_TEST_CASE(geometry_that_is_wrong_says_where) {
  const Tried geometry{"geometry"}, discs{"disc_states"};
  geometry.refuses(geometry.changed("<Lines>", "<Line>"), ":");  // not XML, with its line
  geometry.refuses(geometry.changed("Name=\"connectivity\"", "Name=\"\""),
                   ":4: Lines: array 'connectivity': it is missing");
  geometry.refuses(geometry.changed("<PolyData>", "<PolyDatum/><PolyData>").substr(0, 40), ":");
  discs.refuses(discs.changed("Name=\"radius\"", "Name=\"\""), ":4: PointData: array 'radius': it is missing");
  // A disc number whose absolute value its type cannot represent: the image of a disc has the negative of its number.
  const std::string ids = "Name=\"id\"";
  std::string text = discs.sound();
  const std::size_t begin = text.find('>', text.find(ids)) + 1, end = text.find('<', begin);
  const std::size_t last = text.find_last_of("-0123456789", end), first = text.find_last_of(" \n", last) + 1;
  text.replace(first, last + 1 - first, "-9223372036854775808");
  BOOST_TEST(discs.flaw(text) == "");
}

BOOST_AUTO_TEST_CASE(bibliography_with_a_long_line) {
  const Tried references{"references"};
  references.refuses("% a comment\n" + std::string(200'000, 'a'),
                     ":2: found 200000 bytes; a line must have at most 4000");
  references.refuses("% a comment\n\xff\n", ":2: the line is not UTF-8");
}

BOOST_AUTO_TEST_CASE(checkpoint_that_names_what_is_not_there) {
  const Tried checkpoint{"scene_checkpoint"};
  checkpoint.refuses(checkpoint.changed("\"integrator\": \"", "\"integrator\": \"no_"), ": integrator 'no_");
  checkpoint.refuses(checkpoint.changed("\"scene_file\": \"", "\"scene_file\": \"/no"), ": scene_file: /no/");
  checkpoint.refuses(checkpoint.changed("\"step\": ", "\"step\": 1"), ": run: the step, ");
}

BOOST_AUTO_TEST_CASE(cell_whose_contacts_have_no_frequency) {
  const Tried cell{"cell"};
  cell.refuses(cell.changed("\"1.7e4 N/m\"", "\"4.9e-324 N/m\""), ":");
  const auto dashpot = [](const std::string& restitution) {
    return "units = \"SI\"\n[cell]\nlaw = \"linear_spring_dashpot\"\nstiffness = \"2e4 N/m\"\nrestitution = " +
           restitution +
           "\ndiameter = \"1 mm\"\nmass = \"7.2e-7 kg\"\nblock_mass = \"9e-3 kg\"\nrows = 8\ncolumns = 10\nwall_discs "
           "= "
           "11\n"
           "[run]\nstep = \"0.2 us\"\nevery = \"5 ms\"\nend = \"100 ms\"\n";
  };
  cell.refuses(dashpot("4.9e-324"), ":2: restitution is 5e-324; it must be at least 2.23e-308");
}

BOOST_AUTO_TEST_CASE(run_folder_of_unknown_units) {
  const Tried folder{"run_folder"};
  folder.refuses(folder.changed("\"SI\"", "\"IS\""), ": units: unit system 'IS' is not known");
}

// A misspelt percentile was compared with the other one although it had no value.
BOOST_AUTO_TEST_CASE(a_misspelt_percentile) {
  const Tried capacity{"capacity"};
  capacity.refuses(capacity.changed("p99 = \"65", "P99 = \"65"), ":17: hazard: speed: P99: this key is not known");
}

// The step of a fence of almost no mass was 0, which ended a run by a broken contract.
BOOST_AUTO_TEST_CASE(fence_of_almost_no_mass) {
  const Tried fence{"fence"};
  fence.refuses(fence.changed("density = \"0.38 slug/ft^3\"", "density = \"4.9e-324 slug/ft^3\""), ":");
}

// Errors without a place.
BOOST_AUTO_TEST_CASE(places_in_errors) {
  const Tried pairs{"pairs"}, folder{"run_folder"};
  pairs.refuses("# a wall\nmass;speed\n", ":2: found the header \"mass;speed\"");
  folder.refuses(folder.changed("\"kind\": \"body\"", "\"kind\": \":\""),
                 ": geometry: kind of a body ':' is not known");
}

// The system refused the file of a figure, without a place in the record.
BOOST_AUTO_TEST_CASE(file_of_a_figure_with_a_long_name) {
  const Tried record{"record"};
  record.refuses(record.changed("\"csv\": \"", "\"csv\": \"" + std::string(300, '[')),
                 ": record.figures[0].csv: must be a file name of at most 200 bytes");
}

BOOST_AUTO_TEST_SUITE_END()
