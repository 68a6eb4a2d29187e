#include "bentur/study/suite/suite_study.h"

#include <fmt/format.h>

#include <algorithm>

#include "bentur/io/case/case_parts.h"
#include "bentur/io/schema/case_keys.h"
#include "bentur/model/suite/suite.h"

namespace bentur {
namespace {

/// Of an entry of `files` that is a table the keys that say how a file is read.
std::vector<std::string> reading_keys() {
  std::vector<std::string> names = suite_file_keys().names();
  std::erase_if(names, [](const std::string& name) { return name == "file" || name == "event"; });
  return names;
}

/// What of [excitation] holds for every record of a suite.
bool is_of_all_records(const std::string& key) {
  const std::vector<std::string> known = {"delays", "wave_velocity", "wave_angle", "kinematics", "polarity", "angle"};
  return std::find(known.begin(), known.end(), key) != known.end();
}

bool has_suite(const Study& study) {
  const TomlValue* const kind = find_value(study.case_root, {"excitation", "kind"});
  return kind != nullptr && kind->text == "suite";
}

}  // namespace

std::optional<Vary> take_suite(Study& study, Diagnostics& diagnostics) {
  if (!has_suite(study)) return std::nullopt;
  if (!study.suite) {
    Diagnostics found;
    const std::string name = study.case_file.string();
    const ReadCase read =
        read_case_parts(TomlView(study.case_root, "", name, found), study.case_file.parent_path(), found);
    diagnostics.add(found);
    if (!found.ok()) return std::nullopt;
    study.suite = read.c.excitation.suite;
  }
  const bool pairs = study.suite->is_of_pairs();
  const auto entries_at = [&](const ParameterPath& path) { return find_value(study.case_root, path)->items; };
  const std::vector<TomlValue> entries = entries_at({"excitation", "files"});
  const std::vector<TomlValue> along_y = pairs ? entries_at({"excitation", "y", "files"}) : std::vector<TomlValue>();
  Vary vary;
  vary.parameter = "excitation.file";
  vary.path = {"excitation", "file"};
  vary.name = "record";
  for (const std::string& key : reading_keys()) {
    vary.file_keys.push_back({{"excitation", key}, {}});
    if (pairs) vary.file_keys.push_back({{"excitation", "y", key}, {}});
  }
  if (pairs) vary.file_keys.push_back({{"excitation", "y", "file"}, {}});
  for (const SuiteRecord& record : study.suite->records) {
    vary.values.push_back(toml_text(record.echo.file));
    vary.labels.push_back(record.name());
    vary.normalisation.push_back(record.factor);
    for (FileKey& key : vary.file_keys) {
      const bool is_of_y = key.path.size() == 3;
      const TomlValue& entry = is_of_y ? along_y.at(record.along_y->entry) : entries.at(record.entry);
      const TomlValue* const given = entry.find(std::get<std::string>(key.path.back()));
      key.values.push_back(given != nullptr ? std::optional(*given) : std::nullopt);
      if (key.path.back() == PathStep("file")) key.values.back() = toml_text(record.along_y->echo.file);
    }
  }
  vary.parameter_position = vary.position = study.suite->position;
  TomlValue& excitation = *study.case_root.find("excitation");
  std::erase_if(excitation.members, [](const TomlMember& member) { return !is_of_all_records(member.key); });
  put_value(study.case_root, {"excitation", "kind"}, toml_text("record"));
  if (pairs) put_value(study.case_root, {"excitation", "y", "kind"}, toml_text("record"));
  return vary;
}

void vary_records_of_suite(Vary records, Study& study, Diagnostics& diagnostics) {
  for (const Vary& other : study.varies) {
    if (other.path.empty() || other.path.front() != PathStep("excitation")) continue;
    const auto* const key = other.path.size() > 1 ? std::get_if<std::string>(&other.path[1]) : nullptr;
    if (key != nullptr && is_of_all_records(*key)) continue;
    diagnostics.error(other.parameter_position,
                      fmt::format("{} cannot be varied: the case has a suite, which chooses and scales the records",
                                  other.parameter));
  }
  for (const Vary& other : study.varies) {
    if (other.name != records.name && study.axes[other.axis] != records.name) continue;
    diagnostics.error(other.parameter_position, "has the name \"record\" of the suite's records: give name = \"..\"");
  }
  records.axis = study.axes.size();
  study.axes.push_back(records.name);
  study.varies.push_back(std::move(records));
  if (study.ida) study.ida->normalised = true;
}

}  // namespace bentur
