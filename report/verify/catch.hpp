#pragma once

#include <functional>
#include <string>

/// Catch2, version 2 or 3. Only this file knows the difference.
#if __has_include(<catch2/catch_all.hpp>)

#include <catch2/catch_all.hpp>
#include <catch2/internal/catch_test_case_registry_impl.hpp>

namespace oddity {

inline const std::string& name_of(const Catch::TestCaseHandle& test) { return test.getTestCaseInfo().name; }

inline void use_colour(Catch::ConfigData& data, bool colour) {
  data.defaultColourMode = colour ? Catch::ColourMode::ANSI : Catch::ColourMode::None;
}

/// Redirects each of Catch2's output files to the path that `elsewhere` returns for it.
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

/// A test case in the form that the registry takes.
template <class Invoker>
auto owned(const Invoker& invoker) {
  return Catch::Detail::make_unique<Invoker>(invoker);
}

/// Base of a streaming reporter, with its stream as out().
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

/// A test case created at run time.
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
