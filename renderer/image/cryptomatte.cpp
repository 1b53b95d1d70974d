#include "renderer/image/cryptomatte.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <charconv>
#include <cstring>
#include <stdexcept>

namespace rt::image {
namespace {

std::uint32_t scrambled(std::uint32_t word) {
  return std::rotl(word * 0xcc9e2d51u, 15) * 0x1b873593u;
}

std::uint32_t hexadecimal(std::string_view digits) {
  std::uint32_t number = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number, 16);
  if (error != std::errc() || end != digits.data() + digits.size())
    throw std::runtime_error("its Cryptomatte manifest is malformed");
  return number;
}

std::string json_string(std::string_view text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\')
      (out += '\\') += c;
    else if (static_cast<unsigned char>(c) < 0x20)
      out += fmt::format("\\u{:04x}", static_cast<int>(c));
    else
      out += c;
  }
  return out + '"';
}

/// Reads what `json_string` wrote and advances past it.
std::string read_json_string(std::string_view& text) {
  std::string out;
  for (text.remove_prefix(1); !text.empty() && text[0] != '"'; text.remove_prefix(1)) {
    if (text[0] != '\\' || text.size() < 2) {
      out += text[0];
      continue;
    }
    text.remove_prefix(1);
    if (text[0] != 'u' || text.size() < 5) {
      out += text[0];
      continue;
    }
    out += static_cast<char>(hexadecimal(text.substr(1, 4)));
    text.remove_prefix(4);
  }
  text.remove_prefix(std::min<std::size_t>(1, text.size()));
  return out;
}

constexpr std::string_view key_start = "cryptomatte/", manifest_end = "/manifest";

} // namespace

std::uint32_t murmur_hash(std::string_view text) {
  std::uint32_t hash = 0;
  const std::size_t whole = text.size() / 4 * 4;
  for (std::size_t i = 0; i < whole; i += 4) {
    const auto byte = [&](std::size_t k) { return std::uint32_t{static_cast<unsigned char>(text[i + k])} << 8 * k; };
    hash = std::rotl(hash ^ scrambled(byte(0) | byte(1) | byte(2) | byte(3)), 13) * 5 + 0xe6546b64u;
  }
  std::uint32_t tail = 0;
  for (std::size_t i = text.size(); i > whole; --i) tail = tail << 8 | static_cast<unsigned char>(text[i - 1]);
  hash ^= scrambled(tail) ^ static_cast<std::uint32_t>(text.size());
  hash = (hash ^ hash >> 16) * 0x85ebca6bu;
  hash = (hash ^ hash >> 13) * 0xc2b2ae35u;
  return hash ^ hash >> 16;
}

std::uint32_t matte_id(std::string_view name) {
  constexpr std::uint32_t exponent_bits = 0x7f800000;
  const std::uint32_t hash = murmur_hash(name);
  const std::uint32_t exponent = std::clamp<std::uint32_t>(hash >> 23 & 255, 1, 254);
  return (hash & ~exponent_bits) | exponent << 23;
}

std::vector<std::pair<std::string, std::string>> matte_metadata(std::string_view layer,
                                                                const std::map<std::string, std::uint32_t>& ids) {
  std::string manifest;
  for (const auto& [name, id] : ids)
    manifest += fmt::format("{}{}:\"{:08x}\"", manifest.empty() ? "{" : ",", json_string(name), id);
  manifest += manifest.empty() ? "{}" : "}";
  const std::string prefix = fmt::format("cryptomatte/{}/", fmt::format("{:08x}", murmur_hash(layer)).substr(0, 7));
  return {{prefix + "name", std::string(layer)},
          {prefix + "hash", "MurmurHash3_32"},
          {prefix + "conversion", "uint32_to_float32"},
          {prefix + "manifest", manifest}};
}

bool is_matte_key(std::string_view key) {
  return key.starts_with(key_start);
}

std::map<std::uint32_t, std::string> matte_names(const std::map<std::string, std::string>& metadata) {
  std::map<std::uint32_t, std::string> names;
  for (const auto& [key, manifest] : metadata) {
    if (!is_matte_key(key) || !key.ends_with(manifest_end)) continue;
    for (std::string_view rest = manifest; rest.size() > 2;) { // {"name":"id","name":"id"}
      rest.remove_prefix(1);
      std::string name = read_json_string(rest);
      rest.remove_prefix(std::min<std::size_t>(1, rest.size()));
      names[hexadecimal(read_json_string(rest))] = std::move(name);
    }
  }
  return names;
}

} // namespace rt::image
