#include "cli/program/startup.h"

#ifdef _WIN32
#include <io.h>
#else
#include <array>
#include <clocale>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <langinfo.h>
#include <sys/resource.h>
#include <unistd.h>
#endif

#if defined(__linux__) && !defined(AUTOCUTS_SANITIZED)
namespace {

//! OpenBLAS starts a thread for each core when it is loaded. Where the address space is limited, it ends the
//! program when it cannot, or tries for ever to map a buffer for each of them. The program uses none of them,
//! so it begins again without them, before any library begins to work: nothing but system calls works here.
void beginWithoutBlasThreads(int, char *arguments[], char *environment[])
{
    constexpr const char *none = "OPENBLAS_NUM_THREADS=1";
    constexpr std::size_t most = 4096;
    rlimit space{};
    if (getrlimit(RLIMIT_AS, &space) != 0 || space.rlim_cur == RLIM_INFINITY)
        return;
    std::array<char *, most + 2> changed{};
    std::size_t count = 0;
    for (; *environment && count < most; ++environment) {
        if (std::strcmp(*environment, none) == 0)
            return;
        if (std::strncmp(*environment, none, std::strlen(none) - 1) != 0)
            changed[count++] = *environment;
    }
    changed[count] = const_cast<char *>(none);
    execve("/proc/self/exe", arguments, changed.data());
}

using BeforeLibraries = void (*)(int, char *[], char *[]);
[[gnu::section(".preinit_array"), gnu::used]] const BeforeLibraries first = beginWithoutBlasThreads;

} // namespace
#endif

namespace autocuts {

#ifdef _WIN32

void ensureUtf8Locale() {}

void reportFailedWrites() {}

bool isOnTerminal()
{
    return _isatty(2) != 0;
}

#else

void ensureUtf8Locale()
{
    std::setlocale(LC_CTYPE, "");
    if (std::strcmp(nl_langinfo(CODESET), "UTF-8") != 0)
        setenv("LC_ALL", "C.UTF-8", 1);
}

void reportFailedWrites()
{
    std::signal(SIGPIPE, SIG_IGN);
    std::signal(SIGXFSZ, SIG_IGN);
}

bool isOnTerminal()
{
    return isatty(STDERR_FILENO) != 0;
}

#endif

} // namespace autocuts
