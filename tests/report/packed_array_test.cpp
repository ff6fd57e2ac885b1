// SPDX-License-Identifier: MIT
#include "evenmesh/report/packed_array.h"

#include <limits>

#include <gtest/gtest.h>

#include "tests/report/inflated.h"

namespace evenmesh {
namespace {

using Numbers = std::vector<std::int64_t>;

Numbers there_and_back(const Numbers& values, std::size_t components, Rule rule) {
  const PackedArray packed = pack(values, components, rule);
  EXPECT_EQ(packed.count, values.size());
  EXPECT_EQ(packed.rule, rule);
  return testing::unpacked(packed.bytes, packed.count, packed.components, packed.planes,
                           std::string(name(rule)));
}

TEST(PackedArray, ComesBackAsItWas) {
  const Numbers small{0, 1, 2, 255, 3, 7};
  EXPECT_EQ(there_and_back(small, 1, Rule::as_is), small);
  const Numbers mixed{0, -1, 5, -7, 1000, -65536, 3, 2, 1};
  for (const std::size_t components : {1, 3}) {
    EXPECT_EQ(there_and_back(mixed, components, Rule::zigzag), mixed);
    EXPECT_EQ(there_and_back(mixed, components, Rule::delta), mixed);
  }
  const Numbers cells{0, 1, 2, 2, 1, 3, 0, 4, 3};
  EXPECT_EQ(there_and_back(cells, 1, Rule::highwater), cells);
}

TEST(PackedArray, HoldsNothing) {
  for (const Rule rule : {Rule::as_is, Rule::zigzag, Rule::delta, Rule::highwater}) {
    EXPECT_EQ(there_and_back({}, 1, rule), Numbers{});
  }
}

TEST(PackedArray, HoldsTheGreatestAndTheLeast) {
  const Numbers ends{std::numeric_limits<std::int32_t>::min(),
                     std::numeric_limits<std::int32_t>::max(), 0, -1};
  EXPECT_EQ(there_and_back(ends, 1, Rule::zigzag), ends);
  const Numbers unsigned_end{std::numeric_limits<std::uint32_t>::max(), 0};
  EXPECT_EQ(there_and_back(unsigned_end, 1, Rule::as_is), unsigned_end);
}

TEST(PackedArray, TakesNoMorePlanesThanNeeded) {
  EXPECT_EQ(pack(Numbers{255}, 1, Rule::as_is).planes, 1);
  EXPECT_EQ(pack(Numbers{256}, 1, Rule::as_is).planes, 2);
  EXPECT_EQ(pack(Numbers{127, -128}, 1, Rule::zigzag).planes, 1);
  EXPECT_EQ(pack(Numbers{-32769}, 1, Rule::zigzag).planes, 3);
  EXPECT_EQ(pack(Numbers{1 << 24}, 1, Rule::as_is).planes, 4);
}

TEST(PackedArray, OfManyNumbersComesBackToo) {
  Numbers values;
  for (int i = 0; i < 300'000; ++i) values.push_back((i * 7919LL) % 100'003 - 50'000);
  EXPECT_EQ(there_and_back(values, 3, Rule::delta), values);
  EXPECT_EQ(there_and_back(values, 1, Rule::zigzag), values);
}

TEST(PackedArray, WithSignsTakesTheShorterRule) {
  Numbers slope(1000);
  for (std::size_t i = 0; i < slope.size(); ++i) slope[i] = static_cast<std::int64_t>(1000 * i);
  EXPECT_EQ(pack_signed(slope, 1).rule, Rule::delta);
  Numbers noise(1000);
  for (std::size_t i = 0; i < noise.size(); ++i) noise[i] = i * i * 7919 % 101 < 50 ? -60 : 60;
  EXPECT_EQ(pack_signed(noise, 1).rule, Rule::zigzag);
}

}  // namespace
}  // namespace evenmesh
