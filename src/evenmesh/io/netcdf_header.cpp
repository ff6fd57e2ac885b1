// SPDX-License-Identifier: MIT
#include "evenmesh/io/netcdf_header.h"

#include <algorithm>
#include <bit>
#include <limits>
#include <utility>

#include "evenmesh/base/text.h"
#include "evenmesh/io/byte_scanner.h"

namespace evenmesh {
namespace {

static_assert(std::endian::native == std::endian::little, "numbers of netCDF are swapped");

constexpr std::size_t kPadding = 4;

std::uint64_t padded(std::uint64_t bytes) { return (bytes + kPadding - 1) / kPadding * kPadding; }

class Reader {
 public:
  explicit Reader(const InputFile& input)
      : input_(input), scanner_(input, 3, true), version_(scanner_.take<std::uint8_t>()) {}

  NetcdfHeader read() {
    header_.steps = take_count();
    for (std::uint64_t i = list(kDimensions, "dimensions"); i > 0; --i) {
      std::string name = take_name();
      header_.dimensions.push_back({std::move(name), take_count()});
    }
    skip_attributes(nullptr);
    for (std::uint64_t i = list(kVariables, "variables"); i > 0; --i) read_variable();
    check_apart();
    return std::move(header_);
  }

 private:
  static constexpr std::uint32_t kDimensions = 10;
  static constexpr std::uint32_t kVariables = 11;
  static constexpr std::uint32_t kAttributes = 12;
  static constexpr std::uint32_t kLetters = 2;

  std::uint64_t take_count() {
    constexpr std::uint8_t kWide = 5;
    return version_ == kWide ? scanner_.take<std::uint64_t>() : scanner_.take<std::uint32_t>();
  }

  std::uint64_t take_begin() {
    return version_ == 1 ? scanner_.take<std::uint32_t>() : scanner_.take<std::uint64_t>();
  }

  /// How many things a list has.
  std::uint64_t list(std::uint32_t tag, std::string_view things) {
    const std::uint64_t place = scanner_.offset();
    const auto found = scanner_.take<std::uint32_t>();
    const std::uint64_t count = take_count();
    if (found != tag && (found != 0 || count != 0)) {
      scanner_.fail(place,
                    fmt::format("no list of {}; the file is broken, export it again", things));
    }
    constexpr std::size_t kLeast = 8;  // bytes of a name and of what it is the name of
    scanner_.check_room(count, kLeast, things);
    return count;
  }

  std::string take_name() {
    const std::uint64_t length = take_count();
    const std::uint64_t place = scanner_.offset();
    scanner_.check_room(length, 1, "letters of a name");
    scanner_.skip(padded(length));
    return std::string(input_.bytes().substr(place, length));
  }

  /// Bytes of a value; 0 for a type that there is not.
  static std::size_t bytes_of(std::uint32_t type) {
    if (type == kLetters) return 1;
    const auto number = number_type(type);
    return number ? size_of(*number) : 0;
  }

  static std::optional<NumberType> number_type(std::uint32_t type) {
    switch (type) {
      case 1:
        return NumberType::int8;
      case 3:
        return NumberType::int16;
      case 4:
        return NumberType::int32;
      case 5:
        return NumberType::float32;
      case 6:
        return NumberType::float64;
      case 7:
        return NumberType::uint8;
      case 8:
        return NumberType::uint16;
      case 9:
        return NumberType::uint32;
      case 10:
        return NumberType::int64;
      case 11:
        return NumberType::uint64;
      default:
        return std::nullopt;
    }
  }

  std::uint32_t take_type() {
    const std::uint64_t place = scanner_.offset();
    const auto type = scanner_.take<std::uint32_t>();
    if (bytes_of(type) == 0) {
      scanner_.fail(
          place, fmt::format("{} is no type of value; the file is broken, export it again", type));
    }
    return type;
  }

  void skip_attributes(NetcdfVariable* variable) {
    for (std::uint64_t i = list(kAttributes, "attributes"); i > 0; --i) {
      const std::string name = take_name();
      const std::uint32_t type = take_type();
      const std::uint64_t count = take_count();
      const std::uint64_t place = scanner_.offset();
      scanner_.check_room(count, bytes_of(type), "values of an attribute");
      if (variable != nullptr && type == kLetters && name == "elem_type") {
        variable->element_type = input_.bytes().substr(place, count);
      }
      scanner_.skip(padded(count * bytes_of(type)));
    }
  }

  void read_variable() {
    NetcdfVariable variable;
    variable.name = take_name();
    const std::uint64_t rank = take_count();
    scanner_.check_room(rank, 4, "dimensions of a variable");
    for (std::uint64_t i = 0; i < rank; ++i) {
      const std::uint64_t place = scanner_.offset();
      const std::uint64_t dimension = take_count();
      if (dimension >= header_.dimensions.size()) {
        scanner_.fail(place, fmt::format("variable {} has dimension {} of {}", shown(variable.name),
                                         dimension, header_.dimensions.size()));
      }
      variable.shape.push_back(header_.dimensions[dimension].length);
    }
    variable.is_record = !variable.shape.empty() && variable.shape[0] == 0;
    skip_attributes(&variable);
    const std::uint32_t type = take_type();
    variable.type = number_type(type);
    take_count();  // its bytes, which follow from its shape
    const std::uint64_t place = scanner_.offset();
    variable.begin = take_begin();
    const std::uint64_t all = input_.bytes().size();
    if (!variable.is_record &&
        (variable.begin > all || variable.size() > (all - variable.begin) / bytes_of(type))) {
      scanner_.fail(place,
                    fmt::format("variable {} ends behind the end of the file; it was cut off, "
                                "copy or export it again",
                                shown(variable.name)));
    }
    if (!variable.is_record && variable.size() > 0) {
      stretches_.emplace_back(variable.begin, variable.begin + variable.size() * bytes_of(type));
    }
    header_.variables.push_back(std::move(variable));
  }

  void check_apart() {
    std::sort(stretches_.begin(), stretches_.end());
    std::uint64_t end = scanner_.offset();
    for (const auto& [first, last] : stretches_) {
      if (first < end) {
        scanner_.fail(first, "two variables share bytes; the file is broken, export it again");
      }
      end = last;
    }
  }

  const InputFile& input_;
  ByteScanner scanner_;
  std::vector<std::pair<std::uint64_t, std::uint64_t>> stretches_;  // of variables
  std::uint8_t version_;
  NetcdfHeader header_;
};

}  // namespace

std::uint64_t NetcdfVariable::size() const {
  constexpr std::uint64_t kMost = std::numeric_limits<std::uint64_t>::max();
  std::uint64_t product = 1;
  for (const std::uint64_t length : shape) {
    if (length != 0 && product > kMost / length) return kMost;
    product *= length;
  }
  return product;
}

const NetcdfVariable* NetcdfHeader::find(std::string_view name) const {
  const auto at = std::find_if(variables.begin(), variables.end(),
                               [name](const NetcdfVariable& v) { return v.name == name; });
  return at == variables.end() ? nullptr : &*at;
}

std::uint64_t NetcdfHeader::length(std::string_view name) const {
  const auto at = std::find_if(dimensions.begin(), dimensions.end(),
                               [name](const Dimension& d) { return d.name == name; });
  return at == dimensions.end() ? 0 : at->length;
}

bool is_netcdf(std::string_view begin) {
  if (!begin.starts_with("CDF") || begin.size() < 4) return false;
  return begin[3] == 1 || begin[3] == 2 || begin[3] == 5;
}

NetcdfHeader read_netcdf_header(const InputFile& input) { return Reader(input).read(); }

}  // namespace evenmesh
