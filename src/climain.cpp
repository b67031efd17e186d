// autocuts-cli: UV maps from scripts.
#include "batch.h"

#include <QCoreApplication>

#include <csignal>
#include <unistd.h>

namespace {

autocuts::StopSource stopSource;

extern "C" void interrupt(int signal)
{
    // A second signal ends the program at once.
    std::signal(signal, SIG_DFL);
    stopSource.request(autocuts::StopReason::Interrupted);
}

} // namespace

int main(int argc, char *argv[])
{
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
    std::signal(SIGINT, interrupt);
    std::signal(SIGTERM, interrupt);
    std::signal(SIGPIPE, SIG_IGN);
    return autocuts::runCommand(options.value(), stopSource, isatty(STDERR_FILENO), out, err);
}
