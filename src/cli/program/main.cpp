// autocuts-cli: makes UV maps in scripts.
#include "cli/batch.h"
#include "cli/commandline.h"
#include "cli/manyfiles/manyfiles.h"
#include "cli/program/startup.h"

#include <QCoreApplication>

#include <QTextStream>
#include <QUtf8StringView>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <new>

namespace {

autocuts::StopSource stopSource;

extern "C" void interrupt(int signal)
{
    // A second signal ends the program at once.
    std::signal(signal, SIG_DFL);
    stopSource.request(autocuts::StopReason::Interrupted);
}

//! Qt would replace what is not UTF-8 in the names of files, and so read and write files of other names.
bool areUtf8(int count, char *arguments[])
{
    return std::all_of(arguments, arguments + count,
                       [](const char *argument) { return QUtf8StringView(argument).isValidUtf8(); });
}

//! What Qt says of damaged files is for developers: the program says itself what is wrong with them.
void dropWarnings(QtMsgType type, const QMessageLogContext &, const QString &message)
{
    if (type == QtCriticalMsg || type == QtFatalMsg)
        std::fprintf(stderr, "autocuts-cli: %s\n", qPrintable(message));
}

//! Ends the program while a job prepares: there is nothing to write.
void endProgram(autocuts::StopReason why)
{
    const bool late = why == autocuts::StopReason::TimeLimit;
    // stderr has no buffer: that is safe enough for a signal handler.
    std::fputs(
        late ? "autocuts-cli: the time limit was over before the model was read and prepared. Give it a "
               "longer --time-limit\n"
             : "autocuts-cli: interrupted before the model was read and prepared, nothing was written\n",
        stderr);
    std::_Exit(late ? 1 : 130);
}

//! Ends the program without the destructors of global objects: OpenBLAS waits forever for its threads where
//! memory was too scarce to start them.
int ended(int code, QTextStream &out, QTextStream &err)
{
    out.flush();
    err.flush();
#ifdef AUTOCUTS_SANITIZED
    return code; // leaks are looked for at the end
#else
    std::_Exit(code);
#endif
}

} // namespace

int main(int argc, char *argv[])
try {
    qInstallMessageHandler(dropWarnings);
    autocuts::ensureUtf8Locale();
    qputenv("QT_NO_GLIB", "1"); // it crashes where memory ends, and no event loop needs it here
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
    stopSource.endProgram = endProgram;
    if (autocuts::canBeStopped(options.value())) {
        std::signal(SIGINT, interrupt);
        std::signal(SIGTERM, interrupt);
    }
    autocuts::reportFailedWrites();
    const auto run = options->many ? autocuts::manyfiles::runBatch : autocuts::runCommand;
    const int code = run(options.value(), stopSource, autocuts::isOnTerminal(), out, err);
    return ended(code, out, err);
} catch (const std::bad_alloc &) {
    std::fputs("autocuts-cli: there is not enough memory. Close other programs\n", stderr);
    std::_Exit(1);
}
