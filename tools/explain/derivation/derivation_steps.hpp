#pragma once

#include "renderer/compile/geometries.hpp"
#include "tools/explain/derivation/derivation.hpp"

#include <optional>

/// What the derivations of the shapes share. Each shape has an overload of `derive_shape`.
namespace rt::tools::explain {

/// Writes down a derivation.
class Steps {
public:
  Steps(Derivation& derivation, const Hit& found, bool is_operand)
      : derivation_(derivation), found_(found), is_operand_(is_operand) {}

  const Ray& ray() const { return derivation_.ray; }
  const Hit& found() const { return found_; }

  void equation(std::string text) { derivation_.equation = std::move(text); }
  /// Adds a quantity to the line that is being written.
  Steps& put(std::string_view key, std::string_view label, double value);
  Steps& put(std::string_view key, std::string_view label, const Vec3& value);
  /// Ends the line with a conclusion, which may be empty.
  void so(std::string words = {});

  /// A place where the ray could meet the shape.
  struct Candidate {
    double t;
    std::string name; ///< "t₁" or "the top end"
    bool counts;      ///< it passes the shape's own tests
  };
  /// Says which of them the tracer took and why the others were not; ends the derivation.
  void choose(std::vector<Candidate> candidates);

  /// The roots of a·t² + b·t + c = 0 from their coefficients: the discriminant, and the roots if there are any. One
  /// that is negative by rounding alone counts as 0: the tracer has found the ray to touch.
  struct Roots {
    int count = 0;
    double first = 0, second = 0;
  };
  Roots solve(double a, double b, double c, std::string_view surface);

private:
  Derivation& derivation_;
  const Hit& found_;
  bool is_operand_; // of a combination
  DerivationLine line_;
};

void derive_shape(Steps& steps, const SphereGeometry& sphere);
void derive_shape(Steps& steps, const PlaneGeometry& plane);
void derive_shape(Steps& steps, const CylinderGeometry& cylinder);
void derive_shape(Steps& steps, const ConeGeometry& cone);
void derive_shape(Steps& steps, const BoxGeometry& box);
void derive_shape(Steps& steps, const DiscGeometry& disc);
void derive_shape(Steps& steps, const TriangleGeometry& triangle);
void derive_shape(Steps& steps, const QuadGeometry& quad);
void derive_shape(Steps& steps, const PolygonGeometry& polygon);

} // namespace rt::tools::explain
