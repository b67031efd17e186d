#include "reader/process.h"

#include <algorithm>
#include <csignal>
#include <cstdlib>
#ifdef _WIN32
#include <io.h>
#else
#include <sys/resource.h>
#include <unistd.h>
#endif
#ifdef __linux__
#include <sys/prctl.h>
#endif

namespace autocuts {

#ifdef _WIN32

void endWithParent()
{
    std::signal(SIGINT, SIG_IGN);
}

void setLimits(unsigned long long, unsigned long long) {}

std::FILE *takeOutput()
{
    std::FILE *out = _fdopen(_dup(1), "wb");
    return out && std::freopen("NUL", "w", stdout) ? out : nullptr;
}

void endWith(int code)
{
    std::_Exit(code);
}

#else

namespace {

void limit(int resource, rlim_t most)
{
    rlimit limits{};
    getrlimit(resource, &limits);
    limits.rlim_cur = std::min(most, limits.rlim_max);
    setrlimit(resource, &limits);
}

} // namespace

void setLimits(unsigned long long memory, unsigned long long seconds)
{
    limit(RLIMIT_CORE, 0);
    limit(RLIMIT_CPU, seconds);
#ifdef AUTOCUTS_SANITIZED
    // Sanitizers take address space for themselves.
    static_cast<void>(memory);
#else
    limit(RLIMIT_AS, memory);
#endif
}

void endWithParent()
{
    std::signal(SIGINT, SIG_IGN);
    std::signal(SIGPIPE, SIG_DFL);
    std::signal(SIGXCPU, SIG_DFL);
#ifdef __linux__
    prctl(PR_SET_PDEATHSIG, SIGKILL);
#endif
}

std::FILE *takeOutput()
{
    std::FILE *out = fdopen(dup(STDOUT_FILENO), "wb");
    return out && std::freopen("/dev/null", "w", stdout) ? out : nullptr;
}

void endWith(int code)
{
    _exit(code);
}

#endif

} // namespace autocuts
