#include "renderer/math/static_vector.hpp"

#include <catch2/catch.hpp>

using rt::StaticVector;

namespace {

// It cannot be copied or moved: it must be made where it stays.
struct Fixed {
  int value;
  const Fixed* self;
  explicit Fixed(int v) : value(v), self(this) {}
  Fixed(const Fixed&) = delete;
  Fixed& operator=(const Fixed&) = delete;
};

} // namespace

TEST_CASE("static vector: values are made where they stay") {
  StaticVector<Fixed, 3> values;
  CHECK(values.size() == 0);
  CHECK(values.begin() == values.end());
  for (int i = 0; i < 3; ++i) CHECK(values.add([&] { return Fixed(i * 10); }).value == i * 10);
  REQUIRE(values.size() == 3);
  for (std::size_t i = 0; i < 3; ++i) {
    CHECK(values[i].value == static_cast<int>(i) * 10);
    CHECK(values[i].self == &values[i]);
  }
  int sum = 0;
  for (const Fixed& f : values) sum += f.value;
  CHECK(sum == 30);
}
