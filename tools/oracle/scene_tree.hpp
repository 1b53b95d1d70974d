#pragma once

#include "renderer/math/vec3.hpp"

#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

/// A scene file as a tree of parts that can be removed one by one.
namespace rt::tools::oracle {

struct Block;

/// `name: text`, or `name: block`.
struct Prop {
  std::string name;
  std::string text;
  std::vector<Block> block; ///< none or one
};

/// `head { props things }.chain`; with `operation` the things as operands, `(a - b) { props }.chain`; without a head
/// the file.
struct Block {
  std::string head;
  std::vector<Prop> props;
  std::vector<Block> things;
  std::vector<std::string> chain;
  std::string operation;
  bool is_definition = false; ///< `name = …`, `def name() …`: may be needed by others, places nothing

  Block& set(std::string name, std::string text) {
    props.push_back({std::move(name), std::move(text), {}});
    return *this;
  }
  Block& set(std::string name, Block block) {
    props.push_back({std::move(name), {}, {std::move(block)}});
    return *this;
  }
};

std::string print(const Block& file);

/// Numbers and vectors as written, with five digits.
std::string text(double value);
std::string text(const Vec3& v);

/// All files that have one part less, larger parts first.
std::vector<Block> smaller(const Block& file);

/// The smallest file found by removing parts of `file` for which `fails` still returns true; calls it at most `tries`
/// times.
Block minimise(Block file, const std::function<bool(const Block&)>& fails, int tries);

} // namespace rt::tools::oracle
