#include "lang/load.hpp"
#include "renderer/compile/compiled_scene.hpp"
#include "renderer/render/render.hpp"
#include "tests/paths.hpp"

#include <catch2/catch.hpp>

#include <cstring>

using namespace rt;

namespace {

Film picture(const scene::Scene& scene, bvh::Builder builder) {
  RenderOptions options;
  options.threads = 1;
  options.layers = true;
  return render(CompiledScene(scene, 1, builder), {scene.camera, scene.size, 1}, options).film;
}

template <class T>
bool have_equal_bytes(const std::vector<T>& a, const std::vector<T>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0;
}

} // namespace

TEST_CASE("render: the same picture, byte for byte, whoever builds the tree") {
  for (const char* name :
       {"still_life", "nested_glass", "sphereflake", "dice", "forest", "temple", "own/stone_and_wood"}) {
    INFO(name);
    const lang::Loaded loaded =
        lang::load_file(std::string(RTLANG_SOURCE_DIR "/examples/") + name + ".rtl", lang::LoadOptions{});
    REQUIRE(loaded.scene);
    scene::Scene scene = *loaded.scene;
    scene.size = {48, 36};
    const Film a = picture(scene, bvh::Builder::embree), b = picture(scene, bvh::Builder::portable);
    CHECK(have_equal_bytes(a.color, b.color));
    CHECK(have_equal_bytes(a.depth, b.depth));
    CHECK(have_equal_bytes(a.normal, b.normal));
    CHECK(have_equal_bytes(a.object_id, b.object_id));
    CHECK(std::any_of(a.object_id.begin(), a.object_id.end(), [](std::uint32_t id) { return id > 0; }));
  }
}
