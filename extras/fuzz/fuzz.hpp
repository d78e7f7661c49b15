#pragma once

#include <unistd.h>

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

#include "reference/bad_input.hpp"

/// Shared code of the targets. A reader accepts its input or refuses it by BadInput; anything else is a
/// finding.
namespace fuzz {

template <class Read>
void refused_or_read(const Read& read) {
  try {
    read();
  } catch (const oddity::BadInput&) {
  }
}

/// Aborts if a property that must hold for every input does not.
inline void require(bool holds) {
  if (!holds) std::abort();
}

/// A file of this process, in memory if there is such a folder.
inline std::filesystem::path file(const std::string& name, std::string_view text) {
  static const std::filesystem::path folder = [] {
    const std::filesystem::path memory = "/dev/shm";
    const std::filesystem::path own = (exists(memory) ? memory : std::filesystem::temp_directory_path()) /
                                      ("oddity_fuzz_" + std::to_string(getpid()));
    create_directories(own);
    std::atexit([] { std::filesystem::remove_all("/dev/shm/oddity_fuzz_" + std::to_string(getpid())); });
    return own;
  }();
  create_directories((folder / name).parent_path());
  std::ofstream(folder / name, std::ios::binary) << text;
  return folder / name;
}

/// Defined by each target.
void read(std::string_view input);

}  // namespace fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using Clock = std::chrono::steady_clock;
  const auto read = [&] {
    fuzz::refused_or_read([&] { fuzz::read({reinterpret_cast<const char*>(data), size}); });
  };
  const Clock::time_point start = Clock::now();
  read();
  if (Clock::now() - start < std::chrono::seconds(1)) return 0;
  // Measures CPU time as well, which a busy machine does not stretch. Reading it takes longer than most
  // inputs.
  const std::clock_t own = std::clock();
  read();
  fuzz::require(std::clock() - own < CLOCKS_PER_SEC);
  return 0;
}
