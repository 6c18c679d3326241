// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace pkm_workspace
{
namespace gcode
{
/// The codes that exclude each other in a line.
enum class Group
{
  MOTION,
  PLANE,
  DISTANCE,
  ARC_DISTANCE,
  FEED_MODE,
  UNITS,
  TOOL_LENGTH,
  SYSTEM,
  ONCE,  ///< holds in its own line only
  NOTHING,
  COUNT
};
constexpr int NO_CODE = -1;

/// What an M code does to the path.
enum class Effect
{
  NOTHING,
  SPEED,  ///< M220, which changes all feeds
  LOSES,  ///< leaves the tool at a place that the job does not say
  END     ///< of the job
};

/// One line of G-code as the words that it is made of. Texts live as long as the line does.
/// Codes are ten times their number: 590 for G59, 901 for G90.1.
class Block
{
public:
  /// @throws std::invalid_argument with the reason where the line is not in the subset
  explicit Block(const std::string& line);

  /// The code of a group; NO_CODE where the line has none.
  int code(Group group) const { return codes_[static_cast<std::size_t>(group)]; }
  bool has(char letter) const { return !values_[letter - 'A'].empty(); }
  bool hasAny(const char* letters) const;
  /// Takes the number that follows a letter, as text.
  std::string_view take(char letter);
  /// @throws std::invalid_argument naming a word that was not taken
  void requireAllTaken() const;

  const std::vector<int>& otherCodes() const { return others_; }
  const std::vector<int>& machineCodes() const { return m_codes_; }
  /// What the M codes of the line do, the strongest of them.
  Effect effect() const { return effect_; }

private:
  void addG(std::string_view number);
  /// @return whether the rest of the line belongs to it
  bool addM(std::string_view number);
  void add(char letter, std::string_view number);

  std::array<std::string_view, 26> values_{};
  std::uint32_t taken_ = 0;  ///< one bit for each letter
  std::array<int, static_cast<std::size_t>(Group::COUNT)> codes_;
  std::vector<int> others_;  ///< G codes without effect on the path
  std::vector<int> m_codes_;
  Effect effect_ = Effect::NOTHING;
  bool has_words_ = false;  ///< besides N and M
};

/// "G59.1" of 591.
std::string nameOf(char letter, int code);
}  // namespace gcode
}  // namespace pkm_workspace
