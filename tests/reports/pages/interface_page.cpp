#include "reports/pages/interface_page.hpp"

#include <boost/test/unit_test.hpp>

#include "tests/temporary_folder.hpp"
#include "verification/record/error.hpp"
#include "verification/record/whole_file.hpp"

BOOST_AUTO_TEST_SUITE(interface_page_tests)

using namespace talus::reports;
using namespace talus::records;

namespace {

/// An item that two cases use, unless none does; the second detects its change, if one does.
InterfaceItem item(const char* kind, const std::string& name, InterfaceStatus status) {
  InterfaceItem made{.kind = kind, .name = name, .status = status};
  if (status != InterfaceStatus::unused) made.cases = {"run_files", "two_rocks"};
  if (status == InterfaceStatus::killed) made.killed_by = "two_rocks", made.check = "largest error of " + name;
  return made;
}

const std::vector<InterfaceItem> items{item("option", "run --out", InterfaceStatus::killed),
                                       item("option", "run --all", InterfaceStatus::unused),
                                       item("field", "body.mass", InterfaceStatus::killed),
                                       item("field", "title", InterfaceStatus::survived),
                                       item("field", "units", InterfaceStatus::refused),
                                       item("column", "history.csv: rock.x [m]", InterfaceStatus::killed),
                                       item("member", "summary.json: steps", InterfaceStatus::survived),
                                       item("member", "summary.json: notes[]", InterfaceStatus::unchanged),
                                       item("member", "plot.json: title", InterfaceStatus::survived)};

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

}  // namespace

BOOST_AUTO_TEST_CASE(items_are_counted_by_kind_and_gaps_are_named) {
  const std::string text = interface_text(items);
  BOOST_TEST(contains(text, "| options of commands | 1 | 0 | 1 | 0 | 0 | 100.0 % |"), text);
  BOOST_TEST(contains(text, "| fields of scenes and fences | 1 | 1 | 0 | 1 | 0 | 50.0 % |"));
  BOOST_TEST(contains(text, "| members of JSON files | 0 | 2 | 0 | 0 | 1 | 0.0 % |"));
  BOOST_TEST(contains(text, "| arrays of states (VTK) | 0 | 0 | 0 | 0 | 0 |"));
  BOOST_TEST(contains(text, "| **all** | 3 | 3 | 1 | 1 | 1 | 50.0 % |"));
  const std::size_t survived = text.find("**Not noticed"), unused = text.find("**Not used");
  BOOST_TEST((survived < unused && unused != std::string::npos));
  const std::string first = text.substr(survived, unused - survived);
  BOOST_TEST(contains(first, "- fields of scenes and fences: `title`\n"));
  BOOST_TEST(contains(first, "- members of JSON files: `plot.json`: `title`; `summary.json`: `steps`\n"));
  BOOST_TEST(contains(text.substr(unused), "- options of commands: `run --all`\n"));
}

BOOST_AUTO_TEST_CASE(what_is_written_is_read) {
  const Folder scratch;
  const auto file = scratch.path / "interface.json";
  write_interface(items, file);
  const std::vector<InterfaceItem> read = read_interface(file);
  BOOST_TEST_REQUIRE(read.size() == items.size());
  for (std::size_t i = 0; i < items.size(); ++i) {
    BOOST_TEST(read[i].kind == items[i].kind);
    BOOST_TEST(read[i].name == items[i].name);
    BOOST_TEST(read[i].cases == items[i].cases);
    BOOST_TEST((read[i].status == items[i].status));
    BOOST_TEST(read[i].killed_by == items[i].killed_by);
    BOOST_TEST(read[i].check == items[i].check);
  }
  write_whole(file, "{\"schema\": \"talus interface 0\", \"items\": []}");
  BOOST_CHECK_THROW(static_cast<void>(read_interface(file)), RecordError);
}

BOOST_AUTO_TEST_SUITE_END()
