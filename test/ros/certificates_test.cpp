// SPDX-License-Identifier: BSD-3-Clause
#include <pkm_workspace/CheckPath.h>
#include <pkm_workspace/CheckRegion.h>
#include <pkm_workspace/CompareMachines.h>
#include <pkm_workspace/ComputeWorkspace.h>

#include <filesystem>

#include "node_client.h"
#include "pkm_workspace/certificate/verify.h"
#include "pkm_workspace/common/whole_file.h"

namespace pkm_workspace
{
namespace test
{
namespace
{
/// The node's folder for certificates, which certificates.test gives it. Empty at the beginning of each test.
class Certificates : public testing::Test
{
protected:
  Certificates()
  {
    EXPECT_TRUE(ros::param::get(NODE + "/certificate_folder", folder_));
    for (const auto& entry : std::filesystem::directory_iterator(folder_))
      std::filesystem::remove(entry);
  }

  /// The file that an answer names lies in the folder, and every step in it holds.
  template <class Message>
  std::string verified(const Message& answer) const
  {
    EXPECT_EQ(folder_ + "/" + name_, answer.certificate) << answer.certificate_message;
    const Verification found = verifyCertificate(readWholeFile(answer.certificate, LARGEST_LINES));
    EXPECT_EQ("", found.refused);
    return found.verified.empty() ? "" : found.verified.front();
  }

  bool isEmpty() const { return std::filesystem::is_empty(folder_); }

  std::string folder_;
  const std::string name_ = "proof-1.json";
};

CheckRegion::Request cubeOf(double edge)
{
  CheckRegion::Request request;
  request.solid.type = shape_msgs::SolidPrimitive::BOX;
  request.solid.dimensions = { edge, edge, edge };
  return request;
}

CheckPath::Request lineTo(double x)
{
  CheckPath::Request request;
  request.segments.resize(1);
  request.segments[0].kind = ToolSegment::LINE;
  request.segments[0].end.x = x;
  return request;
}
}  // namespace

TEST_F(Certificates, ofTheLargestRegion)
{
  RegionRequest query;
  query.shape = "cube";
  query.accuracy = 0.01;
  EXPECT_EQ("", compute(query).region.certificate);
  EXPECT_TRUE(isEmpty()) << "none was asked for";
  query.certificate = name_;
  const Region region = compute(query).region;
  verified(region);
  EXPECT_EQ("", region.certificate_message);
}

TEST_F(Certificates, ofTheSet)
{
  ComputeWorkspace::Request request;
  request.query.resolution = 0.2;
  request.query.certificate = name_;
  verified(call<ComputeWorkspace>("compute_workspace", request).workspace);
}

TEST_F(Certificates, ofVerdictsThatAreInside)
{
  CheckRegion::Request cube = cubeOf(0.2);
  cube.certificate = name_;
  verified(call<CheckRegion>("check_region", cube));
  CheckPath::Request path = lineTo(0.1);
  path.certificate = name_;
  path.tool_speed = 0.01;
  const auto answer = call<CheckPath>("check_path", path);
  verified(answer);
  EXPECT_NE(std::string::npos, answer.certificate_message.find("not about the speeds of the joints"));
}

TEST_F(Certificates, verdictsThatAreNotInsideHaveNoneAndAreNotLost)
{
  CheckRegion::Request cube = cubeOf(2.0);
  cube.certificate = name_;
  const auto region = call<CheckRegion>("check_region", cube);
  EXPECT_EQ(CheckRegion::Response::OUTSIDE, region.verdict);
  EXPECT_EQ("", region.certificate);
  EXPECT_NE(std::string::npos, region.certificate_message.find("is not INSIDE: there is nothing to certify")) << region;
  CheckPath::Request path = lineTo(2.0);
  path.certificate = name_;
  const auto answer = call<CheckPath>("check_path", path);
  EXPECT_EQ(CheckPath::Response::OUTSIDE, answer.verdict);
  EXPECT_EQ("", answer.certificate);
  EXPECT_TRUE(isEmpty());
}

TEST_F(Certificates, goToPlainNamesOnly)
{
  for (const std::string name : { "../proof.json", "/tmp/proof.json", ".proof", "a b", "a/b", "\xc3\xa4", ".." })
  {
    CheckRegion::Request request = cubeOf(0.2);
    request.certificate = name;
    const auto answer = call<CheckRegion>("check_region", request);
    EXPECT_EQ(ErrorCode::INVALID_REQUEST, answer.error_code) << name;
    EXPECT_NE(std::string::npos, answer.message.find("must be the plain name of a file")) << answer.message;
  }
  CheckRegion::Request request = cubeOf(0.2);
  std::filesystem::create_symlink("elsewhere", folder_ + "/link");
  request.certificate = "link";
  EXPECT_EQ(ErrorCode::INVALID_REQUEST, call<CheckRegion>("check_region", request).error_code);
  std::filesystem::remove(folder_ + "/link");
  request.certificate = std::string(101, 'a');
  EXPECT_EQ(ErrorCode::INVALID_REQUEST, call<CheckRegion>("check_region", request).error_code);
  EXPECT_TRUE(isEmpty());
}

TEST_F(Certificates, whatNoCheckerKnowsIsRefusedBefore)
{
  RegionRequest query;
  query.shape = "cube";
  query.certificate = name_;
  query.criterion.kappa_max = 3.0;
  const auto answer = compute(query);
  EXPECT_EQ(ErrorCode::INVALID_REQUEST, answer.error_code);
  EXPECT_NE(std::string::npos, answer.message.find("certificates do not know the condition number")) << answer.message;
  CompareMachines::Request comparison;
  comparison.query.certificate = name_;
  EXPECT_EQ(ErrorCode::INVALID_REQUEST, call<CompareMachines>("compare_machines", comparison).error_code);
}
}  // namespace test
}  // namespace pkm_workspace
