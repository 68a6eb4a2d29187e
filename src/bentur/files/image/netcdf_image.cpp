#include "bentur/files/image/netcdf_image.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstring>
#include <functional>
#include <map>
#include <numeric>
#include <stdexcept>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace bentur {
namespace {

static_assert(std::endian::native == std::endian::little);  // as what is written

using Address = std::uint64_t;
constexpr Address nowhere = ~Address{0};

template <class Number>
void put(std::string& bytes, Number number) {
  static_assert(std::is_arithmetic_v<Number>);
  bytes.append(reinterpret_cast<const char*>(&number), sizeof number);
}
template <class... Numbers>
std::string packed(Numbers... numbers) {
  std::string bytes;
  (put(bytes, numbers), ...);
  return bytes;
}
/// HDF5 aligns what it reads by eight bytes.
void align(std::string& bytes) { bytes.resize((bytes.size() + 7) / 8 * 8, '\0'); }

using U8 = std::uint8_t;
using U16 = std::uint16_t;
using U32 = std::uint32_t;
using U64 = std::uint64_t;

/// Types of numbers and texts, as messages of HDF5: class and version, three bytes of flags, bytes of one, properties.
std::string type_of_integer(U32 bytes, bool is_signed) {
  return packed(U8{0x10}, U8(is_signed ? 8 : 0), U8{0}, U8{0}, bytes, U16{0}, static_cast<U16>(8 * bytes));
}
std::string type_of_double() {
  return packed(U8{0x11}, U8{0x20}, U8{63}, U8{0}, U32{8}, U16{0}, U16{64}, U8{52}, U8{11}, U8{0}, U8{52}, U32{1023});
}
/// A text of so many bytes, the rest 0, in UTF-8.
std::string type_of_text(std::size_t bytes) {
  return packed(U8{0x13}, U8{0x10}, U8{0}, U8{0}, static_cast<U32>(bytes));
}
constexpr U32 heap_place_bytes = 16;  ///< of a length and a place in a global heap
std::string type_of_texts() {
  return packed(U8{0x19}, U8{1}, U8{1}, U8{0}, heap_place_bytes) + type_of_integer(1, false);
}
std::string type_of_lists_of_references() {
  return packed(U8{0x19}, U8{0}, U8{0}, U8{0}, heap_place_bytes) + packed(U8{0x17}, U8{0}, U8{0}, U8{0}, U32{8});
}

/// How many places there are along each dimension; of none one place.
std::string space_of(const std::vector<std::size_t>& shape) {
  std::string space = packed(U8{1}, static_cast<U8>(shape.size()), U8{0}, U8{0}, U32{0});
  for (const std::size_t size : shape) put(space, U64{size});
  return space;
}
std::string space_of_nothing() { return packed(U8{2}, U8{0}, U8{0}, U8{2}); }

/// What is said of an object, message by message.
class ObjectHeader {
 public:
  void add(U16 kind, std::string body) {
    align(body);
    if (body.size() > most) {
      throw std::invalid_argument(fmt::format("HDF5 has no messages of {} bytes: {} at most", body.size(), most));
    }
    messages_ += packed(kind, static_cast<U16>(body.size()), U32{0}) + body;
    ++count_;
  }
  void attribute(const std::string& name, std::string type, std::string space, const std::string& data) {
    std::string body = packed(U8{1}, U8{0}, static_cast<U16>(name.size() + 1), static_cast<U16>(type.size()),
                              static_cast<U16>(space.size()));
    body.append(name.c_str(), name.size() + 1);
    for (std::string* const part : {&type, &space}) {
      align(body);
      body += *part;
    }
    align(body);
    add(0x0c, body + data);
  }
  void text(const std::string& name, std::string_view value) {
    if (value.empty()) return attribute(name, type_of_text(1), space_of_nothing(), "");
    attribute(name, type_of_text(value.size()), space_of({}), std::string(value));
  }
  void attribute(const ResultAttribute& one) {
    if (const auto* value = std::get_if<std::string>(&one.value)) return text(one.name, *value);
    if (const auto* number = std::get_if<double>(&one.value)) {
      return attribute(one.name, type_of_double(), space_of({1}), packed(*number));
    }
    const auto& flags = std::get<std::vector<signed char>>(one.value);
    attribute(one.name, type_of_integer(1, true), space_of({flags.size()}), std::string(flags.begin(), flags.end()));
  }
  [[nodiscard]] std::string bytes() const {
    return packed(U8{1}, U8{0}, count_, U32{1}, static_cast<U32>(messages_.size()), U32{0}) + messages_;
  }

