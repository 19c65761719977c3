#include "solver/io/field_catalogue.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <map>
#include <set>

#include "tests/solver/io/file_tables.hpp"

BOOST_AUTO_TEST_SUITE(field_catalogue_tests)

// The catalogue compared with the readers: the fields that each reader knows, and those that it requires.

using namespace talus;

namespace {

using NameSet = std::set<std::string>;

NameSet names_of(const FieldGroup& group) {
  NameSet names;
  for (const CatalogueField& field : all_fields(group))
    names.insert(field.name);
  return names;
}

/// The field with this name in the table's group.
CatalogueField field_of(const FileTable& table, const std::string& name) {
  for (const CatalogueField& field : all_fields(field_group(table.group)))
    if (field.name == name) return field;
  BOOST_FAIL("no field " << name << " in group " << table.group);
  return {};
}

/// True if one table is inside another.
bool is_inside(const std::string& path, const std::string& outer) {
  return outer.empty() ? !path.empty() : path.starts_with(outer + ".");
}

/// The last path component: the name of the table as a field of its parent table.
std::string name_of(const FileTable& table) { return table.path.substr(table.path.rfind('.') + 1); }

/// The parent of table i; the file itself has none.
std::size_t parent_of(const std::vector<FileTable>& tables, std::size_t i) {
  const std::size_t dot = tables[i].path.rfind('.');
  const std::string path = dot == std::string::npos ? "" : tables[i].path.substr(0, dot);
  for (std::size_t k = i; k-- > 0;)
    if (tables[k].path == path) return k;
  BOOST_FAIL("no table around " << tables[i].path);
  return 0;
}

/// True if the field is required, unconditionally or because of another field in this table.
bool is_required(const FileTable& table, const CatalogueField& field) {
  if (!field.required || field.with.empty()) return field.required;
  return std::ranges::any_of(table.lines, [&](const std::string& line) {
    const std::string value = value_of(line);
    return key_of(line) == field.with &&
           (field.with_value.empty() || value == field.with_value || value == '"' + field.with_value + '"');
  });
}

/// The names after "known: " in the line of a message that contains `expected`.
NameSet known_names(const std::string& message, const std::string& expected) {
  const std::size_t at = message.find(expected);
  if (at == std::string::npos) return {};
  const std::string line = message.substr(at, message.find('\n', at) - at);
  NameSet names;
  std::istringstream in{line.substr(line.find("known: ", line.find("nearest: ")) + 7)};
  for (std::string name; std::getline(in >> std::ws, name, ',');)
    names.insert(name);
  return names;
}

}  // namespace

BOOST_AUTO_TEST_CASE(complete_files_are_read) {
  for (const std::string_view file : complete_files)
    BOOST_TEST(errors_of(tables_of(file)) == "");
}

BOOST_AUTO_TEST_CASE(every_field_is_in_a_complete_file) {
  std::map<std::string, NameSet> seen, bases;
  for (const std::string_view file : complete_files) {
    const auto tables = tables_of(file);
    for (std::size_t i = 0; i < tables.size(); ++i) {
      for (const std::string& line : tables[i].lines)
        seen[tables[i].group].insert(key_of(line));
      if (i > 0) seen[tables[parent_of(tables, i)].group].insert(name_of(tables[i]));
    }
  }
  seen["scene"].insert("fence");  // it makes the file one of a fence
  for (const FieldGroup& group : field_catalogue())
    bases[group.base];
  for (const FieldGroup& group : field_catalogue()) {
    if (bases.contains(group.id)) continue;
    const NameSet names = names_of(group), found = seen[group.id];
    BOOST_TEST_CONTEXT("group " << group.id)
    BOOST_TEST(names == found, boost::test_tools::per_element());
  }
}

