#include "bentur/io/results/internal/record_json.h"

#include <nlohmann/json.hpp>

namespace bentur {

void put_record(const RecordEcho& record, nlohmann::ordered_json& object) {
  object["file"] = record.file;
  object["format"] = record.format;
  object["unit"] = record.unit;
  object["channel"] = record.channel;
  object["header_lines"] = record.header_lines;
  object["mean_removed"] = record.mean_removed;
  object["time_step"] = record.time_step;
  object["count"] = record.count;
  object["duration"] = record.duration;
  object["pga_read"] = record.pga_read;
  object["polarity"] = record.reversed ? "reversed" : "as-recorded";
  object["pga"] = record.pga;
}

}  // namespace bentur
