#include "renderer/math/random.hpp"
#include "renderer/render/sums.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

using namespace rt;

TEST_CASE("fixed sum: what doubles lose is kept, in whatever order it comes") {
  FixedSum sum;
  sum.add(1e15);
  for (int i = 0; i < 1024; ++i) sum.add(0x1p-10);
  sum.add(-1e15);
  CHECK(sum.value() == 1);
  std::vector<double> numbers;
  SplitMix64 random(3);
  for (int i = 0; i < 1000; ++i) numbers.push_back(std::exp2(random.between(-60, 40)));
  FixedSum forwards, backwards;
  for (const double x : numbers) forwards.add(x);
  std::reverse(numbers.begin(), numbers.end());
  for (const double x : numbers) backwards.add(x);
  CHECK(forwards == backwards);
}

TEST_CASE("fixed sum: parts add up to the whole") {
  FixedSum whole, left, right;
  for (int i = 1; i <= 100; ++i) {
    whole.add(1.0 / i);
    (i % 3 == 0 ? left : right).add(1.0 / i);
  }
  left.add(right);
  CHECK(left == whole);
  CHECK(whole.value() == Approx(5.187377517639621).epsilon(1e-15)); // the 100th harmonic number
  CHECK(FixedSum::from(whole.upper(), whole.lower()) == whole);
}

TEST_CASE("fixed sum: it rounds to multiples of 2^-64") {
  FixedSum sum;
  sum.add(0x1p-64);
  CHECK(sum.lower() == 1);
  sum.add(0x1.8p-65); // three quarters of one
  CHECK(sum.lower() == 2);
  sum.add(0x1p-66);
  CHECK(sum.lower() == 2);
  sum.add(1 - 0x1p-53);
  CHECK(sum.upper() == 0);
  sum.add(0.5);
  CHECK(sum.upper() == 1);
}

TEST_CASE("fixed sum: beyond 2^62 it stays there") {
  FixedSum sum;
  sum.add(1e300);
  CHECK(sum.value() == 0x1p62);
  sum.add(1e18);
  CHECK(sum.value() == 0x1p62);
}

TEST_CASE("pixel sums: samples go to two halves in turn, and half of their difference is the error") {
  PixelSums sums;
  CHECK(sums.mean() == black);
  sums.add(0, grey(1));
  CHECK(std::isinf(sums.error().r));
  sums.add(1, grey(2));
  sums.add(2, grey(3));
  sums.add(3, grey(4));
  CHECK(sums.samples() == 4);
  CHECK(sums.mean() == grey(2.5));
  CHECK(sums.mean(0) == grey(2));
  CHECK(sums.mean(1) == grey(3));
  CHECK(sums.error() == grey(0.5));
  PixelSums twice = sums;
  twice.add(sums);
  CHECK(twice.samples() == 8);
  CHECK(twice.mean() == sums.mean());
}
