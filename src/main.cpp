// autocuts: the studio.
#include "link/linkplace.h"
#include "views/actions/studioactions.h"
#include "views/shell/mainwindow.h"
#include "views/ui/language.h"
#include "views/ui/preferences.h"
#include "views/ui/theme.h"

#include <QApplication>
#include <QCommandLineParser>
#include <QStandardPaths>
#include <QTimer>

int main(int argc, char *argv[])
{
    QApplication::setApplicationName(QStringLiteral("autocuts"));
    const QString preferencesFile =
        QStandardPaths::writableLocation(QStandardPaths::AppConfigLocation) + QStringLiteral("/autocuts.ini");
    // Qt reads the scale once, before the application is made.
    const int percent = autocuts::Preferences::interfacePercent(preferencesFile);
    if (percent != 100 && !qEnvironmentVariableIsSet("QT_SCALE_FACTOR"))
        qputenv("QT_SCALE_FACTOR", QByteArray::number(percent / 100.0));
    QApplication application(argc, argv);
    QApplication::setApplicationDisplayName(QStringLiteral("Autocuts"));
    QApplication::setDesktopFileName(QStringLiteral("org.autocuts.Autocuts")); // its entry in packaging/
    QApplication::setApplicationVersion(QStringLiteral(AUTOCUTS_VERSION));

    autocuts::installLanguage(application, autocuts::Preferences::language(preferencesFile));

    QCommandLineParser parser;
    parser.setApplicationDescription(QCoreApplication::translate("main", "UV maps by simultaneous distortion "
                                                                         "and cut optimization."));
    parser.addHelpOption();
    parser.addVersionOption();
    const QCommandLineOption sample(QStringLiteral("sample"),
                                    QCoreApplication::translate("main",
                                                                "Open a model made by the program: "
                                                                "bumpycube, character, torus, machine."),
                                    QStringLiteral("name"));
    const QCommandLineOption solve(QStringLiteral("solve"),
                                   QCoreApplication::translate("main", "Start solving at once."));
    parser.addOptions({sample, solve});
    parser.addPositionalArgument(QStringLiteral("file"),
                                 QCoreApplication::translate("main", "A mesh or an .acproj session to open."),
                                 QStringLiteral("[file]"));
    parser.process(application);

    autocuts::Preferences preferences(preferencesFile);
    const auto applyTheme = [&] { autocuts::applyTheme(application, preferences.values().theme); };
    applyTheme();
    QObject::connect(&preferences, &autocuts::Preferences::changed, &application, applyTheme);
    autocuts::MainWindow window(preferences,
                                QStandardPaths::writableLocation(QStandardPaths::AppLocalDataLocation) +
                                    QStringLiteral("/recovery"));
    if (parser.isSet(solve))
        QObject::connect(&window.context().files, &autocuts::FileController::opened, &window.context().solver,
                         &autocuts::SolverController::run);
    window.show();
    window.link().listen(autocuts::link::LinkPlace::userFolder());
    QTimer::singleShot(0, &window, [&] {
        if (parser.isSet(sample))
            window.context().files.openSample(parser.value(sample));
        else if (!parser.positionalArguments().isEmpty())
            window.actions().file().openFile(parser.positionalArguments().constFirst());
        else
            window.actions().file().offerRecovery();
    });
    return QApplication::exec();
}
