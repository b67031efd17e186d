#include "cli/manyfiles/machine.h"

#ifdef Q_OS_WIN
#include <windows.h>
#else
#include <csignal>
#include <unistd.h>
#endif
#ifdef Q_OS_LINUX
#include <sys/prctl.h>
#endif

namespace autocuts::manyfiles {

#ifdef Q_OS_WIN

qint64 freeMemory()
{
    MEMORYSTATUSEX status{};
    status.dwLength = sizeof status;
    return GlobalMemoryStatusEx(&status) ? qint64(status.ullAvailPhys) : 0;
}

void endWithProgram(QProcess &) {}

#else

qint64 freeMemory()
{
#ifdef _SC_AVPHYS_PAGES
    return qint64(sysconf(_SC_AVPHYS_PAGES)) * sysconf(_SC_PAGESIZE);
#else
    return qint64(sysconf(_SC_PHYS_PAGES)) * sysconf(_SC_PAGESIZE) / 2; // macOS says only how much there is
#endif
}

void endWithProgram(QProcess &process)
{
    process.setChildProcessModifier([] {
#ifdef Q_OS_LINUX
        ::prctl(PR_SET_PDEATHSIG, SIGKILL);
#endif
        ::setpgid(0, 0);
    });
}

#endif

} // namespace autocuts::manyfiles
