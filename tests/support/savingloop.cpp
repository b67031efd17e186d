// Saves a session and its recovery file over and over, for a test that kills it. Every save has a number,
// which is written to the standard output, with a letter before it, once the save is done.
#include "model/io/files/savefile.h"
#include "model/io/projects/autosave.h"
#include "support/sessions.h"

#include <QCoreApplication>

#include <cstdio>

using namespace autocuts;

int main(int argc, char *argv[])
{
    QCoreApplication application(argc, argv);
    if (argc != 4)
        return 2;
    const QString path = QString::fromLocal8Bit(argv[1]);
    const QString folder = QString::fromLocal8Bit(argv[2]);
    int number = QByteArray(argv[3]).toInt();
    test::Session session = test::gridSession(12, 0, 1);
    session.extras.sessionPath = path;
    ProjectWriter writer;
    const auto bytes = [&] {
        session.state.viewState = QByteArray::number(++number);
        return writer.bytes(session.state, session.extras);
    };
    const auto report = [&](char kind) {
        std::printf("%c%d\n", kind, number);
        std::fflush(stdout);
    };
    const auto autosave = Autosave::start(folder, [&](const QString &file, const Autosave::Saved &saved) {
        saved(saveAtomically(file, bytes()));
    });
    if (!autosave)
        return 1;
    for (;;) {
        if (!saveProjectBytes(bytes(), path))
            return 1;
        report('s');
        autosave.value()->saveNow();
        report('a');
    }
}
