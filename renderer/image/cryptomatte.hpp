#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

/// Mattes for compositing: which object a pixel shows, by the hash of its name, with the names in the file's metadata
/// (Friedman and Jones, Cryptomatte Specification 1.2: psyop/cryptomatte).
namespace rt::image {

/// MurmurHash3_x86_32 with seed 0 (Appleby, public domain).
std::uint32_t murmur_hash(std::string_view text);

/// The bits of the float that represents a name: its hash, made a finite, normal number.
std::uint32_t matte_id(std::string_view name);

/// Keys and values of a layer's metadata; `ids` are the matte ids of the names that occur.
std::vector<std::pair<std::string, std::string>> matte_metadata(std::string_view layer,
                                                                const std::map<std::string, std::uint32_t>& ids);

/// Whether the key belongs to such metadata.
bool is_matte_key(std::string_view key);
/// The names in the metadata's manifest, by matte id. Throws std::runtime_error if it is malformed.
std::map<std::uint32_t, std::string> matte_names(const std::map<std::string, std::string>& metadata);

} // namespace rt::image
