#include "verification/record/interface.hpp"

#include "verification/record/json_fields.hpp"
#include "verification/record/whole_file.hpp"

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
  const Interface all{items};
  Writer writer;
  fields(writer, all);
  write_whole(file, std::move(writer).json().dump(1) + "\n");
}

std::vector<InterfaceItem> read_interface(const std::filesystem::path& file) {
  const Json json = read_json(file);
  Interface all;
  const Reader reader{Node{json, file.filename().string() + ": interface"}, Completeness::complete};
  fields(reader, all);
  return all.items;
}

}  // namespace talus::records
