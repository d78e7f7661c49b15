#pragma once

#include <string>

/// Catch2, version 2 or 3: the one place that knows the difference.
#if __has_include(<catch2/catch_all.hpp>)

#include <catch2/catch_all.hpp>
#include <catch2/internal/catch_test_case_registry_impl.hpp>

namespace oddity {

inline const std::string& name_of(const Catch::TestCaseHandle& test) { return test.getTestCaseInfo().name; }

inline void use_no_colour(Catch::ConfigData& data) { data.defaultColourMode = Catch::ColourMode::None; }

/// A streaming reporter's base, with its stream as out().
class MarkdownReporterBase : public Catch::StreamingReporterBase {
 public:
  using StreamingReporterBase::StreamingReporterBase;

 protected:
  std::ostream& out() { return m_stream; }
};

}  // namespace oddity

#else

#define CATCH_CONFIG_EXTERNAL_INTERFACES
#include <catch2/catch.hpp>

namespace oddity {

inline const std::string& name_of(const Catch::TestCase& test) { return test.name; }

inline void use_no_colour(Catch::ConfigData& data) { data.useColour = Catch::UseColour::No; }

class MarkdownReporterBase : public Catch::StreamingReporterBase<MarkdownReporterBase> {
 public:
  using StreamingReporterBase::StreamingReporterBase;
  static std::string getDescription() { return {}; }
  void assertionStarting(const Catch::AssertionInfo&) override {}
  bool assertionEnded(const Catch::AssertionStats&) override { return true; }

 protected:
  std::ostream& out() { return stream; }
};

}  // namespace oddity

#endif
