// autocuts-reader: reads a mesh file by Assimp for the other programs and writes the scene to its standard
// output. A file that crashes or hangs Assimp, or takes all memory, ends this program only.
#include "model/io/assimpimport.h"
#include "model/io/assimpstream.h"

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <new>
#include <sys/resource.h>
#include <unistd.h>
#ifdef __linux__
#include <sys/prctl.h>
#endif

namespace {

void limit(int resource, rlim_t most)
{
    rlimit limits{};
    getrlimit(resource, &limits);
    limits.rlim_cur = std::min(most, limits.rlim_max);
    setrlimit(resource, &limits);
}

//! \param memory bytes \param seconds of the processor
void setLimits(rlim_t memory, rlim_t seconds)
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

//! Ends together with the program that asked, and only by its will: Ctrl-C reaches both.
void setSignals()
{
    std::signal(SIGINT, SIG_IGN);
    std::signal(SIGPIPE, SIG_DFL);
    std::signal(SIGXCPU, SIG_DFL);
#ifdef __linux__
    prctl(PR_SET_PDEATHSIG, SIGKILL);
#endif
}

[[noreturn]] void endForLackOfMemory()
{
    _exit(autocuts::readerexit::outOfMemory);
}

} // namespace

//! Arguments: the file, the limits of memory in bytes and of processor time in seconds.
int main(int argc, char *argv[])
{
    if (argc != 4) {
        std::fputs("autocuts-reader is started by autocuts and autocuts-cli\n", stderr);
        return 2;
    }
    setSignals();
    setLimits(std::strtoull(argv[2], nullptr, 10), std::strtoull(argv[3], nullptr, 10));
    std::set_new_handler(endForLackOfMemory);
    // The standard output is for the scene alone, whatever a library prints.
    std::FILE *out = fdopen(dup(STDOUT_FILENO), "wb");
    if (!out || !std::freopen("/dev/null", "w", stdout))
        return autocuts::readerexit::outOfMemory;
    autocuts::importWithAssimp(argv[1], out, _exit);
    return autocuts::readerexit::unreadable;
}
