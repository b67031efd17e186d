// autocuts-cli: makes UV maps in scripts.
#include "cli/batch.h"
#include "cli/commandline.h"
#include "cli/manyfiles/manyfiles.h"
#include "jobs/letgo.h"

#include <QCoreApplication>

#include <QTextStream>
#include <QUtf8StringView>

#include <algorithm>
#include <array>
#include <clocale>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <langinfo.h>
#include <sys/resource.h>
#include <unistd.h>

namespace {

autocuts::StopSource stopSource;

extern "C" void interrupt(int signal)
{
    // A second signal ends the program at once.
    std::signal(signal, SIG_DFL);
    stopSource.request(autocuts::StopReason::Interrupted);
}

#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
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
#endif

//! Selects a UTF-8 locale when there is none, as in cron jobs and containers: Qt needs one for file names and
//! otherwise prints a warning.
void ensureUtf8Locale()
{
    std::setlocale(LC_CTYPE, "");
    if (std::strcmp(nl_langinfo(CODESET), "UTF-8") != 0)
        setenv("LC_ALL", "C.UTF-8", 1);
}

//! Qt would replace what is not UTF-8 in the names of files, and so read and write files of other names.
bool areUtf8(int count, char *arguments[])
{
    return std::all_of(arguments, arguments + count,
                       [](const char *argument) { return QUtf8StringView(argument).isValidUtf8(); });
}

//! Ends the program without the destructors of global objects: work that was left to itself may still use
//! them, and OpenBLAS waits forever for its threads where memory was too scarce to start them.
int ended(int code, QTextStream &out, QTextStream &err)
{
    out.flush();
    err.flush();
#ifdef __SANITIZE_ADDRESS__
    if (autocuts::jobs::letGoCount == 0)
        return code; // leaks are looked for at the end
#endif
    std::_Exit(code);
}

} // namespace

int main(int argc, char *argv[])
{
    ensureUtf8Locale();
    QCoreApplication application(argc, argv);
    QCoreApplication::setApplicationName(QStringLiteral("autocuts-cli"));
    QCoreApplication::setApplicationVersion(QStringLiteral(AUTOCUTS_VERSION));
    QTextStream out(stdout);
    QTextStream err(stderr);
    if (!areUtf8(argc, argv)) {
        err << "autocuts-cli: an argument is not valid UTF-8. Rename the file, for example with convmv"
            << Qt::endl;
        return ended(2, out, err);
    }
    const auto options = autocuts::parseCommandLine(QCoreApplication::arguments().mid(1));
    if (!options) {
        err << "autocuts-cli: " << options.error().toString() << Qt::endl;
        return ended(2, out, err);
    }
    // The other commands have nothing to save: a signal simply ends them.
    if (autocuts::canBeStopped(options.value())) {
        std::signal(SIGINT, interrupt);
        std::signal(SIGTERM, interrupt);
    }
    // Without these signals, closed pipes and file size limits are reported as failed writes.
    std::signal(SIGPIPE, SIG_IGN);
    std::signal(SIGXFSZ, SIG_IGN);
    const auto run = options->many ? autocuts::manyfiles::runBatch : autocuts::runCommand;
    const int code = run(options.value(), stopSource, isatty(STDERR_FILENO), out, err);
    return ended(code, out, err);
}
