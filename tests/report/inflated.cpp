// SPDX-License-Identifier: MIT
#include "tests/report/inflated.h"

#include <array>
#include <bit>
#include <cmath>
#include <stdexcept>

#include <zlib.h>

namespace evenmesh::testing {
namespace {

constexpr std::string_view kLetters =
    "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

std::string bytes_of(std::string_view letters) {
  std::string bytes;
  std::uint32_t bits = 0;
  int count = 0;
  for (const char letter : letters) {
    if (letter == '=' || letter == '\n') continue;
    const std::size_t value = kLetters.find(letter);
    if (value == std::string_view::npos) throw std::runtime_error("not base64");
    bits = bits << 6U | static_cast<std::uint32_t>(value);
    count += 6;
    if (count < 8) continue;
    count -= 8;
    bytes += static_cast<char>(bits >> count & 0xFFU);
  }
  return bytes;
}

std::string letters_of(std::string_view bytes) {
  std::string text;
  for (std::size_t bit = 0; bit < 8 * bytes.size(); bit += 6) {
    std::size_t value = 0;
    for (std::size_t k = bit; k < bit + 6; ++k) {
      const auto byte = k / 8 < bytes.size() ? static_cast<unsigned char>(bytes[k / 8]) : 0U;
      value = 2 * value + (byte >> (7 - k % 8) & 1U);
    }
    text += kLetters[value];
  }
  while (text.size() % 4 != 0) text += '=';
  return text;
}

std::string between(const std::string& text, const std::string& from, const std::string& to) {
  const std::size_t start = text.find(from);
  if (start == std::string::npos) throw std::runtime_error("no " + from);
  const std::size_t end = text.find(to, start + from.size());
  if (end == std::string::npos) throw std::runtime_error("no " + to);
  return text.substr(start + from.size(), end - start - from.size());
}

}  // namespace

std::vector<std::int64_t> unpacked(std::string_view stream, std::size_t count,
                                   std::size_t components, int planes, const std::string& rule) {
  std::vector<unsigned char> raw(count * static_cast<std::size_t>(planes) + 1);
  uLongf size = raw.size();
  if (uncompress(raw.data(), &size, reinterpret_cast<const Bytef*>(stream.data()), stream.size()) !=
          Z_OK ||
      size + 1 != raw.size()) {
    throw std::runtime_error("not a zlib stream of that size");
  }
  std::vector<std::int64_t> values;
  std::int64_t high = 0;
  for (std::size_t i = 0; i < count; ++i) {
    std::int64_t u = 0;
    for (int p = 0; p < planes; ++p) {
      u += std::int64_t{raw[static_cast<std::size_t>(p) * count + i]} << (8 * p);
    }
    const std::int64_t with_sign = u % 2 == 0 ? u / 2 : -(u + 1) / 2;
    if (rule == "unsigned") {
      values.push_back(u);
    } else if (rule == "signed") {
      values.push_back(with_sign);
    } else if (rule == "delta") {
      values.push_back(with_sign + (i < components ? 0 : values[i - components]));
    } else if (rule == "highwater") {
      values.push_back(high - u);
      if (u == 0) ++high;
    } else {
      throw std::runtime_error("no rule " + rule);
    }
  }
  return values;
}

std::vector<std::int64_t> ReportFile::array(const std::string& name) const {
  const nlohmann::json& entry = json.at("arrays").at(name);
  return unpacked(std::string_view(data).substr(entry["offset"], entry["bytes"]), entry["count"],
                  entry["components"], entry["planes"], entry["rule"]);
}

ReportFile parse_report(const std::string& html) {
  ReportFile file;
  file.policy = between(html, "http-equiv=\"Content-Security-Policy\" content=\"", "\"");
  file.style = between(html, "<style>", "</style>");
  file.main = between(html, "<main id=\"evenmesh-static\">", "</main>");
  const std::string json =
      between(html, "<script type=\"application/json\" id=\"evenmesh-report\">", "</script>");
  file.json = nlohmann::json::parse(json);
  file.data = bytes_of(between(
      html, "<script type=\"application/octet-stream\" id=\"evenmesh-data\">", "</script>"));
  file.script = between(html, "<script>", "</script>");
  return file;
}

std::string sha256_base64(std::string_view text) {
  // The first 32 bits of the fractional parts of the cube roots of the first primes, and of square
  // roots.
  std::array<std::uint32_t, 64> k{};
  std::array<std::uint32_t, 8> h{};
  const auto fraction = [](long double x) {
    return static_cast<std::uint32_t>(std::floor((x - std::floor(x)) * 4294967296.0L));
  };
  for (unsigned n = 2, found = 0; found < 64; ++n) {
    bool prime = true;
    for (unsigned d = 2; d * d <= n; ++d) prime = prime && n % d != 0;
    if (!prime) continue;
    k[found] = fraction(std::cbrt(static_cast<long double>(n)));
    if (found < 8) h[found] = fraction(std::sqrt(static_cast<long double>(n)));
    ++found;
  }

  std::string message(text);
  message += '\x80';
  while (message.size() % 64 != 56) message += '\0';
  for (int shift = 56; shift >= 0; shift -= 8) {
    message += static_cast<char>(std::uint64_t{8 * text.size()} >> shift & 0xFFU);
  }
  for (std::size_t block = 0; block < message.size(); block += 64) {
    std::array<std::uint32_t, 64> w{};
    for (std::size_t i = 0; i < 64; ++i) {
      w[i / 4 % 16] = w[i / 4 % 16] << 8U | static_cast<unsigned char>(message[block + i]);
    }
    for (std::size_t i = 16; i < 64; ++i) {
      const std::uint32_t a = w[i - 15];
      const std::uint32_t b = w[i - 2];
      w[i] = w[i - 16] + (std::rotr(a, 7) ^ std::rotr(a, 18) ^ a >> 3U) + w[i - 7] +
             (std::rotr(b, 17) ^ std::rotr(b, 19) ^ b >> 10U);
    }
    auto s = h;
    for (std::size_t i = 0; i < 64; ++i) {
      const std::uint32_t one = s[7] +
                                (std::rotr(s[4], 6) ^ std::rotr(s[4], 11) ^ std::rotr(s[4], 25)) +
                                ((s[4] & s[5]) ^ (~s[4] & s[6])) + k[i] + w[i];
      const std::uint32_t two = (std::rotr(s[0], 2) ^ std::rotr(s[0], 13) ^ std::rotr(s[0], 22)) +
                                ((s[0] & s[1]) ^ (s[0] & s[2]) ^ (s[1] & s[2]));
      s = {one + two, s[0], s[1], s[2], s[3] + one, s[4], s[5], s[6]};
    }
    for (std::size_t i = 0; i < 8; ++i) h[i] += s[i];
  }
  std::string digest;
  for (const std::uint32_t word : h) {
    for (int shift = 24; shift >= 0; shift -= 8) digest += static_cast<char>(word >> shift & 0xFFU);
  }
  return letters_of(digest);
}

}  // namespace evenmesh::testing
