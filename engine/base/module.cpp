#include "engine/base/module.hpp"

#include <dlfcn.h>

namespace zeroset {

std::expected<void*, std::string> load_module(const char* file, const char* function) {
    void* const module = dlopen(file, RTLD_NOW | RTLD_LOCAL);
    void* const found = module == nullptr ? nullptr : dlsym(module, function);
    if (found != nullptr) return found;
    const char* const error = dlerror();  // NOLINT(concurrency-mt-unsafe): glibc has one a thread
    return std::unexpected(error == nullptr ? file : error);
}

}  // namespace zeroset
