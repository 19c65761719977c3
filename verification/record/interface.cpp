#include "verification/record/interface.hpp"

#include "verification/record/json_fields.hpp"

namespace talus::records {

namespace {

struct Interface {
  std::vector<InterfaceItem> items;
};

}  // namespace

void fields(auto& f, Like<InterfaceItem> auto& item) {
  f.nonempty_text("kind", item.kind);
  f.nonempty_text("name", item.name);
  f.value("cases", item.cases);
  f.value("status", item.status);
  f.value("killed_by", item.killed_by);
  f.value("check", item.check);
}

void fields(auto& f, Like<Interface> auto& all) {
  f.derived("schema", std::string("talus interface 1"));
  f.value("items", all.items);
}

void write_interface(const std::vector<InterfaceItem>& items, const std::filesystem::path& file) {
  write_file(Interface{items}, file);
}

std::vector<InterfaceItem> read_interface(const std::filesystem::path& file) {
  return read_file<Interface>(file, "interface").items;
}

}  // namespace talus::records
