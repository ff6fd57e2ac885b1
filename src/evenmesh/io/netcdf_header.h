// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "evenmesh/io/input_file.h"
#include "evenmesh/io/number_type.h"

namespace evenmesh {

/// An array of a netCDF file.
struct NetcdfVariable {
  std::string name = {};
  std::optional<NumberType> type = {};    // none: letters
  std::vector<std::uint64_t> shape = {};  // the last index runs fastest
  std::uint64_t begin = 0;                // byte
  bool is_record = false;                 // has a slice for each time step, not in one stretch
  std::string element_type = {};          // its attribute elem_type

  std::uint64_t size() const;  // in numbers; at most 2^64 - 1
};

/// What a netCDF file of a classic format (CDF-1, CDF-2, CDF-5) has in it and where. Numbers are
/// big-endian. Source: "The NetCDF Classic Format Specification", Unidata.
struct NetcdfHeader {
  struct Dimension {
    std::string name = {};
    std::uint64_t length = 0;  // 0: that of time steps
  };
  std::uint64_t steps = 0;  // of time
  std::vector<Dimension> dimensions = {};
  std::vector<NetcdfVariable> variables = {};

  /// nullptr if there is none.
  const NetcdfVariable* find(std::string_view name) const;
  /// 0 if there is none.
  std::uint64_t length(std::string_view name) const;
};

/// Whether a file begins like one of netCDF's classic formats.
bool is_netcdf(std::string_view begin);

/// @throws IoError  with the byte: cut off or broken, an array ends behind the end of the file or
///                  shares bytes with another
NetcdfHeader read_netcdf_header(const InputFile& input);

}  // namespace evenmesh
