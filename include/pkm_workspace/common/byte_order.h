// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <string>

namespace pkm_workspace
{
/// Puts numbers into bytes, the least significant first on any processor.
class ByteWriter
{
public:
  const std::string& bytes() const { return bytes_; }

  template <class Integer>
  void number(Integer value)
  {
    for (std::size_t k = 0; k < sizeof(Integer); ++k)
      bytes_ += static_cast<char>(static_cast<std::uint64_t>(value) >> (8 * k) & 0xff);
  }
  void real(double value)
  {
    std::uint64_t bits;
    std::memcpy(&bits, &value, sizeof(bits));
    number(bits);
  }
  void text(const std::string& value)
  {
    number(static_cast<std::uint32_t>(value.size()));
    bytes_ += value;
  }
  void raw(const void* data, std::size_t size) { bytes_.append(static_cast<const char*>(data), size); }

private:
  std::string bytes_;
};

/// Takes them out again. Nothing is reserved that the bytes do not hold. @throws std::runtime_error at the end
class ByteReader
{
public:
  /// @param end takes the bytes before that place
  ByteReader(const std::string& bytes, std::size_t end) : bytes_(bytes), end_(end) {}

  std::size_t left() const { return end_ - place_; }

  template <class Integer>
  Integer number()
  {
    const char* const data = raw(sizeof(Integer));
    std::uint64_t value = 0;
    for (std::size_t k = 0; k < sizeof(Integer); ++k)
      value |= std::uint64_t(static_cast<unsigned char>(data[k])) << (8 * k);
    return static_cast<Integer>(value);
  }
  double real()
  {
    const auto bits = number<std::uint64_t>();
    double value;
    std::memcpy(&value, &bits, sizeof(value));
    return value;
  }
  std::string text()
  {
    const auto size = number<std::uint32_t>();
    return { raw(size), size };
  }
  const char* raw(std::size_t size)
  {
    if (size > left())
      throw std::runtime_error("it ends too early");
    place_ += size;
    return bytes_.data() + place_ - size;
  }

private:
  const std::string& bytes_;
  std::size_t end_;
  std::size_t place_ = 0;
};
}  // namespace pkm_workspace
