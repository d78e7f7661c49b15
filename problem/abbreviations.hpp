#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <vector>

#include "problem/file.hpp"

namespace oddity::problem {

/// The letters of a model, and the formulas of its abbreviations; its vectors are abbreviations of their
/// components.
class Abbreviations {
 public:
  Abbreviations(const File&, const ModelText&);

  const Letters& letters() const { return letters_; }
  /// The formula of an abbreviation, by its index. Throws WrongFile.
  const Formula& operator[](std::size_t i);
  /// The shape of a formula in these letters. Throws WrongFile if it has none.
  Shape shape(const Formula&);

  /// Refuses abbreviations that contain themselves, by the depth of nesting.
  class Inside {
   public:
    Inside(Abbreviations& all, const Formula& where) : depth_(all.depth_) {
      if (++depth_ > 20) where.fail({}, "an abbreviation of itself");
    }
    Inside(const Inside&) = delete;
    Inside& operator=(const Inside&) = delete;
    ~Inside() { --depth_; }

   private:
    int& depth_;
  };

 private:
  const Source& source_;
  Named texts_;
  Letters letters_;
  std::vector<std::optional<Formula>> formulas_;
  std::map<std::size_t, Shape> shapes_;
  int depth_ = 0;
};

}  // namespace oddity::problem
