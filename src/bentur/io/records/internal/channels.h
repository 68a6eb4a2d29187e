#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "bentur/io/records/internal/heading.h"
#include "bentur/io/records/internal/record_text.h"

// Files with several channels: blocks of values, each under a heading, or columns side by side.
namespace bentur::records {

/// One of several channels of a file, still unread.
struct Channel {
  std::string title;           ///< as the file calls it
  std::size_t first_line = 0;  ///< index of the line that its values begin with
  int header_lines = 0;        ///< of this channel
  std::string unit;            ///< as the file spells it
  long count = 0;              ///< of values as the file says
  double time_step = 0;        ///< [s]
  std::size_t width = 0;       ///< of a field [characters]
  Heading heading = {};        ///< with the peak that it states
  int line = 0;                ///< where it says count, step and unit; 0: in the line before the values
  std::size_t lines = 0;       ///< of values; 0: up to what ends a block
  bool exact_count = false;    ///< else it may be off by one
  bool timed = false;          ///< pairs of time and acceleration
};

/// A format whose files have several channels, each a block of values under a heading.
struct ChannelFormat {
  const char* heading;        ///< an example, for messages
  const char* step_rule;      ///< the message where a channel has no step
  bool (*ends)(const Line&);  ///< whether a line ends a block
};
/// The channel that the options choose: the only one, or the one with the number or the name given. An error where
/// there is none, or it has no step, or not as many values as the file says, or another peak.
[[nodiscard]] std::optional<StrongMotionRecord> read_channel(const std::vector<Line>& lines,
                                                             const std::vector<Channel>& channels,
                                                             const ChannelFormat& format, const RecordOptions& options,
                                                             RecordErrors& errors);

/// The place of the channel that the options choose among titles. An error where it is not there, or not said.
[[nodiscard]] std::optional<std::size_t> chosen_channel(const std::vector<std::string>& titles,
                                                        const RecordOptions& options, RecordErrors& errors);

/// "channel 2 of 3 (TITLE)"; empty where there is one alone.
[[nodiscard]] std::string channel_text(const std::vector<std::string>& titles, std::size_t chosen);

/// Components side by side: a column of values for each, behind others that hold none.
struct ComponentColumns {
  std::vector<std::string> names;  ///< of the components
  std::size_t before = 0;          ///< columns before the first of them
  std::size_t width = 0;           ///< of a field [characters]; 0: between separators
  char separator = ' ';
};
/// The values of the component that the options choose, from index `first` of the lines on, as the only numbers of the
/// record; and which it is. An error where a row has not one number for each.
[[nodiscard]] std::optional<ChannelPlace> read_component(const std::vector<Line>& lines, std::size_t first,
                                                         const ComponentColumns& columns, const RecordOptions& options,
                                                         StrongMotionRecord& record, RecordErrors& errors);

/// The characters of a field in lines of numbers with `in_line` fields each, by their length; 0 where blanks part them
/// or no length fits.
[[nodiscard]] std::size_t width_of_lines(const std::vector<Line>& lines, std::size_t first, std::size_t in_line);

/// Whether the file states that many values where it states any; else an error.
void check_stated_count(const Heading& heading, std::size_t count, ChannelPlace channel, RecordErrors& errors);

/// The step that the heading states, and in `line` where; an error where it states none, or more than one.
[[nodiscard]] double stated_step(const Heading& heading, ChannelPlace channel, int& line, RecordErrors& errors);

}  // namespace bentur::records
