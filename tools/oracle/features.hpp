#pragma once

#include "renderer/scene/scene.hpp"

#include <cstdint>
#include <map>
#include <string>
#include <vector>

/// Which features of the language scenes use, read off their descriptions: not what a generator intended, but what it
/// produced.
namespace rt::tools::oracle {

/// The names of all features, in a fixed order. Every property of every description type is one (if it does not have
/// its default value), so that a new one is noticed.
std::vector<std::string> feature_names();

/// The indices of the features of a scene, each once, ascending.
std::vector<std::size_t> features_of(const scene::Scene& scene);

/// How often each feature and each pair of features occurred.
class Coverage {
public:
  Coverage();
  void add(const std::vector<std::size_t>& features);
  void add(const Coverage& other);

  std::uint64_t count(std::size_t feature) const { return pairs_[feature * names_.size() + feature]; }
  std::uint64_t count(std::size_t a, std::size_t b) const { return pairs_[a * names_.size() + b]; }
  /// Of those that must occur in this kind of run: `without` are prefixes of names that need not.
  std::vector<std::string> missing(const std::vector<std::string>& without = {}) const;
  /// A line for each feature with its count, and how the pairs occurred; with `all_pairs` also a line for each of them.
  std::string report(bool all_pairs) const;

private:
  std::vector<std::string> names_;
  std::vector<std::uint64_t> pairs_;
};

} // namespace rt::tools::oracle
