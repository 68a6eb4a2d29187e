#include "bentur/contact/laws.h"
#include "bentur/io/schema/case_keys.h"
#include "bentur/model/link.h"

namespace bentur {

const KeyTable& gap_keys() {
  static const KeyTable table = {
      "gap",
      "what lies between two neighbours",
      {Key::of("between", Key::Kind::text, {"Between", "Antara"}, "the names of the two neighbours, left one first")
           .list("the neighbours, left and right", 2),
       Key::number("width", dimension::length, Range::distance, {"Gap", "Celah"}, "the distance at rest")
           .for_each("one per contact point")
           .optional("needed but for buildings in plan, which have theirs"),
       Key::whole("points", 2, 50, {"Contact points", "Titik kontak"},
                  "between buildings in plan alone: of each level, evenly spaced, ends included")
           .optional("`plan.points`"),
       Key::number("elevations", dimension::length, Range::finite, {"Elevations", "Elevasi"},
                   "ascending, where the buildings can touch; both need a floor there; `[]`: no contact is modelled")
           .list()
           .or_empty()
           .optional("every elevation where both have a floor"),
       Key::number("level_tolerance", dimension::length, Range::distance, {"Tolerance of levels", "Toleransi elevasi"},
                   "floors this close in height meet, at the mean of their elevations")
           .optional("a tenth of the smallest storey height at those floors"),
       Key::sub_table("contact", contact_keys(), {"Contact", "Kontak"},
                      "its law, see below; may be left out with `elevations = []`")
           .optional("needed but for `elevations = []`"),
       Key::of("strikes_columns", Key::Kind::flag, {"Floors strike columns", "Lantai membentur kolom"},
               "`elevations` may name a floor that faces a column of the other building: a frame, one with `columns`, "
               "in plan its frames across the joint")
           .by_default(0),
       Key::sub_table("column_capacity", column_capacity_keys(), {"Capacity of struck columns", "Kapasitas kolom"},
                      "of struck columns, for demand over capacity; where floors meet the number counts for nothing")
           .optional("none")
           .goes_with("strikes_columns")}};
  return table;
}

const KeyTable& column_capacity_keys() {
  static const KeyTable table = {"gap.column_capacity",
                                 "what struck columns can carry: one or both",
                                 {Key::number("shear", dimension::force, Range::positive, {"Shear", "Geser"})
                                      .for_each("one per contact point")
                                      .optional(),
                                  Key::number("moment", dimension::moment, Range::positive, {"Moment", "Momen"})
                                      .for_each("one per contact point")
                                      .optional()}};
  return table;
}

const KeyTable& contact_keys() {
  static const KeyTable table = [] {
    KeyTable made = {"gap.contact", "one of the laws of contact, with the keys it takes", {}};
    add_laws(contact_laws(), Key::choice("law", {}, {"Contact law", "Hukum kontak"}), made.keys);
    made.keys.push_back(Key::number("friction", dimension::none, Range::not_negative, {"Friction", "Gesekan"},
                                    "between buildings in plan alone: μ along the joint, of the laws named below")
                            .for_each("one per contact point")
                            .by_default(0));
    made.keys.push_back(Key::number("tangential_stiffness", dimension::stiffness, Range::positive,
                                    {"Tangential stiffness", "Kekakuan tangensial"},
                                    "k_t along the joint, of the spring that slides at μ times the force across")
                            .for_each("one per contact point")
                            .goes_with("friction")
                            .optional("8/9 of the stiffness across, at its beginning"));
    made.keys.push_back(Key::number("spread", dimension::length, Range::positive,
                                    {"Spread of a corner", "Sebaran sudut"},
                                    "between buildings in plan alone: the length of joint of one corner, which carries "
                                    "half of what a long joint does")
                            .optional("a quarter of the shorter building along the joint"));
    return made;
  }();
  return table;
}

const KeyTable& link_keys() {
  static const KeyTable table = [] {
    KeyTable made = {
        "link",
        "a spring, damper or cable that joins two buildings",
        {Key::of("between", Key::Kind::text, {"Between", "Antara"},
                 "the names of two buildings, of a row the left one first")
             .list("the left and the right building", 2),
         Key::number("elevations", dimension::length, Range::finite, {"Elevations", "Elevasi"},
                     "ascending, above the common datum; both buildings need a floor there")
             .list(),
         Key::number("level_tolerance", dimension::length, Range::distance,
                     {"Tolerance of levels", "Toleransi elevasi"},
                     "how far apart in height those two floors may be, as in a gap")
             .optional("as in a gap"),
         Key::number("at", dimension::length, Range::level, {"Place along the joint", "Letak sepanjang celah"},
                     "of buildings in plan: the x or y along the middle of their joint, within the part where they "
                     "face each other")
             .optional("needed in plan"),
         Key::choice("along", {"x", "y"}, {"Along", "Sejajar"}, "of buildings in plan: the axis that it acts along")
             .optional("across the joint")}};
    add_laws(link_laws(), Key::choice("law", {}, {"Law of the link", "Hukum penghubung"}), made.keys);
    return made;
  }();
  return table;
}

}  // namespace bentur
