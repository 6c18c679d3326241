// SPDX-License-Identifier: BSD-3-Clause
#include "document.h"

#include <algorithm>

#include "document_checks.h"
#include "pkm_workspace/common/utf8.h"
#include "refusal.h"

namespace pkm_workspace
{
namespace urdf_io
{
namespace
{
constexpr int DEEPEST_ELEMENT = 50;
constexpr int MOST_ELEMENTS = 1000;    // links, and joints
constexpr int MOST_ATTRIBUTES = 1000;  // of one element

/// Writes elements and attributes out again, so that urdfdom cannot read anything else than we did, and looks after
/// their depth: its parser recurses.
class ElementPrinter : public tinyxml2::XMLPrinter
{
public:
  explicit ElementPrinter(Problems& problems) : problems_(problems) {}

  using XMLPrinter::Visit;
  using XMLPrinter::VisitEnter;
  using XMLPrinter::VisitExit;
  bool VisitEnter(const XMLElement& element, const tinyxml2::XMLAttribute* first) override
  {
    ++depth_;
    if (depth_ == DEEPEST_ELEMENT + 1)
      complain(problems_, "line ", element.GetLineNum(), ": elements are nested deeper than ", DEEPEST_ELEMENT);
    XMLPrinter::VisitEnter(element, first);
    return depth_ <= DEEPEST_ELEMENT;
  }
  bool VisitExit(const XMLElement& element) override
  {
    --depth_;
    return XMLPrinter::VisitExit(element);
  }
  bool Visit(const tinyxml2::XMLText&) override { return true; }
  bool Visit(const tinyxml2::XMLComment&) override { return true; }
  bool Visit(const tinyxml2::XMLUnknown&) override { return true; }
  bool Visit(const tinyxml2::XMLDeclaration&) override { return true; }

private:
  Problems& problems_;
  int depth_ = 0;
};

/// urdfdom's parser never returns from some texts that are not UTF-8.
void checkCharacters(const std::string& text, Problems& problems)
{
  if (const auto byte = unprintableByte(text))
    complain(problems, "an element or attribute holds a character that is not printable UTF-8 (byte ", *byte, ")");
}

/// The largest number of attributes that an element of the text can have: both parsers are quadratic in it.
int mostAttributes(const std::string& xml)
{
  int most = 0;
  int quotes = 0;
  for (const char c : xml)
  {
    quotes = c == '<' ? 0 : quotes + (c == '"' || c == '\'' ? 1 : 0);
    most = std::max(most, quotes / 2);
  }
  return most;
}

void checkText(const std::string& xml, Problems& problems)
{
  if (xml.size() > LARGEST_TEXT)
    complain(problems, "the text is longer than the ", LARGEST_TEXT, " bytes that are read");
  if (xml.find('\0') != std::string::npos)
    complain(problems, "the text holds a zero byte: it is no XML");
  if (mostAttributes(xml) > MOST_ATTRIBUTES)
    complain(problems, "an element has ", mostAttributes(xml), " attributes, at most ", MOST_ATTRIBUTES, " are read");
  throwRefusal(problems);
}

void parse(const std::string& xml, tinyxml2::XMLDocument& xml_document, Problems& problems)
{
  xml_document.Parse(xml.data(), xml.size());
  if (xml_document.ErrorID() == tinyxml2::XML_ELEMENT_DEPTH_EXCEEDED)
    complain(problems, "line ", xml_document.ErrorLineNum(), ": elements are nested deeper than ", DEEPEST_ELEMENT);
  else if (xml_document.Error())
    complain(problems, "the text is not well-formed XML: ", xml_document.ErrorStr());
  throwRefusal(problems);
}

/// The first element of xacro, or null.
const XMLElement* firstOfXacro(const XMLElement& element)
{
  if (std::string(element.Name()).rfind("xacro:", 0) == 0)
    return &element;
  for (auto* child = element.FirstChildElement(); child != nullptr; child = child->NextSiblingElement())
    if (const XMLElement* const found = firstOfXacro(*child))
      return found;
  return nullptr;
}

/// xacro leaves its namespace in what it writes, but none of its elements.
void checkXacro(const tinyxml2::XMLDocument& xml_document, Problems& problems)
{
  const XMLElement* const root = xml_document.RootElement();
  if (const XMLElement* const found = root == nullptr ? nullptr : firstOfXacro(*root))
    complain(problems, "line ", found->GetLineNum(), ": <", found->Name(),
             "> is xacro, from which a URDF is still to be made: run 'xacro FILE > machine.urdf' and give its",
             " output");
  throwRefusal(problems);
}

/// The only element <robot>.
const XMLElement& onlyRobot(const tinyxml2::XMLDocument& xml_document, Problems& problems)
{
  const XMLElement* const root = xml_document.RootElement();
  if (root == nullptr || root->Name() != std::string("robot"))
    complain(problems, "the outermost element is <", (root == nullptr ? "" : root->Name()), ">, expected <robot>");
  throwRefusal(problems);
  for (auto* next = root->NextSiblingElement(); next != nullptr; next = next->NextSiblingElement())
    complain(problems, "line ", next->GetLineNum(), ": a second outermost element <", next->Name(),
             ">, expected one <robot>");
  for (const auto* const inner : childrenOf(*root, "robot"))
    complain(problems, "line ", inner->GetLineNum(), ": a second <robot> inside the first, expected one");
  for (const char* const kind : { "link", "joint" })
  {
    const auto count = childrenOf(*root, kind).size();
    if (count > MOST_ELEMENTS)
      complain(problems, "the robot has ", count, " elements <", kind, ">, at most ", MOST_ELEMENTS, " are read");
  }
  throwRefusal(problems);
  return *root;
}

Origin originOf(const XMLElement& joint)
{
  const auto* const element = joint.FirstChildElement("origin");
  const Eigen::Vector3d xyz = vectorOf(element, "xyz").value_or(Eigen::Vector3d::Zero());
  const Eigen::Vector3d rpy = vectorOf(element, "rpy").value_or(Eigen::Vector3d::Zero());
  return { xyz, { rpy[0], rpy[1], rpy[2] } };
}
}  // namespace

Document readDocument(const std::string& xml, Problems& problems)
{
  Document document;
  tinyxml2::XMLDocument xml_document;
  checkText(xml, problems);
  parse(xml, xml_document, problems);
  checkXacro(xml_document, problems);
  const XMLElement& robot = onlyRobot(xml_document, problems);

  ElementPrinter printer(problems);
  robot.Accept(&printer);
  document.elements = printer.CStr();
  checkCharacters(document.elements, problems);
  checkStructure(robot, problems);
  throwRefusal(problems);
  document.tolerances = toleranceElements(robot, problems);
  checkJoints(robot, problems, document.warnings);
  for (const auto* const joint : childrenOf(robot, "joint"))
  {
    document.joints.push_back(nameOf(*joint));
    document.origins[nameOf(*joint)] = originOf(*joint);
  }
  return document;
}
}  // namespace urdf_io
}  // namespace pkm_workspace
