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

namespace pkm_workspace
{
/// A circle across the axis z.
struct Circle
{
  IntervalVector center;  ///< [m]
  Interval radius;        ///< [m]
};

/// A convex body K that contains the origin (paper, sections 2.4 and 2.5): regions are c + h K for a center c [m] and a
/// size h > 0. The search knows bodies by this interface only. Immutable, so shared freely between threads.
class Shape
{
public:
  virtual ~Shape() = default;

  /// "cube", "square", "box", ...
  virtual std::string name() const = 0;
  /// What one unit of size is, for people: "edge [m]", "factor on the proportions".
  virtual std::string sizeMeaning() const = 0;
  /// K lies within these distances of the origin along the axes; 0 where it has no thickness.
  virtual Eigen::Vector3d halfExtents() const = 0;
  /// Points of K, exactly in K, at which a region that is too large sticks out first. K is their convex hull where it
  /// has neither extremeCircles() nor a ballRadius().
  virtual std::vector<Eigen::Vector3d> extremePoints() const = 0;
  /// Whether K is all of { x : |x_j| <= halfExtents_j }, so that c + h K needs no half-spaces within its bounding box.
  virtual bool isBox() const { return false; }
  /// Whether K holds with a point all that lie straight above and below it within halfExtents_z.
  virtual bool isPrism() const { return isBox(); }
  /// The smallest box of doubles that contains c + h K, whose half extents are doubles.
  Box boundingBox(const Eigen::Vector3d& center, double size) const;
  /// Circles that hold all extreme points of c + h K, where these are neither vertices nor a sphere.
  virtual std::vector<Circle> extremeCircles(const Eigen::Vector3d& center, double size) const;
  /// Encloses the radius of h K where it is a ball [m].
  virtual std::optional<Interval> ballRadius(double size) const;
  /// A half-space that contains c + h K and cuts off as much of a part of its bounding box as it can; all points where
  /// K is that box.
  virtual HalfSpace halfSpace(const Box& part, const Eigen::Vector3d& center, double size) const = 0;
  /// Whether no point of the box lies in c + h K; false when that is not proved.
  virtual bool misses(const Box& box, const Eigen::Vector3d& center, double size) const = 0;
  /// Whether the point is proved to lie in c + h K for every c in the box of centers.
  virtual bool contains(const Eigen::Vector3d& point, const Box& centers, double size) const = 0;
  /// A function of the center, affine over the box of centers, that is not negative for any center whose region avoids
  /// the point; nothing when no such function is at hand.
  virtual std::optional<AffineForm<double>> avoidance(const Eigen::Vector3d& point, const Box& centers,
                                                      double size) const = 0;
  /// Encloses the largest n . k over the points k of K, for every n of the enclosure.
  virtual Interval support(const IntervalVector& n) const = 0;
  /// The outward normal, of length 1, of the side of c + h K through which a point within leaves it soonest; along axes
  /// without thickness there is no leaving. Floating point, as the next two.
  virtual Eigen::Vector3d exit(const Eigen::Vector3d& point, const Eigen::Vector3d& center, double size) const = 0;
  /// The largest n . k over the points k of K.
  virtual double support(const Eigen::Vector3d& n) const = 0;
  /// The nearest point of c + h K.
  virtual Eigen::Vector3d nearest(const Eigen::Vector3d& point, const Eigen::Vector3d& center, double size) const = 0;
  /// As shape_msgs/SolidPrimitive has it, rounded inward: full sides of a box [m] (square: [a, a, 0]).
  virtual std::vector<double> dimensions(double size) const = 0;
  /// Encloses the volume of h K [m^3]; 0 for flat shapes.
  virtual Interval volume(double size) const = 0;
};

/// A point near the given one that is proved to lie in c + h K, if there is such a double.
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
