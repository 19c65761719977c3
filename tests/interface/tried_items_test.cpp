#include "tests/interface/tried_items.hpp"

#include <boost/test/unit_test.hpp>

#include "tests/temporary_folder.hpp"

BOOST_AUTO_TEST_SUITE(tried_items_tests)

using namespace talus::interface_audit;
using talus::records::InterfaceItem;
using talus::records::InterfaceStatus;

namespace {

const InterfaceItem tried{.kind = "option",
                          .name = "run --out",
                          .cases = {"run_files"},
                          .status = InterfaceStatus::killed,
                          .killed_by = "run_files",
                          .check = "files"};

}  // namespace

BOOST_AUTO_TEST_CASE(a_stopped_audit_continues) {
  const Folder folder;
  const auto results = folder.path / "interface.json";
  {
    TriedItems stopped{results, "1f"};
    InterfaceItem item{.kind = "option", .name = "run --out"};
    BOOST_TEST(!stopped.find(item));
    stopped.add(tried);
  }
  const TriedItems items{results, "1f"};
  InterfaceItem item{.kind = "option", .name = "run --out"}, other{.kind = "field", .name = "run --out"};
  BOOST_TEST(items.find(item));
  BOOST_TEST((item.status == InterfaceStatus::killed && item.killed_by == "run_files" && item.check == "files"));
  BOOST_TEST(item.cases == tried.cases, boost::test_tools::per_element());
  BOOST_TEST(!items.find(other));
  items.remove();
  BOOST_TEST(folder.files() == 0);
}

BOOST_AUTO_TEST_CASE(what_another_program_has_tried_does_not_count) {
  const Folder folder;
  const auto results = folder.path / "interface.json";
  TriedItems{results, "1f"}.add(tried);
  folder.file("interface.json", "{}");
  folder.file("other.json.1f.part", "{}");
  const TriedItems items{results, "2f"};
  InterfaceItem item{.kind = "option", .name = "run --out"};
  BOOST_TEST(!items.find(item));
  BOOST_TEST(folder.files() == 2);  // its file is removed, and no other
}

BOOST_AUTO_TEST_SUITE_END()
