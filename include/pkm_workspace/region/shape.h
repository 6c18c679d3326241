// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "pkm_workspace/dexterity/box_kernel.h"
#include "pkm_workspace/interval/affine_vector.h"
#include "pkm_workspace/interval/box.h"
#include "pkm_workspace/interval/growing.h"

namespace pkm_workspace
{
class OwnProof;

/// A circle across the axis z.
struct Circle
{
  IntervalVector center;  ///< [m]
  Interval radius;        ///< [m]
};

/// A family of convex bodies K(h) = K0 + h K1 = { k0 + h k1 : k0 in K0, k1 in K1 }: regions are c + K(h) for a center c
/// [m] and a size h > 0 (paper, sections 2.4 and 2.5, with K0 = {0}). K0 and K1 are convex and hold the origin, be it
/// on their surface: so regions are nested in their size, and each holds its center. The search knows bodies by this
/// interface only. Immutable, so shared freely between threads.
class Shape
{
public:
  virtual ~Shape() = default;

  /// "cube", "square", "cylinder of radius 0.25 m", ...: begins with a word for what its regions are
  virtual std::string name() const = 0;
  /// This word.
  std::string kind() const;
  /// What one unit of size is, for people: "edge [m]", "factor on the proportions".
  virtual std::string sizeMeaning() const = 0;
  /// The least and the largest coordinates of K(h).
  virtual GrowingVector lower() const = 0;
  virtual GrowingVector upper() const = 0;
  /// Half of what K(h) measures along the axes; 0 where it has no thickness.
  GrowingVector halfExtents() const { return 0.5 * (upper() - lower()); }
  /// Whether K0 = {0}: then regions of size 0 are points.
  bool isScaling() const { return halfExtents().fixed == Eigen::Vector3d::Zero(); }
  /// Points of the family, exactly in K0 and K1, at which a region that is too large sticks out first. K(h) is the
  /// convex hull of their places where it has neither extremeCircles() nor a ballRadius().
  virtual std::vector<GrowingVector> extremePoints() const = 0;
  /// A point of the family, exactly in K0 and K1, whose place at this size is near the offset, if there is one.
  /// The default is for K0 = {0}.
  virtual std::optional<GrowingVector> placeOf(const Eigen::Vector3d& offset, double size) const;
  /// Whether c + K(h) is all of its bounding box, so that it needs no half-spaces there.
  virtual bool isBox() const { return false; }
  /// Whether it is none of the solids that dimensions() tell, but a hull of points that grow with its size.
  bool isPolytope() const { return dimensions(1.0).empty(); }
  /// Whether K(h) holds with a point all that lie straight above and below it within its bounding box.
  virtual bool isPrism() const { return isBox(); }
  /// The smallest box of doubles that contains c + K(h), as far as lower() and upper() are exact.
  Box boundingBox(const Eigen::Vector3d& center, double size) const;
  /// Circles that hold all extreme points of c + K(h), where these are neither vertices nor a sphere.
  virtual std::vector<Circle> extremeCircles(const Eigen::Vector3d& center, double size) const;
  /// Encloses the radius of c + K(h) where that is a ball about c [m].
  virtual std::optional<Interval> ballRadius(double size) const;
  /// A half-space that contains c + K(h) and cuts off as much of a part of its bounding box as it can; all points where
  /// it is that box.
  virtual HalfSpace halfSpace(const Box& part, const Eigen::Vector3d& center, double size) const = 0;
  /// Whether no point of the box lies in c + K(h); false when that is not proved.
  virtual bool misses(const Box& box, const Eigen::Vector3d& center, double size) const = 0;
  /// Whether the point is proved to lie in c + K(h) for every c in the box of centers.
  virtual bool contains(const Eigen::Vector3d& point, const Box& centers, double size) const = 0;
  /// A function of the center, affine over the box of centers, that is not negative for any center whose region avoids
  /// the point; nothing when no such function is at hand.
  virtual std::optional<AffineForm<double>> avoidance(const Eigen::Vector3d& point, const Box& centers,
                                                      double size) const = 0;
  /// Encloses the largest n . k over the points k of K(h), for every n of the enclosure.
  virtual Growing<Interval> support(const IntervalVector& n) const = 0;
  /// The outward normal, of length 1, of the side of c + K(h) through which a point within leaves it soonest; along
  /// axes without thickness there is no leaving. Floating point, as the next two.
  virtual Eigen::Vector3d exit(const Eigen::Vector3d& point, const Eigen::Vector3d& center, double size) const = 0;
  /// The largest n . k over the points k of K(h).
  virtual Growing<double> support(const Eigen::Vector3d& n) const = 0;
  /// The nearest point of c + K(h).
  virtual Eigen::Vector3d nearest(const Eigen::Vector3d& point, const Eigen::Vector3d& center, double size) const = 0;
  /// As shape_msgs/SolidPrimitive has it, rounded inward: full sides of a box [m] (square: [a, a, 0]);
  /// none of a polytope.
  virtual std::vector<double> dimensions(double size) const = 0;
  /// Encloses the volume of K(h) [m^3]; 0 for flat shapes.
  virtual Interval volume(double size) const = 0;
  /// The family of the same bodies, each moved along z until the middle of its lowest face is the center of its region;
  /// nothing where they have none.
  virtual std::shared_ptr<const Shape> standing() const { return nullptr; }
  /// Of bodies that are not convex; nullptr where they are.
  virtual const OwnProof* ownProof() const { return nullptr; }
};

/// A point near the given one that is proved to lie in c + K(h), if there is such a double.
std::optional<Eigen::Vector3d> nearestInside(const Shape& shape, const Eigen::Vector3d& point,
                                             const Eigen::Vector3d& center, double size);

using ShapePtr = std::shared_ptr<const Shape>;

/// Size: edge length [m].
ShapePtr makeCube();
/// Parallel to the plane xy, no thickness in z. Size: edge length [m].
ShapePtr makeSquare();
/// A box with full sides size * proportions [m]. @param proportions >= 0, at least one of them > 0, finite
/// @throws std::invalid_argument otherwise
ShapePtr makeBox(const Eigen::Vector3d& proportions);

/// Size: radius [m].
ShapePtr makeSphere();
/// Parallel to the plane xy, no thickness in z. Size: radius [m].
ShapePtr makeDisc();
/// Its axis is parallel to z. Size: height [m]. @param ratio radius over height, > 0
/// @throws std::invalid_argument for another ratio
ShapePtr makeCylinder(double ratio);
/// The same of given measures [m]: size is a factor on both. @throws std::invalid_argument unless both are positive
ShapePtr makeCylinder(double radius, double height);

/// The names of the shapes that a name, and proportions for a box, are enough for: all but the cylinder.
std::vector<std::string> shapeNames();
/// The shape of that name. @param proportions what the shape measures along the axes; a box needs them
/// @throws std::invalid_argument for an unknown name, for proportions that are missing or of another shape
ShapePtr makeShape(const std::string& name, const std::optional<Eigen::Vector3d>& proportions = std::nullopt);
}  // namespace pkm_workspace
