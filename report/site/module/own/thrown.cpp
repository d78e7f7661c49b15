// Exceptions, which the C++ library for WebAssembly lacks: instructions throw and catch them, and the
// compiler calls these functions in between. The names are those of the Itanium C++ ABI for exceptions, and
// of LLVM's tables.

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <typeinfo>

// Vtable of the type_info of types with one base.
extern "C" void* _ZTVN10__cxxabiv120__si_class_type_infoE[];

namespace {

/// Header of a thrown object, which follows it.
struct alignas(16) Thrown {
  const std::type_info* type;
  void* (*destroy)(void*);
  int handlers;   ///< handling it; negative while it is rethrown
  Thrown* outer;  ///< the exception caught before

  void* object() { return this + 1; }
};

Thrown* caught = nullptr;  ///< the last one caught

/// A LEB128 number: seven bits per byte, the lowest first.
std::uint32_t unsigned_at(const std::uint8_t*& at) {
  std::uint32_t value = 0;
  for (int shift = 0;; shift += 7) {
    const std::uint8_t byte = *at++;
    value |= static_cast<std::uint32_t>(byte & 0x7f) << shift;
    if ((byte & 0x80) == 0) return value;
  }
}
std::int32_t signed_at(const std::uint8_t*& at) {
  std::uint32_t value = 0;
  for (int shift = 0;;) {
    const std::uint8_t byte = *at++;
    value |= static_cast<std::uint32_t>(byte & 0x7f) << shift;
    shift += 7;
    if ((byte & 0x80) != 0) continue;
    if ((byte & 0x40) != 0 && shift < 32) value |= ~std::uint32_t{0} << shift;
    return static_cast<std::int32_t>(value);
  }
}

/// A type with one base, as the ABI lays it out.
struct WithBase {
  void* const* table;
  const char* name;
  const std::type_info* base;
};

/// Whether it is this type, or derived from it with one base at each level, as are all exceptions here.
bool is(const std::type_info* type, const std::type_info* wanted) {
  while (type != wanted) {
    const auto* its = reinterpret_cast<const WithBase*>(type);
    if (its->table != _ZTVN10__cxxabiv120__si_class_type_infoE + 2) return false;
    type = its->base;
  }
  return true;
}

constexpr std::uint8_t omitted = 0xff;

}  // namespace

extern "C" {

/// A landing pad writes its index here, and reads the handler that takes the exception.
struct {
  std::uintptr_t landing_pad;
  const std::uint8_t* table;
  std::uintptr_t selector;
} __wasm_lpad_context;

/// Sets the selector: 0 if no handler takes the exception, and it propagates.
int _Unwind_CallPersonality(void* exception) {
  const auto* thrown = static_cast<const Thrown*>(exception);
  const std::uint8_t* at = __wasm_lpad_context.table;
  __wasm_lpad_context.selector = 0;
  if (*at++ != omitted) std::abort();  // a base address for landing pads
  const std::type_info* const* types_end = nullptr;
  if (*at++ != omitted) {
    const std::uint32_t offset = unsigned_at(at);
    types_end = reinterpret_cast<const std::type_info* const*>(at + offset);
  }
  ++at;  // encoding of the numbers of the call sites
  const std::uint32_t length = unsigned_at(at);
  const std::uint8_t* const actions = at + length;
  std::uint32_t action = 0;
  for (std::uintptr_t i = 0; i <= __wasm_lpad_context.landing_pad; ++i) {
    unsigned_at(at);
    action = unsigned_at(at);
  }
  if (action == 0) return 0;
  for (at = actions + action - 1;;) {
    const std::int32_t type = signed_at(at);
    const std::uint8_t* const from = at;
    const std::int32_t next = signed_at(at);
    if (type > 0 && (!types_end[-type] || is(thrown->type, types_end[-type]))) {
      __wasm_lpad_context.selector = static_cast<std::uintptr_t>(type);
      return 0;
    }
    if (next == 0) return 0;
    at = from + next;
  }
}

int __gxx_wasm_personality_v0() { std::abort(); }  // only referenced by the tables

void* __cxa_allocate_exception(std::size_t size) {
  auto* thrown = static_cast<Thrown*>(std::calloc(1, sizeof(Thrown) + size));
  if (!thrown) std::abort();
  return thrown->object();
}
void __cxa_free_exception(void* object) { std::free(static_cast<Thrown*>(object) - 1); }

[[noreturn]] void __cxa_throw(void* object, std::type_info* type, void* (*destroy)(void*)) {
  Thrown* thrown = static_cast<Thrown*>(object) - 1;
  thrown->type = type;
  thrown->destroy = destroy;
  __builtin_wasm_throw(0, thrown);
}

void* __cxa_get_exception_ptr(void* exception) { return static_cast<Thrown*>(exception)->object(); }

void* __cxa_begin_catch(void* exception) {
  auto* thrown = static_cast<Thrown*>(exception);
  thrown->handlers = std::abs(thrown->handlers) + 1;
  if (caught != thrown) {
    thrown->outer = caught;
    caught = thrown;
  }
  return thrown->object();
}

void __cxa_end_catch() {
  Thrown* thrown = caught;
  if (thrown->handlers < 0) {  // it propagates again
    if (++thrown->handlers == 0) caught = thrown->outer;
  } else if (--thrown->handlers == 0) {
    caught = thrown->outer;
    if (thrown->destroy) thrown->destroy(thrown->object());
    __cxa_free_exception(thrown->object());
  }
}

[[noreturn]] void __cxa_rethrow() {
  caught->handlers = -caught->handlers;
  __builtin_wasm_throw(0, caught);
}

/// The page's thread does not end.
int __cxa_thread_atexit(void (*)(void*), void*, void*) { return 0; }
}