 private:
  static constexpr std::size_t most = 65528;
  std::string messages_;
  U16 count_ = 0;
};

/// Objects of a global heap: collections of them, each named by its address and a number in it.
constexpr std::size_t collection_head = 16, object_head = 16, least_collection = 4096;
std::string head_of_collection(std::size_t bytes) { return "GCOL" + packed(U32{1}, U64{bytes}); }
std::string head_of_object(std::size_t number, std::size_t bytes) {
  return packed(static_cast<U16>(number), U16{1}, U32{0}, U64{bytes});
}

/// References to dimensions, each an object of eight bytes: as many fill a collection, so that places are known
/// before what is referred to is written.
class References {
 public:
  explicit References(Address begin) : begin_(begin) {}
  [[nodiscard]] static std::size_t bytes_of(std::size_t count) {
    return (count + in_one - 1) / in_one * least_collection;
  }
  /// The next one, as an attribute has it: a list of one.
  std::string add(int dimension) {
    const std::size_t collection = dimensions_.size() / in_one, number = dimensions_.size() % in_one + 1;
    dimensions_.push_back(dimension);
    return packed(U32{1}, U64{begin_ + collection * least_collection}, static_cast<U32>(number));
  }
  [[nodiscard]] std::string bytes(const std::vector<Address>& scales) const {
    std::string bytes;
    for (std::size_t i = 0; i < dimensions_.size(); ++i) {
      if (i % in_one == 0) bytes += head_of_collection(least_collection);
      bytes += head_of_object(i % in_one + 1, 8) + packed(scales.at(static_cast<std::size_t>(dimensions_[i])));
    }
    const std::size_t left = bytes_of(dimensions_.size()) - bytes.size();
    if (left > 0) bytes += packed(U16{0}, U16{0}, U32{0}, U64{left});
    bytes.resize(bytes_of(dimensions_.size()), '\0');
    return bytes;
  }

 private:
  static constexpr std::size_t in_one = (least_collection - collection_head) / (object_head + 8);
  static_assert(collection_head + in_one * (object_head + 8) == least_collection);
  Address begin_;
  std::vector<int> dimensions_;
};

/// Texts of variables; what is empty is a text of one byte, 0, as HDF5 has no objects of none.
class Texts {
 public:
  explicit Texts(Address begin) : begin_(begin) {}
  /// @return what stands for it in the variable
  std::string add(const std::string& text) {
    const std::size_t length = std::max<std::size_t>(text.size(), 1);
    if (collection_.size() > most_bytes || count_ >= most_objects) close();
    ++count_;
    collection_ += head_of_object(count_, length);
    collection_.append(text.c_str(), length);
    align(collection_);
    return packed(static_cast<U32>(length), U64{begin_ + closed_.size()}, static_cast<U32>(count_));
  }
  /// All of them; no more come.
  [[nodiscard]] const std::string& bytes() {
    if (count_ > 0) close();
    return closed_;
  }

 private:
  void close() {
    const std::size_t used = collection_head + collection_.size();
    const std::size_t size = std::max(used + object_head, least_collection);
    closed_ += head_of_collection(size) + collection_ + packed(U16{0}, U16{0}, U32{0}, U64{size - used});
    closed_.append(size - used - object_head, '\0');
    collection_.clear();
    count_ = 0;
  }
  static constexpr std::size_t most_bytes = 1U << 16, most_objects = 60000;
  Address begin_;
  std::string closed_, collection_;
  std::size_t count_ = 0;
};

constexpr std::size_t names_in_leaf = 32;  ///< twice the K of leaves

/// Writes a group: the names of objects in a B-tree of one level, whose nodes have room for so many leaves.
/// @return addresses of the tree, of the heap of names and of the group's header
struct GroupPlace {
  Address tree, heap, header;
};
GroupPlace write_group(std::string& image, const std::map<std::string, Address>& objects, std::size_t most_leaves) {
  std::string names(8, '\0');  // the empty one
  std::string keys_and_leaves = packed(U64{0});
  std::size_t leaves = 0;
  for (auto object = objects.begin(); object != objects.end(); ++leaves) {
    const Address leaf = image.size();
    std::string entries;
    U16 count = 0;
    Address last = 0;
    for (; object != objects.end() && count < names_in_leaf; ++object, ++count) {
      last = names.size();
      entries += packed(last, object->second, U64{0}, U64{0}, U64{0});
      names.append(object->first.c_str(), object->first.size() + 1);
      align(names);
    }
    entries.resize(names_in_leaf * 40, '\0');
    image += "SNOD" + packed(U8{1}, U8{0}, count) + entries;
    keys_and_leaves += packed(leaf, last);
  }
  const Address heap = image.size();
  constexpr std::size_t heap_head = 32;
  constexpr U64 no_free_part = 1;
  image += "HEAP" + packed(U32{0}, U64{names.size()}, no_free_part, U64{heap + heap_head}) + names;
  const Address tree = image.size();
  keys_and_leaves.resize((2 * most_leaves + 1) * 8, '\0');
  image += "TREE" + packed(U8{0}, U8{0}, static_cast<U16>(leaves), nowhere, nowhere) + keys_and_leaves;
  const Address header = image.size();
  ObjectHeader group;
  group.add(0x11, packed(tree, heap));
  image += group.bytes();
  return {tree, heap, header};
}

/// "exact" of "exact/time", nothing of a name that is in no group.
std::string group_of(const std::string& name) {
  const std::size_t end = name.rfind('/');
  return end == std::string::npos ? "" : name.substr(0, end);
}
std::string own_name(const std::string& name) { return name.substr(name.rfind('/') + 1); }

std::size_t bytes_of_one(const ResultValues& values) {
  static constexpr std::size_t bytes[] = {8, 8, 4, 1, heap_place_bytes};  // in the order of their types
  return bytes[values.index()];
}
std::string type_of(const ResultValues& values) {
  switch (values.index()) {
    case 2:
      return type_of_integer(4, true);
    case 3:
      return type_of_integer(1, true);
    case 4:
      return type_of_texts();
    default:
      return type_of_double();
  }
}

/// Puts the file together: references to dimensions, texts, values, objects, groups.
class Image {
 public:
  explicit Image(const ResultFile& file)
      : file_(file), references_(superblock_bytes), texts_(superblock_bytes + bytes_of_references(file)) {}

