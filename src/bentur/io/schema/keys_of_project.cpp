#include "bentur/io/schema/case_keys.h"

namespace bentur {

const KeyTable& project_keys() {
  const auto line = [](const char* name, Label label, const char* doc) {
    return Key::of(name, Key::Kind::line, label, doc).optional("not said");
  };
  static const KeyTable table = {
      "project",
      "whose case it is and what for, as a report says it that is handed in",
      {line("name", {"Project", "Proyek"}, "of the project"),
       line("number", {"Number", "Nomor"}, "the office's number of it"),
       line("engineer", {"Engineer", "Insinyur"}, "who answers for it"),
       line("date", {"Date", "Tanggal"}, "of the report, as it is to be printed"),
       line("revision", {"Revision", "Revisi"}, "of the report"),
       line("code_basis", {"Code basis", "Dasar peraturan"},
            "codes and standards of the project, as they are to be named; `[code]` says which separation rules are "
            "checked"),
       Key::of("assumptions", Key::Kind::line, {"Assumptions", "Asumsi"},
               "the engineer's own, a sentence each, before the program's")
           .list()
           .optional("none"),
       Key::of("sources", Key::Kind::line, {"Sources", "Sumber"},
               "of the numbers of the case, a sentence each: drawings, surveys, other programs")
           .list()
           .optional("none"),
       Key::of("logo", Key::Kind::file, {"Logo", "Logo"},
               "a PNG, JPEG or SVG [picture](report.md#logo) beside the case, up to 256 kB")
           .optional("none")}};
  return table;
}

}  // namespace bentur
