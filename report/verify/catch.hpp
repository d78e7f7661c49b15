#pragma once

#include <functional>
#include <string>

/// Catch2, version 2 or 3: the one place that knows the difference.
#if __has_include(<catch2/catch_all.hpp>)

#include <catch2/catch_all.hpp>
#include <catch2/internal/catch_test_case_registry_impl.hpp>

namespace oddity {

inline const std::string& name_of(const Catch::TestCaseHandle& test) { return test.getTestCaseInfo().name; }

inline void use_colour(Catch::ConfigData& data, bool colour) {
  data.defaultColourMode = colour ? Catch::ColourMode::ANSI : Catch::ColourMode::None;
}

/// Every file that Catch2 is to write goes where `elsewhere` says instead.
template <class F>
void redirect_outputs(Catch::ConfigData& data, const F& elsewhere) {
  const auto is_file = [](const std::string& name) {
    return !name.empty() && name != "-" && name.front() != '%';
  };
  if (is_file(data.defaultOutputFilename)) data.defaultOutputFilename = elsewhere(data.defaultOutputFilename);
  for (Catch::ReporterSpec& spec : data.reporterSpecifications)
    if (spec.outputFile() && is_file(*spec.outputFile()))
      spec = Catch::ReporterSpec(spec.name(), elsewhere(*spec.outputFile()), spec.colourMode(),
                                 spec.customOptions());
}

/// A test case as the registry takes it.
template <class Invoker>
auto owned(const Invoker& invoker) {
  return Catch::Detail::make_unique<Invoker>(invoker);
}

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

inline void use_colour(Catch::ConfigData& data, bool colour) {
  data.useColour = colour ? Catch::UseColour::Yes : Catch::UseColour::No;
}

template <class F>
void redirect_outputs(Catch::ConfigData& data, const F& elsewhere) {
  if (!data.outputFilename.empty() && data.outputFilename.front() != '%')
    data.outputFilename = elsewhere(data.outputFilename);
}

template <class Invoker>
Invoker* owned(const Invoker& invoker) {
  return new Invoker(invoker);
}

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

namespace oddity {

/// A test case made while the program runs, as many as there are.
class TestOf : public Catch::ITestInvoker {
 public:
  explicit TestOf(std::function<void()> body) : body_(std::move(body)) {}
  void invoke() const override { body_(); }

 private:
  std::function<void()> body_;
};

inline void register_test(std::function<void()> body, const std::string& name, const std::string& tags) {
  Catch::AutoReg(owned(TestOf(std::move(body))), CATCH_INTERNAL_LINEINFO, Catch::StringRef(),
                 Catch::NameAndTags{name, tags});
}

}  // namespace oddity
