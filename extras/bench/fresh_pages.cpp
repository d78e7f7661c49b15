#include "extras/bench/fresh_pages.hpp"

#include <link.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cstdint>
#include <cstring>
#include <string_view>

namespace oddity {

namespace {

void move(std::uintptr_t begin, std::size_t bytes) {
  void* fresh = mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (fresh == MAP_FAILED) return;
  void* code = reinterpret_cast<void*>(begin);
  std::memcpy(fresh, code, bytes);
  if (mprotect(fresh, bytes, PROT_READ | PROT_EXEC) != 0 ||
      mremap(fresh, bytes, bytes, MREMAP_MAYMOVE | MREMAP_FIXED, code) == MAP_FAILED)
    munmap(fresh, bytes);
}

int move_object(dl_phdr_info* object, std::size_t, void*) {
  const std::string_view name = object->dlpi_name;  // empty for the program itself
  if (!name.empty() && name.find("/liboddity_") == name.npos) return 0;
  const std::uintptr_t page = static_cast<std::uintptr_t>(sysconf(_SC_PAGESIZE));
  for (int i = 0; i < object->dlpi_phnum; ++i) {
    const auto& part = object->dlpi_phdr[i];
    if (part.p_type != PT_LOAD || !(part.p_flags & PF_X)) continue;
    const std::uintptr_t begin = object->dlpi_addr + part.p_vaddr, end = begin + part.p_memsz;
    const std::uintptr_t first = begin / page * page;
    move(first, (end - first + page - 1) / page * page);
  }
  return 0;
}

}  // namespace

void move_code_to_fresh_pages() { dl_iterate_phdr(move_object, nullptr); }

}  // namespace oddity
