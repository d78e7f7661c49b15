#pragma once

#include <string>

#include "formula/tokens.hpp"

namespace oddity::formula {

/// Prints a letter's name: \dot\theta, m_{12}, y_1', \ddot{\mathbf r}.
class NameWriter {
 public:
  virtual ~NameWriter() = default;
  std::string of(const std::string& name);
  /// Prints the indices and primes behind a base that is already printed: _{12}''.
  std::string behind(const std::string& base, const std::string& scripts);

 protected:
  /// `font` is \mathbf or the like, or empty.
  virtual std::string atom(const std::string& token, const std::string& font) = 0;
  virtual std::string accented(const std::string& base, const std::string& accent) = 0;
  virtual std::string with_scripts(const std::string& base, const std::string& below, std::size_t primes) = 0;
  virtual std::string group(const std::string& inside) { return inside; }

 private:
  std::string all();
  std::string scripts(std::string base);
  std::string one(const std::string& font);

  Tokens tokens_;
  std::size_t at_ = 0;
};

}  // namespace oddity::formula
