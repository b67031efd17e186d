// autocuts-cli: makes UV maps in scripts.
#include "cli/batch.h"
#include "cli/commandline.h"
#include "cli/letgo.h"

#include <QCoreApplication>

#include <clocale>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <langinfo.h>
#include <unistd.h>

namespace {

autocuts::StopSource stopSource;

extern "C" void interrupt(int signal)
{
    // A second signal ends the program at once.
    std::signal(signal, SIG_DFL);
    stopSource.request(autocuts::StopReason::Interrupted);
}

//! Selects a UTF-8 locale when there is none, as in cron jobs and containers: Qt needs one for file names and
//! otherwise prints a warning.
void ensureUtf8Locale()
{
    std::setlocale(LC_CTYPE, "");
    if (std::strcmp(nl_langinfo(CODESET), "UTF-8") != 0)
        setenv("LC_ALL", "C.UTF-8", 1);
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
    const auto options = autocuts::parseCommandLine(QCoreApplication::arguments().mid(1));
    if (!options) {
        err << "autocuts-cli: " << options.error().toString() << Qt::endl;
        return 2;
    }
    // The other commands have nothing to save: a signal simply ends them.
    if (autocuts::canBeStopped(options.value())) {
        std::signal(SIGINT, interrupt);
        std::signal(SIGTERM, interrupt);
    }
    // Without these signals, closed pipes and file size limits are reported as failed writes.
    std::signal(SIGPIPE, SIG_IGN);
    std::signal(SIGXFSZ, SIG_IGN);
    const int code = autocuts::runCommand(options.value(), stopSource, isatty(STDERR_FILENO), out, err);
    if (autocuts::letGoCount > 0) {
        out.flush();
        err.flush();
        std::_Exit(code);
    }
    return code;
}
