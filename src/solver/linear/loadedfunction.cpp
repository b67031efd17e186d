#include "solver/linear/loadedfunction.h"

#ifdef _WIN32
#include <initializer_list>
#include <windows.h>
#else
#include <dlfcn.h>
#endif

namespace autocuts::linear {

#ifdef _WIN32

void *loadedFunction(const char *name)
{
    // Of the libraries that Windows has, only those named here are looked into.
    for (const char *library : {"libopenblas.dll", "openblas.dll"}) {
        if (const HMODULE module = GetModuleHandleA(library))
            return reinterpret_cast<void *>(GetProcAddress(module, name));
    }
    return nullptr;
}

#else

void *loadedFunction(const char *name)
{
    return dlsym(RTLD_DEFAULT, name);
}

#endif

} // namespace autocuts::linear