  std::string bytes() {
    number_dimensions();
    std::size_t bytes = 0;
    for (const ResultVariable& one : file_.variables) {
      bytes += 2000 + bytes_of_one(one.values) * std::visit([](const auto& all) { return all.size(); }, one.values);
    }
    image_.reserve(bytes);
    std::vector<std::string> of_texts;
    for (const ResultVariable& one : file_.variables) of_texts.push_back(texts_of(one));
    image_.resize(superblock_bytes + bytes_of_references(file_), '\0');
    image_ += texts_.bytes();
    for (std::size_t i = 0; i < file_.variables.size(); ++i) variable(file_.variables[i], of_texts[i]);
    for (const auto& [name, dimension] : dimensions_) {
      if (scales_[static_cast<std::size_t>(dimension.number)] == nowhere) scale_alone(name, dimension);
    }
    const std::string references = references_.bytes(scales_);
    image_.replace(superblock_bytes, references.size(), references);
    groups();
    return std::move(image_);
  }

 private:
  static constexpr std::size_t superblock_bytes = 96;
  struct Dimension {
    int number;
    std::size_t size;
  };

  static std::size_t bytes_of_references(const ResultFile& file) {
    std::size_t count = 0;
    for (const ResultVariable& one : file.variables) count += is_scale(one) ? 0 : one.dimensions.size();
    return References::bytes_of(count);
  }

  /// Whether it says where the places along the dimension of its own name are.
  static bool is_scale(const ResultVariable& one) {
    return one.dimensions.size() == 1 && one.dimensions.front().name == one.name;
  }

  void number_dimensions() {
    for (const ResultVariable& one : file_.variables) {
      for (const ResultDimension& dimension : one.dimensions) {
        if (dimension.size == 0) throw std::invalid_argument(dimension.name + ": a dimension without places");
        const auto number = static_cast<int>(dimensions_.size());
        const auto [known, is_new] = dimensions_.try_emplace(dimension.name, Dimension{number, dimension.size});
        if (!is_new && known->second.size != dimension.size) {
          throw std::invalid_argument(dimension.name + ": a dimension of two sizes");
        }
      }
    }
    scales_.assign(dimensions_.size(), nowhere);
  }

  /// What stands for texts in a variable; nothing of numbers.
  std::string texts_of(const ResultVariable& variable) {
    std::string places;
    if (const auto* texts = std::get_if<std::vector<std::string>>(&variable.values)) {
      for (const std::string& text : *texts) places += texts_.add(text);
    }
    return places;
  }

