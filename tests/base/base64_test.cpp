// SPDX-License-Identifier: MIT
#include "evenmesh/base/base64.h"

#include <gtest/gtest.h>

namespace evenmesh {
namespace {

TEST(Base64, MatchesTheVectorsOfRfc4648) {
  const std::pair<const char*, const char*> known[] = {{"", ""},
                                                       {"f", "Zg=="},
                                                       {"fo", "Zm8="},
                                                       {"foo", "Zm9v"},
                                                       {"foob", "Zm9vYg=="},
                                                       {"fooba", "Zm9vYmE="},
                                                       {"foobar", "Zm9vYmFy"}};
  for (const auto& [bytes, letters] : known) {
    EXPECT_EQ(to_base64(bytes), letters);
    EXPECT_EQ(to_base64(bytes).size(), base64_size(std::string_view(bytes).size()));
  }
}

TEST(Base64, KnowsBytesOfAllKinds) {
  EXPECT_EQ(to_base64(std::string_view("\0\xff\xfe", 3)), "AP/+");
}

}  // namespace
}  // namespace evenmesh