BOOST_AUTO_TEST_CASE(the_fields_that_readers_know_are_those_of_the_catalogue) {
  for (const std::string_view file : complete_files) {
    const auto tables = tables_of(file);
    for (std::size_t i = 0; i < tables.size(); ++i) {
      auto changed = tables;
      changed[i].lines.insert(changed[i].lines.begin(), "no_such_field = 1");
      const NameSet known = known_names(errors_of(changed), "no_such_field: this key is not known; nearest: ");
      const NameSet names = names_of(field_group(tables[i].group));
      BOOST_TEST_CONTEXT("group " << tables[i].group)
      BOOST_TEST(known == names, boost::test_tools::per_element());
    }
  }
}

BOOST_AUTO_TEST_CASE(the_fields_that_readers_require_are_those_marked) {
  for (const std::string_view file : complete_files) {
    const auto tables = tables_of(file);
    for (std::size_t i = 0; i < tables.size(); ++i) {
      for (const std::string& line : tables[i].lines) {
        const CatalogueField field = field_of(tables[i], key_of(line));
        // Without it the other fields would belong to another law.
        if (field.name == "law" && !field.required && value_of(line) != '"' + field.absent + '"') continue;
        auto changed = tables;
        // With it all fields go that require it, and those that require one of these.
        const auto requires_it = [&](std::string name) {
          while (!name.empty() && name != field.name)
            name = field_of(tables[i], name).with;
          return !name.empty();
        };
        std::erase_if(changed[i].lines,
                      [&](const std::string& other) { return other == line || requires_it(key_of(other)); });
        const std::string errors = errors_of(changed);
        BOOST_TEST(errors.empty() == !is_required(tables[i], field),
                   tables[i].group << ": without " << line << ": " << (errors.empty() ? "no error" : errors));
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(the_tables_that_readers_require_are_those_marked) {
  for (const std::string_view file : complete_files) {
    const auto tables = tables_of(file);
    for (std::size_t i = 1; i < tables.size(); ++i) {
      const CatalogueField field = field_of(tables[parent_of(tables, i)], name_of(tables[i]));
      const bool one = field.form != FieldForm::tables;
      // The contacts of a body require its shape.
      if (tables[i].path == "body.shape" && tables[i].group != "shape none") continue;
      // Other tables may refer to a table of an array; see the scene without any, below.
      if (!one && !field.required) continue;
      auto changed = tables;
      const auto goes = [&](std::size_t k) {
        if (!one) return tables[k].path == tables[i].path || is_inside(tables[k].path, tables[i].path);
        return k >= i && (k == i || is_inside(tables[k].path, tables[i].path));
      };
      for (std::size_t k = changed.size(); k-- > 0;)
        if (goes(k)) changed.erase(changed.begin() + static_cast<std::ptrdiff_t>(k));
      const std::string errors = errors_of(changed);
      BOOST_TEST(errors.empty() == !field.required,
                 "without " << tables[i].header << ": " << (errors.empty() ? "no error" : errors));
    }
  }
}

BOOST_AUTO_TEST_CASE(either_of_two_fields_is_enough_and_both_are_too_many) {
  int pairs = 0;
  for (const FieldGroup& group : field_catalogue()) {
    for (const CatalogueField& field : group.fields) {
      if (field.alternative.empty()) continue;
      const auto all = all_fields(group);
      const auto other = std::ranges::find(all, field.alternative, &CatalogueField::name);
      BOOST_REQUIRE((other != all.end()));
      BOOST_TEST(other->alternative == field.name);
      BOOST_TEST((field.required && other->required));
      ++pairs;
    }
  }
  BOOST_TEST(pairs >= 10);
}

BOOST_AUTO_TEST_CASE(fields_are_explained) {
  NameSet ids;
  for (const FieldGroup& group : field_catalogue()) {
    BOOST_TEST(ids.insert(group.id).second, group.id);
    BOOST_TEST(!group.head.empty());
    for (const CatalogueField& field : group.fields) {
      BOOST_TEST(!field.meaning.empty(), group.id << ": " << field.name);
      const bool named = field.form == FieldForm::name || field.form == FieldForm::names;
      BOOST_TEST(named == !field.names.empty(), group.id << ": " << field.name);
    }
  }
  BOOST_CHECK_THROW(static_cast<void>(field_group("contact hrtz")), InputError);
}

BOOST_AUTO_TEST_SUITE_END()
