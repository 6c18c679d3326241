// SPDX-License-Identifier: BSD-3-Clause
// Collision geometry of the links that do not move, held against points that are carried through the joints by hand.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <fstream>
#include <iterator>

#include "pkm_workspace/dexterity/zone_forms.h"
#include "pkm_workspace/interval/decimal.h"
#include "pkm_workspace/urdf_io/urdf_reader.h"
#include "support/random.h"

namespace pkm_workspace
{
namespace test
{
namespace
{
using Eigen::Vector3d;

/// The numbers of an <origin>.
struct Place
{
  Vector3d xyz;
  Vector3d rpy;

  Vector3d operator*(const Vector3d& p) const
  {
    const auto about = [](double angle, const Vector3d& axis) { return Eigen::AngleAxisd(angle, axis); };
    return xyz + about(rpy.z(), Vector3d::UnitZ()) *
                     (about(rpy.y(), Vector3d::UnitY()) * (about(rpy.x(), Vector3d::UnitX()) * p));
  }
  std::string text() const
  {
    const auto three = [](const Vector3d& v) { return exact(v.x()) + " " + exact(v.y()) + " " + exact(v.z()); };
    return "<origin xyz=\"" + three(xyz) + "\" rpy=\"" + three(rpy) + "\"/>";
  }
};

Place randomPlace(Random& random)
{
  const auto three = [&](double most) {
    return Vector3d(random.uniform(-most, most), random.uniform(-most, most), random.uniform(-most, most));
  };
  return { three(2.0), three(3.0) };
}

std::string collision(const Place& place, const std::string& geometry)
{
  return "<collision>" + place.text() + "<geometry>" + geometry + "</geometry></collision>";
}

std::string fixedTo(const std::string& parent, const std::string& child, const Place& place)
{
  return "<joint name=\"to_" + child + "\" type=\"fixed\"><parent link=\"" + parent + "\"/><child link=\"" + child +
         "\"/>" + place.text() + "</joint>";
}

/// The Orthoglide with these elements more.
UrdfMachine orthoglideWith(const std::string& elements)
{
  std::ifstream file(PKM_WORKSPACE_SOURCE_DIR "/urdf/orthoglide.urdf");
  std::string urdf{ std::istreambuf_iterator<char>(file), {} };
  urdf.insert(urdf.rfind("</robot>"), elements);
  return readUrdf(urdf);
}

/// A point of the body's surface, or within it by a share.
Vector3d pointOf(const Zone& zone, Random& random, double share)
{
  const auto sign = [&] { return random.uniform(-1.0, 1.0); };
  Vector3d u(sign(), sign(), sign());
  if (zone.kind == ZoneKind::BOX)
  {
    u[random.integer(0, 2)] = random.sign();
    return share * 0.5 * u.cwiseProduct(Vector3d(0.1, 0.2, 0.4));
  }
  if (zone.kind == ZoneKind::SPHERE)
    return share * 0.3 * u.normalized();
  u.z() = 0.0;
  u = 0.05 * u.normalized();
  u.z() = 0.5 * 0.7 * sign();
  return share * u;
}
}  // namespace

TEST(StillCollisions, holdTheirBodiesWhereTheJointsPutThem)
{
  Random random(SEED);
  const std::string bodies[] = { "<box size=\"0.1 0.2 0.4\"/>", "<cylinder radius=\"0.05\" length=\"0.7\"/>",
                                 "<sphere radius=\"0.3\"/>" };
  for (int k = 0; k < cases(30); ++k)
    for (const std::string& body : bodies)
    {
      SCOPED_TRACE("case " + std::to_string(k) + ", seed " + std::to_string(SEED));
      const Place frame = randomPlace(random), column = randomPlace(random), own = randomPlace(random);
      const UrdfMachine urdf =
          orthoglideWith("<link name=\"frame\"/><link name=\"column\">" + collision(own, body) + "</link>" +
                         fixedTo("base_link", "frame", frame) + fixedTo("frame", "column", column));
      ASSERT_EQ(urdf.still_collisions.size(), 1U);
      const Zone& zone = urdf.still_collisions[0];
      EXPECT_EQ(zone.name, "column");
      EXPECT_EQ(zone.use, Zone::Use::KEEP_OUT);
      const EnclosedZone enclosed_zone = enclosed(zone, 0.0);
      for (int sample = 0; sample < 20; ++sample)
      {
        const auto at = [&](double share) {
          return clearance(enclosed_zone, enclose(frame * (column * (own * pointOf(zone, random, share)))));
        };
        EXPECT_LT(at(1.0).upper(), 0.0) << "a point of the surface is out";
        EXPECT_GT(at(1.0).lower(), -1e-10) << "the zone is much larger than the body";
        EXPECT_LT(at(0.99).upper(), 0.0);
        EXPECT_GT(at(1.01).lower(), 0.0);
      }
    }
}

/// What urdfdom leaves out is not left out in silence.
TEST(StillCollisions, areReadAllOrNamed)
{
  const Place here{ Vector3d::Zero(), Vector3d::Zero() };
  const std::string box = collision(here, "<box size=\"0.1 0.1 0.1\"/>");
  const std::vector<std::string> all = {
    collision(here, "<capsule radius=\"0.1\" length=\"1\"/>") + box,
    collision(here, "") + box,
    collision(here, "<sphere radius=\"nan\"/>"),
    collision(here, "<sphere radius=\"0,05\"/>") + box,
    "<visual><geometry><blob/></geometry></visual>" + box,
    collision(here, "<box size=\"0.1 0.1 0.1\"/><sphere radius=\"0.1\"/>"),
    collision(here, "<sphere radius=\"0.1\"/></geometry><geometry><sphere radius=\"0.2\"/>"),
  };
  for (const std::string& wrong : all)
  {
    SCOPED_TRACE(wrong);
    Problems problems;
    try
    {
      const UrdfMachine urdf =
          orthoglideWith("<link name=\"tank\">" + wrong + "</link>" + fixedTo("base_link", "tank", here));
      std::vector<Zone> zones;
      addCollisions(urdf.still_collisions, urdf.open_collisions, "asked", zones, problems);
      validateZones(zones, 0.0, problems);
    }
    catch (const std::invalid_argument& reason)
    {
      problems.push_back(reason.what());
    }
    EXPECT_FALSE(problems.empty());
  }
}

/// The way there and back again rounds more than the place is away.
TEST(StillCollisions, growByTheWayToThem)
{
  const Place out{ { 1e6, 0.0, 0.0 }, { 0.0, 0.0, 0.3 } };
  const Vector3d back = -(Eigen::AngleAxisd(-0.3, Vector3d::UnitZ()) * out.xyz);
  const UrdfMachine urdf = orthoglideWith(
      "<link name=\"far\"/><link name=\"near\">" + collision({ back, Vector3d::Zero() }, "<sphere radius=\"0.1\"/>") +
      "</link>" + fixedTo("base_link", "far", out) + fixedTo("far", "near", { Vector3d::Zero(), Vector3d::Zero() }));
  ASSERT_EQ(urdf.still_collisions.size(), 1U);
  EXPECT_GT(urdf.still_collisions[0].radius - 0.1, 1.9e-6);
}

TEST(StillCollisions, areOfNoLinkThatMovesAndNoMesh)
{
  const Place here{ Vector3d::Zero(), Vector3d::Zero() };
  const UrdfMachine urdf = orthoglideWith("<link name=\"probe\">" + collision(here, "<sphere radius=\"0.1\"/>") +
                                          "</link>" + fixedTo("slider_1", "probe", here) + "<link name=\"tank\">" +
                                          collision(here, "<mesh filename=\"package://shop/tank.stl\"/>") + "</link>" +
                                          fixedTo("base_link", "tank", here));
  EXPECT_TRUE(urdf.still_collisions.empty());
  ASSERT_EQ(urdf.open_collisions.size(), 1U);
  EXPECT_NE(urdf.open_collisions[0].find("link 'tank' has a mesh"), std::string::npos);
}
}  // namespace test
}  // namespace pkm_workspace
