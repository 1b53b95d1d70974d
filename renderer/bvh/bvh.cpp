#include "renderer/bvh/bvh.hpp"

#include "renderer/bvh/bvh_embree.hpp"
#include "renderer/bvh/bvh_portable.hpp"

#include <utility>

namespace rt::bvh {

const Builder default_builder = Builder::RTLANG_BVH;

Device::Device(int threads, Builder builder)
    : embree_(builder == Builder::embree ? std::make_unique<EmbreeDevice>(threads) : nullptr) {}
Device::~Device() = default;

Tree::Tree() = default;
Tree::~Tree() = default;
Tree::Tree(Tree&&) noexcept = default;
Tree& Tree::operator=(Tree&&) noexcept = default;

Tree::Tree(const Device& device, const Box3& bounds) {
  if (device.embree_)
    embree_ = std::make_unique<EmbreeTree>(*device.embree_, bounds);
  else
    portable_ = std::make_unique<PortableTree>(bounds);
}

void Tree::build() {
  if (embree_)
    embree_->build(std::exchange(sets_, {}));
  else
    portable_->build(std::exchange(sets_, {}));
}

void Tree::nearest(Query& query) const {
  if (embree_) return embree_->nearest(query);
  portable_->nearest(query);
}

bool Tree::blocks(Query& query) const {
  return embree_ ? embree_->blocks(query) : portable_->blocks(query);
}

void Tree::nearest(std::span<Query* const> queries) const {
  if (embree_) return embree_->nearest(queries);
  for (Query* const query : queries) portable_->nearest(*query);
}

std::array<bool, packet_size> Tree::blocks(std::span<Query* const> queries) const {
  if (embree_) return embree_->blocks(queries);
  std::array<bool, packet_size> answers{};
  for (std::size_t i = 0; i < queries.size(); ++i) answers[i] = portable_->blocks(*queries[i]);
  return answers;
}

} // namespace rt::bvh
