#include "tests/interface/tried_items.hpp"

#include <boost/test/unit_test.hpp>

#include "tests/temporary_folder.hpp"

BOOST_AUTO_TEST_SUITE(tried_items_tests)

using namespace talus::interface_audit;
using talus::records::InterfaceItem;
using talus::records::InterfaceStatus;

namespace {

using Sources = std::map<std::string, std::string>;

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
  const Sources sources{{"run_files", "a1"}};
  {
    TriedItems stopped{results, "1f", sources};
    InterfaceItem item{.kind = "option", .name = "run --out"};
    BOOST_TEST(!stopped.find(item));
    stopped.add(tried);
  }
  const TriedItems items{results, "1f", sources};
  InterfaceItem item{.kind = "option", .name = "run --out"}, other{.kind = "field", .name = "run --out"};
  BOOST_TEST(items.find(item));
  BOOST_TEST((item.status == InterfaceStatus::killed && item.killed_by == "run_files" && item.check == "files"));
  BOOST_TEST(!items.find(other));
}

BOOST_AUTO_TEST_CASE(a_detected_item_counts_while_the_case_that_detected_it_is_the_same) {
  const Folder folder;
  const auto results = folder.path / "interface.json";
  const auto found = [&](const Sources& sources, InterfaceItem item) {
    return TriedItems{results, "1f", sources}.find(item);
  };
  const InterfaceItem item{.kind = "option", .name = "run --out", .cases = {"cell_files", "run_files"}};
  TriedItems{results, "1f", {{"run_files", "a1"}, {"cell_files", "b1"}}}.add(tried);
  BOOST_TEST(found({{"run_files", "a1"}, {"cell_files", "b2"}}, item));
  BOOST_TEST(!found({{"run_files", "a2"}, {"cell_files", "b2"}}, item));
  BOOST_TEST(!found({{"run_files", "a2"}, {"cell_files", "b2"}}, item));  // it is gone for good
  BOOST_TEST(!found({{"run_files", "a1"}, {"cell_files", "b2"}}, item));
}

BOOST_AUTO_TEST_CASE(another_outcome_counts_while_all_cases_that_use_the_item_are_the_same) {
  const Folder folder;
  const auto results = folder.path / "interface.json";
  InterfaceItem survived = tried;
  survived.status = InterfaceStatus::survived, survived.killed_by = survived.check = "";
  const Sources first{{"run_files", "a1"}, {"cell_files", "b1"}};
  TriedItems{results, "1f", first}.add(survived);
  InterfaceItem item{.kind = "option", .name = "run --out", .cases = {"run_files"}}, shared = item;
  shared.cases.emplace_back("cell_files");
  BOOST_TEST((TriedItems{results, "1f", first}.find(item)));
  BOOST_TEST((!TriedItems{results, "1f", first}.find(shared)));  // a case that did not use it
  BOOST_TEST((TriedItems{results, "1f", {{"run_files", "a1"}, {"cell_files", "b2"}}}.find(item)));
  BOOST_TEST((!TriedItems{results, "1f", {{"run_files", "a2"}, {"cell_files", "b2"}}}.find(item)));
}

BOOST_AUTO_TEST_CASE(what_another_program_has_tried_does_not_count) {
  const Folder folder;
  const auto results = folder.path / "interface.json";
  const Sources sources{{"run_files", "a1"}};
  TriedItems{results, "1f", sources}.add(tried);
  folder.file("interface.json", "{}");
  folder.file("other.json.1f.tried", "{}");
  const TriedItems items{results, "2f", sources};
  InterfaceItem item{.kind = "option", .name = "run --out"};
  BOOST_TEST(!items.find(item));
  BOOST_TEST(folder.files() == 3);  // its files are removed, and no others; there is one with the cases
}

BOOST_AUTO_TEST_SUITE_END()