  void variable(const ResultVariable& variable, const std::string& texts) {
    std::vector<std::size_t> shape;
    for (const ResultDimension& dimension : variable.dimensions) shape.push_back(dimension.size);
    const std::size_t places = std::accumulate(shape.begin(), shape.end(), std::size_t{1}, std::multiplies<>());
    const std::size_t count = std::visit([](const auto& all) { return all.size(); }, variable.values);
    if (count != places) {
      throw std::invalid_argument(fmt::format("{}: {} values for {} places", variable.name, count, places));
    }
    const Address data = image_.size();
    const std::size_t bytes = count * bytes_of_one(variable.values);
    if (texts.empty()) {
      std::visit([&](const auto& all) { image_.append(reinterpret_cast<const char*>(all.data()), bytes); },
                 variable.values);
    } else {
      image_ += texts;
    }
    align(image_);
    ObjectHeader header = dataset(type_of(variable.values), shape, data, bytes);
    if (is_scale(variable)) {
      scale(header, variable.dimensions.front().name, own_name(variable.name));
    } else if (!shape.empty()) {
      std::string lists;
      for (const ResultDimension& one : variable.dimensions) lists += references_.add(dimensions_.at(one.name).number);
      header.attribute("DIMENSION_LIST", type_of_lists_of_references(), space_of({shape.size()}), lists);
    }
    if (!variable.units.empty()) header.text("units", variable.units);
    header.text("long_name", variable.long_name);
    for (const ResultAttribute& one : variable.attributes) header.attribute(one);
    // A name that a dimension of its group has, which it does not say the places of, NetCDF writes so.
    const bool is_other = !is_scale(variable) && dimensions_.count(variable.name) > 0;
    add(group_of(variable.name), (is_other ? "_nc4_non_coord_" : "") + own_name(variable.name), header);
  }

  static ObjectHeader dataset(std::string type, const std::vector<std::size_t>& shape, Address data,
                              std::size_t bytes) {
    ObjectHeader header;
    header.add(0x01, space_of(shape));
    header.add(0x03, std::move(type));
    header.add(0x05, packed(U8{2}, U8{2}, U8{2}, U8{1}, U32{0}));  // filled by default, which nothing is left to be
    header.add(0x08, packed(U8{3}, U8{1}, data, U64{bytes}));
    return header;
  }

  void scale(ObjectHeader& header, const std::string& dimension, const std::string& name) {
    const int number = dimensions_.at(dimension).number;
    header.attribute("CLASS", type_of_text(16), space_of({}), std::string("DIMENSION_SCALE\0", 16));
    header.attribute("NAME", type_of_text(name.size() + 1), space_of({}), name + '\0');
    header.attribute("_Netcdf4Dimid", type_of_integer(4, true), space_of({}), packed(number));
    scales_[static_cast<std::size_t>(number)] = image_.size();
  }

  /// Of a dimension whose places no variable names.
  void scale_alone(const std::string& name, const Dimension& dimension) {
    ObjectHeader header = dataset(type_of_double(), {dimension.size}, nowhere, 8 * dimension.size);
    scale(header, name, fmt::format("This is a netCDF dimension but not a netCDF variable.{:10}", dimension.size));
    add(group_of(name), own_name(name), header);
  }

  void add(const std::string& group, const std::string& name, const ObjectHeader& header) {
    if (!groups_[group].try_emplace(name, image_.size()).second) {
      throw std::invalid_argument(name + ": there are two of this name");
    }
    image_ += header.bytes();
  }

  void groups() {
    std::size_t most = 0;
    groups_.try_emplace("");
    for (const auto& [name, objects] : groups_) most = std::max(most, objects.size() + 1);
    const std::size_t half_of_leaves = (most / names_in_leaf + 2) / 2;
    for (auto& [name, objects] : groups_) {
      if (!name.empty()) groups_[""].emplace(name, write_group(image_, objects, 2 * half_of_leaves).header);
    }
    const GroupPlace root = write_group(image_, groups_[""], 2 * half_of_leaves);
    ObjectHeader header;
    header.add(0x11, packed(root.tree, root.heap));
    for (const ResultAttribute& one : file_.attributes) header.attribute(one);
    const Address at = image_.size();
    image_ += header.bytes();
    const std::string superblock =
        "\x89HDF\r\n\x1a\n" + packed(U32{0}, U8{0}, U8{8}, U8{8}, U8{0}, static_cast<U16>(names_in_leaf / 2)) +
        packed(static_cast<U16>(half_of_leaves), U32{0}, Address{0}, nowhere, Address{image_.size()}, nowhere) +
        packed(U64{0}, at, U32{1}, U32{0}, root.tree, root.heap);
    image_.replace(0, superblock_bytes, superblock);
  }

  const ResultFile& file_;
  References references_;
  Texts texts_;
  std::string image_;
  std::map<std::string, Dimension> dimensions_;
  std::vector<Address> scales_;  ///< of each dimension
  std::map<std::string, std::map<std::string, Address>> groups_;
};

}  // namespace

std::string netcdf_image(const ResultFile& file) { return Image(file).bytes(); }

}  // namespace bentur
