#include "bentur/io/schema/file_names.h"

#include "bentur/io/schema/table_view.h"

namespace bentur {
namespace {

using Naming = std::function<std::string(const std::string&)>;

void rename_in(TomlValue& value, const Key& key, const Naming& name) {
  if (value.kind == TomlValue::Kind::table && key.table != nullptr) rename_files(value, *key.table, name);
  if (value.kind == TomlValue::Kind::text && key.kind == Key::Kind::file) value.text = name(value.text);
  for (TomlValue& item : value.items) rename_in(item, key, name);
}

}  // namespace

void rename_files(TomlValue& table, const KeyTable& keys, const Naming& name) {
  for (TomlMember& member : table.members) {
    const Key* const key = key_of(keys, member.key, table);
    if (key != nullptr) rename_in(member.value, *key, name);
  }
}

}  // namespace bentur
